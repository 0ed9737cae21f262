// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "boolean/arrangement/soup.h"
#include "boolean/extraction/result_mesh.h"

namespace mq::boolean {

/// Mean thickness, mm, below which a shell is left out. A shell is a closed surface that hangs together by edges; its
/// mean thickness is twice the volume by the area.
struct ShellThickness {
    /// Shells that are left of closed gaps and of films between common faces: they are made of pieces of several
    /// operands, and one piece at least is of a common face.
    double of_gaps = 0.0;
    /// Every shell with a triangle that no operand has: those that single precision flattens or turns, e.g. where an
    /// operand crosses itself by less than its rounding.
    double of_any = 0.0;
};

/// Removes shells that are too thin. The rest of the result stays closed, as no shell has an edge of another one.
/// @param in_contact  for each triangle of the soup whether it is of a common face, or was moved with one; empty: none
/// @return the number of triangles removed
std::size_t remove_thin_shells(ResultMesh& draft, const Soup& soup, const std::vector<char>& in_contact,
                               const ShellThickness& thickness);

}  // namespace mq::boolean
