// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/cells/cell_measure.h"

#include <algorithm>
#include <cmath>

#include "tetrahedralise/cells/flips.h"
#include "tetrahedralise/cells/tuning.h"

namespace mq::tetrahedralise {

namespace {

/// The least sine of the dihedral angles of a corner with these edges; for a folded corner its volume, negative.
double sine_of_corner(const std::array<Vec3, 3>& edges) {
    const Vec3 a = edges[0].normalized();
    const Vec3 b = edges[1].normalized();
    const Vec3 c = edges[2].normalized();
    const double volume = a.cross(b).dot(c);
    if (!(volume > 0.0)) {
        return volume;
    }
    const double ab = a.cross(b).squaredNorm();
    const double ac = a.cross(c).squaredNorm();
    const double bc = b.cross(c).squaredNorm();
    return volume / std::sqrt(std::max(ab * ac, std::max(ab * bc, ac * bc)));
}

/// A monotone function with positive values: a corner that is folded by curving must not look like a cell without
/// volume.
double made_positive(double sine) {
    const double kFrom = CellTuning::kFoldedSine;
    return sine > kFrom ? sine : kFrom * std::exp(sine / kFrom - 1.0);
}

}  // namespace

double excess_of_edges(const std::array<const Vec3*, 4>& corners, const SizeField& field) {
    double worst = 0.0;
    for (std::size_t i = 1; i < 4; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double bound = CellTuning::kLongestByField * field.at(0.5 * (*corners[i] + *corners[j]));
            worst = std::max(worst, (*corners[i] - *corners[j]).norm() / bound);
        }
    }
    return worst;
}

double excess_by_least(const std::array<const Vec3*, 4>& corners, const SizeField& field) {
    double longest = 0.0;
    for (std::size_t i = 1; i < 4; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            longest = std::max(longest, (*corners[i] - *corners[j]).norm());
        }
    }
    const double limit = longest / CellTuning::kLongestByLeast;
    const double least = field.least_in_simplex({*corners[0], *corners[1], *corners[2], *corners[3]}, 4, limit);
    return least < limit ? limit / least : 0.0;
}

CellMeasure::CellMeasure(const Tetrahedralisation& mesh, const EndTangents& tangents, const SizeField* field)
    : mesh_(mesh), tangents_(tangents), field_(field) {
    for (const auto& [key, tangent] : tangents) {
        const auto v = static_cast<std::size_t>(key >> 32);
        curved_.resize(std::max(curved_.size(), v + 1), 0);
        curved_[v] = 1;
    }
}

double CellMeasure::folded() {
    return made_positive(0.0);
}

double CellMeasure::at(const std::array<int, 4>& v) const {
    return value(v, {&mesh_.point(v[0]), &mesh_.point(v[1]), &mesh_.point(v[2]), &mesh_.point(v[3])});
}

double CellMeasure::at(const std::array<int, 3>& face, const Vec3& place) const {
    return value({face[0], face[1], face[2], -1},
                 {&mesh_.point(face[0]), &mesh_.point(face[1]), &mesh_.point(face[2]), &place});
}

double CellMeasure::value(const std::array<int, 4>& v, const Corners& p) const {
    const double shape = shape_of(v, p);
    if (field_ == nullptr || !(shape > 0.0)) {
        return shape;
    }
    return shape / std::pow(std::max(1.0, excess_of_edges(p, *field_)), CellTuning::kExcessPower);
}

double CellMeasure::shape_of(const std::array<int, 4>& v, const Corners& p) const {
    const double sine = sine_quality(*p[0], *p[1], *p[2], *p[3]);
    if (!(sine > 0.0)) {
        return sine;
    }
    const double volume = volume_quality(*p[0], *p[1], *p[2], *p[3]);
    const double mean_ratio = std::cbrt(volume * volume);
    double least = std::min(sine, CellTuning::kMeanRatioFraction * mean_ratio);
    if (std::count_if(v.begin(), v.end(), [&](int k) { return curved(k); }) < 2) {
        return least;
    }
    for (int k = 0; k < 4; ++k) {
        if (curved(v[k])) {
            least = std::min(least, made_positive(corner_sine(v, p, k)));
        }
    }
    return least;
}

double CellMeasure::corner_sine(const std::array<int, 4>& v, const Corners& p, int corner) const {
    // Seen from the corner, its opposite face has the reverse orientation.
    const std::array<int, 3> others{kFaceOf[corner][0], kFaceOf[corner][2], kFaceOf[corner][1]};
    std::array<Vec3, 3> edges;
    bool any = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const int other = others[i];
        edges[i] = *p[other] - *p[corner];
        if (curved(v[other])) {
            const auto found = tangents_.find(directed_edge(v[corner], v[other]));
            if (found != tangents_.end()) {
                edges[i] = found->second;
                any = true;
            }
        }
    }
    return any ? sine_of_corner(edges) : 1.0;
}

}  // namespace mq::tetrahedralise
