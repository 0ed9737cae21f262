// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/incremental/cache_restore.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "geometry/face_definition.h"
#include "triangulate/components/placed_body.h"
#include "triangulate/incremental/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {
using geometry::Topology;

constexpr std::size_t kMany = static_cast<std::size_t>(-1);  // no count yet: larger than any number of samples

double shortest_side(const FaceMesh& mesh) {
    double shortest = 1e300;
    for (const auto& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            shortest = std::min(shortest, (mesh.sites[t[k]].point - mesh.sites[t[(k + 1) % 3]].point).norm());
        }
    }
    return shortest;
}

}  // namespace

CacheRestore::CacheRestore(geometry::Session& session, const SinglePrecisionGrid& grid,
                           std::shared_ptr<const CachedRun> run, const std::vector<geometry::Fingerprint>& faces,
                           double chord)
    : session_(session),
      grid_(grid),
      run_(std::move(run)),
      motion_(geometry::RigidMotion::between(run_->place, session.place())),
      faces_(faces.size()),
      claims_(session.topology().edges.size()),
      fewest_(session.topology().edges.size(), 0),
      exact_(faces.size(), 1),
      settled_(faces.size()) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto found = run_->faces.find(faces[f]);
        if (found == run_->faces.end()) {
            continue;
        }
        const std::vector<int> uses = uses_in_order(session.topology().faces[f]);
        for (std::size_t k = 0; k < uses.size(); ++k) {
            std::size_t& min_sample_count = fewest_[session.topology().uses[uses[k]].edge];
            min_sample_count =
                std::min(min_sample_count == 0 ? kMany : min_sample_count, found->second->min_sample_count[k]);
        }
        if (fine_enough(*found->second, chord)) {
            faces_[f] = found->second;
        }
    }
}

// Whether a cached face is neither too fine nor too coarse for the chord tolerance (mm).
bool CacheRestore::fine_enough(const CachedFace& face, double chord) const {
    return std::max(chord, face.chord) <= IncrementalTuning::kMuchTheSame * std::min(chord, face.chord) &&
           (grid_.resolution() <= run_->resolution || shortest_side(face.mesh) >= grid_.shortest_side());
}

InitialTriangulation CacheRestore::begin() {
    InitialTriangulation begun{EdgeDiscretisation(session_, grid_), {}, {}};
    forget_where_points_differ();
    drop_over_refined();
    assign_edge_samples(begun.chains);
    for (std::size_t e = 0; e < claims_.size(); ++e) {
        if (claims_[e] != nullptr) {
            const std::vector<double>& t = *claims_[e];
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

// A small detail beside an edge refines the edge and the faces at it; the refinement would remain after the detail is
// removed. So where one face at an over-refined edge is meshed from scratch, all faces at it are.
void CacheRestore::drop_over_refined() {
    for (bool changed = true; changed;) {
        changed = false;
        for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
            if (faces_[f] != nullptr && made_fine_by_changes(f)) {
                faces_[f] = nullptr;
                changed = true;
            }
        }
    }
}

bool CacheRestore::made_fine_by_changes(int face) const {
    const Topology& topology = session_.topology();
    const std::vector<int> uses = uses_in_order(topology.faces[face]);
    for (std::size_t k = 0; k < uses.size(); ++k) {
        const int e = topology.uses[uses[k]].edge;
        const std::vector<int>& around = topology.edges[e].uses;
        const bool changes =
            std::any_of(around.begin(), around.end(), [&](int u) { return faces_[topology.uses[u].face] == nullptr; });
        if (changes &&
            static_cast<double>(faces_[face]->parameters[k].size()) > IncrementalTuning::kOverRefined * fewest_[e]) {
            return true;
        }
    }
    return false;
}

// Where two cached faces store different samples of one edge, the samples of the first face are used.
void CacheRestore::assign_edge_samples(const EdgeDiscretisation& chains) {
    const Topology& topology = session_.topology();
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (faces_[f] == nullptr) {
            continue;
        }
        const std::vector<int> uses = uses_in_order(topology.faces[f]);
        for (std::size_t k = 0; k < uses.size(); ++k) {
            const int e = topology.uses[uses[k]].edge;
            if (claims_[e] == nullptr && !chains.chain(e).collapsed && !faces_[f]->parameters[k].empty()) {
                claims_[e] = &faces_[f]->parameters[k];
            }
        }
    }
}

bool CacheRestore::same_borders(const EdgeDiscretisation& chains, int face) const {
    const Topology& topology = session_.topology();
    const std::vector<int> uses = uses_in_order(topology.faces[face]);
    for (std::size_t k = 0; k < uses.size(); ++k) {
        const EdgePolyline& chain = chains.chain(topology.uses[uses[k]].edge);
        const std::vector<double>& remembered = faces_[face]->parameters[k];
        if (chain.collapsed ? !remembered.empty() : chain.t != remembered) {
            return false;
        }
    }
    return true;
}

void CacheRestore::forget_where_edges_differ(const EdgeDiscretisation& chains) {
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
        if (faces_[f] != nullptr && !same_borders(chains, f)) {
            faces_[f] = nullptr;
        }
    }
}

