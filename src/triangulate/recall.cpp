// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/recall.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "triangulate/corner_angle.h"

namespace mq::triangulate {

namespace {

using geometry::EdgeChain;
using geometry::EdgeChains;
using geometry::FaceTriangulation;
using geometry::Topology;
using mesh::SurfaceMesh;

// Resolutions by which a vertex may lie off the point of its surface at its (u, v): once rounded, once projected.
constexpr double kOffSurface = 4.0;
// A mesh that is so many times finer or coarser than asked for is a start as good as any.
constexpr double kMuchTheSame = 1.25;
// Edges that have so many more vertices than they had once have become fine.
constexpr double kGrowth = 1.25;
constexpr std::size_t kMany = static_cast<std::size_t>(-1);

double shortest_side(const FaceTriangulation& mesh) {
    double shortest = 1e300;
    for (const auto& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            shortest = std::min(shortest, (mesh.sites[t[k]].point - mesh.sites[t[(k + 1) % 3]].point).norm());
        }
    }
    return shortest;
}

}  // namespace

Recall::Recall(geometry::Session& session, const SingleGrid& grid, std::shared_ptr<const Run> run,
               const std::vector<geometry::Fingerprint>& faces, double chord)
    : session_(session),
      grid_(grid),
      run_(std::move(run)),
      motion_(geometry::Motion::between(run_->place, session.place())),
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
        const std::vector<int> uses = geometry::uses_in_order(session.topology().faces[f]);
        for (std::size_t k = 0; k < uses.size(); ++k) {
            std::size_t& fewest = fewest_[session.topology().uses[uses[k]].edge];
            fewest = std::min(fewest == 0 ? kMany : fewest, found->second->fewest[k]);
        }
        if (fine_enough(*found->second, chord)) {
            faces_[f] = found->second;
        }
    }
}

// Neither too fine nor too coarse.
bool Recall::fine_enough(const RememberedFace& face, double chord) const {
    return std::max(chord, face.chord) <= kMuchTheSame * std::min(chord, face.chord) &&
           (grid_.resolution() <= run_->resolution || shortest_side(face.mesh) >= grid_.shortest_side());
}

geometry::InitialTriangulation Recall::begin() {
    geometry::InitialTriangulation begun{EdgeChains(session_, grid_), {}, {}};
    forget_where_points_differ();
    forget_what_changes_made_fine();
    claim_edges(begun.chains);
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

// A detail beside an edge makes it fine, and the faces beside it too; that would stay when the detail goes. So where a
// face at an edge that has become fine is meshed anew, all are.
void Recall::forget_what_changes_made_fine() {
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

bool Recall::made_fine_by_changes(int face) const {
    const Topology& topology = session_.topology();
    const std::vector<int> uses = geometry::uses_in_order(topology.faces[face]);
    for (std::size_t k = 0; k < uses.size(); ++k) {
        const int e = topology.uses[uses[k]].edge;
        const std::vector<int>& around = topology.edges[e].uses;
        const bool changes =
            std::any_of(around.begin(), around.end(), [&](int u) { return faces_[topology.uses[u].face] == nullptr; });
        if (changes && static_cast<double>(faces_[face]->parameters[k].size()) > kGrowth * fewest_[e]) {
            return true;
        }
    }
    return false;
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
            if (claims_[e] == nullptr && !chains.chain(e).collapsed && !faces_[f]->parameters[k].empty()) {
                claims_[e] = &faces_[f]->parameters[k];
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
    const double allowed = kOffSurface * std::max(run_->resolution, grid_.resolution());
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
        if (faces_[f] == nullptr) {
            continue;
        }
        geometry::Engine::Batch batch;
        std::vector<Vec3> points;
        for (const FaceTriangulation::Site& site : faces_[f]->mesh.sites) {
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

FaceTriangulation Recall::restored(const EdgeChains& chains, int face) {
    const Topology& topology = session_.topology();
    const std::vector<int> uses = geometry::uses_in_order(topology.faces[face]);
    FaceTriangulation mesh = faces_[face]->mesh;
    for (FaceTriangulation::Site& site : mesh.sites) {
        const Vec3 before = site.point;
        if (site.vertex >= 0) {
            const RememberedFace::Knot& knot = faces_[face]->knots[site.vertex];
            site.vertex = chains.chain(topology.uses[uses[knot.use]].edge).vertices[knot.index];
            site.point = chains.vertices()[site.vertex].point;
        } else {
            site.point = grid_.snap(motion_.of_point(before));
        }
        site.normal = motion_.of_direction(site.normal);
        if (motion_ != geometry::Motion() || grid_.to_part(site.point) != before) {
            exact_[face] = 0;
        }
    }
    for (FaceTriangulation::Border& border : mesh.borders) {
        border.use = uses[border.use];
    }
    return mesh;
}

void Recall::settle(const EdgeChains& chains, Workspace& work, ChordMeasure& measure, double min_angle) {
    const auto triangles = work.mesh.triangles_by_face(faces_.size());
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
        if (faces_[f] != nullptr && same_borders(chains, f)) {  // none was halved for a face beside it
            settle_face(f, triangles[f], min_angle * kDegree, work, measure);
            settled_[f] = corners(work.mesh, triangles[f]);
        }
    }
}

void Recall::settle_face(int face, const std::vector<int>& triangles, double bound, Workspace& work,
                         ChordMeasure& measure) const {
    const RememberedFace& remembered = *faces_[face];
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const int t = triangles[i];
        if (smallest_angle(work.mesh, t).angle >= bound) {
            work.settled.mark(work.mesh, t);
        }
        for (int k = 0; k < 3; ++k) {
            if (exact(face)) {
                measure.take(3 * t + k, remembered.measured[3 * i + k]);
            }
        }
    }
}

std::vector<std::shared_ptr<const RememberedFace>> Recall::kept(const SurfaceMesh& mesh) const {
    const auto triangles = mesh.triangles_by_face(faces_.size());
    std::vector<std::shared_ptr<const RememberedFace>> result(faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (!settled_[f].empty() && settled_[f] == corners(mesh, triangles[f])) {
            result[f] = faces_[f];
        }
    }
    return result;
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
