// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/editor.h"

#include <algorithm>
#include <cmath>

#include "base/tuning.h"
#include "curve/volume/tuning.h"
#include "elements/bezier/jacobian.h"

namespace mq::curve {

double VolumeEditor::fixed_score(const std::array<int, 4>& c) const {
    const elements::CurvedShapes& shapes = volume.shapes();
    const double order = shapes.order();
    const double straight = volume.straight_jacobian(c);
    double least = 1.0;
    for (std::size_t k = 0; k < 4; ++k) {
        std::array<Vec3, 3> tangents;
        bool fixed = true;
        for (std::size_t i = 0; i < 3 && fixed; ++i) {
            const int other = c[(k + 1 + i) % 4];
            fixed = volume.fixed_edge(c[k], other);
            tangents[i] =
                fixed ? Vec3(order * (shapes.edge_inner(c[k], other).front() - volume.point(c[k]))) : Vec3::Zero();
        }
        if (fixed) {
            // Corners (k, k + 1, k + 2, k + 3) are an odd permutation of (0, 1, 2, 3) for odd k.
            const double sign = k % 2 == 0 ? 1.0 : -1.0;
            least = std::min(least, sign * tangents[0].cross(tangents[1]).dot(tangents[2]) / std::abs(straight));
        }
    }
    return least;
}

VolumeEditor::Score VolumeEditor::score(const std::array<int, 4>& c) const {
    Score score;
    const double shape = volume.straight_shape(c);
    const elements::CurvedShapes& shapes = volume.shapes();
    if (!volume.curved(c)) {
        score.quality = shape > 0.0 ? std::min(1.0, shape / VolumeTuning::kSliverShape) : -1.0;
        return score;
    }
    score.fixed = fixed_score(c);
    std::vector<Vec3> control;
    shapes.tetrahedron(c, control);
    const elements::JacobianForm form = elements::jacobian_by_nodes(elements::Lattice::of(3, shapes.order()), control);
    const auto [low, high] = std::minmax_element(form.coefficients.begin(), form.coefficients.end());
    score.quality = *high > 0.0 ? *low / *high : -1.0;
    if (score.quality > 0.0) {
        score.quality *= std::min(1.0, shape / VolumeTuning::kSliverShape);
    }
    score.quality = shape > 0.0 ? score.quality : std::min(score.quality, -1.0);
    return score;
}

VolumeEditor::Score VolumeEditor::worst(const std::vector<std::array<int, 4>>& elements) const {
    Score worst;
    for (const auto& corners : elements) {
        const Score one = score(corners);
        worst.fixed = std::min(worst.fixed, one.fixed);
        worst.quality = std::min(worst.quality, one.quality);
    }
    return worst;
}

bool VolumeEditor::better(const std::vector<int>& removed, const std::vector<std::array<int, 4>>& added,
                          Rule rule) const {
    std::vector<std::array<int, 4>> old;
    double flat_before = 1.0;
    for (const int t : removed) {
        old.push_back(tetrahedron(t).corners);
        flat_before = std::min(flat_before, volume.straight_shape(tetrahedron(t).corners));
    }
    double flat_after = 1.0;
    for (const auto& corners : added) {
        flat_after = std::min(flat_after, volume.straight_shape(corners));
    }
    if (flat_after < std::min(VolumeTuning::kLeastShape, flat_before) || !(flat_after > 0.0)) {
        return false;
    }
    const Score before = worst(old);
    const Score after = worst(added);
    if (rule == Rule::Free) {
        return after.fixed > before.fixed + 0.05;
    }
    return after.quality > before.quality + kLeastGain &&
           after.fixed >= std::min(before.fixed, VolumeTuning::kFreeCorner);
}

bool VolumeEditor::replace(const std::vector<int>& removed, const std::vector<std::array<int, 4>>& added, Rule rule) {
    if (!better(removed, added, rule)) {
        return false;
    }
    const int solid = tetrahedron(removed.front()).volume;
    for (const int t : removed) {
        volume.remove(t);
    }
    std::vector<int> fresh;
    for (const auto& corners : added) {
        fresh.push_back(volume.add(corners, solid));
    }
    forget_lost_shapes(removed);
    volume.measure(fresh);
    return true;
}

void VolumeEditor::forget_lost_shapes(const std::vector<int>& removed) {
    for (const int t : removed) {
        const std::array<int, 4> c = tetrahedron(t).corners;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::array<int, 3> face{c[(i + 1) % 4], c[(i + 2) % 4], c[(i + 3) % 4]};
            if (!volume.fixed_face(face[0], face[1], face[2]) && volume.of_face(face[0], face[1], face[2]).empty()) {
                volume.shapes().forget_face(face);
            }
            for (std::size_t k = i + 1; k < 4; ++k) {
                if (!volume.fixed_edge(c[i], c[k]) && !volume.has_edge(c[i], c[k])) {
                    volume.shapes().forget_edge(c[i], c[k]);
                }
            }
        }
    }
}

}  // namespace mq::curve
