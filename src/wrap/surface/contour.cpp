// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/surface/contour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/key_set.h"
#include "wrap/lattice/tuning.h"
#include "wrap/surface/quadric.h"

namespace mq::wrap {

namespace {

using Corners = std::array<Vec3, 4>;

bool sharp(const Crossing& a, const Crossing& b) {
    return a.source >= 0 && b.source >= 0 && a.normal.dot(b.normal) < WrapTuning::kSharpCosine;
}

/// Barycentric coordinates of a point in a tetrahedron.
std::array<double, 4> barycentric(const Vec3& p, const Corners& c) {
    const auto volume = [](const Vec3& u, const Vec3& v, const Vec3& w, const Vec3& x) {
        return (v - u).cross(w - u).dot(x - u);
    };
    const double whole = volume(c[0], c[1], c[2], c[3]);
    return {volume(p, c[1], c[2], c[3]) / whole, volume(c[0], p, c[2], c[3]) / whole,
            volume(c[0], c[1], p, c[3]) / whole, volume(c[0], c[1], c[2], p) / whole};
}

/// The point itself where it is inside of the cell; else the last one on the way to it from `middle`, which is.
Vec3 kept_inside(const Vec3& point, const Vec3& middle, const Corners& corners) {
    const std::array<double, 4> there = barycentric(point, corners);
    const std::array<double, 4> here = barycentric(middle, corners);
    double share = 1.0;
    for (std::size_t k = 0; k < 4; ++k) {
        const double inset = std::min(WrapTuning::kInset, 0.5 * here[k]);
        if (there[k] < inset) {
            share = std::min(share, (here[k] - inset) / (here[k] - there[k]));
        }
    }
    return middle + share * (point - middle);
}

class ContourBuilder {
  public:
    ContourBuilder(const NodeStates& states, const CrossedCells& cells, const Progress& progress)
        : states_(states), cells_(cells), pace_(progress) {}

    Contour run() {
        for (const Crossing& crossing : cells_.crossings) {
            result_.points.push_back(crossing.point);
        }
        for (const CrossedCell& cell : cells_.cells) {
            pace_.step();
            add(cell);
        }
        return std::move(result_);
    }

  private:
    const Crossing& crossing(const CrossedCell& cell, int k) const {
        return cells_.crossings[static_cast<std::size_t>(cell.crossings[static_cast<std::size_t>(k % cell.count)])];
    }

    void add(const CrossedCell& cell) {
        bool is_sharp = false;
        for (int i = 0; i < cell.count; ++i) {
            for (int j = i + 1; j < cell.count; ++j) {
                is_sharp = is_sharp || sharp(crossing(cell, i), crossing(cell, j));
            }
        }
        if (is_sharp) {
            add_cone(cell);
        } else {
            add_flat(cell);
        }
    }

    void add_triangle(const mesh::Triangle& triangle, std::int32_t source, std::int32_t plane) {
        result_.triangles.push_back(triangle);
        result_.source.push_back(source);
        result_.plane.push_back(plane);
    }

    /// That of a triangle or a pair of them: -1 where one of the crossings closes a gap.
    std::int32_t source_of(const CrossedCell& cell) const {
        std::int32_t source = crossing(cell, 0).source;
        for (int k = 1; k < cell.count; ++k) {
            source = crossing(cell, k).source < 0 ? -1 : source;
        }
        return source;
    }

    void add_flat(const CrossedCell& cell) {
        const auto& p = cell.crossings;
        const std::int32_t source = source_of(cell);
        const std::int32_t plane = source < 0 ? -1 : p[0];
        if (cell.count == 3) {
            add_triangle({p[0], p[1], p[2]}, source, plane);
            return;
        }
        const auto length = [&](int a, int b) {
            return (crossing(cell, a).point - crossing(cell, b).point).squaredNorm();
        };
        if (length(0, 2) <= length(1, 3)) {
            add_triangle({p[0], p[1], p[2]}, source, plane);
            add_triangle({p[0], p[2], p[3]}, source, plane);
        } else {
            add_triangle({p[1], p[2], p[3]}, source, plane);
            add_triangle({p[1], p[3], p[0]}, source, plane);
        }
    }

