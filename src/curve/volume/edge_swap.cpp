// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "curve/volume/editor.h"

namespace mq::curve {

namespace {

/// The vertices around edge (a, b) in order, so that (a, b, ring[i], ring[i + 1]) has positive volume; empty when they
/// do not form one ring.
std::vector<int> ring_around(const VolumeEditor& editor, const std::vector<int>& around, int a, int b) {
    std::vector<std::pair<int, int>> steps;
    for (const int t : around) {
        std::array<int, 2> rest{};
        std::size_t n = 0;
        for (const int v : editor.tetrahedron(t).corners) {
            if (v != a && v != b) {
                rest[n++] = v;
            }
        }
        if (editor.volume.straight_jacobian({a, b, rest[0], rest[1]}) < 0.0) {
            std::swap(rest[0], rest[1]);
        }
        steps.emplace_back(rest[0], rest[1]);
    }
    std::vector<int> ring{steps.front().first};
    while (ring.size() <= steps.size()) {
        const auto next =
            std::find_if(steps.begin(), steps.end(), [&](const auto& step) { return step.first == ring.back(); });
        if (next == steps.end()) {
            return {};
        }
        if (next->second == ring.front()) {
            return ring.size() == steps.size() ? ring : std::vector<int>{};
        }
        ring.push_back(next->second);
    }
    return {};
}

}  // namespace

bool swap_region_edge(VolumeEditor& editor, int a, int b, VolumeEditor::Rule rule) {
    if (editor.volume.fixed_edge(a, b)) {
        return false;
    }
    const std::vector<int> around = editor.volume.of_edge(a, b);
    if (around.size() < 3) {
        return false;
    }
    const std::vector<int> ring = ring_around(editor, around, a, b);
    const std::size_t n = ring.size();
    if (n < 3) {
        return false;
    }
    // The ring is cut into a fan around each of its vertices in turn; a fan's chords must be new edges.
    for (std::size_t hub = 0; hub < (n == 3 ? 1 : n); ++hub) {
        bool possible = true;
        std::vector<std::array<int, 4>> added;
        for (std::size_t i = 1; i + 1 < n; ++i) {
            const int p = ring[hub];
            const int x = ring[(hub + i) % n];
            const int y = ring[(hub + i + 1) % n];
            possible = possible && (i + 2 == n || !editor.volume.has_edge(p, y));
            added.push_back({p, x, y, b});
            added.push_back({p, y, x, a});
        }
        if (possible && editor.replace(around, added, rule)) {
            return true;
        }
    }
    return false;
}

}  // namespace mq::curve
