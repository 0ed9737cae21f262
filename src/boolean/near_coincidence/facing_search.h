// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "boolean/arrangement/soup.h"
#include "boolean/near_coincidence/triangle_overlap.h"
#include "boolean/near_coincidence/tuning.h"
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

/// A circle in the plane of a triangle, around it.
struct BoundingCircle {
    explicit BoundingCircle(const std::array<Vec3, 3>& q);
    /// False only if a triangle in this circle and one in another circle, enlarged by a margin, do not face each other:
    /// their planes differ by more than 45 degrees, or they lie side by side, seen along the axis.
    bool may_face(const BoundingCircle& other, double margin) const {
        // Normals have rounding errors; overlap_of decides.
        constexpr double kNormalRounding = 1e-9;
        const Vec3 way = other.middle - middle;
        const double along = way.dot(axis);
        // Shifting an edge by the margin shifts the corners of the enlarged triangle farther; the neglected area lies
        // beside a corner.
        const double reach = radius + other.radius + 2.0 * margin;
        return std::abs(axis.dot(other.axis)) > NearCoincidenceTuning::kParallelPlanes - kNormalRounding &&
               way.squaredNorm() - along * along <= reach * reach;
    }

    Vec3 middle;
    Vec3 axis;
    double radius = 0.0;
};

/// Finds triangles of different operands that face each other. The soup must outlive it.
class FacingSearch {
  public:
    /// @param all    a tree over the triangles of the soup, in any frame; its groups are set
    /// @param reach  mm, at least the largest one of later searches
    /// @throws Cancelled
    FacingSearch(const Soup& soup, mesh::AabbTree& all, double reach, const Progress& progress);

    /// A superset of the triangles within the reach of a triangle of another operand, ascending.
    const std::vector<std::int32_t>& near() const { return near_; }

    /// visit(earlier, overlap) for each triangle of an earlier operand that a triangle faces.
    /// @param reach, margin  as for overlap_of
    template <typename Visit>
    void for_each_facing(std::int32_t later, double reach, double margin, const Visit& visit) const {
        const std::array<Vec3, 3> q = corners(soup_, later);
        const BoundingCircle circle(q);
        const Box box = swept(q, reach, margin);
        for (const std::size_t operand : operands_[static_cast<std::size_t>(operand_of(soup_, later))].earlier) {
            const NearTriangles& others = operands_[operand];
            others.tree->for_each_in_box(box, [&](std::int32_t k) {
                const auto i = static_cast<std::size_t>(k);
                if (circle.may_face(others.circles[i], margin)) {
                    const Overlap overlap = overlap_of(corners(soup_, others.index[i]), q, reach, margin);
                    if (overlap.area > 0.0) {
                        visit(others.index[i], overlap);
                    }
                }
            });
        }
    }

  private:
    /// The triangles of one operand near others.
    struct NearTriangles {
        std::vector<std::int32_t> index;  ///< in the soup
        std::vector<Triangle> triangles;
        std::vector<BoundingCircle> circles;
        std::optional<mesh::AabbTree> tree;
        std::vector<std::size_t> earlier;  ///< operands before this one that come near its box
    };

    const Soup& soup_;
    const std::vector<std::int32_t> near_;
    std::vector<NearTriangles> operands_;
};

}  // namespace mq::boolean
