// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "base/message.h"
#include "base/progress.h"
#include "base/stopwatch.h"
#include "boolean/input/operation.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// The finest tolerance of a Boolean as a fraction of the size of its operands: four units of single precision.
constexpr double kFinestTolerance = 4.0 * std::numeric_limits<float>::epsilon();
/// @throws InvalidInput for a finer tolerance, mm, of operands of this size, mm.
void require_possible(double tolerance, double size);

struct BooleanOptions {
    /// The largest distance between the result and the exact one, mm. 0: computed from `resolution`.
    double tolerance = 0.0;
    /// Cells along the longest side of the operands' box; the tolerance is then sqrt(3) times the side of a cell, the
    /// bound of Wang 2010, section IV.A.
    int resolution = 512;
    /// mm, the length that `resolution` divides; 0: that longest side. A shorter length keeps the tolerance below the
    /// thickness of slender operands.
    double length = 0.0;
    /// Threads that work at a time; 0: one for each core, or as many as MESHQUALITY_THREADS says. The result is the
    /// same for any number.
    int threads = 0;
    /// Whether the method "uniform" reconstructs the whole surface from its samples (Wang 2010, Table III); other
    /// methods have no samples.
    bool full = false;
    /// Whether the operands have the intended orientation, so that components stay as they are turned. If false,
    /// components that bound a volume inside out are reversed.
    bool oriented = false;

    /// Returns `tolerance`, mm, if it is set; else that of `resolution` for `length`, or for `size`, the longest side
    /// of the operands' box.
    double tolerance_for(double size) const;
    /// @throws InvalidInput naming the option
    void validate() const;
};

/// The result of a Boolean of closed meshes, and its counts and notes.
struct BooleanResult {
    mesh::TriangleMesh mesh;
    /// Operand and triangle index there of each triangle that is an operand's own, bit for bit (reversed where the
    /// result has its outside within the operand); {-1, -1} for triangles made or changed here.
    std::vector<std::array<std::int32_t, 2>> triangle_source;
    /// Operand and triangle index there of which each triangle is a piece, also where it was moved; {-1, -1} for
    /// triangles that fill holes of operands.
    std::vector<std::array<std::int32_t, 2>> triangle_origin;
    /// mm. Bound for the distance between the surface of the result and that of the exact Boolean, in both directions.
    /// Excepted are slivers and gaps thinner than 1.75 closed_gaps, or than half the spacing of single-precision
    /// numbers, which may have vanished. Rounding and the closing of cracks count by how far they move points. The
    /// effect of moved common faces is measured (measure_error), as most of the moved surface is not in the result.
    double error_bound = 0.0;
    /// mm, the widest gap or sliver between common faces of operands that was closed; 0: none was.
    double closed_gaps = 0.0;
    std::size_t retained = 0;       ///< triangles that an operand has unchanged
    std::size_t reconstructed = 0;  ///< all other triangles
    std::size_t crossing_pairs = 0;
    std::size_t curve_edges = 0;         ///< on the intersection curves
    std::size_t separated_contacts = 0;  ///< points in which regions of the result touched
    std::size_t separated_vertices = 0;  ///< vertices moved beyond common faces of another operand
    /// Triangles of the operands at which the result touches or crosses itself or is not manifold: 0, or an error is
    /// raised.
    std::size_t faults_left = 0;
    /// Components and Euler number of each operand; with 0 components if it had to be repaired.
    std::vector<mesh::SurfaceTopology> operand_topology;
    std::vector<Message> repaired;  ///< a sentence for each operand, empty when there was nothing to do
    std::vector<Message> notes;
    StageTimes seconds;
};

/// Joins, intersects or subtracts any number of closed meshes; the operation is applied from the first operand on.
///
/// The operands' triangles are intersected exactly; where their surfaces cross, triangles are divided, everywhere else
/// they are kept as they are. Bodies that meet in an edge or a vertex only are separated; surfaces that nearly
/// coincide, within the tolerance, are separated, too. Operands may intersect themselves: inside is where an operand
/// winds around at least once (the normal index of Wang 2010, section V.C). They are repaired first, see
/// prepare_operand.
///
/// All vertices made here are single-precision numbers when those of the operands are.
/// @throws InvalidInput for an option out of range, or an operand that cannot be repaired, naming it
/// @throws TopologyError when the surfaces do not bound volumes
/// @throws Cancelled
BooleanResult boolean(const std::vector<const mesh::TriangleMesh*>& operands, Operation operation,
                      const BooleanOptions& options, Progress* progress = nullptr);

/// Evaluates any expression of the operands in one arrangement: nothing is rounded between its operations.
BooleanResult boolean(const std::vector<const mesh::TriangleMesh*>& operands, const Expression& expression,
                      const BooleanOptions& options, Progress* progress = nullptr);

}  // namespace mq::boolean
