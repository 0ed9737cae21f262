// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "mesh/triangle_mesh.h"

namespace mq::offset {

struct OffsetOptions {
    double distance = 0.0;   ///< mm; for a solid: outward if positive, inward if negative
    double tolerance = 0.0;  ///< mm: the largest distance between the result and the exact one, in both directions
    int threads = 0;         ///< threads to use, as in BooleanOptions::threads
    /// By corner of the input's triangles: the outward unit normal of the CAD face there; zero if it is not known.
    /// Empty if none is known.
    std::vector<Vec3> corner_normals{};
    /// @throws InvalidInput naming the option
    void validate() const;
};

/// A closed surface at a distance from another one, with its counts.
struct OffsetResult {
    mesh::TriangleMesh mesh;
    /// For each triangle the input's triangle from which it is offset, itself or as a piece of the strip along an edge.
    std::vector<std::int32_t> triangle_source;
    /// mm, proven: no point of the result is farther than this from the exact distance, and no point of the exact
    /// offset is farther from the result. Excepted are gaps between offsets that are thinner than twice the tolerance:
    /// these may close. For a contour the second bound holds at the nodes of its lattice only (see RefinedCells).
    double error_bound = 0.0;
    std::size_t raw_triangles = 0;  ///< number before trimming; for a contour 0, as is the number of pairs
    std::size_t crossing_pairs = 0;
    StageTimes seconds;
};

/// The boundary of all points within a distance of a solid; for a negative distance, of those of its points that are
/// farther than that from its surface. Sharp edges are rounded on the outer side and kept on the inner one, as in the
/// exact offset.
///
/// The raw offset of the surface is divided along its self-intersections (arrange), the cells within the distance are
/// taken (assign_dilation), and their boundary is rounded (snap_round).
/// @param solid  closed, oriented outward, without self-intersections, as the results of boolean() are
/// @throws InvalidInput for an option out of range
/// @throws TopologyError if the result cannot be held in single precision, or more triangles cross than may be divided
/// @throws Cancelled
OffsetResult offset(const mesh::TriangleMesh& solid, const OffsetOptions& options, Progress& progress);

/// The boundary of all points within a distance of some triangles of a surface, on both of their sides.
/// @param left_out  for each triangle whether it is left out; the surface may be open along these triangles
/// @throws as offset(); InvalidInput if all triangles are left out or the distance is below 0
OffsetResult thicken(const mesh::TriangleMesh& surface, const std::vector<char>& left_out, const OffsetOptions& options,
                     Progress& progress);

}  // namespace mq::offset
