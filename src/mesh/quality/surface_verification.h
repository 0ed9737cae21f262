// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// The kinds of faults of a result.
enum class FaultKind {
    OpenEdge,            ///< an edge with one triangle
    NonmanifoldEdge,     ///< an edge with three or more triangles, or with two that run along it the same way
    PinchedVertex,       ///< the triangles around a vertex are not one fan
    DegenerateTriangle,  ///< corners on one line, exactly
    CoincidentVertices,  ///< two vertices in one place
    Crossing,            ///< the interiors of two triangles meet
    Touching,  ///< two triangles meet elsewhere than in common vertices or edges, but not with their interiors
};
/// The number of kinds.
constexpr std::size_t kFaultKinds = 7;

/// The name of a kind: "open edge" and so on.
const char* name(FaultKind kind);

struct Fault {
    FaultKind kind = FaultKind::OpenEdge;
    Vec3 position = Vec3::Zero();  ///< in the mesh's frame: on the fault, or between the triangles that meet there
    /// Triangles at fault; for an edge or a vertex one or two that have it.
    std::array<std::int32_t, 2> triangles{-1, -1};
    std::array<std::int32_t, 2> vertices{-1, -1};  ///< the ends of the edge; the vertex; or the vertices in one place
};

struct Verification {
    std::vector<Fault> faults;  ///< sorted by kind, then by triangles; at most the limit for each kind
    std::array<std::size_t, kFaultKinds>
        count{};          ///< number of each kind, up to the limit for contacts, in full for the others
    double volume = 0.0;  ///< signed volume, mm^3; for a closed surface only

    bool passed() const { return faults.empty(); }
    /// "2 open edges, first at (1, 2, 3) mm; ..." or "none"; `origin` is that of the mesh's frame.
    std::string summary(const Vec3& origin = Vec3::Zero()) const;
};

/// Checks a surface by its indices and coordinates alone: closed, every edge with two opposite directed edges, every
/// vertex with one fan, no degenerate triangle, no two vertices in one place, no two triangles that touch or cross. All
/// tests are exact. About 0.75 us a triangle; vertices that no triangle names do not matter.
///
/// @param changed  when given, only contacts with one of these triangles (indices, each once) are searched, in a fifth
/// of the time; the rest of the surface must be known to be free of contacts
/// @param limit  faults listed for each kind
/// @throws Cancelled.
Verification verify(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                    const std::vector<std::int32_t>* changed = nullptr, std::size_t limit = 1000,
                    const Progress* progress = nullptr);

}  // namespace mq::mesh
