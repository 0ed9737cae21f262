// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/virtual_topology/virtual_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angle.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::triangulate {

namespace {

// Barycentric weights of the points in a triangle for which the face is determined: the centroid, and points near
// corners and sides.
constexpr std::array<std::array<double, 3>, 7> kPlaces{{{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0},
                                                        {0.8, 0.1, 0.1},
                                                        {0.1, 0.8, 0.1},
                                                        {0.1, 0.1, 0.8},
                                                        {0.45, 0.45, 0.1},
                                                        {0.1, 0.45, 0.45},
                                                        {0.45, 0.1, 0.45}}};

// Barycentric weights of the points whose projections become CAD samples: the centroid and the middles of the sides.
constexpr std::array<std::array<double, 3>, 4> kFootPlaces{
    {{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}, {0.5, 0.5, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5}}};

}  // namespace

VirtualFaces::VirtualFaces(ClassifiedMesh& mesh, const std::vector<char>& smooth, double feature_angle)
    : mesh_(mesh), face_of_site_(static_cast<std::size_t>(mesh.site_count()), -1) {
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        corners_.push_back({mesh.site_of(3 * t), mesh.site_of(3 * t + 1), mesh.site_of(3 * t + 2)});
        for (const int site : corners_.back()) {
            face_of_site_[static_cast<std::size_t>(site)] = mesh.face_of(t);
        }
    }
    for (int s = 0; s < mesh.segment_count(); ++s) {
        const ClassifiedMesh::Segment& segment = mesh.segment(s);
        if (smooth[static_cast<std::size_t>(segment.edge)] != 0 && !segment.uses.empty()) {
            sites_[segment.vertices[0]];
            sites_[segment.vertices[1]];
            mesh.dissolve(s);
        }
    }
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        const auto found = sites_.find(mesh.vertex_of(h));
        if (found != sites_.end()) {
            found->second.push_back(mesh.site_of(h));
        }
    }
    for (auto& entry : sites_) {
        std::sort(entry.second.begin(), entry.second.end());
        entry.second.erase(std::unique(entry.second.begin(), entry.second.end()), entry.second.end());
    }
    lock_singular_vertices(feature_angle);
    unify_vertex_uses();
}

void VirtualFaces::unify_vertex_uses() {
    std::vector<char> seen(static_cast<std::size_t>(mesh_.half_edge_count()), 0);
    for (int h = 0; h < mesh_.half_edge_count(); ++h) {
        if (seen[static_cast<std::size_t>(h)] != 0 || sites_.count(mesh_.vertex_of(h)) == 0) {
            continue;
        }
        const int site = mesh_.site_of(h);
        for (const int spoke : mesh_.star(h)) {
            seen[static_cast<std::size_t>(spoke)] = 1;
            mesh_.put_site(spoke, site);
        }
    }
}

// Edges that are smooth along all of their length may still meet in a singular point, such as the tip of a cone.
void VirtualFaces::lock_singular_vertices(double feature_angle) {
    const double least = std::cos(feature_angle * kDegree);
    for (const auto& [vertex, sites] : sites_) {
        if (mesh_.vertex(vertex).entity[0] != 0) {
            continue;
        }
        for (const int a : sites) {
            for (const int b : sites) {
                if (!(mesh_.site(a).normal.dot(mesh_.site(b).normal) > least)) {
                    lock(vertex);
                }
            }
        }
    }
}

std::vector<int> VirtualFaces::vertices_on_edges() const {
    std::vector<int> vertices;
    for (const auto& entry : sites_) {
        vertices.push_back(entry.first);
    }
    return vertices;
}

bool VirtualFaces::changed(int triangle) const {
    return samples_of_changed_.count(triangle) > 0;
}

// Adds the faces of the triangle's CAD samples and of its corners.
void VirtualFaces::add_faces(int triangle, std::vector<int>& faces) const {
    const auto found = samples_of_changed_.find(triangle);
    if (found == samples_of_changed_.end()) {
        faces.push_back(mesh_.face_of(triangle));
        return;
    }
    for (const CadSample& passenger : found->second) {
        faces.push_back(passenger.face);
    }
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        faces.push_back(face_of_site(mesh_.site_of(h)));
    }
}

