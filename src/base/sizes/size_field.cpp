// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/sizes/size_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq {

namespace {

Vec3 offset_of(int octant) {
    return {static_cast<double>(octant & 1), static_cast<double>(octant >> 1 & 1), static_cast<double>(octant >> 2)};
}

/// The half-spaces whose intersection is a triangle or a tetrahedron.
class HalfSpaces {
  public:
    HalfSpaces(const std::array<Vec3, 4>& p, int count) {
        for (int i = 0; i < count; ++i) {
            box_.add(p[static_cast<std::size_t>(i)]);
        }
        const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
        if (count == 3) {
            add(normal, p[0], p[0] - normal);
            add(normal, p[0], p[0] + normal);
            for (std::size_t i = 0; i < 3; ++i) {
                add((p[(i + 1) % 3] - p[i]).cross(normal), p[i], p[(i + 2) % 3]);
            }
            return;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3& a = p[(i + 1) % 4];
            add((p[(i + 2) % 4] - a).cross(p[(i + 3) % 4] - a), a, p[i]);
        }
    }

    /// Whether a sphere meets all of them, and their box.
    bool meets(const Vec3& center, double radius) const {
        const Vec3 reach = Vec3::Constant(radius);
        return box_.meets({center - reach, center + reach}) &&
               std::all_of(outward_.begin(), outward_.begin() + count_,
                           [&](const auto& plane) { return plane.first.dot(center) - plane.second <= radius; });
    }

  private:
    // The half-space that has a point inside and is bounded by a plane through another one; none for a normal of no
    // length.
    void add(const Vec3& normal, const Vec3& on, const Vec3& inner) {
        const double length = normal.norm();
        if (length > 0.0) {
            const Vec3 outward = (normal.dot(inner - on) > 0.0 ? -1.0 : 1.0) / length * normal;
            outward_[count_++] = {outward, outward.dot(on)};
        }
    }

    Box box_;
    std::array<std::pair<Vec3, double>, 5> outward_;
    std::size_t count_ = 0;
};

}  // namespace

double trilinear(const SizeField::Corners& c, const Vec3& at) {
    const auto between = [](double from, double to, double t) { return from + t * (to - from); };
    const double y0 = between(between(c[0], c[1], at.x()), between(c[2], c[3], at.x()), at.y());
    const double y1 = between(between(c[4], c[5], at.x()), between(c[6], c[7], at.x()), at.y());
    return between(y0, y1, at.z());
}

SizeField::SizeField(const Vec3& low, double side, std::vector<std::int32_t> children, std::vector<Corners> leaves)
    : low_(low), side_(side), children_(std::move(children)), leaves_(std::move(leaves)) {
    bool sound = side > 0.0 && low.allFinite() && !children_.empty();
    for (std::size_t i = 0; i < children_.size() && sound; ++i) {
        const auto child = static_cast<std::int64_t>(children_[i]);
        sound = child < 0
                    ? -1 - child < static_cast<std::int64_t>(leaves_.size())
                    : child > static_cast<std::int64_t>(i) && child + 8 <= static_cast<std::int64_t>(children_.size());
    }
    const auto positive = [](const Corners& c) {
        return std::all_of(c.begin(), c.end(),
                           [](double size) { return size > 0.0 && size < std::numeric_limits<double>::infinity(); });
    };
    if (!sound || !std::all_of(leaves_.begin(), leaves_.end(), positive)) {
        throw InvalidInput(phrases::kNoSizeField);
    }
    least_ = least_by_cell();
}

std::vector<double> SizeField::least_by_cell() const {
    std::vector<double> least(children_.size());
    for (std::size_t i = children_.size(); i-- > 0;) {
        if (children_[i] < 0) {
            const Corners& corners = leaves_[static_cast<std::size_t>(-1 - children_[i])];
            least[i] = *std::min_element(corners.begin(), corners.end());
        } else {
            const auto first = least.begin() + children_[i];
            least[i] = *std::min_element(first, first + 8);
        }
    }
    return least;
}

double SizeField::at(const Vec3& point) const {
    Vec3 place = ((point - low_) / side_).cwiseMax(0.0).cwiseMin(1.0);
    std::int32_t cell = children_[0];
    while (cell >= 0) {
        const int octant = static_cast<int>(place.x() >= 0.5) + 2 * static_cast<int>(place.y() >= 0.5) +
                           4 * static_cast<int>(place.z() >= 0.5);
        place = 2.0 * place - offset_of(octant);
        cell = children_[static_cast<std::size_t>(cell + octant)];
    }
    return trilinear(leaves_[static_cast<std::size_t>(-1 - cell)], place);
}

double SizeField::least_in_simplex(const std::array<Vec3, 4>& corners, int count, double limit) const {
    const double kRadius = 0.5 * std::sqrt(3.0);  // radius of the sphere around a cell, divided by its side
    const HalfSpaces inside(corners, count);
    struct Cell {
        std::int32_t index;
        Vec3 low;
        double side;
    };
    std::vector<Cell> stack{{0, low_, side_}};
    while (!stack.empty()) {
        const Cell cell = stack.back();
        stack.pop_back();
        const auto i = static_cast<std::size_t>(cell.index);
        if (least_[i] >= limit || !inside.meets(cell.low + Vec3::Constant(0.5 * cell.side), kRadius * cell.side)) {
            continue;
        }
        if (children_[i] < 0) {
            limit = least_[i];
            continue;
        }
        for (int octant = 0; octant < 8; ++octant) {
            stack.push_back({children_[i] + octant, cell.low + 0.5 * cell.side * offset_of(octant), 0.5 * cell.side});
        }
    }
    return limit;
}

double SizeField::least_in(const Box& box) const {
    double least = std::numeric_limits<double>::infinity();
    for_each_leaf(box, [&](const Vec3&, double, const Corners& corners) {
        least = std::min(least, *std::min_element(corners.begin(), corners.end()));
    });
    if (least == std::numeric_limits<double>::infinity()) {  // beyond the cube
        least = at(box.center());
    }
    return least;
}

void SizeField::for_each_leaf(const Box& box, const Visit& visit) const {
    struct Cell {
        std::int32_t index;
        Vec3 low;
        double side;
    };
    std::vector<Cell> stack{{0, low_, side_}};
    while (!stack.empty()) {
        const Cell cell = stack.back();
        stack.pop_back();
        if (!box.meets({cell.low, cell.low + Vec3::Constant(cell.side)})) {
            continue;
        }
        const std::int32_t child = children_[static_cast<std::size_t>(cell.index)];
        if (child < 0) {
            visit(cell.low, cell.side, leaves_[static_cast<std::size_t>(-1 - child)]);
            continue;
        }
        const double half = 0.5 * cell.side;
        for (int octant = 7; octant >= 0; --octant) {
            stack.push_back({child + octant, cell.low + half * offset_of(octant), half});
        }
    }
}

}  // namespace mq
