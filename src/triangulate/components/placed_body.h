// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <vector>

#include "base/single_precision_grid.h"
#include "geometry/session.h"
#include "triangulate/components/equal_bodies.h"
#include "triangulate/components/mesh_components.h"

namespace mq::triangulate {

/// Allowed distance, in resolutions, between a vertex that was moved with its body and the point of the CAD model at
/// its parameters: one rounding to the grid and one projection, each with a reserve.
constexpr double kOffPlace = 4.0;

/// The vertices of a mesh at the CAD nodes of some triangles, by node.
std::map<int, int> vertices_of_nodes(const ClassifiedMesh& mesh, const std::vector<int>& triangles);

/// Adds a copy of a body's mesh to a component, as the last of its entities in the same order, classified on the
/// copy's own entities. Vertices have the same parameters as those of the original, and are the points of the copy's
/// own nodes, curves and surfaces there, rounded to the grid.
///
/// Nothing is added where these points are not the moved ones of the original, or where rounding turns a triangle over.
/// @param original  the mesh of the body without unused indices
/// @param whole  the mesh to which the component will belong: its vertices at the copy's nodes are `nodes`
/// @return whether the copy was added
/// @throws Cancelled
bool add_placed(geometry::Session& session, const SinglePrecisionGrid& grid, const ClassifiedMesh& original,
                const EqualBodies& equal, int copy, const ClassifiedMesh& whole, const std::map<int, int>& nodes,
                MeshComponent& component);

}  // namespace mq::triangulate
