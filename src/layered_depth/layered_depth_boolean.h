// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "boolean/input/operation.h"
#include "layered_depth/layered_depth_operand.h"
#include "layered_depth/samples/face_samples.h"
#include "layered_depth/samples/winding_samples.h"
#include "mesh/triangle_mesh.h"

namespace mq::layered_depth {

/// Options of the uniform scheme.
struct LayeredDepthOptions {
    /// Rays along the longest side of the box in which the result can lie: the box of A for a difference, the
    /// intersection of both boxes for an intersection, else the box around both. Rounded up to 2^n + 1; 9 to 4097.
    int resolution = 513;
    /// Surfaces of A and B nearer than this are in contact: gaps and slabs between them vanish. As a fraction of the
    /// longest side (the paper's epsilon).
    double thinnest = 1e-6;
    /// Whether points with a normal index of 1 or more are inside, so that only the outer surface of an operand that
    /// intersects itself counts. Otherwise points after an odd number of crossings are inside.
    bool normal_index = true;
    /// Whether the whole surface is reconstructed from the samples, as in the paper's Table III; no triangle of an
    /// operand is kept then.
    bool full = false;
};

/// The result of a Boolean by layered depth images, with its counts.
struct UniformResult {
    mesh::TriangleMesh mesh;
    /// For each triangle that is a triangle of an operand with the same coordinates: the operand (0, 1, ...) and the
    /// index in it. Such a triangle is reversed if the outside of the result is inside of the operand. {-1, -1} for
    /// triangles that were made or changed.
    std::vector<std::array<std::int32_t, 2>> triangle_source;
    /// mm. layered_depth_boolean sets the paper's bound, which is not measured: sqrt(3) r, where r is the distance
    /// between rays (Wang 2010, section IV-A: every point of the true result has a sample this near). The bound does
    /// not hold for features thinner than r: these may be lost, and the triangles that close the gap can lie farther
    /// away. 0 if nothing was reconstructed. sound_layered_depth_boolean sets a measured bound.
    double error_bound = 0.0;
    double spacing = 0.0;  ///< the distance r between rays, mm

    std::vector<Message> repaired;        ///< for each operand a sentence on its repair; empty: nothing was repaired
    std::size_t samples = 0;              ///< samples of all operands
    FaceSampleCounts cad;                 ///< samples of operands that are shapes
    WindingSampleCounts winding;          ///< samples of operands that are open
    std::vector<char> open;               ///< for each operand whether it is still open after repair
    std::size_t guessed_samples = 0;      ///< samples of the result on no triangle, where an operand is open
    std::size_t fitted = 0;               ///< vertices that were moved onto the faces of shapes
    std::size_t unfitted = 0;             ///< vertices without a point on these faces near enough
    std::size_t result_samples = 0;       ///< samples of the result
    std::size_t retained = 0;             ///< triangles of operands that were kept unchanged
    std::size_t changed = 0;              ///< triangles of operands that stitching split or moved
    std::size_t reconstructed = 0;        ///< triangles made by contouring
    std::size_t unsampled_triangles = 0;  ///< triangles in components that no ray met, which are lost
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

/// The shapes from which the operands were meshed. Their CAD faces are sampled, and reconstructed vertices are put on
/// them.
struct CadOperands {
    std::vector<CadShape> shapes;  ///< without a model for an operand that is a mesh only; empty: all operands are
    geometry::Engine* engine = nullptr;
};

/// The approximate Boolean of Wang 2010 on a uniform grid of rays (method "uniform"), of any number of operands in one
/// pass.
///
/// Operands may intersect themselves. An operand that is open, not oriented or inside out is repaired first (see
/// prepare_operand). If no repair closes it, points whose generalised winding number is at least 0.5 are inside (see
/// sample_by_winding).
///
/// The result is closed, oriented and 2-manifold in its connections. As in the paper it is not guaranteed to be free of
/// self-intersections where it was reconstructed, and features thinner than the distance between rays may be lost.
/// @throws OpenOperand for an open sheet: most of a surface that closes it would be a guess
/// @throws InvalidInput for an option out of range, a resolution whose samples would take more than 2 GB, an operand
///     whose triangles have no area, or operands with different origins
/// @throws Cancelled
UniformResult layered_depth_boolean(const std::vector<const mesh::TriangleMesh*>& operands,
                                    const boolean::Expression& expression, const LayeredDepthOptions& options,
                                    Progress* progress, const CadOperands& cad = {});

/// Prepares the operands of layered_depth_boolean().
/// @throws InvalidInput, OpenOperand, Cancelled as layered_depth_boolean
std::vector<UniformOperand> prepare_uniform(const std::vector<const mesh::TriangleMesh*>& operands,
                                            const boolean::Expression& expression, const LayeredDepthOptions& options,
                                            const Progress* progress);

/// layered_depth_boolean() of prepared operands.
UniformResult layered_depth_boolean(const std::vector<UniformOperand>& prepared, const boolean::Expression& expression,
                                    const LayeredDepthOptions& options, Progress* progress, const CadOperands& cad);

/// layered_depth_boolean() of two operands.
UniformResult layered_depth_boolean(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b,
                                    boolean::Operation operation, const LayeredDepthOptions& options,
                                    Progress* progress);

/// The largest error bound of a result whose operands have a common box with this longest side, mm.
double uniform_bound(double size, int resolution);

/// The least resolution whose error bound is within the tolerance, mm.
/// @throws InvalidInput naming the least tolerance if the highest resolution does not suffice.
int uniform_resolution(double size, double tolerance);

}  // namespace mq::layered_depth
