// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

struct OffsetOptions {
    double distance = 0.0;   ///< mm; of a solid: outward where positive, inward where negative
    double tolerance = 0.0;  ///< mm: the largest distance between the result and the exact one, in both directions
    int threads = 0;         ///< as BooleanOptions::threads
    /// For each corner of the input's triangles the unit normal of its CAD face there, outward; zero where it is not
    /// known; empty: nowhere.
    std::vector<Vec3> corner_normals{};
    /// @throws InvalidInput naming the option
    void validate() const;
};

/// A closed surface at a distance from another one, and its counts.
struct OffsetResult {
    mesh::TriangleMesh mesh;
    /// The input's triangle from which each triangle, or the strip along its edge, is offset.
    std::vector<std::int32_t> triangle_source;
    /// mm, proven: no point of the result is farther than this from the exact distance, and none of the exact offset
    /// farther from the result, but for gaps between offsets thinner than twice the tolerance, which may close.
    /// Of a contour the last is so at the nodes of its lattice (see RefinedCells).
    double error_bound = 0.0;
    std::size_t raw_triangles = 0;  ///< triangles before it was trimmed; 0 of a contour, as the pairs are
    std::size_t crossing_pairs = 0;
    StageTimes seconds;
};

/// The boundary of all points within a distance of a solid, or of those of its points that are farther than that from
/// its surface: sharp edges are rounded on the outer side and kept on the inner one, as the exact offset has them.
///
/// The raw offset of the surface is divided along its self-intersections (arrange), those of its cells are taken that
/// lie within the distance (settle_dilation), and their boundary is rounded (snap_round).
/// @param solid  closed, oriented outward, without self-intersections: what boolean() gives
/// @throws InvalidInput for an option out of range
/// @throws TopologyError where the result cannot be held in single precision, and where more triangles cross than may
/// @throws Cancelled
OffsetResult offset(const mesh::TriangleMesh& solid, const OffsetOptions& options, Progress& progress);

/// The boundary of all points within a distance of some triangles of a surface, on both of their sides.
/// @param left_out  for each triangle of the surface, which may be open where they are left out
/// @throws as offset; InvalidInput where all triangles are left out, and for a distance below 0
OffsetResult thicken(const mesh::TriangleMesh& surface, const std::vector<char>& left_out, const OffsetOptions& options,
                     Progress& progress);

}  // namespace mq::boolean
