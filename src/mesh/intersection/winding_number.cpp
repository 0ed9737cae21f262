// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/winding_number.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/segment_distance.h"

namespace mq::mesh {

namespace {

/// Triangles are taken together from this many radii on: the terms left out are of the third order in its inverse.
constexpr double kFar = 2.5;
constexpr double kWhole = 4.0 * M_PI;

/// The solid angle of the triangle (a, b, c) from the origin (Van Oosterom and Strackee 1983).
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double volume = a.dot(b.cross(c));
    return 2.0 * std::atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double distance_to(const Box& box, const Vec3& p) {
    return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0).norm();
}

/// The edges along which more triangles run one way than the other, see WindingNumber::border.
std::vector<Triangle> border_of(const std::vector<Triangle>& triangles) {
    std::vector<std::array<std::int32_t, 3>> edges;  // low vertex, high vertex, 1 upward or -1
    edges.reserve(3 * triangles.size());
    for (const Triangle& t : triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::int32_t from = t[i], to = t[(i + 1) % 3];
            if (from != to) {
                edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
            }
        }
    }
    std::sort(edges.begin(), edges.end());
    std::vector<Triangle> border;
    for (std::size_t i = 0; i < edges.size();) {
        const auto [low, high, first] = edges[i];
        std::int32_t sum = 0;
        for (; i < edges.size() && edges[i][0] == low && edges[i][1] == high; ++i) {
            sum += edges[i][2];
        }
        const Triangle edge = sum > 0 ? Triangle{low, high, high} : Triangle{high, low, low};
        border.insert(border.end(), static_cast<std::size_t>(std::abs(sum)), edge);
    }
    return border;
}

}  // namespace

WindingNumber::WindingNumber(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles)
    : vertices_(vertices),
      triangles_(triangles),
      border_(border_of(triangles)),
      tree_(vertices, triangles),
      border_tree_(vertices, border_) {
    sum_moments();
    sum_currents();
}

void WindingNumber::Moments::add(const Moments& other) {
    area += other.area;
    centre += other.centre;
    normal += other.normal;
    first += other.first;
    for (int i = 0; i < 3; ++i) {
        second[i] += other.second[i];
    }
}

/// Moments from an origin, with the centre as the sum of area times place, become those from the centre.
void WindingNumber::Moments::move_to_centre(const Vec3& origin) {
    const Vec3 c = area > 0.0 ? Vec3(centre / area) : Vec3(Vec3::Zero());
    for (int i = 0; i < 3; ++i) {
        const Vec3 m = first.col(i);
        second[i] += normal[i] * c * c.transpose() - c * m.transpose() - m * c.transpose();
    }
    first -= c * normal.transpose();
    centre = origin + c;
}

void WindingNumber::sum_moments() {
    moments_.resize(tree_.node_count());
    // From the middle of the box, which keeps the sums short.
    const Vec3 middle = tree_.box().empty() ? Vec3(Vec3::Zero()) : tree_.box().center();
    tree_.sum_up(
        [&](std::int32_t node, std::int32_t triangle) {
            const Triangle& t = triangles_[triangle];
            const std::array<Vec3, 3> p{vertices_[t[0]] - middle, vertices_[t[1]] - middle, vertices_[t[2]] - middle};
            const Vec3 sum = p[0] + p[1] + p[2];
            Eigen::Matrix3d square = sum * sum.transpose();
            for (const Vec3& q : p) {
                square += q * q.transpose();
            }
            Moments one;
            one.normal = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]);
            one.area = one.normal.norm();
            one.centre = one.area / 3.0 * sum;
            one.first = sum / 3.0 * one.normal.transpose();
            for (int i = 0; i < 3; ++i) {
                one.second[i] = one.normal[i] / 12.0 * square;
            }
            moments_[node].add(one);
        },
        [&](std::int32_t node, std::int32_t child) { moments_[node].add(moments_[child]); });
    for (std::size_t n = 0; n < moments_.size(); ++n) {
        const Box box = tree_.node_box(static_cast<std::int32_t>(n));
        moments_[n].move_to_centre(middle);
        moments_[n].radius = (moments_[n].centre - box.low).cwiseMax(box.high - moments_[n].centre).norm();
    }
}

