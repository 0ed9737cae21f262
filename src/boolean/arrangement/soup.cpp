// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/soup.h"

#include <tsl/robin_map.h>

#include <algorithm>
#include <array>

#include "base/key_set.h"
#include "mesh/weld_vertices.h"

namespace mq::boolean {

namespace {

/// The intersections of the closed boxes of any two operands.
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

/// Marks places where vertices of one operand come together.
void mark_shared(Soup& soup, const std::vector<std::int32_t>& first) {
    std::vector<std::array<std::int32_t, 2>> users;  // place and operand of each vertex that is merged with others
    std::vector<std::int32_t> operand(first.size(), -1);
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        for (const std::int32_t v : soup.triangles[t]) {
            operand[static_cast<std::size_t>(v)] = soup.source[t].operand;
        }
    }
    std::vector<char> merged(first.size(), 0);
    for (std::size_t v = 0; v < first.size(); ++v) {
        const auto place = static_cast<std::size_t>(first[v]);
        if (place != v && operand[v] >= 0) {
            users.push_back({first[v], operand[v]});
            merged[place] = 1;
        }
    }
    for (std::size_t v = 0; v < first.size(); ++v) {
        if (merged[v] != 0) {
            users.push_back({static_cast<std::int32_t>(v), operand[v]});
        }
    }
    std::sort(users.begin(), users.end());
    soup.shared.resize(first.size(), 0);
    for (auto next = std::adjacent_find(users.begin(), users.end()); next != users.end();
         next = std::adjacent_find(next + 1, users.end())) {
        soup.shared[static_cast<std::size_t>((*next)[0])] = 1;
    }
}

/// Gives the marked vertices one index for each place.
void merge_marked(Soup& soup, const std::vector<char>& marked) {
    const std::vector<std::int32_t> first = mesh::equal_vertices(soup.vertices, marked);
    bool any = false;
    for (std::size_t v = 0; v < first.size() && !any; ++v) {
        any = static_cast<std::size_t>(first[v]) != v;
    }
    if (!any) {
        return;
    }
    mark_shared(soup, first);
    for (Triangle& t : soup.triangles) {
        for (std::int32_t& v : t) {
            v = first[static_cast<std::size_t>(v)];
        }
    }
}

}  // namespace

void forget_moved_triangles(Soup& soup) {
    for (std::size_t t = 0; t < soup.triangles.size() && !soup.moved.empty(); ++t) {
        const Triangle& c = soup.triangles[t];
        if (std::any_of(c.begin(), c.end(), [&](int v) { return soup.moved[static_cast<std::size_t>(v)] != 0; })) {
            soup.source[t].triangle = -1;
        }
    }
}

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

void merge_vertices(Soup& soup, const std::vector<Box>& boxes) {
    const std::vector<Box> meeting = meeting_boxes(boxes);
    if (meeting.empty()) {
        return;
    }
    std::vector<char> near(soup.vertices.size(), 0);
    for (std::size_t v = 0; v < near.size(); ++v) {
        near[v] =
            std::any_of(meeting.begin(), meeting.end(), [&](const Box& box) { return box.contains(soup.vertices[v]); })
                ? 1
                : 0;
    }
    merge_marked(soup, near);
}

void merge_all_vertices(Soup& soup) {
    merge_marked(soup, std::vector<char>(soup.vertices.size(), 1));
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
    merge_marked(soup, near);
}

std::vector<CoincidentTriangle> find_twins(const Soup& soup) {
    // A coincident triangle has three vertices that triangles of several operands use.
    std::vector<std::int32_t> user(soup.vertices.size(), -1);
    std::vector<char> shared(soup.vertices.size(), 0);
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        for (const int v : soup.triangles[i]) {
            const auto at = static_cast<std::size_t>(v);
            shared[at] = shared[at] || (user[at] >= 0 && user[at] != soup.source[i].operand);
            user[at] = soup.source[i].operand;
        }
    }
    std::vector<std::int32_t> among;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const Triangle& t = soup.triangles[i];
        if (std::all_of(t.begin(), t.end(), [&](int v) { return shared[static_cast<std::size_t>(v)] != 0; })) {
            among.push_back(static_cast<std::int32_t>(i));
        }
    }
    return find_twins(soup, among);
}

std::vector<CoincidentTriangle> find_twins(const Soup& soup, const std::vector<std::int32_t>& among) {
    std::vector<CoincidentTriangle> twins;
    tsl::robin_map<Triangle, std::int32_t, KeyHash> at;
    for (const std::int32_t i : among) {
        Triangle t = soup.triangles[static_cast<std::size_t>(i)];
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        const bool turned = t[1] > t[2];
        const Triangle key{t[0], std::min(t[1], t[2]), std::max(t[1], t[2])};
        const auto [found, fresh] = at.emplace(key, 2 * i + (turned ? 1 : 0));
        if (!fresh) {
            const int turn = (found->second % 2 == 1) == turned ? 1 : -1;
            twins.push_back({i, found->second / 2, turn});
        }
    }
    return twins;
}

}  // namespace mq::boolean
