// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "geometry/engine.h"

namespace mq::curve {

/// How far sampled points of the CAD faces and edges are from a surface mesh: the direction that shows what is missing.
struct CadDistances {
    std::vector<double> of_face;  ///< mm, by face of the shape, its edges counted with it; 0 of faces without area
    Vec3 farthest = Vec3::Zero();
    double spacing = 0.0;  ///< mm, the largest distance of samples that are next to each other on a face or an edge
    std::size_t samples = 0;
    /// A grid of (u, v) on a face of the shape, or on a piece of it: those inside of it were sampled.
    struct FaceGrid {
        int face = -1;
        std::array<double, 2> low{};
        std::array<double, 2> high{};
        int columns = 0;  ///< steps along u
        int rows = 0;
    };
    /// Even parameters of an edge of the shape, or of a piece of it.
    struct EdgeGrid {
        int edge = -1;
        double low = 0.0;
        double high = 0.0;
        int steps = 0;
    };
    std::vector<FaceGrid> face_grids;
    std::vector<EdgeGrid> edge_grids;  ///< creases inside of faces are not listed
};

/// Samples a grid of each CAD face, and its edges, and looks for the nearest point of the curved triangles. The number
/// of samples is about kSamplesOfTriangle times that of the triangles, and at least kLeastSamples in all.
/// @param order      1 to 5
/// @param triangles  the nodes of one after those of the other, in Gmsh's order
/// @throws InvalidInput where there are none or the order is another; Cancelled.
CadDistances cad_distances(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                           const std::vector<Vec3>& nodes, int order, const std::vector<std::int32_t>& triangles,
                           Progress* progress = nullptr);

constexpr double kSamplesOfTriangle = 2.0;
constexpr double kLeastSamples = 4000.0;

}  // namespace mq::curve
