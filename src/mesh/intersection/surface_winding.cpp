// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/surface_winding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/segment_distance.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::mesh {

namespace {

/// Triangles at a distance of more than this many radii are summed as one: the neglected terms are of third order in
/// its inverse.
constexpr double kFar = 2.5;
/// Bounds sum border edges as one at a distance of more than this many widths of their box: that adds at most a quarter
/// of the sum of their single contributions.
constexpr double kFarBorder = 4.0;
constexpr double kWhole = 4.0 * M_PI;
/// If the bound by area, times the size of the triangles, exceeds this, the bound by the border is computed as well.
constexpr double kLongBorder = 4.0;

/// The solid angle of the triangle (a, b, c) from the origin (Van Oosterom and Strackee 1983).
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double volume = a.dot(b.cross(c));
    return 2.0 * std::atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

/// The line integral of dl x r / |r|^3 along an edge from whose ends a point is off by r and s; zero on its line.
Vec3 along_edge(const Vec3& r, const Vec3& s) {
    const double lr = r.norm(), ls = s.norm(), below = lr * ls * (lr * ls + r.dot(s));
    return below > 0.0 ? Vec3((lr + ls) / below * r.cross(s)) : Vec3(Vec3::Zero());
}

double distance_to(const Box& box, const Vec3& p) {
    return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0).norm();
}

/// The border: edges along which more triangles run in one direction than in the other, see SurfaceWinding::border.
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

SurfaceWinding::SurfaceWinding(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles)
    : vertices_(vertices),
      triangles_(triangles),
      border_(border_of(triangles)),
      tree_(vertices, triangles),
      border_tree_(vertices, border_) {
    sum_moments();
    sum_currents();
}

void SurfaceWinding::Moments::add(const Moments& other) {
    area += other.area;
    centre += other.centre;
    normal += other.normal;
    first += other.first;
    for (int i = 0; i < 3; ++i) {
        second[i] += other.second[i];
    }
}

/// Turns moments about an origin, whose centre is the sum of area times position, into moments about the centre of
/// area.
void SurfaceWinding::Moments::move_to_centre(const Vec3& origin) {
    const Vec3 c = area > 0.0 ? Vec3(centre / area) : Vec3(Vec3::Zero());
    for (int i = 0; i < 3; ++i) {
        const Vec3 m = first.col(i);
        second[i] += normal[i] * c * c.transpose() - c * m.transpose() - m * c.transpose();
    }
    first -= c * normal.transpose();
    centre = origin + c;
}

void SurfaceWinding::sum_moments() {
    moments_.resize(tree_.node_count());
    // Measured from the middle of the box, which keeps the sums short.
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

void SurfaceWinding::sum_currents() {
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
double SurfaceWinding::far_winding(const Moments& moments, const Vec3& r, double distance) {
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

double SurfaceWinding::at(const Vec3& p) const {
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

Vec3 SurfaceWinding::gradient(const Vec3& p) const {
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
            sum += along_edge(p - vertices_[border_[edge][0]], p - vertices_[border_[edge][1]]);
        });
    return sum / kWhole;
}

double SurfaceWinding::steepest(const Vec3& p, double radius) const {
    const double by_border = steepest_by_border(p, radius);
    // The bound by the border is tight for a single sheet; the border of many loose triangles is long, and its pieces
    // cancel each other.
    return by_border > kLongBorder / tree_.box().largest_side() ? std::min(by_border, steepest_by_area(p, radius))
                                                                : by_border;
}

/// Each piece of area is a dipole, whose gradient is at most 2 / r^3.
double SurfaceWinding::steepest_by_area(const Vec3& p, double radius) const {
    double sum = 0.0;
    tree_.for_each_divided(
        [&](std::int32_t node) {
            const Moments& moments = moments_[node];
            const double distance = (moments.centre - p).norm() - moments.radius - radius;
            if (distance <= 2.0 * moments.radius) {
                return true;
            }
            sum += 2.0 * moments.area / (distance * distance * distance);
            return false;
        },
        [&](std::int32_t triangle) {
            const Triangle& t = triangles_[triangle];
            const Vec3 &a = vertices_[t[0]], &b = vertices_[t[1]], &c = vertices_[t[2]];
            const double distance = (nearest_on_triangle(p, a, b, c) - p).norm() - radius;
            sum += distance > 0.0 ? (b - a).cross(c - a).norm() / (distance * distance * distance)
                                  : std::numeric_limits<double>::infinity();
        });
    return sum / kWhole;
}

/// The lower of two bounds: the sum of what pieces of the border add at most, and the gradient at p with how much it
/// changes in the ball and by taking far pieces together.
double SurfaceWinding::steepest_by_border(const Vec3& p, double radius) const {
    double sum = 0.0, change = 0.0;
    Vec3 gradient = Vec3::Zero();
    border_tree_.for_each_divided(
        [&](std::int32_t node) {
            const Current& current = currents_[node];
            const double wide = (current.box.high - current.box.low).norm();
            const double distance = distance_to(current.box, p) - radius;
            if (distance <= kFarBorder * wide) {
                return true;
            }
            const Vec3 r = p - current.centre;
            const double far = r.norm();
            sum += current.length / (distance * distance);
            change += current.length * (wide + 2.0 * radius) / (distance * distance * distance);
            gradient += current.along.cross(r) / (far * far * far);
            return false;
        },
        [&](std::int32_t edge) {
            const Vec3 &a = vertices_[border_[edge][0]], &b = vertices_[border_[edge][1]];
            const double distance = distance_to_segment(p, a, b) - radius, length = (b - a).norm();
            const double inverse = distance > 0.0 ? 1.0 / distance : std::numeric_limits<double>::infinity();
            sum += length * inverse * inverse;
            change += 2.0 * radius * length * inverse * inverse * inverse;
            gradient += along_edge(p - a, p - b);
        });
    const double near = gradient.norm() + change;
    return (near < sum ? near : sum) / kWhole;
}

}  // namespace mq::mesh
