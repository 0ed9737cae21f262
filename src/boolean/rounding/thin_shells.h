// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "boolean/arrangement/soup.h"
#include "boolean/extraction/result_mesh.h"

namespace mq::boolean {

/// Mean thickness, mm, below which a shell is removed. A shell is a closed surface that is connected by edges; its mean
/// thickness is twice the volume divided by the area.
struct ShellThickness {
    /// For shells that closed gaps and films between common faces leave: they consist of pieces of several operands,
    /// and at least one piece belongs to a common face.
    double of_gaps = 0.0;
    /// For every shell with a triangle that no operand has: single precision flattens or reverses some, e.g. where an
    /// operand crosses itself by less than its rounding.
    double of_any = 0.0;
};

/// Removes shells that are too thin. The rest of the result stays closed, as no shell has an edge of another one.
/// @param in_contact  for each triangle of the soup whether it is of a common face, or was moved with one; empty: none
/// @return the number of triangles removed
std::size_t remove_thin_shells(ResultMesh& draft, const Soup& soup, const std::vector<char>& in_contact,
                               const ShellThickness& thickness);

}  // namespace mq::boolean
