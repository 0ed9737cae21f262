// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "mesh/triangle_mesh.h"

namespace mq::inspection {

/// The nearest places of two surfaces, or of one CAD face of each.
struct NearestPlaces {
    double distance = std::numeric_limits<double>::infinity();  ///< mm
    std::array<std::int32_t, 2> triangles{-1, -1};
    std::array<Vec3, 2> points{Vec3::Zero(), Vec3::Zero()};
};

/// How near two bodies are to each other.
struct Clearance {
    std::array<std::int32_t, 2> bodies{};
    NearestPlaces nearest;  ///< at distance 0 where their surfaces meet
    /// Where their surfaces meet, the largest distance from the surface of the other body of vertices that lie in it,
    /// and of the middles of what lies in it of edges that go through it, mm.
    double depth = 0.0;
    /// What bodies whose surfaces meet have in common, mm^3, and its surface, mm^2; -1: not known. 0 of others.
    double common_volume = 0.0;
    double common_area = 0.0;
    /// The body that lies in the other one without meeting its surface: 0 the first, 1 the second, -1: none does.
    int inside = -1;
    /// The nearest places of the pairs of CAD faces that are at most `slack` farther than the nearest ones.
    std::vector<NearestPlaces> faces;
};

struct ClearanceOptions {
    /// Pairs of bodies farther from each other than this are left out, mm.
    double within = std::numeric_limits<double>::infinity();
};

/// The distances of all pairs of bodies: closed, oriented surfaces in one frame; pairs in ascending order. Exact for
/// the triangles but for rounding; the same bytes for any number of threads.
/// @param slack  mm, by body; that of a pair is the sum. See Clearance::faces.
/// @throws Cancelled
std::vector<Clearance> clearances(const std::vector<const mesh::TriangleMesh*>& bodies,
                                  const std::vector<double>& slack, const ClearanceOptions& options,
                                  Progress* progress = nullptr);

}  // namespace mq::inspection
