// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "curve/injectivity/surface_patches.h"
#include "curve/output/curved_mesh.h"

/// Whether the map from the straight surface to the curved one is injective: equation (2) of Dey, O'Bara, Shephard
/// 1999, for the triangles and quadrilaterals of a mesh.
namespace mq::curve {

/// Bound of the work on pairs that a few comparisons of pieces do not decide, such as pairs of bodies that lie on each
/// other: the number of comparisons of pieces for all of these pairs together.
struct CrossingEffort {
    std::size_t base = 2'000'000;
    std::size_t for_each_triangle = 0;
};
/// Takes a small fraction of the time of curving.
constexpr CrossingEffort kQuickEffort{20'000, 30};

/// The pairs of curved sides that meet outside of the vertices and edges that they share, in ascending order. A side
/// that meets itself is the pair (i, i).
struct CurvedCrossings {
    struct Crossing {
        std::int32_t a = -1;
        std::int32_t b = -1;
        Vec3 point = Vec3::Zero();  ///< mm: a point near the place where one pierces the other
    };
    std::vector<Crossing> crossing;  ///< pairs that are proven to cross
    /// Pairs that are neither proven to cross nor to be apart. They touch, lie on each other or are nearer than
    /// `kLeastPiece` of the mesh's size; or the proof needs more comparisons than `kMostPiecePairs` (patch_pair.h) or
    /// the remaining effort allow.
    std::vector<std::pair<std::int32_t, std::int32_t>> not_proven;
    /// Pairs of different bodies that are proven to touch only: a plane separates the two sides, up to 1e-9 of the
    /// mesh's size. Bodies are connected by edges of exactly two triangles.
    std::vector<std::pair<std::int32_t, std::int32_t>> touching;
    std::size_t compared = 0;  ///< pairs whose bounding boxes meet
    std::size_t given_up = 0;  ///< pairs in `not_proven` for which no effort was left

    bool none() const { return crossing.empty() && not_proven.empty(); }
};

/// Compares all curved triangles of a mesh, within bodies and between them. All pairs that are not listed are proven
/// apart, up to bounded rounding errors. Nodes of equal coordinates count as one node. Triangles with the same nodes
/// lie on each other, as do those of two bodies that touch: they count as no crossing.
/// @throws Cancelled.
CurvedCrossings curved_crossings(const CurvedMesh& mesh, Progress* progress = nullptr,
                                 const CrossingEffort& effort = {});
/// Compares sides of elements of any kinds and orders. The pairs contain the numbers of sides.
CurvedCrossings curved_crossings(const SurfacePatches& patches, Progress* progress = nullptr,
                                 const CrossingEffort& effort = {});

}  // namespace mq::curve
