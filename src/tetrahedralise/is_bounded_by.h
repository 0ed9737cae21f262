// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

namespace mq::tetrahedralise {

/// Whether the tetrahedra share their triangles two by two, but for those of the surface.
bool is_bounded_by(const std::vector<std::array<int, 3>>& surface, const std::vector<std::array<int, 4>>& tetrahedra);

}  // namespace mq::tetrahedralise
