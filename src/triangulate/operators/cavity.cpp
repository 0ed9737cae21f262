// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/cavity.h"

#include <algorithm>
#include <cmath>

#include "triangulate/operators/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/side_lengths.h"

namespace mq::triangulate {

namespace {

// Ratio of successive step lengths of the pattern search: they shrink from a quarter of the cavity's reach to about
// 1e-4 of it, in four directions that rotate by the golden angle from step to step, so that the search does not stop at
// ridges.
constexpr double kShrink = 0.58;
constexpr double kTurn = 2.399963;  // Radians: the golden angle.

bool contains(const std::vector<int>& all, int one) {
    return std::find(all.begin(), all.end(), one) != all.end();
}

double angle_of(double squared_sine) {
    return squared_sine < 0.0 ? -1.0 : std::asin(std::sqrt(std::min(squared_sine, 1.0)));
}

bool ends_at(const ClassifiedMesh& mesh, int side, int site) {
    return mesh.site_of(side) == site || mesh.site_of(ClassifiedMesh::next(side)) == site;
}

// Returns the squared sine of the smallest angle of the triangle over a side, whose squared length is `length`; -1 if
// the triangle is inverted.
double squared_sine_over(const Vec3& from, const Vec3& to, double length, const Vec3& apex, const Vec3& normal) {
    const Vec3 a = from - apex;
    const Vec3 b = to - apex;
    const Vec3 area = a.cross(b);
    return area.dot(normal) > 0.0 ? squared_sine_of_smallest_angle(area, a.squaredNorm(), b.squaredNorm(), length)
                                  : -1.0;
}

double squared_sine_over(const ClassifiedMesh& mesh, const Cavity& disc, int side, const Vec3& apex) {
    return squared_sine_over(mesh.point_of(side), mesh.point_of(ClassifiedMesh::next(side)), squared_length(mesh, side),
                             apex, disc.normal);
}

}  // namespace

std::vector<int> triangles_around(const ClassifiedMesh& mesh, int h, std::size_t most) {
    std::vector<int> result;
    for (const int spoke : mesh.star(h, most)) {
        result.push_back(ClassifiedMesh::triangle_of(spoke));
    }
    return result;
}

namespace {

// Whether two of these sites (each occurs once) belong to one vertex: a side or two places of the parameter domain are
// one point in space. A region around such a vertex is no disc, however its corners are counted.
bool share_a_vertex(const ClassifiedMesh& mesh, const std::vector<int>& sites) {
    std::vector<int> vertices;
    vertices.reserve(sites.size());
    for (const int site : sites) {
        const int vertex = mesh.site(site).vertex;
        if (mesh.vertex(vertex).entity[0] < 2) {
            vertices.push_back(vertex);
        }
    }
    std::sort(vertices.begin(), vertices.end());
    return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

}  // namespace

std::optional<Cavity> disc_of(const ClassifiedMesh& mesh, std::vector<int> triangles) {
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    Cavity disc{std::move(triangles), {}, Vec3::Zero()};
    std::vector<int> sites;
    std::vector<int> rim_vertices;
    sites.reserve(3 * disc.triangles.size());
    disc.rim.reserve(disc.triangles.size() + 2);  // Enough without inner vertices, which make it shorter.
    rim_vertices.reserve(disc.triangles.size() + 2);
    for (const int t : disc.triangles) {
        if (narrow_corner_of(mesh, t) >= 0) {
            return std::nullopt;
        }
        disc.normal += doubled_area(mesh, t);
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            sites.push_back(mesh.site_of(h));
            if (mesh.twin(h) < 0 || !contains(disc.triangles, ClassifiedMesh::triangle_of(mesh.twin(h)))) {
                disc.rim.push_back(h);
                rim_vertices.push_back(mesh.vertex_of(h));
            }
        }
    }
    std::sort(sites.begin(), sites.end());
    sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    const std::size_t corners = sites.size();
    std::sort(rim_vertices.begin(), rim_vertices.end());
    const bool simple = std::adjacent_find(rim_vertices.begin(), rim_vertices.end()) == rim_vertices.end();
    // Euler: triangles = sides of the boundary + 2 inner corners - 2.
    const std::size_t inner = corners - disc.rim.size();
    const bool nodes_inside = std::any_of(sites.begin(), sites.end(), [&](int site) {
        const int vertex = mesh.site(site).vertex;
        return mesh.vertex(vertex).entity[0] == 0 &&
               !std::binary_search(rim_vertices.begin(), rim_vertices.end(), vertex);
    });
    if (!simple || nodes_inside || corners < disc.rim.size() ||
        disc.triangles.size() + 2 != disc.rim.size() + 2 * inner || share_a_vertex(mesh, sites)) {
        return std::nullopt;
    }
    return disc;
}

double smallest_angle(const ClassifiedMesh& mesh, const Cavity& disc) {
    double least = 1.0;
    for (const int t : disc.triangles) {
        least = std::min(least, squared_sine_of_smallest_angle(mesh, t));
    }
    return angle_of(least);
}

double fan_angle(const ClassifiedMesh& mesh, const Cavity& disc, const Vec3& apex, int apex_site, double at_least) {
    const double enough = at_least > 0.0 ? sine_squared_below(at_least) : -1.0;
    double least = 1.0;
    for (const int side : disc.rim) {
        if (!ends_at(mesh, side, apex_site)) {
            least = std::min(least, squared_sine_over(mesh, disc, side, apex));
            if (least < enough) {
                return -1.0;
            }
        }
    }
    return angle_of(least);
}

int worst_side(const ClassifiedMesh& mesh, const Cavity& disc, const Vec3& apex) {
    return *std::min_element(disc.rim.begin(), disc.rim.end(), [&](int a, int b) {
        return squared_sine_over(mesh, disc, a, apex) < squared_sine_over(mesh, disc, b, apex);
    });
}

double fan_alignment(const ClassifiedMesh& mesh, const Cavity& disc, const Corner& apex, int apex_site) {
    double least = 1.0;
    for (const int side : disc.rim) {
        if (!ends_at(mesh, side, apex_site)) {
            const Corner a = corner_of(mesh, mesh.site_of(side));
            const Corner b = corner_of(mesh, mesh.site_of(ClassifiedMesh::next(side)));
            least = std::min(least, alignment(a, b, apex));
        }
    }
    return least;
}

double disc_alignment(const ClassifiedMesh& mesh, const Cavity& disc) {
    double least = 1.0;
    for (const int t : disc.triangles) {
        least = std::min(least, alignment(mesh, t));
    }
    return least;
}

namespace {

// The sides of a cavity's boundary in contiguous memory, for many fans.
class Rim {
  public:
    Rim(const ClassifiedMesh& mesh, const Cavity& disc) : normal_(disc.normal) {
        for (const int side : disc.rim) {
            add(mesh.point_of(side), mesh.point_of(ClassifiedMesh::next(side)));
        }
        measure();
    }

