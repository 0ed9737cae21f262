// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/interior_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tetrahedralise/cells/cell_measure.h"
#include "tetrahedralise/tuning.h"

namespace mq::tetrahedralise {

namespace {

/// The centre of the sphere through four points, and its radius.
struct Sphere {
    Vec3 center;
    double radius;
};

Sphere circumsphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 ad = d - a;
    const double volume = 2.0 * ab.cross(ac).dot(ad);
    const Vec3 to =
        (ad.squaredNorm() * ab.cross(ac) + ac.squaredNorm() * ad.cross(ab) + ab.squaredNorm() * ac.cross(ad)) / volume;
    return {a + to, to.norm()};
}

}  // namespace

InteriorPoints::InteriorPoints(Tetrahedralisation& mesh, const std::vector<std::array<int, 3>>& surface, double growth,
                               const SizeField* field)
    : mesh_(mesh), growth_(growth), field_(field), length_(mesh.points.size(), 0.0), locator_(mesh), insertion_(mesh) {
    std::vector<int> count(mesh.points.size(), 0);
    for (const auto& t : surface) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = t[k];
            const int b = t[(k + 1) % 3];
            const double length = (mesh.point(a) - mesh.point(b)).norm();
            length_[a] += length;
            length_[b] += length;
            ++count[a];
            ++count[b];
        }
    }
    for (std::size_t v = 0; v < length_.size(); ++v) {
        length_[v] = count[v] > 0 ? length_[v] / count[v] : std::numeric_limits<double>::infinity();
    }
    // Starts with points inside that recovery has left.
    std::vector<int> star;
    for (std::size_t v = 0; v < length_.size(); ++v) {
        if (count[v] == 0) {
            mesh.star(static_cast<int>(v), star);
            for (const int c : star) {
                for (const int w : mesh.cells[c].v) {
                    const double length =
                        length_[w] + growth * (mesh.point(static_cast<int>(v)) - mesh.point(w)).norm();
                    length_[v] = std::min(length_[v], length);
                }
            }
        }
    }
}

void InteriorPoints::insert(const Progress& progress) {
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
        if (mesh_.alive(static_cast<int>(c))) {
            consider(static_cast<int>(c));
        }
    }
    while (!queue_.empty()) {
        progress.check();
        std::pop_heap(queue_.begin(), queue_.end());
        const Candidate top = queue_.back();
        queue_.pop_back();
        if (mesh_.cells[top.cell].v != top.v) {
            continue;
        }
        const auto& v = top.v;
        const Sphere sphere = circumsphere(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3]));
        if (try_point(sphere.center, top.cell)) {
            continue;
        }
        try_point(0.25 * (mesh_.point(v[0]) + mesh_.point(v[1]) + mesh_.point(v[2]) + mesh_.point(v[3])), top.cell);
    }
}

void InteriorPoints::consider(int cell) {
    const std::array<int, 4>& v = mesh_.cells[cell].v;
    const Sphere sphere = circumsphere(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3]));
    double length = std::numeric_limits<double>::infinity();
    for (const int k : v) {
        length = std::min(length, length_[k] + growth_ * sphere.radius);
    }
    double ratio = sphere.radius / length;
    if (field_ != nullptr) {
        const std::array<const Vec3*, 4> corners{&mesh_.point(v[0]), &mesh_.point(v[1]), &mesh_.point(v[2]),
                                                 &mesh_.point(v[3])};
        double excess = excess_of_edges(corners, *field_);
        excess = excess > 1.0 ? excess : std::max(excess, excess_by_least(corners, *field_));
        ratio = std::max(ratio, TetrahedralisationTuning::kLargestRadius * excess);
    }
    if (ratio > TetrahedralisationTuning::kLargestRadius) {
        queue_.push_back({ratio, cell, v});
        std::push_heap(queue_.begin(), queue_.end());
    }
}

bool InteriorPoints::try_point(const Vec3& p, int cell) {
    if (!p.allFinite()) {
        return false;
    }
    const int at = locator_.find(p, cell);
    if (at < 0 || !insertion_.open(p, at)) {
        return false;
    }
    const double length = length_at(p, insertion_.corners());
    if (!is_far_enough(p, length)) {
        return false;
    }
    insertion_.close(mesh_.add_point(p));
    length_.push_back(length);
    for (const int c : insertion_.created()) {
        consider(c);
    }
    return true;
}

double InteriorPoints::length_at(const Vec3& p, const std::vector<int>& around) const {
    double length = std::numeric_limits<double>::infinity();
    for (const int v : around) {
        length = std::min(length, length_[v] + growth_ * (mesh_.point(v) - p).norm());
    }
    return field_ != nullptr ? std::min(length, field_->at(p)) : length;
}

/// Whether the vertices and the surface around are far enough away.
bool InteriorPoints::is_far_enough(const Vec3& p, double length) const {
    const double least = TetrahedralisationTuning::kLeastDistance * length;
    for (const int v : insertion_.corners()) {
        if ((mesh_.point(v) - p).squaredNorm() < least * least) {
            return false;
        }
    }
    const double height = TetrahedralisationTuning::kLeastHeight * length;
    for (const int c : insertion_.cavity()) {
        for (int face = 0; face < 4; ++face) {
            if (mesh_.cells[c].n[face] >= 0) {
                continue;
            }
            const auto at = [&](int k) -> const Vec3& { return mesh_.point(mesh_.cells[c].v[kFaceOf[face][k]]); };
            const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0));
            if (normal.dot(p - at(0)) < height * normal.norm()) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace mq::tetrahedralise