CandidateFaces VirtualFaces::sheets(const std::vector<int>& triangles, const Vec3& middle) const {
    CandidateFaces result;
    for (const int t : triangles) {
        add_faces(t, result.faces);
    }
    std::sort(result.faces.begin(), result.faces.end());
    result.faces.erase(std::unique(result.faces.begin(), result.faces.end()), result.faces.end());
    result.guesses.resize(result.faces.size());
    std::vector<double> distances(result.faces.size(), std::numeric_limits<double>::infinity());
    const auto offer_point = [&](int face, const Vec3& point, const Vec2& uv) {
        const auto found = std::lower_bound(result.faces.begin(), result.faces.end(), face);
        const auto k = static_cast<std::size_t>(found - result.faces.begin());
        const double distance = (point - middle).norm();
        if (found != result.faces.end() && *found == face && distance < distances[k]) {
            distances[k] = distance;
            result.guesses[k] = uv;
        }
    };
    const auto offer = [&](int site) {
        const ClassifiedMesh::VertexUse& s = mesh_.site(site);
        offer_point(face_of_site(site), mesh_.vertex(s.vertex).point, s.uv);
    };
    for (const int t : triangles) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            offer(mesh_.site_of(h));
            const auto others = sites_.find(mesh_.vertex_of(h));
            if (others != sites_.end()) {
                std::for_each(others->second.begin(), others->second.end(), offer);
            }
        }
        const auto load = samples_of_changed_.find(t);
        for (std::size_t i = 0; load != samples_of_changed_.end() && i < load->second.size(); ++i) {
            offer_point(load->second[i].face, load->second[i].point, load->second[i].uv);
        }
    }
    return result;
}

