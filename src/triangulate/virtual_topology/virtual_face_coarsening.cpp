// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/virtual_topology/virtual_face_coarsening.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "mesh/intersection/triangle_distance.h"
#include "triangulate/operators/cavity_replacement.h"
#include "triangulate/virtual_topology/tuning.h"
#include "triangulate/work_mesh/side_lengths.h"

namespace mq::triangulate {

namespace {

// Allowed distance in resolutions of single precision if there is no tolerance, for rounding on plane faces.
constexpr double kNoTolerance = 4.0;

std::vector<Vec3> samples_of_fan(const ClassifiedMesh& mesh, const Cavity& disc, const Vec3& apex, int apex_site) {
    std::vector<Vec3> points;
    for (const int side : disc.rim) {
        const int next = ClassifiedMesh::next(side);
        if (mesh.site_of(side) != apex_site) {
            sample_edge(mesh.point_of(side), apex, points);
            if (mesh.site_of(next) != apex_site) {
                sample_triangle(mesh.point_of(side), mesh.point_of(next), apex, points);
            }
        }
    }
    return points;
}

// Returns the sites that the boundary surrounds.
std::vector<int> inner_sites(const ClassifiedMesh& mesh, const Cavity& disc) {
    std::vector<int> rim;
    for (const int side : disc.rim) {
        rim.push_back(mesh.site_of(side));
    }
    std::vector<int> inner;
    for (const int t : disc.triangles) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const int site = mesh.site_of(h);
            if (std::find(rim.begin(), rim.end(), site) == rim.end() &&
                std::find(inner.begin(), inner.end(), site) == inner.end()) {
                inner.push_back(site);
            }
        }
    }
    return inner;
}

double farthest(const std::vector<SurfaceProjection>& feet) {
    double worst = 0.0;
    for (const SurfaceProjection& foot : feet) {
        worst = std::max(worst, foot.distance);
    }
    return worst;
}

}  // namespace

VirtualFaceCoarsening::VirtualFaceCoarsening(Workspace& work, double min_angle_degrees, const Sizing& sizing,
                                             VirtualFaces& patches)
    : work_(work), bound_(min_angle_degrees * kDegree), sizing_(sizing), patches_(patches) {
    find_half_edges();
}

void VirtualFaceCoarsening::find_half_edges() {
    half_edge_of_.assign(static_cast<std::size_t>(work_.mesh.vertex_count()), -1);
    for (int h = work_.mesh.half_edge_count() - 1; h >= 0; --h) {
        half_edge_of_[static_cast<std::size_t>(work_.mesh.vertex_of(h))] = h;
    }
}

bool VirtualFaceCoarsening::admissible(const Cavity& disc) const {
    const std::vector<int> inner = inner_sites(work_.mesh, disc);
    // Two coinciding triangles over a removed edge have a boundary of two sides: no triangles could replace them.
    return disc.rim.size() > 2 &&
           std::none_of(inner.begin(), inner.end(),
                        [&](int site) { return patches_.locked(work_.mesh.site(site).vertex); }) &&
           patches_.sheets(disc.triangles, Vec3::Zero()).faces.size() <= VirtualTopologyTuning::kMaxFacesBelow;
}

// Returns the CAD samples of the disc, including its inner vertices, which are points of the shape.
std::vector<CadSample> VirtualFaceCoarsening::passengers(const Cavity& disc) const {
    const ClassifiedMesh& mesh = work_.mesh;
    std::vector<CadSample> all = patches_.passengers(work_, disc.triangles);
    for (const int site : inner_sites(mesh, disc)) {
        const Vec3& point = mesh.vertex(mesh.site(site).vertex).point;
        all.push_back({point, patches_.face_of_site(site), mesh.site(site).uv, 0.0});
    }
    return all;
}

bool VirtualFaceCoarsening::near_surface(const Cavity& disc, const Vec3& apex, int apex_site) const {
    const std::vector<CadSample> all = passengers(disc);
    double allowed = VirtualTopologyTuning::kCoarseningMargin * sizing_.tolerance;
    if (!(sizing_.tolerance > 0.0)) {
        allowed = kNoTolerance * work_.grid.resolution();
        for (const CadSample& passenger : all) {
            allowed = std::max(allowed, passenger.distance);
        }
    }
    return near_passengers(disc, apex, apex_site, all, allowed) &&
           farthest(project_onto(work_, samples_of_fan(work_.mesh, disc, apex, apex_site),
                                 patches_.sheets(disc.triangles, apex))) <= allowed;
}

