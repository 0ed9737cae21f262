// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "curve/output/curved_mesh.h"

/// Whether the map from the straight surface to the curved one is injective: equation (2) of Dey, O'Bara, Shephard
/// 1999, for the triangles of a mesh.
namespace mq::curve {

/// Pieces of curved triangles smaller than this share of the mesh's size are not halved any more.
constexpr double kLeastPiece = 1e-6;

/// Pairs that cross or are not proven apart from which on no more are looked for; each may take milliseconds.
constexpr std::size_t kMostFound = 500;

/// The pairs of curved triangles that meet elsewhere than in the vertices and edges that they share, by ascending
/// indices. A triangle that meets itself is the pair (i, i).
struct CurvedCrossings {
    struct Crossing {
        std::int32_t a = -1;
        std::int32_t b = -1;
        Vec3 point = Vec3::Zero();  ///< about the place where one pierces the other, mm
    };
    std::vector<Crossing> crossing;  ///< proven to cross
    /// Neither proven to cross nor to be apart: they touch, or lie on each other, or are nearer than `kLeastPiece` of
    /// the mesh's size; or the proof needs more than `kMostPiecePairs` (patch_pair.h) comparisons.
    std::vector<std::pair<std::int32_t, std::int32_t>> not_proven;
    std::size_t compared = 0;  ///< pairs whose bounding boxes meet
    /// Whether all of them were: the search ends once kMostFound pairs are found, as where bodies lie on each other.
    bool complete = true;

    bool none() const { return crossing.empty() && not_proven.empty(); }
};

/// Compares all curved triangles of a mesh, within bodies and between them: all pairs that are not listed are proven
/// apart, but for rounding errors, which are bounded. Nodes of equal coordinates are one node. Triangles with the same
/// nodes lie on each other, as where two bodies touch: they are no crossing.
/// @throws Cancelled.
CurvedCrossings curved_crossings(const CurvedMesh& mesh, Progress* progress = nullptr);

}  // namespace mq::curve
