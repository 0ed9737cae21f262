// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/intersection/needle_frame.h"
#include "mesh/intersection/triangle_contact.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Two triangles, a < b, that meet elsewhere than in the vertices or the edge that they share by index.
struct ContactPair {
    std::int32_t a = -1;
    std::int32_t b = -1;
    Contact contact = Contact::None;
};

/// The value of a limit that lists all pairs.
constexpr std::size_t kAllPairs = std::numeric_limits<std::size_t>::max();

/// The limit for pairs that are only counted: a report with this count says "at least".
constexpr std::size_t kMostCounted = 1'000'000;

/// A search for contacts whose tree also serves other queries. Vertices and triangles must outlive it.
class SelfIntersectionSearch {
  public:
    /// @throws Cancelled
    SelfIntersectionSearch(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                           const Progress* progress);
    /// See self_intersections. Sets the groups of the tree.
    /// @throws Cancelled
    std::vector<ContactPair> pairs(std::size_t limit = kAllPairs);

    /// A tree over all triangles, in the coordinates of the frame.
    AabbTree& tree() { return *tree_; }
    const NeedleFrame& frame() const { return *frame_; }

  private:
    const std::vector<Vec3>& vertices_;
    const std::vector<Triangle>& triangles_;
    const Progress* progress_;
    std::vector<std::int32_t> patch_;  ///< for each triangle (height_fields)
    std::optional<NeedleFrame> frame_;
    std::optional<AabbTree> tree_;
};

/// All pairs of triangles of a mesh that touch or cross each other, in ascending order; at most `limit` of them. If
/// fewer are returned the list is complete.
///
/// Exact (see contact). About 0.3 s for a million triangles without self-intersection: nearly all of them are in
/// patches that are height fields, so that only pairs of different patches are tested (see height_fields); where those
/// share a vertex, its star decides (see embedded_star). Every vertex index must be in range and every coordinate
/// finite.
/// @throws Cancelled.
std::vector<ContactPair> self_intersections(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                                            std::size_t limit = kAllPairs, const Progress* progress = nullptr);

/// The pairs of which at least one triangle is in `subset` (indices, each once). The time is proportional to the subset
/// and the triangles near it, plus 50 ns for every other one.
std::vector<ContactPair> self_intersections_with(const std::vector<Vec3>& vertices,
                                                 const std::vector<Triangle>& triangles,
                                                 const std::vector<std::int32_t>& subset, std::size_t limit = kAllPairs,
                                                 const Progress* progress = nullptr);

}  // namespace mq::mesh
