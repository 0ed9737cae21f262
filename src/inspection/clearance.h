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
    NearestPlaces nearest;  ///< at distance 0 if the surfaces meet
    /// mm, if the surfaces meet: how deep one body is in the other, by two kinds of points. These are vertices of the
    /// one inside of the other, and middles of the pieces of edges inside. The depth is their largest distance from the
    /// surface of the other body.
    double depth = 0.0;
    /// Volume (mm^3) and surface (mm^2) of the intersection of bodies whose surfaces meet; -1: not known. 0 for all
    /// others.
    double common_volume = 0.0;
    double common_area = 0.0;
    /// Which body lies in the other one without meeting its surface: 0 the first, 1 the second, -1 neither.
    int inside = -1;
    /// The nearest places of each pair of CAD faces that is at most `slack` farther apart than the nearest pair.
    std::vector<NearestPlaces> faces;
};

struct ClearanceOptions {
    /// mm: pairs of bodies farther apart than this are left out.
    double within = std::numeric_limits<double>::infinity();
};

/// The distances of all pairs of bodies: closed, oriented surfaces in one frame; pairs in ascending order. Exact for
/// triangles but for rounding; the same bytes for any number of threads.
/// @param slack  mm, by body; the slack of a pair is the sum of both. See Clearance::faces.
/// @throws Cancelled
std::vector<Clearance> clearances(const std::vector<const mesh::TriangleMesh*>& bodies,
                                  const std::vector<double>& slack, const ClearanceOptions& options,
                                  Progress* progress = nullptr);

}  // namespace mq::inspection
