// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/removal_cavity.h"

#include <algorithm>
#include <cmath>

#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

// Returns the squared sine of the smallest angle, which is 60 degrees at most; -1 if the triangle is inverted.
double squared_sine(const ClassifiedMesh& mesh, const std::array<int, 3>& sites, const Vec3& normal) {
    const Vec3& a = mesh.site(sites[0]).point;
    const Vec3& b = mesh.site(sites[1]).point;
    const Vec3& c = mesh.site(sites[2]).point;
    const Vec3 area = (b - a).cross(c - a);
    if (!(area.dot(normal) > 0.0)) {
        return -1.0;
    }
    return squared_sine_of_smallest_angle(area, (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm());
}

Fan fan_from(const ClassifiedMesh& mesh, const RemovalCavity& cavity, int apex_site, double least_angle) {
    const double enough = std::pow(std::sin(least_angle), 2);
    double least = 1.0;
    for (const auto& side : cavity.sides) {
        if (side[0] != apex_site && side[1] != apex_site) {
            least = std::min(least, squared_sine(mesh, {side[0], side[1], apex_site}, cavity.normal));
            if (least < enough) {
                return {};
            }
        }
    }
    Fan fan;
    fan.apex_site = apex_site;
    fan.angle = std::asin(std::sqrt(least));
    fan.triangles.reserve(cavity.sides.size());
    for (const auto& side : cavity.sides) {
        if (side[0] != apex_site && side[1] != apex_site) {
            fan.triangles.push_back({side[0], side[1], apex_site});
        }
    }
    return fan;
}

}  // namespace

std::optional<RemovalCavity> removal_cavity(const ClassifiedMesh& mesh, int half_edge) {
    RemovalCavity cavity;
    const std::vector<int> star = mesh.star(half_edge);
    std::vector<int> vertices;
    cavity.triangles.reserve(star.size());
    cavity.sides.reserve(star.size() + 1);
    vertices.reserve(star.size() + 1);
    for (const int spoke : star) {
        const int t = ClassifiedMesh::triangle_of(spoke);
        if (narrow_corner_of(mesh, t) >= 0) {
            return std::nullopt;
        }
        cavity.triangles.push_back(t);
        cavity.sides.push_back({mesh.site_of(ClassifiedMesh::next(spoke)), mesh.site_of(ClassifiedMesh::prev(spoke))});
        cavity.normal += (mesh.point_of(ClassifiedMesh::next(spoke)) - mesh.point_of(spoke))
                             .cross(mesh.point_of(ClassifiedMesh::prev(spoke)) - mesh.point_of(spoke));
    }
    if (mesh.twin(ClassifiedMesh::prev(star.back())) < 0) {
        cavity.base = {cavity.sides.back()[1], cavity.sides.front()[0]};
        cavity.sides.push_back(cavity.base);
    }
    for (std::size_t i = 0; i < cavity.sides.size(); ++i) {
        vertices.push_back(mesh.site(cavity.sides[i][0]).vertex);
        if (cavity.sides[i][1] != cavity.sides[(i + 1) % cavity.sides.size()][0]) {
            return std::nullopt;  // a pole, with one site for each of its images in the parameter domain
        }
    }
    std::sort(vertices.begin(), vertices.end());
    if (std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end()) {
        return std::nullopt;
    }
    return cavity;
}

std::vector<int> spokes_of(const RemovalCavity& cavity, int apex_site) {
    std::vector<int> ends;
    ends.reserve(cavity.sides.size());
    for (const auto& side : cavity.sides) {
        ends.push_back(side[0]);
    }
    for (const auto& side : cavity.sides) {
        if (side[0] == apex_site || side[1] == apex_site) {
            ends.erase(std::remove_if(ends.begin(), ends.end(), [&](int s) { return s == side[0] || s == side[1]; }),
                       ends.end());
        }
    }
    return ends;
}

std::vector<Fan> fans_of(const ClassifiedMesh& mesh, const RemovalCavity& cavity, double least_angle) {
    std::vector<Fan> fans;
    for (const auto& side : cavity.sides) {
        Fan fan = fan_from(mesh, cavity, side[0], least_angle);
        if (fan.apex_site >= 0) {
            fans.push_back(std::move(fan));
        }
    }
    std::stable_sort(fans.begin(), fans.end(), [](const Fan& a, const Fan& b) { return a.angle > b.angle; });
    return fans;
}

bool fan_aligned(const ClassifiedMesh& mesh, const RemovalCavity& cavity, const Fan& fan, double aligned) {
    double worst = 1.0;
    for (const auto& t : fan.triangles) {
        worst = std::min(worst, alignment(corner_of(mesh, t[0]), corner_of(mesh, t[1]), corner_of(mesh, t[2])));
    }
    return worst >= aligned || (worst >= kAligned && std::any_of(cavity.triangles.begin(), cavity.triangles.end(),
                                                                 [&](int t) { return alignment(mesh, t) <= worst; }));
}

// All inner edges of the cavity end at its vertex, so an edge between two of its corners lies outside.
bool fan_legal(const ClassifiedMesh& mesh, const MaxMinSwaps& maxmin, const RemovalCavity& cavity, int apex_site) {
    int h = -1;  // leaves the apex
    for (const int t : cavity.triangles) {
        for (int k = 3 * t; k < 3 * t + 3; ++k) {
            h = mesh.site_of(k) == apex_site ? k : h;
        }
    }
    const int apex = mesh.site(apex_site).vertex;
    std::vector<int> joined;
    const std::vector<int> star = mesh.star(h);
    joined.reserve(2 * star.size());
    for (const int spoke : star) {
        joined.push_back(mesh.vertex_of(ClassifiedMesh::next(spoke)));
        joined.push_back(mesh.vertex_of(ClassifiedMesh::prev(spoke)));
    }
    const std::vector<int> ends = spokes_of(cavity, apex_site);
    return std::none_of(ends.begin(), ends.end(), [&](int site) {
        const int v = mesh.site(site).vertex;
        return v == apex || maxmin.joined(apex, v) || std::find(joined.begin(), joined.end(), v) != joined.end();
    });
}

}  // namespace mq::triangulate