    const Vec3& normal() const { return normal_; }
    const Vec3& middle() const { return middle_; }
    double reach() const { return reach_; }
    // Returns the points half way from the middle to the corners.
    std::vector<Vec3> inner_points() const {
        std::vector<Vec3> points;
        for (const Side& side : sides_) {
            points.push_back(0.5 * (middle_ + side.a));
        }
        return points;
    }

    // Returns the squared sine of the smallest angle of the fan: -1 if a triangle is inverted, or the value is below
    // `enough`. The side that failed last is tested first, since it usually fails again.
    double squared_sine(const Vec3& apex, double enough) {
        double least = 1.0;
        for (Side& side : sides_) {
            const Vec3 a = side.a - apex;
            const Vec3 b = side.b - apex;
            const Vec3 area = a.cross(b);
            const double to_a = a.squaredNorm();
            const double to_b = b.squaredNorm();
            const double product = to_a * to_b * side.length;
            const double part = area.squaredNorm() * std::min({to_a, to_b, side.length});
            if (!(area.dot(normal_) > 0.0) || part < enough * product) {  // decides most cases without a division
                std::swap(side, sides_.front());
                return -1.0;
            }
            least = product > 0.0 ? std::min(least, part / product) : 0.0;
        }
        return least;
    }

  private:
    struct Side {
        Vec3 a;
        Vec3 b;
        double length;  // squared length, mm^2
    };
    void add(const Vec3& a, const Vec3& b) { sides_.push_back({a, b, (b - a).squaredNorm()}); }
    void measure() {
        for (const Side& side : sides_) {
            middle_ += side.a / static_cast<double>(sides_.size());
        }
        for (const Side& side : sides_) {
            reach_ = std::max(reach_, (side.a - middle_).norm());
        }
    }

