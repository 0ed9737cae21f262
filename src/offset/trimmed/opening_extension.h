// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::offset {

struct ExtensionOptions {
    double thickness = 0.0;  ///< mm: thickness of the wall; the ends of the prisms are farther from the solid
    double flatness = 0.0;   ///< mm: most that an opening's vertices are off its plane, and that walls are moved
};

/// A solid with a prism on each of its plane openings. The offset of the result inward by the thickness, cut to the
/// solid, consists of the points of the solid that are farther than the thickness from its walls (the triangles that
/// are
/// not open).
/// The prisms are apart from the solid and from each other. So the shortest way from a point of the solid to the side
/// of a prism leaves the solid through a wall, or through the opening below that prism; then the rim, which belongs to
/// the walls, is as near. Openings that meet in a convex edge have a face between their prisms. If a wall rises from a
/// rim, the prism leans away from the wall by an angle that leaves a gap; the error of this is less than the flatness.
/// Walls that stand upright on an opening are extended above it, so that the offset has no vertices in the plane of the
/// opening, where it is cut.
/// @param solid  closed, oriented outward; its triangle_face, if it has one, is extended along the prisms
/// @param open  for each triangle of the solid whether it belongs to an opening
/// @return nothing if an opening is not plane, or a prism would meet the solid or another prism
std::optional<mesh::TriangleMesh> extend_openings(const mesh::TriangleMesh& solid, const std::vector<char>& open,
                                                  const ExtensionOptions& options);

}  // namespace mq::offset
