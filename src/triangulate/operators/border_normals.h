// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "triangulate/work_mesh/workspace.h"

/// Where two surfaces are tangent along their common edge, and at the tips of wings, the normal of a surface may
/// reverse within the resolution of its border. The normal on the border then does not represent the triangles there:
/// those that follow the surface count as folded, and nothing can be split. The normal slightly inside replaces it.
namespace mq::triangulate {

/// A step from a point of the border into a triangle beside it: in space (mm) and in (u, v).
struct InwardStep {
    Vec3 step = Vec3::Zero();
    Vec2 uv_step = Vec2::Zero();
};

/// Returns the step perpendicular to the side `half_edge`, as long as the height of the third corner.
InwardStep inward_step(const ClassifiedMesh& mesh, int half_edge);

/// Returns the normal inside of a site on the border of the face, at a distance of at most `Workspace::unseen`, if it
/// deviates there by more than 60 degrees; else nothing.
std::optional<Vec3> interior_normal(const Workspace& work, int face, const ClassifiedMesh::VertexUse& site,
                                    const InwardStep& way);

/// Assigns that normal to border sites whose own normal disagrees with the initial triangles.
void use_interior_normals(Workspace& work);

}  // namespace mq::triangulate
