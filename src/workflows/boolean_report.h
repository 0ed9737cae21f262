// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/quality/mesh_report.h"

namespace mq::workflows {

/// The contents of a MeshReport, the error bound of a Boolean's result, and the repairs of its operands. The comments
/// are what Python says of the fields (tools/bound_fields).
struct BooleanReport : mesh::MeshReport {
    std::string method = "exact";  ///< that has made the result: 'exact', 'uniform' or 'wrap'
    /// share of the surface where an open operand has no triangle, a guess, 0 to 1
    double guessed_share = 0.0;
    /// mm; the largest distance between the result and the exact one of the operands' meshes, both ways, but for gaps
    /// and slivers up to 1.75 closed_gaps wide: measured for the method 'uniform' and where common faces were moved,
    /// else proven
    double error_bound = 0.0;
    double closed_gaps = 0.0;      ///< mm; the widest gap or sliver between common faces of operands that was closed
    double tolerance_asked = 0.0;  ///< mm; the tolerance that was requested, or that of the resolution
    std::vector<mesh::SurfaceTopology> operands;  // see operand_components and operand_euler
    std::size_t retained = 0;                     ///< triangles that are an operand's own
    std::size_t reconstructed = 0;                ///< all others
    std::vector<Message> repaired;                ///< a sentence for each operand that was repaired
    std::size_t faults_left = 0;                  ///< faults of the result that no repair removed; notes name them
    /// pairs of the operands' triangles; by the method 'uniform' those of its surface that crossed, and were divided
    std::size_t crossing_pairs = 0;
    std::size_t curve_edges = 0;         ///< edges on the intersection curves
    std::size_t separated_contacts = 0;  ///< points in which parts of the result touched
    std::size_t separated_vertices = 0;  ///< vertices moved beyond common faces of another operand
    std::size_t fitted_vertices = 0;     ///< made on the faces of shapes and put onto their surfaces
    /// left on the meshes of the shapes: the surfaces are too far, or a fault would result
    std::size_t unfitted_vertices = 0;
    std::size_t holes_filled = 0;  ///< that stitching left in the reconstructed surface (method 'uniform')
    std::size_t samples = 0;       ///< samples of the operands along rays (method 'uniform')
    std::size_t face_samples = 0;  ///< those with depth and normal of a CAD face
};

/// A text of a dozen lines for people.
std::string to_text(const BooleanReport& report);

/// A summary in one line: "1,234 triangles, closed, smallest angle 25.1°, max. deviation 0.01 mm of 0.05 mm".
std::string in_short(const BooleanReport& report);

/// Whether the result has no fault and its error bound is within the tolerance.
bool met(const BooleanReport& report);

}  // namespace mq::workflows
