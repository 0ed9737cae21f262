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
/// Points of the solid are below the planes of the openings. So what is nearest to them on a prism's sides is on the
/// rim, which belongs to the walls, too. Openings that meet in a convex edge have a face between their prisms. Walls
/// that stand upright on an opening go on above it, so that the offset has no vertices in its plane, where it is cut.
/// @param solid  closed, oriented outward; its triangle_face, where there is one, goes on along the prisms
/// @param open  for each of its triangles
/// @return nothing where an opening is not plane, or what is near to a prism rises above its opening: there that does
///     not hold
std::optional<mesh::TriangleMesh> extend_openings(const mesh::TriangleMesh& solid, const std::vector<char>& open,
                                                  const ExtensionOptions& options);

}  // namespace mq::boolean
