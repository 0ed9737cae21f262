// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "curve/bezier/simplex_lattice.h"

/// Whether two Bezier triangles meet elsewhere than in the vertices and edges that they share: proofs by the convex
/// hulls of control points and of their differences, on pieces that are halved until a proof succeeds.
namespace mq::curve {

/// What two patches have in common by the nodes of their mesh.
struct SharedEntities {
    /// Vertices: the corner of the first patch and that of the second.
    std::vector<std::array<int, 2>> corners;
    /// Edges, with all control points: two indices into `corners`.
    std::vector<std::array<int, 2>> edges;
    /// Whether they are of different bodies, so that they may touch.
    bool may_touch = false;
};

enum class PatchContact {
    None,       ///< proven: they meet nowhere else
    Touching,   ///< proven: they are on both sides of planes, but for PatchLimits::touching
    Crossing,   ///< proven: one pierces the other
    NotProven,  ///< they touch, or are nearer than the proofs can tell
};

struct PatchVerdict {
    PatchContact contact = PatchContact::None;
    Vec3 point = Vec3::Zero();  ///< about the place where they cross, or where nothing was proven, mm
    int looked_at = 0;          ///< pairs of pieces that were compared
};

/// Pairs of pieces that are compared for one pair of patches, at most: more show nothing more.
constexpr int kMostPiecePairs = 4000;

/// The lengths below which nothing is proven, mm, and the effort.
struct PatchLimits {
    double rounding = 0.0;    ///< bound of the error of control points and of their differences
    double least_size = 0.0;  ///< pieces that are smaller on both sides are not halved
    double touching = 0.0;    ///< distance from a plane of what counts as on it
    int most_pairs = kMostPiecePairs;
};

/// Two different patches of one order.
PatchVerdict contact_of_patches(const Lattice& lattice, const std::vector<Vec3>& a, const std::vector<Vec3>& b,
                                const SharedEntities& shared, const PatchLimits& limits);

/// Whether a patch meets itself: None where each of its points has parameters of its own.
PatchVerdict contact_with_itself(const Lattice& lattice, const std::vector<Vec3>& control, const PatchLimits& limits);

}  // namespace mq::curve
