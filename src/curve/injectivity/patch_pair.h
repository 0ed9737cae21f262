// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "elements/bezier/simplex_lattice.h"

/// Whether two Bezier triangles meet outside of the vertices and edges that they share. Proofs use the convex hulls of
/// control points and of their differences, on pieces that are halved until a proof succeeds.
namespace mq::curve {

/// The vertices and edges that two patches share as elements of a mesh.
struct SharedEntities {
    /// Shared vertices: the corner of the first patch and the corner of the second one.
    std::vector<std::array<int, 2>> corners;
    /// Shared edges, all of whose control points are equal: two indices into `corners`.
    std::vector<std::array<int, 2>> edges;
    /// Whether the patches belong to different bodies, so that they may touch.
    bool may_touch = false;
};

enum class PatchContact {
    None,       ///< proven: they meet only in what they share
    Touching,   ///< proven: they lie on two sides of a plane, up to PatchLimits::touching
    Crossing,   ///< proven: one pierces the other
    NotProven,  ///< they touch, or are nearer than the proofs can decide
};

struct PatchVerdict {
    PatchContact contact = PatchContact::None;
    Vec3 point = Vec3::Zero();  ///< mm: near the crossing, or near a place that is not decided
    int looked_at = 0;          ///< pairs of pieces that were compared
};

/// Most pairs of pieces that are compared for one pair of patches; more comparisons decided no further pair.
constexpr int kMostPiecePairs = 4000;

/// The lengths (mm) below which nothing is proven, and the bound of the work.
struct PatchLimits {
    double rounding = 0.0;    ///< bound of the error of control points and of their differences
    double least_size = 0.0;  ///< pairs whose pieces are both smaller are not halved
    double touching = 0.0;    ///< up to this distance from a plane a point counts as on it
    int most_pairs = kMostPiecePairs;
};

/// How two different patches of one order meet.
PatchVerdict contact_of_patches(const elements::Lattice& lattice, const std::vector<Vec3>& a,
                                const std::vector<Vec3>& b, const SharedEntities& shared, const PatchLimits& limits);

/// Whether a patch meets itself. None: each of its points has only one pair of parameters.
PatchVerdict contact_with_itself(const elements::Lattice& lattice, const std::vector<Vec3>& control,
                                 const PatchLimits& limits);

}  // namespace mq::curve
