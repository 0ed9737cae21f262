// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/surface/editor.h"

#include <algorithm>
#include <cmath>

#include "base/tuning.h"
#include "curve/surface/tuning.h"

namespace mq::curve {

double SurfaceEditor::length(int a, int b) const {
    return (point(b) - point(a)).norm();
}

double SurfaceEditor::deviation(int a, int b) const {
    if (!surface.shapes.has_edge(a, b)) {
        return 0.0;
    }
    const Vec3 along = (point(b) - point(a)).normalized();
    double most = 0.0;
    for (const Vec3& p : surface.shapes.edge_inner(a, b)) {
        const Vec3 offset = p - point(a);
        most = std::max(most, (offset - along * along.dot(offset)).norm());
    }
    // The middle of a quadratic moves half as far as its control point; of higher orders a little more.
    return (surface.shapes.order() == 2 ? 0.5 : 0.75) * most;
}

double SurfaceEditor::rms_deviation(const std::vector<int>& triangles) {
    const std::vector<double> distances = placement.deviations(triangles);
    double squares = 0.0;
    for (const double d : distances) {
        squares += d * d;
    }
    return distances.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(distances.size()));
}

double SurfaceEditor::plain_deviation() {
    if (plain_deviation_ < 0.0) {
        std::vector<int> some;
        for (std::size_t t = 0; t < surface.triangles.size();
             t += 1 + surface.triangles.size() / SurfaceTuning::kDeviationSamples) {
            if (surface.triangles[t].alive) {
                some.push_back(static_cast<int>(t));
            }
        }
        plain_deviation_ = rms_deviation(some);
    }
    return plain_deviation_;
}

bool SurfaceEditor::straight_sound(const std::vector<int>& removed, const std::vector<Corners>& added) const {
    const auto area = [&](const std::array<int, 3>& c) -> Vec3 {
        return (point(c[1]) - point(c[0])).cross(point(c[2]) - point(c[0]));
    };
    Vec3 sum = Vec3::Zero();
    for (const int t : removed) {
        sum += area(triangle(t).corners);
    }
    return std::all_of(added.begin(), added.end(), [&](const Corners& corners) {
        const Vec3 a = area(corners.corners);
        return a.dot(sum) > SurfaceTuning::kStraightTurn * a.norm() * sum.norm();
    });
}

/// Two faces may have the same vertices on their common border: two edges between them, one inside each face, would
/// become one.
bool SurfaceEditor::inner_edges_sound(const std::vector<int>& triangles) const {
    return std::all_of(triangles.begin(), triangles.end(), [&](int t) {
        const auto& v = triangle(t).corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::vector<int> beside = surface.triangles_of_edge(v[k], v[(k + 1) % 3]);
            const auto on_face = [&](int other) { return triangle(other).face == triangle(t).face; };
            if (surface.segment(v[k], v[(k + 1) % 3]) == nullptr &&
                (beside.size() > 2 || !std::all_of(beside.begin(), beside.end(), on_face))) {
                return false;
            }
        }
        return true;
    });
}

bool SurfaceEditor::replace(const std::vector<int>& removed, const std::vector<Corners>& added, Rule rule) {
    // For folded triangles the sum of the areas is meaningless.
    const bool sound_before =
        std::all_of(removed.begin(), removed.end(), [&](int t) { return triangle(t).quality > 0.0; });
    if (rule == Rule::Improve && sound_before && !straight_sound(removed, added)) {
        return false;
    }
    const double floor = rule == Rule::RefinePoor ? SurfaceTuning::kHardlyValid : 0.0;
    double worst_before = 1.0;
    std::ptrdiff_t invalid_before = 0;
    std::vector<std::array<int, 3>> old;
    for (const int t : removed) {
        worst_before = std::min(worst_before, triangle(t).quality);
        invalid_before += triangle(t).quality > floor ? 0 : 1;
        old.push_back(triangle(t).corners);
    }
    std::vector<std::pair<int, int>> fresh;
    for (const Corners& corners : added) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = corners.corners[k];
            const int b = corners.corners[(k + 1) % 3];
            if (!surface.has_edge(a, b)) {
                fresh.emplace_back(a, b);
            }
        }
    }
    for (const int t : removed) {
        surface.remove_triangle(t);
    }
    std::vector<int> indices;
    for (const Corners& corners : added) {
        indices.push_back(surface.add_triangle(corners.corners, corners.face));
    }
    if (!inner_edges_sound(indices)) {
        undo(removed, indices, fresh);
        return false;
    }
    placement.place(indices);
    double worst_after = 1.0;
    std::ptrdiff_t invalid_after = 0;
    for (const int t : indices) {
        worst_after = std::min(worst_after, triangle(t).quality);
        invalid_after += triangle(t).quality > floor ? 0 : 1;
    }
    const bool adds_invalid = rule != Rule::Try && invalid_after > invalid_before;
    if (adds_invalid || (rule == Rule::Improve && worst_after <= worst_before + kLeastGain)) {
        undo(removed, indices, fresh);
        return false;
    }
    for (const auto& corners : old) {
        surface.shapes.forget_face(corners);
        for (std::size_t k = 0; k < 3; ++k) {
            if (!surface.has_edge(corners[k], corners[(k + 1) % 3])) {
                surface.shapes.forget_edge(corners[k], corners[(k + 1) % 3]);
                surface.segments.erase(pair_key(corners[k], corners[(k + 1) % 3]));
            }
        }
    }
    return true;
}

void SurfaceEditor::undo(const std::vector<int>& removed, const std::vector<int>& added,
                         const std::vector<std::pair<int, int>>& fresh_edges) {
    for (auto t = added.rbegin(); t != added.rend(); ++t) {
        surface.shapes.forget_face(triangle(*t).corners);
        surface.withdraw_triangle();
    }
    for (const int t : removed) {
        surface.revive_triangle(t);
    }
    for (const auto& [a, b] : fresh_edges) {
        surface.shapes.forget_edge(a, b);
        surface.segments.erase(pair_key(a, b));
    }
}

}  // namespace mq::curve
