// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "geometry/engine.h"

namespace mq::given {

/// The triangles of a given surface, as they are, compared with the CAD; by triangle.
struct GivenSurfaceMeasures {
    std::vector<std::int32_t> face;  ///< the CAD face of the shape
    std::vector<double>
        quality;  ///< lower bound of min J / max J against the CAD normal; not positive: the triangle folds
    std::vector<double> deviation;  ///< mm: largest distance from the CAD face of 33 points between the nodes
};

/// Classifies the triangles of a surface on the CAD and measures them with the nodes that they have.
/// @param order      1 to 5
/// @param triangles  the nodes of all triangles, one triangle after another, in Gmsh's order
/// @throws as match().
GivenSurfaceMeasures measure_given_surface(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                                           const std::vector<Vec3>& nodes, int order,
                                           const std::vector<std::int32_t>& triangles, Progress* progress = nullptr);

}  // namespace mq::given
