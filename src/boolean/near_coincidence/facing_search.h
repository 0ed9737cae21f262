// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boolean/arrangement/soup.h"
#include "boolean/near_coincidence/facing_triangles.h"
#include "mesh/intersection/aabb_tree.h"

namespace mq::boolean {

/// The corners of a triangle.
std::array<Vec3, 3> corners(const Soup& soup, std::int32_t t);
/// The operand of a triangle.
inline std::int32_t operand_of(const Soup& soup, std::int32_t t) {
    return soup.source[static_cast<std::size_t>(t)].operand;
}
/// The box of a triangle that moves along its normal to both sides, and that is larger by a margin, mm.
Box swept(const std::array<Vec3, 3>& q, double reach, double margin = 0.0);

/// Finds triangles of different operands that face each other. The soup is referred to.
class FacingSearch {
  public:
    /// @param reach  mm, at least as much as is asked for later
    FacingSearch(const Soup& soup, double reach);

    /// The triangles whose boxes come within the reach of the box of another operand, in ascending order.
    const std::vector<std::int32_t>& near() const { return near_; }

    /// visit(earlier, overlap) for each triangle of an earlier operand that a triangle faces.
    /// @param reach, margin  as for overlap_of
    template <typename Visit>
    void for_each_facing(std::int32_t later, double reach, double margin, const Visit& visit) const {
        const std::array<Vec3, 3> q = corners(soup_, later);
        tree_.for_each_in_box(swept(q, reach, margin), [&](std::int32_t earlier) {
            if (operand_of(soup_, earlier) < operand_of(soup_, later)) {
                const Overlap overlap = overlap_of(corners(soup_, earlier), q, reach, margin);
                if (overlap.area > 0.0) {
                    visit(earlier, overlap);
                }
            }
        });
    }

  private:
    const Soup& soup_;
    const std::vector<std::int32_t> near_;
    const mesh::AabbTree tree_;
};

}  // namespace mq::boolean
