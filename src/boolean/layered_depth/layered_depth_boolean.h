// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "boolean/input/operation.h"
#include "boolean/layered_depth/samples/face_samples.h"
#include "boolean/layered_depth/samples/winding_samples.h"
#include "boolean/layered_depth/uniform_operand.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// Options of the uniform scheme.
struct UniformOptions {
    /// Rays along the longest side of the box in which the result can lie (that of A for a difference, that common to A
    /// and B for an intersection, else that of both), rounded up to 2^n + 1; 9 to 4097.
    int resolution = 513;
    /// Surfaces of A and B nearer than this are in contact: gaps and slabs between them vanish. A fraction of the
    /// longest side (the paper's epsilon).
    double thinnest = 1e-6;
    /// Whether inside is where the normal index is 1 or more, so that only the outer surface of an operand that
    /// intersects itself counts. Otherwise inside is after an odd number of crossings.
    bool normal_index = true;
    /// Whether the whole surface is reconstructed from the samples, as in the paper's Table III; no triangle of an
    /// operand stays.
    bool full = false;
};

/// The result of a Boolean by layered depth images, and its counts.
struct UniformResult {
    mesh::TriangleMesh mesh;
    /// Operand (0, 1, ...) and index there of each triangle that is the operand's own, all coordinates unchanged
    /// (reversed where the result has its outside within the operand); {-1, -1} for triangles made or changed here.
    std::vector<std::array<std::int32_t, 2>> triangle_source;
    /// By layered_depth_boolean it is the paper's bound, not measured: sqrt(3) r, where r is the distance between rays
    /// (Wang 2010, section IV-A: every point of the true result has a sample this near). It does not hold where
    /// features are thinner than r: those may be lost, and the triangles that close the gap can lie farther away. 0
    /// where nothing was reconstructed. By sound_layered_depth_boolean it is measured. mm.
    double error_bound = 0.0;
    double spacing = 0.0;  ///< the distance r between rays, mm

    std::vector<std::string> repaired;    ///< a sentence for each operand, empty when there was nothing to do
    std::size_t samples = 0;              ///< samples of all operands
    FaceSampleCounts cad;                 ///< samples of operands that are shapes
    WindingSampleCounts winding;          ///< samples of operands that are open
    std::vector<char> open;               ///< for each operand whether no repair closed it
    std::size_t guessed_samples = 0;      ///< samples of the result where an open operand has no triangle
    std::size_t fitted = 0;               ///< vertices put onto the faces of shapes
    std::size_t unfitted = 0;             ///< vertices that have no place on these faces near enough
    std::size_t result_samples = 0;       ///< samples of the result
    std::size_t retained = 0;             ///< triangles that are an operand's own
    std::size_t changed = 0;              ///< triangles of operands that stitching split or moved
    std::size_t reconstructed = 0;        ///< triangles made by contouring
    std::size_t unsampled_triangles = 0;  ///< triangles in components that no ray met: they are lost
    std::size_t cells = 0;                ///< leaves of the octree with samples to reconstruct
    std::size_t boundary_cells = 0;
    std::size_t complex_cells = 0;  ///< boundary cells that the three filters had to amend
    std::size_t split_edges = 0, collapsed_nodes = 0, moved_nodes = 0, left_nodes = 0;
    std::size_t refused_triangles = 0;  ///< triangles not made, because an edge would have had a third one
    std::size_t opened_nodes = 0;       ///< points added by Node-Open
    std::size_t holes_filled = 0, hole_triangles = 0, largest_hole = 0;
    std::size_t crossing_pairs = 0;  ///< pairs of triangles of the scheme's surface that crossed, and were divided

    StageTimes seconds;
};

/// The shapes from which the operands were meshed. Their CAD faces are sampled, and reconstructed vertices lie on them.
struct CadOperands {
    std::vector<CadShape> shapes;  ///< without a model where an operand is nothing but a mesh; empty: all are
    geometry::Engine* engine = nullptr;
};

/// The approximate Boolean of Wang 2010 on a uniform grid of rays (method "uniform"), of any number of operands in one
/// pass.
///
/// Operands may intersect themselves. One that is not closed, not oriented or inside out is repaired first (see
/// prepare_operand); where no repair closes it, inside is where its generalised winding number is at least 0.5 (see
/// sample_by_winding).
///
/// The result is closed, oriented and 2-manifold in its connections. As in the paper it is not guaranteed to be free of
/// self-intersections where it was reconstructed, and features thinner than the distance between rays may be lost.
/// @throws OpenOperand for an open sheet, around which a guess would be most of the surface
/// @throws InvalidInput for an option out of range, a resolution whose samples would take more than 2 GB, an operand
///     whose triangles have no area, or operands with different origins
/// @throws Cancelled
UniformResult layered_depth_boolean(const std::vector<const mesh::TriangleMesh*>& operands,
                                    const Expression& expression, const UniformOptions& options, Progress* progress,
                                    const CadOperands& cad = {});

/// The operands of that Boolean, fit for rays.
/// @throws InvalidInput, OpenOperand, Cancelled as layered_depth_boolean
std::vector<UniformOperand> prepare_uniform(const std::vector<const mesh::TriangleMesh*>& operands,
                                            const Expression& expression, const UniformOptions& options,
                                            const Progress* progress);

/// The same Boolean of operands that are prepared.
UniformResult layered_depth_boolean(const std::vector<UniformOperand>& prepared, const Expression& expression,
                                    const UniformOptions& options, Progress* progress, const CadOperands& cad);

/// The same for two operands.
UniformResult layered_depth_boolean(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b, Operation operation,
                                    const UniformOptions& options, Progress* progress);

/// The largest error bound of a result whose operands have a common box with this longest side, mm.
double uniform_bound(double size, int resolution);

/// The least resolution whose bound is within the tolerance, mm.
/// @throws InvalidInput naming the least tolerance where the rays do not suffice.
int uniform_resolution(double size, double tolerance);

}  // namespace mq::boolean