bool VirtualFaceCoarsening::near_passengers(const Cavity& disc, const Vec3& apex, int apex_site,
                                            const std::vector<CadSample>& passengers, double allowed) const {
    const ClassifiedMesh& mesh = work_.mesh;
    return std::all_of(passengers.begin(), passengers.end(), [&](const CadSample& passenger) {
        const Vec3& p = passenger.point;
        return std::any_of(disc.rim.begin(), disc.rim.end(), [&](int side) {
            const int next = ClassifiedMesh::next(side);
            return mesh.site_of(side) != apex_site && mesh.site_of(next) != apex_site &&
                   (mesh::nearest_on_triangle(p, mesh.point_of(side), mesh.point_of(next), apex) - p).norm() <= allowed;
        });
    });
}

void VirtualFaceCoarsening::replace(const Cavity& disc, int apex_site) {
    const std::vector<CadSample> all = passengers(disc);
    for (const int site : inner_sites(work_.mesh, disc)) {
        half_edge_of_[static_cast<std::size_t>(work_.mesh.site(site).vertex)] = -1;
    }
    const std::vector<int> added = replace_by_fan(work_, disc, apex_site, bound_);
    patches_.replaced(added, all);
    for (const int t : added) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            half_edge_of_[static_cast<std::size_t>(work_.mesh.vertex_of(h))] = h;
        }
    }
}

// @param around  receives the vertices of the boundary.
bool VirtualFaceCoarsening::take_out(int vertex, std::vector<int>& around) {
    const ClassifiedMesh& mesh = work_.mesh;
    const int h = half_edge_of_[static_cast<std::size_t>(vertex)];
    if (h < 0 || patches_.locked(vertex)) {
        return false;
    }
    const std::vector<int> star = mesh.star(h);
    if (mesh.twin(ClassifiedMesh::prev(star.back())) < 0) {
        return false;  // on an edge that is kept
    }
    const auto disc = disc_of(mesh, triangles_around(mesh, h));
    if (!disc || !admissible(*disc)) {
        return false;
    }
    const double aligned = std::min(kWellAligned, disc_alignment(mesh, *disc));
    std::vector<std::pair<double, int>> apexes;
    for (const int side : disc->rim) {
        const double angle = fan_angle(mesh, *disc, mesh.point_of(side), mesh.site_of(side));
        if (angle >= bound_) {
            apexes.emplace_back(-angle, side);
        }
    }
    std::sort(apexes.begin(), apexes.end());
    apexes.resize(std::min(apexes.size(), VirtualTopologyTuning::kMaxCoarseningFans));
    for (const auto& [angle, side] : apexes) {
        const int site = mesh.site_of(side);
        const Corner apex = corner_of(mesh, site);
        if (fan_alignment(mesh, *disc, apex, site) >= aligned && within_bounds(work_, sizing_, *disc, apex, site) &&
            rim_apex_legal(mesh, work_.maxmin, *disc, site) && near_surface(*disc, apex.point, site)) {
            for (const int other : disc->rim) {
                around.push_back(mesh.vertex_of(other));
            }
            replace(*disc, site);
            return true;
        }
    }
    return false;
}

double VirtualFaceCoarsening::shortest_spoke(int vertex) const {
    const int h = half_edge_of_[static_cast<std::size_t>(vertex)];
    double shortest = 1e300;
    for (const int spoke : h < 0 ? std::vector<int>() : work_.mesh.star(h)) {
        shortest = std::min(shortest, side_length(work_.mesh, spoke));
    }
    return shortest;
}

void VirtualFaceCoarsening::run() {
    std::vector<int> vertices = patches_.vertices_on_edges();
    for (int round = 0; round < VirtualTopologyTuning::kMaxCoarseningRounds && !vertices.empty(); ++round) {
        // Vertices with the shortest edges come first.
        std::vector<std::pair<double, int>> order;
        for (const int v : vertices) {
            order.emplace_back(shortest_spoke(v), v);
        }
        std::sort(order.begin(), order.end());
        std::vector<int> around;
        for (const auto& [length, v] : order) {
            work_.progress.check();
            take_out(v, around);
        }
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        vertices = std::move(around);
    }
    patches_.moved(close_gaps(work_));
}

}  // namespace mq::triangulate
