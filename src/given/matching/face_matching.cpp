// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/matching/face_matching.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "base/key_set.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/edge_table.h"

namespace mq::given {

namespace {

using geometry::Query;

/// Most points of a region by which its face is found.
constexpr std::size_t kSamples = 12;

/// Most edges named in an error.
constexpr std::size_t kNamed = 3;

/// Triangles that are connected without crossing a CAD edge.
struct Region {
    std::vector<int> triangles;
    std::set<int> edges;  ///< CAD edges around the region and inside of it
};

/// A point of a region, and the largest distance at which a face still counts as its face.
struct Sample {
    Vec3 point;
    double reach;
};

class Matcher {
  public:
    Matcher(geometry::Session& session, const SurfaceGraph& graph, const EdgePaths& edges)
        : session_(session), topology_(session.topology()), graph_(graph), edges_(edges) {
        for (std::size_t e = 0; e < edges.polylines.size(); ++e) {
            const std::vector<int>& polyline = edges.polylines[e].vertices;
            for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
                border_.emplace(pair_key(polyline[i], polyline[i + 1]), static_cast<int>(e));
                on_border_.insert({polyline[i], polyline[i + 1]});
            }
        }
        for (int f = 0; f < static_cast<int>(topology_.faces.size()); ++f) {
            edges_of_face_.push_back(topology_.edges_of(f));
        }
    }

    std::vector<int> run() {
        std::vector<int> face(graph_.triangles.size(), -1);
        const std::vector<Region> all = regions();
        std::map<std::set<int>, int> alike;  // number of regions with the same set of CAD edges around them
        for (const Region& region : all) {
            ++alike[region.edges];
        }
        for (const Region& region : all) {
            session_.check();
            const int found = face_of(region, alike[region.edges] == 1);
            require_edges_of(found, region);
            for (const int t : region.triangles) {
                face[static_cast<std::size_t>(t)] = found;
            }
        }
        return face;
    }

