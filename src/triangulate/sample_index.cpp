// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/sample_index.h"

namespace mq::triangulate {

SampleIndex::Cell SampleIndex::cell_of(const Vec3& p, double cell) {
    return {static_cast<std::int64_t>(std::floor(p.x() / cell)), static_cast<std::int64_t>(std::floor(p.y() / cell)),
            static_cast<std::int64_t>(std::floor(p.z() / cell))};
}

std::uint64_t SampleIndex::key(const Cell& cell) {
    constexpr std::uint64_t kMask = (1ULL << 21) - 1;
    return (static_cast<std::uint64_t>(cell[0]) & kMask) << 42 | (static_cast<std::uint64_t>(cell[1]) & kMask) << 21 |
           (static_cast<std::uint64_t>(cell[2]) & kMask);
}

int SampleIndex::add(const Vec3& point, double spacing) {
    const int i = size();
    const int level = static_cast<int>(std::ceil(std::log2(spacing)));
    points_.push_back(point);
    Grid& grid = grids_[level];
    grid.members.push_back(i);
    const auto entry = grid.first.insert({key(cell_of(point, std::ldexp(1.0, level))), -1}).first;
    next_.push_back(entry->second);
    entry.value() = i;
    return i;
}

}  // namespace mq::triangulate
