// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/quality/mesh_report.h"

namespace mq::workflows {

/// The contents of a MeshReport, the error bound of a Boolean's result, and the repairs of its operands.
struct BooleanReport : mesh::MeshReport {
    std::string method = "exact";  ///< that has made the result: "exact", "uniform" or "wrap"
    /// mm. By the method Exact it is how far surfaces and vertices were moved at most, see boolean::BooleanResult. Of
    /// the method Uniform the largest distance found between the result and the exact one, both ways
    /// (boolean/error_measure.h).
    double error_bound = 0.0;
    double tolerance_asked = 0.0;   ///< the tolerance that was requested, or that of the resolution, mm
    std::size_t retained = 0;       ///< triangles that an operand has unchanged
    std::size_t reconstructed = 0;  ///< all other triangles
    std::size_t faults_left = 0;    ///< faults of the result that no repair removed; notes name them
    /// Pairs of triangles of the operands that cross; of the method Uniform those of its surface that did, until this
    /// was divided along the crossings.
    std::size_t crossing_pairs = 0;
    std::size_t curve_edges = 0;         ///< edges on the intersection curves
    std::size_t separated_contacts = 0;  ///< points in which regions of the result touched
    double closed_gaps = 0.0;  ///< mm, the widest gap or sliver between common faces of operands that was closed
    std::size_t separated_vertices = 0;  ///< vertices moved beyond common faces of another operand
    std::size_t fitted_vertices = 0;     ///< vertices put onto the surfaces of the shapes that were operands
    std::size_t unfitted_vertices = 0;   ///< vertices left on the meshes of these shapes
    std::size_t holes_filled = 0;        ///< holes that stitching left in the reconstructed surface (method Uniform)
    std::size_t samples = 0;             ///< samples of the operands along rays (method Uniform)
    std::size_t face_samples = 0;        ///< samples with depth and normal of a CAD face
    /// Share of the result's surface where an open operand has no triangle: it is a guess by the winding number, to
    /// which the error bound does not apply (method Uniform). 0 to 1.
    double guessed_share = 0.0;
    /// Components and Euler number of each given operand, to be compared with `components` and `euler` of the result.
    std::vector<mesh::SurfaceTopology> operands;
    std::vector<std::string> repaired;  ///< a sentence for each operand that was repaired
};

/// A text of a dozen lines for people.
std::string to_text(const BooleanReport& report);

/// A summary in one line: "1,234 triangles, closed, smallest angle 25.1°, max. deviation 0.01 mm of 0.05 mm".
std::string in_short(const BooleanReport& report);

/// Whether the result has no fault and its error bound is within the tolerance.
bool met(const BooleanReport& report);

}  // namespace mq::workflows
