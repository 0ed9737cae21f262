// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/spacing_field.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "triangulate/spacing/tuning.h"

namespace mq::triangulate {

double spacing_for(double curvature, const SpacingBounds& bounds) {
    const double k = std::abs(curvature);
    double spacing = bounds.most;
    if (k * bounds.most > SpacingTuning::kChordTurn) {
        spacing = SpacingTuning::kChordTurn / k;
    }
    if (bounds.chord > 0.0 && k * bounds.chord < 1.0 && k > 0.0) {
        spacing = std::min(spacing, 2.0 * std::sqrt(bounds.chord * (2.0 / k - bounds.chord)));
    }
    return std::clamp(spacing, bounds.least, bounds.most);
}

void SpacingField::build() {
    nodes_.clear();
    if (!sources_.empty()) {
        build_node(0, 0, static_cast<int>(sources_.size()));
    }
}

void SpacingField::build_node(std::size_t node, int begin, int end) {
    if (nodes_.size() <= node) {
        nodes_.resize(node + 1);
    }
    Node made;
    made.begin = begin;
    made.end = end;
    for (int i = begin; i < end; ++i) {
        made.box.add(sources_[i].point);
        made.least = std::min(made.least, sources_[i].spacing);
    }
    nodes_[node] = made;
    if (end - begin <= SpacingTuning::kLeaf) {
        return;
    }
    int axis = 0;
    (made.box.high - made.box.low).maxCoeff(&axis);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(sources_.begin() + begin, sources_.begin() + middle, sources_.begin() + end,
                     [axis](const Source& a, const Source& b) {
                         return a.point[axis] != b.point[axis] ? a.point[axis] < b.point[axis] : a.spacing < b.spacing;
                     });
    build_node(2 * node + 1, begin, middle);
    build_node(2 * node + 2, middle, end);
}

double SpacingField::bound(const Node& node, const Vec3& point) {
    const Vec3 outside = (node.box.low - point).cwiseMax(point - node.box.high).cwiseMax(Vec3::Zero());
    return node.least + kGrowth * outside.norm();
}

double SpacingField::at(const Vec3& point, double most) const {
    double best = most;
    if (nodes_.empty()) {
        return best;
    }
    std::array<std::size_t, 64> stack{};
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const std::size_t n = stack[--depth];
        const Node& node = nodes_[n];
        if (bound(node, point) >= best) {
            continue;
        }
        if (node.end - node.begin <= SpacingTuning::kLeaf) {
            for (int i = node.begin; i < node.end; ++i) {
                best = std::min(best, sources_[i].spacing + kGrowth * (sources_[i].point - point).norm());
            }
            continue;
        }
        const bool right_first = bound(nodes_[2 * n + 2], point) < bound(nodes_[2 * n + 1], point);
        stack[depth++] = right_first ? 2 * n + 1 : 2 * n + 2;
        stack[depth++] = right_first ? 2 * n + 2 : 2 * n + 1;
    }
    return best;
}

}  // namespace mq::triangulate
