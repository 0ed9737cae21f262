// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/point_octree.h"

namespace mq::triangulate {

int PointOctree::add(const Vec3& point, double spacing) {
    const int i = size();
    const int k = level_of(spacing);
    points_.push_back(point);
    own_level_.push_back(static_cast<std::int16_t>(k));
    add_levels(k);
    ++level(k).points;
    const auto entry = level(k).first.insert({key(cell_of(point, k)), -1}).first;
    next_.push_back(entry->second);
    entry.value() = i;
    mark_parents(point, k + 1);
    return i;
}

// Marks the cells above a point, on all levels up to the highest one.
void PointOctree::mark_parents(const Vec3& point, int from) {
    for (int k = from; k <= top() && level(k).parents.insert(key(cell_of(point, k))).second; ++k) {
    }
}

void PointOctree::add_levels(int k) {
    if (levels_.empty()) {
        lowest_ = k;
        levels_.resize(1);
    }
    if (k < lowest_) {
        levels_.insert(levels_.begin(), static_cast<std::size_t>(lowest_ - k), Level());
        lowest_ = k;
    }
    if (k > top()) {
        const int from = top() + 1;
        levels_.resize(static_cast<std::size_t>(k - lowest_ + 1));
        for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
            mark_parents(points_[i], from);
        }
    }
}

}  // namespace mq::triangulate
