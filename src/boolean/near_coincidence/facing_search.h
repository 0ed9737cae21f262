// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
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

    /// Triangles near those of other operands: at least all that are within the reach of one; in ascending order.
    const std::vector<std::int32_t>& near() const { return near_; }

    /// visit(earlier, overlap) for each triangle of an earlier operand that a triangle faces.
    /// @param reach, margin  as for overlap_of
    template <typename Visit>
    void for_each_facing(std::int32_t later, double reach, double margin, const Visit& visit) const {
        const std::array<Vec3, 3> q = corners(soup_, later);
        const BoundingCircle circle(q);
        const Box box = swept(q, reach, margin);
        for (const std::size_t operand : earlier_[static_cast<std::size_t>(operand_of(soup_, later))]) {
            trees_[operand]->for_each_in_box(box, [&](std::int32_t earlier) {
                const std::array<Vec3, 3> p = corners(soup_, earlier);
                if (circle.meets_column_of(p, margin)) {
                    const Overlap overlap = overlap_of(p, q, reach, margin);
                    if (overlap.area > 0.0) {
                        visit(earlier, overlap);
                    }
                }
            });
        }
    }

  private:
    /// A circle in the plane of a triangle, around it.
    struct BoundingCircle {
        explicit BoundingCircle(const std::array<Vec3, 3>& q);
        /// False only if, seen along the circle's axis, a triangle enlarged by the margin does not meet it.
        bool meets_column_of(const std::array<Vec3, 3>& p, double margin) const;

        Vec3 middle;
        Vec3 axis;
        double radius = 0.0;
    };

    const Soup& soup_;
    const std::vector<std::int32_t> near_;
    std::vector<std::unique_ptr<mesh::AabbTree>> trees_;  ///< by operand, of its triangles near others
    std::vector<std::vector<std::size_t>> earlier_;       ///< by operand, those before it that come near its box
};

}  // namespace mq::boolean
