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

/// How long pairs are compared that a few comparisons of pieces do not decide, such as those of bodies that lie on each
/// other: comparisons of pieces, all pairs together.
struct CrossingEffort {
    std::size_t base = 2'000'000;
    std::size_t for_each_triangle = 0;
};
/// A small share of the time that curving takes.
constexpr CrossingEffort kQuickEffort{20'000, 30};

/// The pairs of curved sides that meet elsewhere than in the vertices and edges that they share, by ascending
/// indices. A side that meets itself is the pair (i, i).
struct CurvedCrossings {
    struct Crossing {
        std::int32_t a = -1;
        std::int32_t b = -1;
        Vec3 point = Vec3::Zero();  ///< about the place where one pierces the other, mm
    };
    std::vector<Crossing> crossing;  ///< proven to cross
    /// Neither proven to cross nor to be apart: they touch, or lie on each other, or are nearer than `kLeastPiece` of
    /// the mesh's size; or the proof needs more comparisons than `kMostPiecePairs` (patch_pair.h), or than are left of
    /// the effort.
    std::vector<std::pair<std::int32_t, std::int32_t>> not_proven;
    /// Proven to touch only: of bodies that no edge of two triangles connects, with planes that have them on both
    /// sides, but for 1e-9 of the mesh's size.
    std::vector<std::pair<std::int32_t, std::int32_t>> touching;
    std::size_t compared = 0;  ///< pairs whose bounding boxes meet
    std::size_t given_up = 0;  ///< pairs among those not proven for which nothing was left of the effort

    bool none() const { return crossing.empty() && not_proven.empty(); }
};

/// Compares all curved triangles of a mesh, within bodies and between them: all pairs that are not listed are proven
/// apart, but for rounding errors, which are bounded. Nodes of equal coordinates are one node. Triangles with the same
/// nodes lie on each other, as where two bodies touch: they are no crossing.
/// @throws Cancelled.
CurvedCrossings curved_crossings(const CurvedMesh& mesh, Progress* progress = nullptr,
                                 const CrossingEffort& effort = {});
/// The same for sides of elements of any kinds and orders, which are what the pairs number.
CurvedCrossings curved_crossings(const SurfacePatches& patches, Progress* progress = nullptr,
                                 const CrossingEffort& effort = {});

}  // namespace mq::curve
