// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "triangulate/workspace.h"

/// Where two surfaces touch along their common edge, and at the tips of wings, a surface may turn over within nothing
/// beside its border. The normal on the border then says nothing of the triangles there: those that follow the surface
/// count as folded, and nothing can be split. The normal a little inside takes its place.
namespace mq::triangulate {

/// From a point of the border into a triangle beside it.
struct WayIn {
    Vec3 step = Vec3::Zero();
    Vec2 uv_step = Vec2::Zero();
};

/// At right angles from the side that `half_edge` is to the height of the third corner.
WayIn way_across(const mesh::SurfaceMesh& mesh, int half_edge);

/// The normal a little way in from a site on the border of the face, no farther than `Workspace::unseen`, if the
/// surface has turned by more than 60 degrees there; else nothing.
std::optional<Vec3> normal_a_little_inside(const Workspace& work, int face, const mesh::SurfaceMesh::Site& site,
                                           const WayIn& way);

/// Gives that normal to the sites of the first triangles whose own disagrees with these.
void take_normals_from_inside(Workspace& work);

}  // namespace mq::triangulate