    std::vector<Side> sides_;
    Vec3 normal_;
    Vec3 middle_ = Vec3::Zero();
    double reach_ = 0.0;
};

// An apex, and the squared sine of the smallest angle of its fan.
struct Apex {
    Vec3 point;
    double squared_sine;

    bool improve(Rim& rim, const Vec3& p) {
        const double found = rim.squared_sine(p, squared_sine);
        if (!(found > squared_sine)) {
            return false;
        }
        *this = {p, found};
        return true;
    }
};

Apex rough_apex(Rim& rim) {
    Apex best{rim.middle(), rim.squared_sine(rim.middle(), -1.0)};
    for (const Vec3& p : rim.inner_points()) {
        best.improve(rim, p);
    }
    return best;
}

// The apexes whose fan reaches a given angle form a convex region, so that the search may start anywhere in it.
Vec3 best_apex(Rim& rim) {
    const Vec3 x = rim.normal().unitOrthogonal();
    const Vec3 y = rim.normal().cross(x).normalized();
    Apex best = rough_apex(rim);
    double step = 0.25 * rim.reach();
    for (int n = 0; n < OperatorTuning::kSearchSteps; ++n, step *= kShrink) {
        const Vec3 first = step * (std::cos(n * kTurn) * x + std::sin(n * kTurn) * y);
        const Vec3 second = step * (std::cos(n * kTurn) * y - std::sin(n * kTurn) * x);
        for (int moves = 0; moves < OperatorTuning::kMovesPerStep; ++moves) {
            const Vec3 from = best.point;
            bool better = false;
            for (const Vec3& way : {first, second, Vec3(-first), Vec3(-second)}) {
                better = best.improve(rim, from + way) || better;
            }
            if (!better) {
                break;
            }
        }
    }
    return best.point;
}

}  // namespace

Vec3 rough_apex(const ClassifiedMesh& mesh, const Cavity& disc) {
    Rim rim(mesh, disc);
    return rough_apex(rim).point;
}

Vec3 best_apex(const ClassifiedMesh& mesh, const Cavity& disc) {
    Rim rim(mesh, disc);
    return best_apex(rim);
}

bool rim_apex_legal(const ClassifiedMesh& mesh, const MaxMinSwaps& maxmin, const Cavity& disc, int apex_site) {
    std::vector<int> inside;   // vertices to which the apex is joined within the cavity
    std::vector<int> outside;  // vertices to which it is joined elsewhere on the face
    for (const int side : disc.rim) {
        if (mesh.site_of(side) != apex_site) {
            continue;
        }
        for (const int spoke : mesh.star(side)) {
            const int back = ClassifiedMesh::prev(spoke);  // half-edge of the spoke's triangle that ends at the apex
            const bool in = contains(disc.triangles, ClassifiedMesh::triangle_of(spoke));
            auto& list = in ? inside : outside;
            list.push_back(mesh.vertex_of(ClassifiedMesh::next(spoke)));
            list.push_back(mesh.vertex_of(back));
        }
    }
    const int apex = mesh.site(apex_site).vertex;
    return std::all_of(disc.rim.begin(), disc.rim.end(), [&](int side) {
        const int v = mesh.vertex_of(side);
        if (v == apex || contains(inside, v)) {
            return true;
        }
        return !contains(outside, v) && !maxmin.joined(apex, v);
    });
}

std::vector<std::array<int, 3>> fan(const ClassifiedMesh& mesh, const Cavity& disc, int apex_site) {
    std::vector<std::array<int, 3>> result;
    for (const int side : disc.rim) {
        if (!ends_at(mesh, side, apex_site)) {
            result.push_back({mesh.site_of(side), mesh.site_of(ClassifiedMesh::next(side)), apex_site});
        }
    }
    return result;
}

}  // namespace mq::triangulate
