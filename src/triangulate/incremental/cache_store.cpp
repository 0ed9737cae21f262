// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/incremental/cache_store.h"

#include <algorithm>
#include <unordered_map>

#include "geometry/face_definition.h"

namespace mq::triangulate {

namespace {
using geometry::Topology;

/// All vertices along one CAD edge, in its direction.
struct Chain {
    std::vector<double> t;      // parameters; empty for a collapsed edge
    std::vector<int> vertices;  // a single one for a collapsed edge
    int index_of(double at) const { return static_cast<int>(std::lower_bound(t.begin(), t.end(), at) - t.begin()); }
};

std::vector<Chain> final_chains(const ClassifiedMesh& mesh, const EdgeDiscretisation& first, std::size_t edges) {
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
            const ClassifiedMesh::Segment& segment = mesh.segment(s);
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

/// Writes one face of the mesh as a CachedFace, independent of the shape's numbering.
class FaceWriter {
  public:
    FaceWriter(const Workspace& work, const std::vector<Chain>& chains, int face, const CacheRestore* restore)
        : work_(work), mesh_(work.mesh), topology_(work.session.topology()), chains_(chains) {
        const std::vector<int> uses = uses_in_order(topology_.faces[face]);
        for (int k = 0; k < static_cast<int>(uses.size()); ++k) {
            const Chain& chain = chains[topology_.uses[uses[k]].edge];
            place_of_use_[uses[k]] = k;
            result_.parameters.push_back(chain.t);
            result_.min_sample_count.push_back(min_sample_count(topology_.uses[uses[k]].edge, restore));
            for (int i = 0; i < static_cast<int>(chain.vertices.size()); ++i) {
                edge_parameter_at_.emplace(chain.vertices[i], CachedFace::EdgeParameter{k, i});
            }
        }
    }

    /// @return false if the triangles use vertices or links outside of the face.
    bool write(const std::vector<int>& triangles) {
        for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
            place_of_triangle_[triangles[i]] = i;
        }
        bool own = true;
        for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
            const int t = triangles[i];
            std::array<int, 3> corners{};
            std::array<FaceMesh::Link, 3> links{};
            for (int k = 0; k < 3 && own; ++k) {
                own = add_site(mesh_.site_of(3 * t + k), corners[k]) && add_link(3 * t + k, links[k]);
            }
            if (const Exemption* exemption = work_.exemption_of(t)) {
                add_exemption(i, *exemption);
            }
            result_.mesh.triangles.push_back(corners);
            result_.mesh.links.push_back(links);
        }
        return own;
    }

    CachedFace release() { return std::move(result_); }

  private:
    std::size_t min_sample_count(int edge, const CacheRestore* restore) const {
        const std::size_t before = restore != nullptr ? restore->min_sample_count(edge) : 0;
        const std::size_t now = chains_[edge].t.size();
        return before > 0 ? std::min(before, now) : now;
    }

    bool add_site(int site, int& place) {
        const auto [entry, fresh] = place_of_site_.emplace(site, static_cast<int>(result_.mesh.sites.size()));
        place = entry->second;
        if (!fresh) {
            return true;
        }
        const ClassifiedMesh::VertexUse& s = mesh_.site(site);
        int edge_parameter = -1;
        if (mesh_.vertex(s.vertex).entity[0] != 2) {
            const auto found = edge_parameter_at_.find(s.vertex);
            if (found == edge_parameter_at_.end()) {
                return false;
            }
            edge_parameter = static_cast<int>(result_.edge_parameters.size());
            result_.edge_parameters.push_back(found->second);
        }
        result_.mesh.sites.push_back({edge_parameter, s.uv, s.normal, work_.grid.to_shape(s.point)});
        return true;
    }

    bool add_link(int h, FaceMesh::Link& link) {
        const int s = mesh_.segment_of(h);
        if (s < 0) {
            const auto other = place_of_triangle_.find(mesh_.twin(h) / 3);
            link.half_edge = other != place_of_triangle_.end() ? 3 * other->second + mesh_.twin(h) % 3 : -1;
            return link.half_edge >= 0;
        }
        const ClassifiedMesh::Segment& segment = mesh_.segment(s);
        const auto use = std::find_if(segment.uses.begin(), segment.uses.end(),
                                      [&](const ClassifiedMesh::SegmentUse& u) { return u.half_edge == h; });
        const auto place = place_of_use_.find(use->use);
        if (place == place_of_use_.end()) {
            return false;
        }
        link.border = static_cast<int>(result_.mesh.borders.size());
        result_.mesh.borders.push_back({place->second, chains_[segment.edge].index_of(segment.t[0])});
        return true;
    }

    void add_exemption(int place, const Exemption& exemption) {
        CachedFace::GivenUp given_up{place, exemption.cause, {}, -1};
        if (exemption.vertex >= 0) {
            const auto found = edge_parameter_at_.find(exemption.vertex);
            if (found == edge_parameter_at_.end()) {
                return;
            }
            given_up.vertex = found->second;
        }
        if (exemption.edge >= 0) {
            const auto found = std::find_if(place_of_use_.begin(), place_of_use_.end(), [&](const auto& use) {
                return topology_.uses[use.first].edge == exemption.edge;
            });
            if (found == place_of_use_.end()) {
                return;
            }
            given_up.use = found->second;
        }
        result_.given_up.push_back(given_up);
    }

    const Workspace& work_;
    const ClassifiedMesh& mesh_;
    const Topology& topology_;
    const std::vector<Chain>& chains_;
    CachedFace result_;
    std::unordered_map<int, int> place_of_use_;
    std::unordered_map<int, int> place_of_triangle_;
    std::unordered_map<int, int> place_of_site_;
    std::unordered_map<int, CachedFace::EdgeParameter> edge_parameter_at_;  // by vertex
};

}  // namespace

std::map<geometry::Fingerprint, std::shared_ptr<const CachedFace>> store(const Workspace& work,
                                                                         const ChordErrorCache& measure,
                                                                         const EdgeDiscretisation& chains,
                                                                         const std::vector<geometry::Fingerprint>& keys,
                                                                         double chord, const CacheRestore* restore) {
    const std::vector<Chain> all = final_chains(work.mesh, chains, work.session.topology().edges.size());
    const std::vector<std::vector<int>> triangles = work.mesh.triangles_by_face(keys.size());
    const auto kept =
        restore != nullptr ? restore->kept(work.mesh) : std::vector<std::shared_ptr<const CachedFace>>(keys.size());
    std::map<geometry::Fingerprint, std::shared_ptr<const CachedFace>> faces;
    for (int f = 0; f < static_cast<int>(keys.size()); ++f) {
        work.progress.check();
        if (kept[f] != nullptr && restore->exact(f)) {
            faces.emplace(keys[f], kept[f]);
            continue;
        }
        FaceWriter writer(work, all, f, restore);
        if (triangles[f].empty() || !writer.write(triangles[f])) {
            continue;
        }
        auto face = std::make_shared<CachedFace>(writer.release());
        for (const int t : triangles[f]) {
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                face->measured.push_back(measure.measured(h));
            }
        }
        const CachedFace* beginning = restore != nullptr ? restore->beginning(f) : nullptr;
        face->chord = beginning != nullptr ? beginning->chord : chord;
        faces.emplace(keys[f], std::move(face));
    }
    return faces;
}

}  // namespace mq::triangulate