    void add_cone(const CrossedCell& cell) {
        Corners corners;
        for (std::size_t k = 0; k < 4; ++k) {
            corners[k] = states_.position(cell.nodes[k]);
        }
        Vec3 middle = Vec3::Zero();
        Quadric planes;
        for (int k = 0; k < cell.count; ++k) {
            middle += crossing(cell, k).point / cell.count;
            planes.add_plane(crossing(cell, k).on_input, crossing(cell, k).normal, 1.0);
        }
        const auto apex = static_cast<std::int32_t>(result_.points.size());
        result_.points.push_back(kept_inside(planes.least(middle, WrapTuning::kFlatShare), middle, corners));
        for (int k = 0; k < cell.count; ++k) {
            const std::int32_t from = cell.crossings[static_cast<std::size_t>(k)];
            const std::int32_t to = cell.crossings[static_cast<std::size_t>((k + 1) % cell.count)];
            const std::int32_t source = crossing(cell, k).source;
            const std::int32_t next = crossing(cell, k + 1).source;
            const std::int32_t between = on_face(cell, from, to);
            if (between >= 0) {
                add_triangle({apex, from, between}, source, from);
                add_triangle({apex, between, to}, next, to);
            } else if (source < 0 || next < 0) {
                add_triangle({apex, from, to}, -1, -1);
            } else {
                add_triangle({apex, from, to}, source, from);
            }
        }
    }

    /// The point on the face of the cell with two crossings, which both of its cells share; -1: there is none.
    std::int32_t on_face(const CrossedCell& cell, std::int32_t from, std::int32_t to) {
        const Crossing& a = cells_.crossings[static_cast<std::size_t>(from)];
        const Crossing& b = cells_.crossings[static_cast<std::size_t>(to)];
        if (!sharp(a, b)) {
            return -1;
        }
        const auto [at, is_new] = on_face_.insert({pair_key(from, to), -1});
        if (is_new) {
            at.value() = static_cast<std::int32_t>(result_.points.size());
            result_.points.push_back(face_point(cell, a, b));
        }
        return at->second;
    }

    /// Where both planes meet on the face; the middle of the crossings where that is not on it.
    Vec3 face_point(const CrossedCell& cell, const Crossing& a, const Crossing& b) const {
        const std::array<Vec3, 3> face = face_of(cell, a.point, b.point);
        const Vec3 middle = 0.5 * (a.point + b.point);
        const Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
        const Vec3 along = normal.cross(a.normal);
        const double turn = along.dot(b.normal);
        if (std::abs(turn) < 1e-6) {
            return middle;
        }
        const Vec3 point = a.point + along * ((b.point - a.point).dot(b.normal) / turn);
        const double area = (face[1] - face[0]).cross(face[2] - face[0]).dot(normal);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& u = face[(k + 1) % 3];
            const Vec3& v = face[(k + 2) % 3];
            if ((u - point).cross(v - point).dot(normal) < WrapTuning::kInset * area) {
                return middle;
            }
        }
        return point;
    }

    /// The corners of the face of the cell on which two points lie.
    std::array<Vec3, 3> face_of(const CrossedCell& cell, const Vec3& a, const Vec3& b) const {
        Corners corners;
        for (std::size_t k = 0; k < 4; ++k) {
            corners[k] = states_.position(cell.nodes[k]);
        }
        const std::array<double, 4> there = barycentric(0.5 * (a + b), corners);
        const auto opposite = static_cast<std::size_t>(std::min_element(there.begin(), there.end()) - there.begin());
        return {corners[(opposite + 1) % 4], corners[(opposite + 2) % 4], corners[(opposite + 3) % 4]};
    }

    const NodeStates& states_;
    const CrossedCells& cells_;
    CancelPace pace_;
    KeyMap<std::int32_t> on_face_;
    Contour result_;
};

}  // namespace

Contour contour(const NodeStates& states, const CrossedCells& cells, const Progress& progress) {
    return ContourBuilder(states, cells, progress).run();
}

}  // namespace mq::wrap