void WindingNumber::sum_currents() {
    currents_.resize(border_tree_.node_count());
    border_tree_.sum_up(
        [&](std::int32_t node, std::int32_t edge) {
            const Vec3 &a = vertices_[border_[edge][0]], &b = vertices_[border_[edge][1]];
            Current& current = currents_[node];
            current.length += (b - a).norm();
            current.along += b - a;
            current.centre += 0.5 * (b - a).norm() * (a + b);
        },
        [&](std::int32_t node, std::int32_t child) {
            currents_[node].length += currents_[child].length;
            currents_[node].along += currents_[child].along;
            currents_[node].centre += currents_[child].centre;
        });
    for (std::size_t n = 0; n < currents_.size(); ++n) {
        currents_[n].box = border_tree_.node_box(static_cast<std::int32_t>(n));
        currents_[n].centre /= currents_[n].length;
    }
}

/// The first three terms of the expansion of r / |r|^3 at the centre, which lies at r.
double WindingNumber::far_winding(const Moments& moments, const Vec3& r, double distance) {
    const double square = distance * distance;
    double traces = 0.0, cubes = 0.0;
    Vec3 mixed = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        traces += moments.second[i].trace() * r[i];
        mixed += moments.second[i].col(i);
        cubes += r[i] * r.dot(moments.second[i] * r);
    }
    const double first = moments.first.trace() - 3.0 * r.dot(moments.first * r) / square;
    const double second = (7.5 * cubes / square - 1.5 * (2.0 * mixed.dot(r) + traces)) / square;
    return (moments.normal.dot(r) + first + second) / (square * distance);
}

double WindingNumber::at(const Vec3& p) const {
    double sum = 0.0;
    tree_.for_each_divided(
        [&](std::int32_t node) {
            const Moments& moments = moments_[node];
            const Vec3 r = moments.centre - p;
            const double distance = r.norm();
            if (distance <= kFar * moments.radius) {
                return true;
            }
            sum += far_winding(moments, r, distance);
            return false;
        },
        [&](std::int32_t triangle) {
            const Triangle& t = triangles_[triangle];
            sum += solid_angle(vertices_[t[0]] - p, vertices_[t[1]] - p, vertices_[t[2]] - p);
        });
    return sum / kWhole;
}

Vec3 WindingNumber::gradient(const Vec3& p) const {
    Vec3 sum = Vec3::Zero();
    border_tree_.for_each_divided(
        [&](std::int32_t node) {
            const Current& current = currents_[node];
            const Vec3 r = p - current.centre;
            const double distance = r.norm();
            if (distance <= kFar * (current.box.high - current.box.low).norm()) {
                return true;
            }
            sum += current.along.cross(r) / (distance * distance * distance);
            return false;
        },
        [&](std::int32_t edge) {
            const Vec3 r = p - vertices_[border_[edge][0]], s = p - vertices_[border_[edge][1]];
            const double lr = r.norm(), ls = s.norm(), below = lr * ls * (lr * ls + r.dot(s));
            if (below > 0.0) {
                sum += (lr + ls) / below * r.cross(s);
            }
        });
    return sum / kWhole;
}

double WindingNumber::steepest(const Vec3& p, double radius) const {
    double sum = 0.0;
    border_tree_.for_each_divided(
        [&](std::int32_t node) {
            const Current& current = currents_[node];
            const double distance = distance_to(current.box, p) - radius;
            // A box wider than it is far is divided, as its nearest point says little of the others.
            if (distance <= (current.box.high - current.box.low).norm()) {
                return true;
            }
            sum += current.length / (distance * distance);
            return false;
        },
        [&](std::int32_t edge) {
            const Vec3 &a = vertices_[border_[edge][0]], &b = vertices_[border_[edge][1]];
            const double distance = distance_to_segment(p, a, b) - radius;
            sum += distance > 0.0 ? (b - a).norm() / (distance * distance) : std::numeric_limits<double>::infinity();
        });
    return sum / kWhole;
}

}  // namespace mq::mesh
