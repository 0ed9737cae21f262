// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/soup.h"

#include <tsl/robin_map.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>

namespace mq::boolean {

namespace {

std::vector<Box> operand_boxes(const Soup& soup) {
    std::vector<Box> boxes(static_cast<std::size_t>(soup.operands));
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        Box& box = boxes[static_cast<std::size_t>(soup.source[i].operand)];
        for (const int v : soup.triangles[i]) {
            box.add(soup.vertices[static_cast<std::size_t>(v)]);
        }
    }
    return boxes;
}

bool contains(const Box& box, const Vec3& p) {
    return (box.low.array() <= p.array()).all() && (p.array() <= box.high.array()).all();
}

/// The closed boxes common to two operands each.
std::vector<Box> meeting_boxes(const std::vector<Box>& boxes) {
    std::vector<Box> found;
    for (std::size_t a = 0; a < boxes.size(); ++a) {
        for (std::size_t b = a + 1; b < boxes.size(); ++b) {
            const Box common{boxes[a].low.cwiseMax(boxes[b].low), boxes[a].high.cwiseMin(boxes[b].high)};
            if ((common.low.array() <= common.high.array()).all()) {
                found.push_back(common);
            }
        }
    }
    return found;
}

struct BitsHash {
    std::size_t operator()(const std::array<std::uint64_t, 3>& bits) const {
        std::uint64_t h = 0;
        for (const std::uint64_t b : bits) {
            h = (h ^ b) * 0x9E3779B97F4A7C15ULL;
            h ^= h >> 29;
        }
        return h;
    }
};

std::array<std::uint64_t, 3> bits_of(const Vec3& p) {
    std::array<std::uint64_t, 3> bits{};
    for (int k = 0; k < 3; ++k) {
        const double value = p[k] + 0.0;  // one zero only
        std::memcpy(&bits[static_cast<std::size_t>(k)], &value, sizeof value);
    }
    return bits;
}

/// Gives the vertices asked for one index for each place.
template <typename Asked>
void merge_where(Soup& soup, Asked&& asked) {
    std::vector<std::int32_t> first(soup.vertices.size());
    std::iota(first.begin(), first.end(), 0);
    tsl::robin_map<std::array<std::uint64_t, 3>, std::int32_t, BitsHash> at;
    at.reserve(soup.vertices.size() / 4);
    bool merged = false;
    for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
        if (asked(v)) {
            first[v] = at.emplace(bits_of(soup.vertices[v]), static_cast<std::int32_t>(v)).first->second;
            merged = merged || first[v] != static_cast<std::int32_t>(v);
        }
    }
    if (merged) {
        for (Triangle& t : soup.triangles) {
            for (std::int32_t& v : t) {
                v = first[static_cast<std::size_t>(v)];
            }
        }
    }
}

}  // namespace

void merge_vertices(Soup& soup) {
    const std::vector<Box> meeting = meeting_boxes(operand_boxes(soup));
    if (!meeting.empty()) {
        merge_where(soup, [&](std::size_t v) {
            return std::any_of(meeting.begin(), meeting.end(),
                               [&](const Box& box) { return contains(box, soup.vertices[v]); });
        });
    }
}

void merge_touching(Soup& soup, const std::vector<std::array<std::int32_t, 2>>& pairs) {
    std::vector<char> near(soup.vertices.size(), 0);
    for (const auto& pair : pairs) {
        for (const std::int32_t t : pair) {
            for (const std::int32_t v : soup.triangles[static_cast<std::size_t>(t)]) {
                near[static_cast<std::size_t>(v)] = 1;
            }
        }
    }
    merge_where(soup, [&](std::size_t v) { return near[v] != 0; });
}

std::vector<Twin> find_twins(const Soup& soup) {
    // A twin has three vertices that triangles of several operands use.
    std::vector<std::int32_t> user(soup.vertices.size(), -1);
    std::vector<char> shared(soup.vertices.size(), 0);
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        for (const int v : soup.triangles[i]) {
            const auto at = static_cast<std::size_t>(v);
            shared[at] = shared[at] || (user[at] >= 0 && user[at] != soup.source[i].operand);
            user[at] = soup.source[i].operand;
        }
    }
    std::vector<Twin> twins;
    tsl::robin_map<std::array<std::uint64_t, 3>, std::int32_t, BitsHash> at;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        Triangle t = soup.triangles[i];
        if (!std::all_of(t.begin(), t.end(), [&](int v) { return shared[static_cast<std::size_t>(v)] != 0; })) {
            continue;
        }
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        const bool turned = t[1] > t[2];
        const std::array<std::uint64_t, 3> key{static_cast<std::uint64_t>(t[0]),
                                               static_cast<std::uint64_t>(std::min(t[1], t[2])),
                                               static_cast<std::uint64_t>(std::max(t[1], t[2]))};
        const auto [found, fresh] = at.emplace(key, static_cast<std::int32_t>(2 * i + turned));
        if (!fresh) {
            const int turn = (found->second % 2 == 1) == turned ? 1 : -1;
            twins.push_back({static_cast<std::int32_t>(i), found->second / 2, turn});
        }
    }
    return twins;
}

}  // namespace mq::boolean
