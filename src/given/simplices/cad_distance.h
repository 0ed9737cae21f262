// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "geometry/engine.h"

namespace mq::given {

/// How far sampled points of the CAD faces and edges are from a surface mesh: distances in this direction show missing
/// regions of the mesh.
struct CadDistances {
    std::vector<double> of_face;  ///< mm, by face of the shape, its edges included; 0 for faces without area
    Vec3 farthest = Vec3::Zero();
    double spacing = 0.0;  ///< mm, the largest distance between neighbouring samples of a face or an edge
    std::size_t samples = 0;
    /// A grid of (u, v) on a face of the shape, or on a piece of it. The grid points inside of the face were sampled.
    struct FaceGrid {
        int face = -1;
        std::array<double, 2> low{};
        std::array<double, 2> high{};
        int columns = 0;  ///< steps along u
        int rows = 0;
    };
    /// Evenly spaced parameters of an edge of the shape, or of a piece of it.
    struct EdgeGrid {
        int edge = -1;
        double low = 0.0;
        double high = 0.0;
        int steps = 0;
    };
    std::vector<FaceGrid> face_grids;
    std::vector<EdgeGrid> edge_grids;  ///< creases inside of faces are not listed
};

/// Samples a grid on each CAD face, and its edges, and finds the nearest point of the curved triangles. The number
/// of samples is about kSamplesOfTriangle times that of the triangles, and at least kLeastSamples in all.
/// @param order      1 to 5
/// @param triangles  the nodes of all triangles, one triangle after another, in Gmsh's order
/// @throws InvalidInput if there are no triangles or the order is out of range; Cancelled.
CadDistances cad_distances(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                           const std::vector<Vec3>& nodes, int order, const std::vector<std::int32_t>& triangles,
                           Progress* progress = nullptr);

constexpr double kSamplesOfTriangle = 2.0;
constexpr double kLeastSamples = 4000.0;

}  // namespace mq::given
