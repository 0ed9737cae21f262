// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/cells/flips.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mq::tetrahedralise {

double volume_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int sign = orient3d(a, b, c, d);
    if (sign <= 0) {
        return sign;
    }
    const double volume = (b - a).cross(c - a).dot(d - a);
    const double squares = (b - a).squaredNorm() + (c - a).squaredNorm() + (d - a).squaredNorm() +
                           (c - b).squaredNorm() + (d - b).squaredNorm() + (d - c).squaredNorm();
    /// Normalisation: the inverse of six times the volume over the power 3/2 of the sum of squares, for the regular
    /// tetrahedron.
    constexpr double kRegular = 20.7846096908265;
    return std::max(kRegular * volume / (squares * std::sqrt(squares)), std::numeric_limits<double>::min());
}

double sine_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 ad = d - a;
    const Vec3 bc = c - b;
    const Vec3 bd = d - b;
    const Vec3 cd = d - c;
    const double volume = ab.cross(ac).dot(ad);
    if (!(volume > 0.0)) {
        return volume;
    }
    const double abc = 1.0 / ab.cross(ac).squaredNorm();
    const double abd = 1.0 / ab.cross(ad).squaredNorm();
    const double acd = 1.0 / ac.cross(ad).squaredNorm();
    const double bcd = 1.0 / bc.cross(bd).squaredNorm();
    // The square of the sine at an edge is (6 V edge)^2 over the squares of twice the areas of its two faces.
    const double at_a =
        std::min(ab.squaredNorm() * abc * abd, std::min(ac.squaredNorm() * abc * acd, ad.squaredNorm() * abd * acd));
    const double opposite =
        std::min(bc.squaredNorm() * abc * bcd, std::min(bd.squaredNorm() * abd * bcd, cd.squaredNorm() * acd * bcd));
    return volume * std::sqrt(std::min(at_a, opposite));
}

double Flipper::quality(const std::array<int, 4>& v, const FlipRule& rule) const {
    return rule.measure != nullptr
               ? rule.measure->at(v)
               : volume_quality(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3]));
}

bool Flipper::plan_face(int cell, int face, const FlipRule& rule) {
    const int other = mesh_.cells[cell].n[face];
    if (other < 0) {
        return false;
    }
    const Cell& c = mesh_.cells[cell];
    const int top = c.v[face];
    const int bottom = mesh_.cells[other].v[mesh_.face_towards(other, cell)];
    added_.clear();
    for (int k = 0; k < 3; ++k) {
        const int x = c.v[kFaceOf[face][k]];
        const int y = c.v[kFaceOf[face][(k + 1) % 3]];
        if (!(quality({bottom, top, x, y}, rule) > rule.floor) || mesh_.orient(bottom, top, x, y) <= 0) {
            return false;
        }
        added_.push_back({bottom, top, x, y});
    }
    removed_ = {cell, other};
    return true;
}

bool Flipper::plan_ring(int a, int b, const FlipRule& rule) {
    if (ring_.x.size() > std::min(rule.most_around, kMostAround)) {
        return false;
    }
    chord_from_ = chord_to_ = -1;
    if (rule.chord_a >= 0) {
        for (std::size_t i = 0; i < ring_.x.size(); ++i) {
            if (ring_.x[i] == rule.chord_a) {
                chord_from_ = static_cast<int>(i);
            } else if (ring_.x[i] == rule.chord_b) {
                chord_to_ = static_cast<int>(i);
            }
        }
        if (chord_from_ < 0 || chord_to_ < 0) {
            return false;
        }
    }
    const auto improve = [&](std::size_t i, std::size_t k, std::size_t j, double left, double right, double& best) {
        const double sides = std::min(left, right);
        if (!(sides > best) || crosses_chord(i, k) || crosses_chord(k, j) || crosses_chord(i, j)) {
            return false;
        }
        const double value = std::min(sides, triangle_quality(a, b, i, k, j, rule));
        const bool better = value > best;
        best = better ? value : best;
        return better;
    };
    if (!(table_.find(ring_.x.size(), std::numeric_limits<double>::max(), rule.floor, improve) > rule.floor)) {
        return false;
    }
    added_.clear();
    table_.for_each_triangle([&](std::size_t i, std::size_t k, std::size_t j) {
        added_.push_back({ring_.x[i], ring_.x[k], ring_.x[j], b});
        added_.push_back({ring_.x[i], ring_.x[j], ring_.x[k], a});
    });
    for (const auto& v : added_) {
        if (mesh_.orient(v[0], v[1], v[2], v[3]) <= 0) {
            return false;
        }
    }
    removed_ = ring_.cells;
    return true;
}

bool Flipper::crosses_chord(std::size_t i, std::size_t k) const {
    const auto from = static_cast<int>(i);
    const auto to = static_cast<int>(k);
    const auto between = [&](int v) { return from < v && v < to; };
    const auto end = [&](int v) { return v == from || v == to; };
    return chord_from_ >= 0 && between(chord_from_) != between(chord_to_) && !end(chord_from_) && !end(chord_to_);
}

double Flipper::triangle_quality(int a, int b, std::size_t i, std::size_t k, std::size_t j,
                                 const FlipRule& rule) const {
    const int x = ring_.x[i];
    const int y = ring_.x[k];
    const int z = ring_.x[j];
    const double above = quality({x, y, z, b}, rule);
    return above > rule.floor ? std::min(above, quality({x, z, y, a}, rule)) : above;
}

}  // namespace mq::tetrahedralise
