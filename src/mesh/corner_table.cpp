// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/corner_table.h"

#include <algorithm>

namespace mq::mesh {
namespace {

/// A corner in the bucket of the lower vertex of its edge.
struct Entry {
    std::int32_t high;
    std::uint32_t corner_and_way;  ///< 2 * corner, plus 1 when the edge runs from the lower vertex

    std::int32_t corner() const { return static_cast<std::int32_t>(corner_and_way >> 1); }
    bool upward() const { return (corner_and_way & 1u) != 0; }
};

bool comes_before(const Entry& a, const Entry& b) {
    return a.high != b.high ? a.high < b.high : a.corner_and_way < b.corner_and_way;
}

bool names_twice(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

void sort_bucket(Entry* first, Entry* last) {
    // Bucket size up to which insertion sort is faster than std::sort.
    constexpr std::ptrdiff_t kSmall = 24;
    if (last - first > kSmall) {
        std::sort(first, last, comes_before);
        return;
    }
    for (Entry* i = first; i < last; ++i) {
        const Entry entry = *i;
        Entry* j = i;
        for (; j > first && comes_before(entry, j[-1]); --j) {
            *j = j[-1];
        }
        *j = entry;
    }
}

void match_bucket(const Entry* first, const Entry* last, std::vector<std::int32_t>& twins) {
    for (const Entry* i = first; i != last;) {
        const Entry* j = i + 1;
        while (j != last && j->high == i->high) {
            ++j;
        }
        if (j - i == 1) {
            twins[i->corner()] = kBorder;
        } else if (j - i == 2 && i[0].upward() != i[1].upward()) {
            twins[i[0].corner()] = i[1].corner();
            twins[i[1].corner()] = i[0].corner();
        }
        i = j;
    }
}

}  // namespace

std::vector<std::int32_t> edge_twins(const std::vector<Triangle>& triangles, std::size_t vertex_count) {
    std::vector<std::uint32_t> begin(vertex_count + 2, 0);
    for (const Triangle& t : triangles) {
        if (!names_twice(t)) {
            for (int i = 0; i < 3; ++i) {
                ++begin[std::min(t[i], t[(i + 1) % 3]) + 2];
            }
        }
    }
    for (std::size_t v = 2; v < begin.size(); ++v) {
        begin[v] += begin[v - 1];
    }
    // begin[v + 1] is the next free entry of v's bucket, and finally the bucket's end.
    std::vector<Entry> entries(begin.back());
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const Triangle& t = triangles[k];
        if (names_twice(t)) {
            continue;
        }
        for (int i = 0; i < 3; ++i) {
            const std::int32_t tail = t[i];
            const std::int32_t head = t[(i + 1) % 3];
            const auto corner = static_cast<std::uint32_t>(3 * k + i);
            entries[begin[std::min(tail, head) + 1]++] = {std::max(tail, head), 2 * corner + (tail < head ? 1u : 0u)};
        }
    }
    std::vector<std::int32_t> twins(3 * triangles.size(), kIrregular);
    for (std::size_t v = 0; v < vertex_count; ++v) {
        sort_bucket(entries.data() + begin[v], entries.data() + begin[v + 1]);
        match_bucket(entries.data() + begin[v], entries.data() + begin[v + 1], twins);
    }
    return twins;
}

VertexFans fans(const std::vector<Triangle>& triangles, const std::vector<std::int32_t>& twins) {
    VertexFans result;
    result.fan_of.assign(twins.size(), -1);
    for (std::size_t start = 0; start < twins.size(); ++start) {
        if (result.fan_of[start] >= 0) {
            continue;
        }
        const auto fan = static_cast<std::int32_t>(result.vertex_of.size());
        result.vertex_of.push_back(triangles[start / 3][start % 3]);
        // Once around, over the edges that arrive at the vertex; where that meets a border, back over those that leave.
        auto h = static_cast<std::int32_t>(start);
        do {
            result.fan_of[h] = fan;
            h = twins[previous_corner(h)];
        } while (h >= 0 && result.fan_of[h] < 0);
        for (h = twins[start]; h >= 0 && result.fan_of[next_corner(h)] < 0; h = twins[next_corner(h)]) {
            result.fan_of[next_corner(h)] = fan;
        }
    }
    return result;
}

Components components(const std::vector<std::int32_t>& twins) {
    Components result;
    result.component_of.assign(twins.size() / 3, -1);
    std::vector<std::int32_t> stack;
    for (std::size_t start = 0; start < result.component_of.size(); ++start) {
        if (result.component_of[start] >= 0) {
            continue;
        }
        result.component_of[start] = result.count;
        stack.push_back(static_cast<std::int32_t>(start));
        while (!stack.empty()) {
            const std::int32_t t = stack.back();
            stack.pop_back();
            for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h) {
                if (twins[h] >= 0 && result.component_of[twins[h] / 3] < 0) {
                    result.component_of[twins[h] / 3] = result.count;
                    stack.push_back(twins[h] / 3);
                }
            }
        }
        ++result.count;
    }
    return result;
}

}  // namespace mq::mesh