void CacheRestore::forget_where_points_differ() {
    const double allowed = kOffPlace * std::max(run_->resolution, grid_.resolution());
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
        if (faces_[f] == nullptr) {
            continue;
        }
        geometry::Engine::Batch batch;
        std::vector<Vec3> points;
        for (const FaceMesh::VertexUse& site : faces_[f]->mesh.sites) {
            if (site.vertex < 0) {
                batch.push_back(geometry::Query::face_point(f, site.uv.x(), site.uv.y()));
                points.push_back(motion_.of_point(site.point));
            }
        }
        const geometry::Engine::Answers answers = session_.ask(std::move(batch));
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!answers[i].found() || (answers[i].point - points[i]).norm() > allowed) {
                faces_[f] = nullptr;
                break;
            }
        }
    }
}

FaceMesh CacheRestore::restored(const EdgeDiscretisation& chains, int face) {
    const Topology& topology = session_.topology();
    const std::vector<int> uses = uses_in_order(topology.faces[face]);
    FaceMesh mesh = faces_[face]->mesh;
    for (FaceMesh::VertexUse& site : mesh.sites) {
        const Vec3 before = site.point;
        if (site.vertex >= 0) {
            const CachedFace::EdgeParameter& edge_parameter = faces_[face]->edge_parameters[site.vertex];
            site.vertex = chains.chain(topology.uses[uses[edge_parameter.use]].edge).vertices[edge_parameter.index];
            site.point = chains.vertices()[site.vertex].point;
        } else {
            site.point = grid_.snap(motion_.of_point(before));
        }
        site.normal = motion_.of_direction(site.normal);
        if (motion_ != geometry::RigidMotion() || grid_.to_shape(site.point) != before) {
            exact_[face] = 0;
        }
    }
    for (FaceMesh::Border& border : mesh.borders) {
        border.use = uses[border.use];
    }
    return mesh;
}

void CacheRestore::mark_settled(const EdgeDiscretisation& chains, Workspace& work, ChordErrorCache& measure,
                                double min_angle) {
    const auto triangles = work.mesh.triangles_by_face(faces_.size());
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
        if (faces_[f] != nullptr && same_borders(chains, f)) {  // no piece was halved for a neighbouring face
            mark_settled_face(f, triangles[f], min_angle * kDegree, work, measure);
            settled_[f] = corners(work.mesh, triangles[f]);
        }
    }
    mark_given_up(chains, triangles, work);
}

// Triangles beside newly meshed faces are tried again, since a new neighbourhood may allow a change there.
void CacheRestore::mark_given_up(const EdgeDiscretisation& chains, const std::vector<std::vector<int>>& triangles,
                                 Workspace& work) const {
    const Topology& topology = session_.topology();
    std::vector<char> beside_new(static_cast<std::size_t>(work.mesh.vertex_count()), 0);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        for (std::size_t i = 0; settled_[f].empty() && i < triangles[f].size(); ++i) {
            for (int k = 0; k < 3; ++k) {
                beside_new[work.mesh.vertex_of(3 * triangles[f][i] + k)] = 1;
            }
        }
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (settled_[f].empty()) {
            continue;
        }
        const std::vector<int> uses = uses_in_order(topology.faces[f]);
        const auto edge_of = [&](int use) { return use >= 0 ? topology.uses[uses[use]].edge : -1; };
        for (const CachedFace::GivenUp& given_up : faces_[f]->given_up) {
            const int t = triangles[f][given_up.triangle];
            if (beside_new[work.mesh.vertex_of(3 * t)] == 0 && beside_new[work.mesh.vertex_of(3 * t + 1)] == 0 &&
                beside_new[work.mesh.vertex_of(3 * t + 2)] == 0) {
                const int at = edge_of(given_up.vertex.use);
                const int vertex = at >= 0 ? chains.chain(at).vertices[given_up.vertex.index] : -1;
                work.exempt[t] = {given_up.cause, vertex, edge_of(given_up.use), work.mesh.stamp(t)};
                work.settled.mark(work.mesh, t);
            }
        }
    }
}

void CacheRestore::mark_settled_face(int face, const std::vector<int>& triangles, double bound, Workspace& work,
                                     ChordErrorCache& measure) const {
    const CachedFace& remembered = *faces_[face];
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const int t = triangles[i];
        if (smallest_angle(work.mesh, t).angle >= bound) {
            work.settled.mark(work.mesh, t);
        }
        for (int k = 0; k < 3; ++k) {
            if (exact(face)) {
                measure.set_measured(3 * t + k, remembered.measured[3 * i + k]);
            }
        }
    }
}

bool CacheRestore::began() const {
    return std::any_of(faces_.begin(), faces_.end(), [](const auto& face) { return face != nullptr; });
}

std::vector<std::shared_ptr<const CachedFace>> CacheRestore::kept(const ClassifiedMesh& mesh) const {
    const auto triangles = mesh.triangles_by_face(faces_.size());
    std::vector<std::shared_ptr<const CachedFace>> result(faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (!settled_[f].empty() && settled_[f] == corners(mesh, triangles[f])) {
            result[f] = faces_[f];
        }
    }
    return result;
}

// Returns the site triples of the triangles, each rotated to begin with its smallest site, in ascending order.
std::vector<CacheRestore::Corners> CacheRestore::corners(const ClassifiedMesh& mesh,
                                                         const std::vector<int>& triangles) {
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