  private:
    std::vector<Region> regions() const {
        std::vector<mesh::Triangle> triangles;
        for (const auto& t : graph_.triangles) {
            triangles.push_back({t[0], t[1], t[2]});
        }
        DisjointSets<std::size_t> joined(triangles.size());
        const mesh::EdgeTable table(triangles, graph_.points.size());
        std::vector<std::pair<std::size_t, int>> borders;  // triangle, CAD edge
        table.for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* last) {
            const auto border = border_.find(pair_key(low, high));
            for (const std::uint32_t* corner = first; corner != last; ++corner) {
                if (border != border_.end()) {
                    borders.emplace_back(*corner / 3, border->second);
                } else if (last - first == 2) {
                    joined.unite(*first / 3, *corner / 3);
                }
            }
        });
        std::size_t count = 0;
        const std::vector<std::size_t> number = joined.number(count);
        std::vector<Region> result(count);
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            result[number[t]].triangles.push_back(static_cast<int>(t));
        }
        for (const auto& [t, e] : borders) {
            result[number[t]].edges.insert(e);
        }
        return result;
    }

    /// @param alone  whether no other region has the same edges around it: then these edges determine its face, if only
    /// one face has them
    int face_of(const Region& region, bool alone) {
        const std::vector<int> candidates = faces_with(region.edges);
        if (candidates.empty()) {
            throw not_followed(region);
        }
        if (alone && candidates.size() == 1 && has_all_edges(candidates[0], region)) {
            return candidates[0];
        }
        const std::vector<Sample> samples = samples_of(region);
        int best = -1;
        std::pair<int, double> least{static_cast<int>(samples.size()) + 1, 0.0};
        for (const int f : candidates) {
            const std::pair<int, double> off = off_face(f, samples);
            if (off < least) {
                least = off;
                best = f;
            }
        }
        if (best < 0 || 2 * least.first > static_cast<int>(samples.size())) {
            throw GeometryError(phrases::kOnNoFace,
                                {{"count", region.triangles.size()}, {"point", in_mm(samples[0].point)}});
        }
        return best;
    }

    /// Refuses a region that lacks an edge of its face's border: the mesh lacks the hole there, or the face beside it.
    void require_edges_of(int face, const Region& region) const {
        for (const int e : edges_of_face_[static_cast<std::size_t>(face)]) {
            if (bounds(e, face) && edges_.polylines[static_cast<std::size_t>(e)].vertices.empty()) {
                throw not_followed(region);
            }
        }
    }

    /// Whether all mesh edges along the border of a face lie around a region.
    bool has_all_edges(int face, const Region& region) const {
        const std::set<int>& all = edges_of_face_[static_cast<std::size_t>(face)];
        return !region.edges.empty() && std::all_of(all.begin(), all.end(), [&](int e) {
            const bool followed = edges_.polylines[static_cast<std::size_t>(e)].vertices.size() > 1;
            return !bounds(e, face) || !followed || region.edges.count(e) > 0;
        });
    }

    /// Whether an edge is on the border of a face: neither a pole, nor a seam between two sides of the face, nor a
    /// slit.
    bool bounds(int e, int face) const {
        const geometry::Edge& edge = topology_.edges[static_cast<std::size_t>(e)];
        std::size_t here = 0;
        bool slit = false;
        for (const int use : edge.uses) {
            const geometry::EdgeUse& one = topology_.uses[static_cast<std::size_t>(use)];
            here += one.face == face ? 1 : 0;
            slit = slit || (one.face == face && one.internal);
        }
        return !edge.degenerate && !slit && here == 1;
    }

    std::vector<int> faces_with(const std::set<int>& edges) const {
        std::vector<int> result;
        for (std::size_t f = 0; f < edges_of_face_.size(); ++f) {
            const std::set<int>& all = edges_of_face_[f];
            if (!topology_.faces[f].no_area && std::includes(all.begin(), all.end(), edges.begin(), edges.end())) {
                result.push_back(static_cast<int>(f));
            }
        }
        return result;
    }

    /// Vertices inside of the region if there are any, as these lie on the face; else centroids.
    std::vector<Sample> samples_of(const Region& region) const {
        std::vector<Sample> inside;
        std::vector<Sample> centroids;
        const std::size_t step = 1 + region.triangles.size() / kSamples;
        for (std::size_t i = 0; i < region.triangles.size(); i += step) {
            const auto& corners = graph_.triangles[static_cast<std::size_t>(region.triangles[i])];
            Vec3 sum = Vec3::Zero();
            double longest = 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                sum += at(corners[k]) / 3.0;
                longest = std::max(longest, (at(corners[k]) - at(corners[(k + 1) % 3])).norm());
            }
            centroids.push_back({sum, 0.5 * longest});
            for (const int v : corners) {
                if (on_border_.count(v) == 0) {
                    inside.push_back({at(v), 0.5 * graph_.shortest[static_cast<std::size_t>(v)]});
                }
            }
        }
        return inside.empty() ? centroids : inside;
    }

    /// The number of samples whose nearest point is not inside of the trimmed face, and the largest distance of the
    /// others from the surface.
    std::pair<int, double> off_face(int face, const std::vector<Sample>& samples) {
        geometry::Engine::Batch batch;
        for (const Sample& sample : samples) {
            batch.push_back(Query::face_nearest_global(face, sample.point));
        }
        const auto nearest = session_.ask(std::move(batch));
        geometry::Engine::Batch inside;
        for (const auto& answer : nearest) {
            inside.push_back(Query::face_contains(face, answer.u, answer.v));
        }
        const auto contains = session_.ask(std::move(inside));
        std::pair<int, double> off{0, 0.0};
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (!nearest[i].found() || nearest[i].distance > samples[i].reach || contains[i].side < 0) {
                ++off.first;
            } else {
                off.second = std::max(off.second, nearest[i].distance);
            }
        }
        return off;
    }

    /// The reason why edges of more than one face lie around a region: the edges between those faces have no polyline.
    TopologyError not_followed(const Region& region) const {
        std::set<int> faces;
        for (const int e : region.edges) {
            for (const int use : topology_.edges[static_cast<std::size_t>(e)].uses) {
                faces.insert(topology_.uses[static_cast<std::size_t>(use)].face);
            }
        }
        std::set<int> missing;
        for (const int f : faces) {
            for (const int e : edges_of_face_[static_cast<std::size_t>(f)]) {
                const geometry::Edge& edge = topology_.edges[static_cast<std::size_t>(e)];
                if (!edge.degenerate && edges_.polylines[static_cast<std::size_t>(e)].vertices.empty()) {
                    missing.insert(e);
                }
            }
        }
        std::string names;
        for (const int e : missing) {
            if (names.empty() || std::count(names.begin(), names.end(), ',') + 1 < static_cast<int>(kNamed)) {
                names += (names.empty() ? "" : ", ") + topology_.name_of({1, e});
            }
        }
        const auto& corners = graph_.triangles[static_cast<std::size_t>(region.triangles[0])];
        return {names.empty()             ? phrases::kGivenNotFollowed
                : missing.size() > kNamed ? phrases::kGivenManyNotFollowed
                                          : phrases::kGivenEdgesNotFollowed,
                {{"list", names}, {"count", missing.size()}, {"point", in_mm(at(corners[0]))}}};
    }

    const Vec3& at(int v) const { return graph_.points[static_cast<std::size_t>(v)]; }

    geometry::Session& session_;
    const geometry::Topology& topology_;
    const SurfaceGraph& graph_;
    const EdgePaths& edges_;
    KeyMap<int> border_;  ///< by mesh edge: the CAD edge that it follows
    std::set<int> on_border_;
    std::vector<std::set<int>> edges_of_face_;
};

}  // namespace

std::vector<int> match_faces(geometry::Session& session, const SurfaceGraph& graph, const EdgePaths& edges) {
    return Matcher(session, graph, edges).run();
}

}  // namespace mq::given
