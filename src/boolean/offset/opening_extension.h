// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::boolean {

struct ExtensionOptions {
    double thickness = 0.0;  ///< mm: of the wall, farther than which the ends of the prisms are from the solid
    double flatness = 0.0;  ///< mm: how far from its plane an opening's vertices may be, and walls from where they were
};

/// A solid with a prism on each of its openings, which are plane: its offset inward by the thickness is, within the
/// solid, all that is deeper in it than that, from those of its triangles that are not open.
///
/// The prisms are apart from the solid and from each other. So the way from a point of the solid to a prism's side
/// leaves the solid through a wall, or through the opening of that prism, from below its plane. Then the rim, which
/// belongs to the walls, is as near. Openings that meet in a convex edge have a face between their prisms. Where a wall
/// rises from a rim, the prism leans away from it by an angle, so that a gap is left; this makes an error of less than
/// the flatness. Walls that stand upright on an opening go on above it, so that the offset has no vertices in its
/// plane, where it is cut.
/// @param solid  closed, oriented outward; its triangle_face, where there is one, goes on along the prisms
/// @param open  for each of its triangles
/// @return nothing where an opening is not plane, or a prism would meet the solid or another prism
std::optional<mesh::TriangleMesh> extend_openings(const mesh::TriangleMesh& solid, const std::vector<char>& open,
                                                  const ExtensionOptions& options);

}  // namespace mq::boolean
