// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/recall.h"

#include <algorithm>

namespace mq::triangulate {

namespace {

using geometry::EdgeChain;
using geometry::EdgeChains;
using geometry::FaceTriangulation;
using geometry::Fingerprint;
using geometry::Topology;
using mesh::SurfaceMesh;

// Resolutions by which a vertex may lie off the point of its surface at its (u, v): once rounded, once projected.
constexpr double kOffSurface = 4.0;

std::vector<std::vector<int>> triangles_by_face(const SurfaceMesh& mesh, std::size_t faces) {
    std::vector<std::vector<int>> result(faces);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        result[mesh.face_of(t)].push_back(t);
    }
    return result;
}

}  // namespace

std::vector<Fingerprint> keys_of_faces(geometry::Session& session, const Options& options) {
    std::vector<Fingerprint> keys = geometry::fingerprints_of_faces(session);
    const Topology& topology = session.topology();
    const auto add_sizes = [&](Fingerprint& key, int dimension, int index) {
        for (const LocalSize& size : options.local_sizes) {
            if (size.dimension == dimension && size.index == index) {
                geometry::add_to(key, static_cast<std::uint64_t>(dimension));
                geometry::add_to(key, size.max_edge);
            }
        }
    };
    for (int f = 0; f < static_cast<int>(keys.size()); ++f) {
        add_sizes(keys[f], 2, f);
        for (const int u : geometry::uses_in_order(topology.faces[f])) {
            geometry::add_to(keys[f], std::uint64_t{1});  // so that sizes count by their use
            add_sizes(keys[f], 1, topology.uses[u].edge);
            for (const int n : topology.edges[topology.uses[u].edge].nodes) {
                add_sizes(keys[f], 0, n);
            }
        }
    }
    return keys;
}

Recall::Recall(geometry::Session& session, const SingleGrid& grid, const Memory& memory,
               const std::vector<Fingerprint>& keys)
    : session_(session),
      grid_(grid),
      memory_(memory),
      faces_(keys.size(), nullptr),
      parameters_(session.topology().edges.size(), nullptr),
      settled_(keys.size()) {
    for (std::size_t f = 0; f < keys.size(); ++f) {
        const auto found = memory.faces.find(keys[f]);
        faces_[f] = found != memory.faces.end() ? &found->second : nullptr;
    }
}

geometry::InitialTriangulation Recall::begin() {
    geometry::InitialTriangulation begun{EdgeChains(session_, grid_), {}, {}};
    forget_where_points_differ();
    claim_edges(begun.chains);
    for (std::size_t e = 0; e < parameters_.size(); ++e) {
        if (parameters_[e] != nullptr) {
            const std::vector<double>& t = *parameters_[e];
            begun.chains.resample(session_, static_cast<int>(e), {t.begin() + 1, t.end() - 1});
        }
    }
    forget_where_edges_differ(begun.chains);
    begun.faces.resize(faces_.size());
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
        if (faces_[f] != nullptr) {
            begun.faces[f] = restored(begun.chains, f);
        }
    }
    return begun;
}

// Where two faces remember an edge with different samples, the first one decides.
void Recall::claim_edges(const EdgeChains& chains) {
    const Topology& topology = session_.topology();
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (faces_[f] == nullptr) {
            continue;
        }
        const std::vector<int> uses = geometry::uses_in_order(topology.faces[f]);
        for (std::size_t k = 0; k < uses.size(); ++k) {
            const int e = topology.uses[uses[k]].edge;
            if (parameters_[e] == nullptr && !chains.chain(e).collapsed && !faces_[f]->parameters[k].empty()) {
                parameters_[e] = &faces_[f]->parameters[k];
            }
        }
    }
}

bool Recall::same_borders(const EdgeChains& chains, int face) const {
    const Topology& topology = session_.topology();
    const std::vector<int> uses = geometry::uses_in_order(topology.faces[face]);
    for (std::size_t k = 0; k < uses.size(); ++k) {
        const EdgeChain& chain = chains.chain(topology.uses[uses[k]].edge);
        const std::vector<double>& remembered = faces_[face]->parameters[k];
        if (chain.collapsed ? !remembered.empty() : chain.t != remembered) {
            return false;
        }
    }
    return true;
}

void Recall::forget_where_edges_differ(const EdgeChains& chains) {
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
        if (faces_[f] != nullptr && !same_borders(chains, f)) {
            faces_[f] = nullptr;
        }
    }
}

void Recall::forget_where_points_differ() {
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
        if (faces_[f] == nullptr) {
            continue;
        }
        geometry::Engine::Batch batch;
        std::vector<Vec3> points;
        for (const FaceTriangulation::Site& site : faces_[f]->mesh.sites) {
            if (site.vertex < 0) {
                batch.push_back(geometry::Query::face_point(f, site.uv.x(), site.uv.y()));
                points.push_back(site.point);
            }
        }
        const geometry::Engine::Answers answers = session_.ask(std::move(batch));
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!answers[i].found() || (answers[i].point - points[i]).norm() > kOffSurface * memory_.resolution) {
                faces_[f] = nullptr;
                break;
            }
        }
    }
}

FaceTriangulation Recall::restored(const EdgeChains& chains, int face) const {
    const Topology& topology = session_.topology();
    const std::vector<int> uses = geometry::uses_in_order(topology.faces[face]);
    FaceTriangulation mesh = faces_[face]->mesh;
    for (FaceTriangulation::Site& site : mesh.sites) {
        if (site.vertex >= 0) {
            const RememberedFace::Knot& knot = faces_[face]->knots[site.vertex];
            site.vertex = chains.chain(topology.uses[uses[knot.use]].edge).vertices[knot.index];
            site.point = chains.vertices()[site.vertex].point;
        } else {
            site.point = grid_.snap(site.point);
        }
    }
    for (FaceTriangulation::Border& border : mesh.borders) {
        border.use = uses[border.use];
    }
    return mesh;
}

void Recall::settle(const EdgeChains& chains, Workspace& work, ChordMeasure& measure, double chord) {
    const auto triangles = triangles_by_face(work.mesh, faces_.size());
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
        if (faces_[f] == nullptr || !same_borders(chains, f)) {
            continue;  // a border was halved for a face beside it
        }
        for (std::size_t i = 0; i < triangles[f].size(); ++i) {
            if (faces_[f]->good[i] != 0) {
                work.settled.mark(work.mesh, triangles[f][i]);
            }
            for (std::size_t k = 0; k < 3 && memory_.chord == chord; ++k) {
                measure.take(3 * triangles[f][i] + static_cast<int>(k), faces_[f]->measured[3 * i + k]);
            }
        }
        settled_[f] = corners(work.mesh, triangles[f]);
    }
}

std::size_t Recall::kept(const SurfaceMesh& mesh) const {
    const auto triangles = triangles_by_face(mesh, faces_.size());
    std::size_t count = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        count += !settled_[f].empty() && settled_[f] == corners(mesh, triangles[f]) ? 1 : 0;
    }
    return count;
}

// Sites, the smallest first, in ascending order.
std::vector<Recall::Corners> Recall::corners(const SurfaceMesh& mesh, const std::vector<int>& triangles) {
    std::vector<Corners> result;
    for (const int t : triangles) {
        Corners c{mesh.site_of(3 * t), mesh.site_of(3 * t + 1), mesh.site_of(3 * t + 2)};
        std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        result.push_back(c);
    }
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace mq::triangulate
