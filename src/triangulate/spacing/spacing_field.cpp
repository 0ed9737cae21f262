// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/spacing_field.h"

#include <algorithm>
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
    sources_.build(SpacingTuning::kLeaf);
}

double SpacingField::at(const Vec3& point, double most) const {
    double best = most;
    sources_.search(
        best, [&](const Bounds& bounds) { return bounds.least + kGrowth * geometry::gap(bounds.box, point).norm(); },
        [&](std::size_t i) {
            const Source& source = sources_.items[i];
            best = std::min(best, source.spacing + kGrowth * (source.point - point).norm());
        });
    return best;
}

}  // namespace mq::triangulate
