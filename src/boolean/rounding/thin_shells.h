// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "boolean/arrangement/soup.h"
#include "boolean/extraction/result_mesh.h"

namespace mq::boolean {

/// Removes what is left of closed gaps and films between common faces: the shells of a result, closed surfaces that
/// hang together by edges, whose mean thickness, twice the volume by the area, is below a length, which are made of
/// pieces of several operands, and of which one at least is a piece of a common face. The rest of the result stays
/// closed, as no shell has an edge of another one.
/// @param in_contact  for each triangle of the soup whether it is of a common face, or was moved with one
/// @param thickness   mm
/// @return the number of triangles removed
std::size_t remove_thin_shells(ResultMesh& draft, const Soup& soup, const std::vector<char>& in_contact,
                               double thickness);

}  // namespace mq::boolean
