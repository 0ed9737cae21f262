// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/remember.h"

#include <algorithm>
#include <unordered_map>

namespace mq::triangulate {

namespace {

using geometry::FaceTriangulation;
using geometry::Topology;
using mesh::SurfaceMesh;

/// All vertices along a CAD edge.
struct Chain {
    std::vector<double> t;      // none of a collapsed edge
    std::vector<int> vertices;  // one of a collapsed edge
    int index_of(double at) const { return static_cast<int>(std::lower_bound(t.begin(), t.end(), at) - t.begin()); }
};

std::vector<Chain> final_chains(const SurfaceMesh& mesh, const geometry::EdgeChains& first, std::size_t edges) {
    std::vector<std::vector<int>> segments(edges);
    for (int s = 0; s < mesh.segment_count(); ++s) {
        if (!mesh.segment(s).uses.empty()) {
            segments[mesh.segment(s).edge].push_back(s);
        }
    }
    std::vector<Chain> chains(edges);
    for (std::size_t e = 0; e < edges; ++e) {
        if (first.chain(static_cast<int>(e)).collapsed) {
            chains[e].vertices = {first.chain(static_cast<int>(e)).vertices.front()};
            continue;
        }
        std::sort(segments[e].begin(), segments[e].end(),
                  [&](int a, int b) { return mesh.segment(a).t[0] < mesh.segment(b).t[0]; });
        for (const int s : segments[e]) {
            const SurfaceMesh::Segment& segment = mesh.segment(s);
            if (chains[e].t.empty()) {
                chains[e].t.push_back(segment.t[0]);
                chains[e].vertices.push_back(segment.vertices[0]);
            }
            chains[e].t.push_back(segment.t[1]);
            chains[e].vertices.push_back(segment.vertices[1]);
        }
    }
    return chains;
}

/// Puts one face into other words.
class FaceWriter {
  public:
    FaceWriter(const Workspace& work, const std::vector<Chain>& chains, int face, const Recall* recall)
        : work_(work), mesh_(work.mesh), topology_(work.session.topology()), chains_(chains) {
        const std::vector<int> uses = geometry::uses_in_order(topology_.faces[face]);
        for (int k = 0; k < static_cast<int>(uses.size()); ++k) {
            const Chain& chain = chains[topology_.uses[uses[k]].edge];
            place_of_use_[uses[k]] = k;
            result_.parameters.push_back(chain.t);
            result_.fewest.push_back(fewest(topology_.uses[uses[k]].edge, recall));
            for (int i = 0; i < static_cast<int>(chain.vertices.size()); ++i) {
                knot_at_.emplace(chain.vertices[i], RememberedFace::Knot{k, i});
            }
        }
    }

    /// @return false where the triangles are not the face's own.
    bool write(const std::vector<int>& triangles) {
        for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
            place_of_triangle_[triangles[i]] = i;
        }
        bool own = true;
        for (const int t : triangles) {
            std::array<int, 3> corners{};
            std::array<FaceTriangulation::Link, 3> links{};
            for (int k = 0; k < 3 && own; ++k) {
                own = add_site(mesh_.site_of(3 * t + k), corners[k]) && add_link(3 * t + k, links[k]);
            }
            result_.mesh.triangles.push_back(corners);
            result_.mesh.links.push_back(links);
        }
        return own;
    }

    RememberedFace take() { return std::move(result_); }

  private:
    std::size_t fewest(int edge, const Recall* recall) const {
        const std::size_t before = recall != nullptr ? recall->fewest(edge) : 0;
        const std::size_t now = chains_[edge].t.size();
        return before > 0 ? std::min(before, now) : now;
    }

    bool add_site(int site, int& place) {
        const auto [entry, fresh] = place_of_site_.emplace(site, static_cast<int>(result_.mesh.sites.size()));
        place = entry->second;
        if (!fresh) {
            return true;
        }
        const SurfaceMesh::Site& s = mesh_.site(site);
        int knot = -1;
        if (mesh_.vertex(s.vertex).entity[0] != 2) {
            const auto found = knot_at_.find(s.vertex);
            if (found == knot_at_.end()) {
                return false;
            }
            knot = static_cast<int>(result_.knots.size());
            result_.knots.push_back(found->second);
        }
        result_.mesh.sites.push_back({knot, s.uv, s.normal, work_.grid.to_part(s.point)});
        return true;
    }

    bool add_link(int h, FaceTriangulation::Link& link) {
        const int s = mesh_.segment_of(h);
        if (s < 0) {
            const auto other = place_of_triangle_.find(mesh_.twin(h) / 3);
            link.half_edge = other != place_of_triangle_.end() ? 3 * other->second + mesh_.twin(h) % 3 : -1;
            return link.half_edge >= 0;
        }
        const SurfaceMesh::Segment& segment = mesh_.segment(s);
        const auto use = std::find_if(segment.uses.begin(), segment.uses.end(),
                                      [&](const SurfaceMesh::SegmentUse& u) { return u.half_edge == h; });
        const auto place = place_of_use_.find(use->use);
        if (place == place_of_use_.end()) {
            return false;
        }
        link.border = static_cast<int>(result_.mesh.borders.size());
        result_.mesh.borders.push_back({place->second, chains_[segment.edge].index_of(segment.t[0])});
        return true;
    }

    const Workspace& work_;
    const SurfaceMesh& mesh_;
    const Topology& topology_;
    const std::vector<Chain>& chains_;
    RememberedFace result_;
    std::unordered_map<int, int> place_of_use_;
    std::unordered_map<int, int> place_of_triangle_;
    std::unordered_map<int, int> place_of_site_;
    std::unordered_map<int, RememberedFace::Knot> knot_at_;  // by vertex
};

}  // namespace

std::map<geometry::Fingerprint, std::shared_ptr<const RememberedFace>> remember(
    const Workspace& work, const ChordMeasure& measure, const geometry::EdgeChains& chains,
    const std::vector<geometry::Fingerprint>& keys, double chord, const Recall* recall) {
    const std::vector<Chain> all = final_chains(work.mesh, chains, work.session.topology().edges.size());
    const std::vector<std::vector<int>> triangles = work.mesh.triangles_by_face(keys.size());
    const auto kept =
        recall != nullptr ? recall->kept(work.mesh) : std::vector<std::shared_ptr<const RememberedFace>>(keys.size());
    std::map<geometry::Fingerprint, std::shared_ptr<const RememberedFace>> faces;
    for (int f = 0; f < static_cast<int>(keys.size()); ++f) {
        work.progress.check();
        if (kept[f] != nullptr && recall->exact(f)) {
            faces.emplace(keys[f], kept[f]);
            continue;
        }
        FaceWriter writer(work, all, f, recall);
        if (triangles[f].empty() || !writer.write(triangles[f])) {
            continue;
        }
        auto face = std::make_shared<RememberedFace>(writer.take());
        for (const int t : triangles[f]) {
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                face->measured.push_back(measure.measured(h));
            }
        }
        const RememberedFace* beginning = recall != nullptr ? recall->beginning(f) : nullptr;
        face->chord = beginning != nullptr ? beginning->chord : chord;
        faces.emplace(keys[f], std::move(face));
    }
    return faces;
}

}  // namespace mq::triangulate
