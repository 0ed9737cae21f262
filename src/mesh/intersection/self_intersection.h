// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/progress.h"
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

/// The value of a limit for pairs that are only counted: a report that counts as many says that there are more.
constexpr std::size_t kMostCounted = 1'000'000;

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