std::vector<CadSample> VirtualFaces::passengers(Workspace& work, const std::vector<int>& triangles) {
    std::vector<CadSample> all;
    for (const int t : triangles) {
        const auto load = samples_of_changed_.find(t);
        if (load == samples_of_changed_.end() && samples_of_unchanged_.count(t) == 0) {
            const auto& sites = corners_[static_cast<std::size_t>(t)];
            geometry::Engine::Batch batch;
            for (const auto& w : kFootPlaces) {
                Vec3 p = Vec3::Zero();
                Vec2 uv = Vec2::Zero();
                for (std::size_t k = 0; k < 3; ++k) {
                    p += w[k] * mesh_.point_of(3 * t + static_cast<int>(k));
                    uv += w[k] * mesh_.site(sites[k]).uv;
                }
                batch.push_back(geometry::Query::face_nearest(mesh_.face_of(t), work.grid.to_shape(p), uv.x(), uv.y()));
            }
            std::vector<CadSample>& feet = samples_of_unchanged_[t];
            for (const geometry::Answer& a : work.session.ask(std::move(batch))) {
                if (a.found()) {
                    feet.push_back({a.point - work.grid.origin(), mesh_.face_of(t), Vec2(a.u, a.v), a.distance});
                }
            }
        }
        const std::vector<CadSample>& some =
            load != samples_of_changed_.end() ? load->second : samples_of_unchanged_[t];
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

// Assigns every CAD sample to the nearest triangle.
void VirtualFaces::replaced(const std::vector<int>& triangles, const std::vector<CadSample>& passengers) {
    for (const int t : triangles) {
        samples_of_changed_[t].clear();
        samples_of_unchanged_.erase(t);
    }
    for (const CadSample& passenger : passengers) {
        const auto distance = [&](int t) {
            const Vec3 foot = mesh::nearest_on_triangle(passenger.point, mesh_.point_of(3 * t),
                                                        mesh_.point_of(3 * t + 1), mesh_.point_of(3 * t + 2));
            return (foot - passenger.point).squaredNorm();
        };
        int nearest = triangles.front();
        double least = distance(nearest);
        for (const int t : triangles) {
            const double d = distance(t);
            if (d < least) {
                least = d;
                nearest = t;
            }
        }
        samples_of_changed_[nearest].push_back(passenger);
    }
}

void VirtualFaces::moved(const std::vector<std::pair<int, int>>& pairs) {
    corners_.resize(std::max(corners_.size(), static_cast<std::size_t>(mesh_.triangle_count()) + pairs.size()));
    for (const auto& [from, to] : pairs) {
        if (static_cast<std::size_t>(from) < corners_.size()) {
            corners_[static_cast<std::size_t>(to)] = corners_[static_cast<std::size_t>(from)];
        }
        samples_of_changed_.erase(to);
        const auto found = samples_of_changed_.find(from);
        if (found != samples_of_changed_.end()) {
            samples_of_changed_[to] = std::move(found->second);
        }
    }
    samples_of_changed_.erase(samples_of_changed_.lower_bound(mesh_.triangle_count()), samples_of_changed_.end());
    samples_of_unchanged_.clear();
}

// Returns the site of the vertex on a face with (u, v) nearest to `near`; -1 if the vertex is not on the face.
int VirtualFaces::site_on(int half_edge, int face, const Vec2& near) const {
    std::vector<int> sites{mesh_.site_of(half_edge)};
    const auto others = sites_.find(mesh_.vertex_of(half_edge));
    if (others != sites_.end()) {
        sites = others->second;
    }
    int best = -1;
    for (const int site : sites) {
        if (face_of_site(site) == face &&
            (best < 0 || (mesh_.site(site).uv - near).norm() < (mesh_.site(best).uv - near).norm())) {
            best = site;
        }
    }
    return best;
}

void VirtualFaces::settle_one(Workspace& work, int triangle, std::map<int, MultiFaceClassification>& spans) {
    const int h = 3 * triangle;
    std::vector<Vec3> points;
    for (const auto& w : kPlaces) {
        points.push_back(w[0] * mesh_.point_of(h) + w[1] * mesh_.point_of(h + 1) + w[2] * mesh_.point_of(h + 2));
    }
    std::vector<int> around;
    for (int k = h; k < h + 3; ++k) {
        for (const int spoke : mesh_.star(k)) {
            around.push_back(ClassifiedMesh::triangle_of(spoke));
        }
    }
    const CandidateFaces near = sheets(around, points.front());
    std::map<int, int> shares;
    Vec2 uv = Vec2::Zero();
    const std::vector<SurfaceProjection> feet = project_onto(work, points, near);
    for (const SurfaceProjection& foot : feet) {
        if (foot.face >= 0) {
            ++shares[foot.face];
        }
    }
    int label = shares.empty() ? mesh_.face_of(triangle) : shares.begin()->first;
    for (const auto& [face, share] : shares) {
        label = share > shares[label] ? face : label;
    }
    for (const SurfaceProjection& foot : feet) {
        uv = foot.face == label ? foot.uv : uv;
    }
    mesh_.put_face(triangle, label);
    for (int k = h; k < h + 3; ++k) {
        const int site = site_on(k, label, uv);
        if (site >= 0) {
            mesh_.put_site(k, site);
        } else {
            shares[face_of_site(mesh_.site_of(k))];
        }
    }
    shares.erase(label);
    if (near.faces.size() > 1) {
        MultiFaceClassification span{{label}, near};
        for (const auto& entry : shares) {
            span.faces.push_back(entry.first);
        }
        spans[triangle] = std::move(span);
    }
}

std::map<int, MultiFaceClassification> VirtualFaces::settle(Workspace& work) {
    std::map<int, MultiFaceClassification> spans;
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
        if (changed(t)) {
            work.progress.check();
            settle_one(work, t, spans);
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            mesh_.put_site(3 * t + k, corners_[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)]);
        }
    }
    return spans;
}

}  // namespace mq::triangulate
