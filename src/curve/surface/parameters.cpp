// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <string>

#include "base/error.h"
#include "base/tuning.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/surface/curved_surface.h"
#include "geometry/closed_edge.h"

namespace mq::curve {

namespace {

using geometry::Answer;
using geometry::Query;

class Parameters {
  public:
    Parameters(geometry::Session& session, CurvedSurface& surface, const std::vector<int>& at_node)
        : session_(session), topology_(session.topology()), surface_(surface), at_node_(at_node) {
        for (const SurfaceTriangle& t : surface.triangles) {
            meshed_faces_.insert(t.face);
        }
    }

    void find() {
        put_on_nodes_and_edges();
        put_on_faces();
        orient();
    }

  private:
    void put_on_nodes_and_edges() {
        std::vector<std::vector<int>> on_edge(topology_.edges.size());
        for (std::size_t v = 0; v < surface_.shapes.vertices.size(); ++v) {
            elements::Vertex& vertex = surface_.shapes.vertices[v];
            const auto index = static_cast<std::size_t>(vertex.entity[1]);
            if (vertex.entity[0] == 0) {
                vertex.point = topology_.nodes[index].point;
            } else if (vertex.entity[0] == 1) {
                on_edge[index].push_back(static_cast<int>(v));
            }
        }
        for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
            const geometry::Edge& edge = topology_.edges[e];
            if (edge.degenerate) {
                for (const int use : edge.uses) {
                    ask_uv(use, edge.t0, vertex_at_end(edge, 0, at_node_));
                    ask_uv(use, edge.t1, vertex_at_end(edge, 0, at_node_));
                }
            } else if (!edge.uses.empty()) {  // other edges were joined with an edge that lies along them
                follow_edge(static_cast<int>(e), sorted_along(static_cast<int>(e), on_edge[e]));
            }
        }
        set_uv();
    }

    /// Vertices with their parameters on the edge, ascending. The search for the nearest point is a local one, and a
    /// curve may come near a vertex more than once: the search is repeated from more and more parameters until the
    /// vertex lies on the curve.
    std::vector<std::pair<double, int>> sorted_along(int e, const std::vector<int>& vertices) {
        const double near = kOnCurve * topology_.box.largest_side();
        std::vector<Answer> best(vertices.size());
        std::vector<std::size_t> open(vertices.size());
        std::iota(open.begin(), open.end(), std::size_t{0});
        for (int starts = 1; starts <= kMostSteps && !open.empty(); starts *= 4) {
            search(e, vertices, open, starts, best);
            open.erase(std::remove_if(open.begin(), open.end(),
                                      [&](std::size_t i) { return best[i].found() && best[i].distance <= near; }),
                       open.end());
        }
        std::vector<std::pair<double, int>> sorted;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            if (!best[i].found()) {
                throw GeometryError(phrases::kNoPointNear, {{"name", topology_.name_of({1, e})}});
            }
            sorted.emplace_back(best[i].t, vertices[i]);
            surface_.shapes.vertices[static_cast<std::size_t>(vertices[i])].point = best[i].point;
        }
        std::sort(sorted.begin(), sorted.end());
        return sorted;
    }

    void search(int e, const std::vector<int>& vertices, const std::vector<std::size_t>& open, int starts,
                std::vector<Answer>& best) {
        const geometry::Edge& edge = topology_.edges[static_cast<std::size_t>(e)];
        geometry::Engine::Batch batch;
        for (const std::size_t i : open) {
            const Vec3& p = surface_.shapes.vertices[static_cast<std::size_t>(vertices[i])].point;
            for (int k = 0; k < starts; ++k) {
                const double t = edge.t0 + (k + 0.5) / starts * (edge.t1 - edge.t0);
                batch.push_back(Query::edge_nearest(e, p, t, edge.t0, edge.t1));
            }
        }
        const auto answers = session_.ask(std::move(batch));
        std::size_t next = 0;
        for (const std::size_t i : open) {
            for (int k = 0; k < starts; ++k, ++next) {
                if (answers[next].found() && (!best[i].found() || answers[next].distance < best[i].distance)) {
                    best[i] = answers[next];
                }
            }
        }
    }

    /// Vertices that follow each other along the edge are joined by mesh edges on it.
    void follow_edge(int e, std::vector<std::pair<double, int>> chain) {
        const geometry::Edge& edge = topology_.edges[static_cast<std::size_t>(e)];
        if (vertex_at_end(edge, 0, at_node_) >= 0) {
            chain.insert(chain.begin(), {edge.t0, vertex_at_end(edge, 0, at_node_)});
        }
        if (vertex_at_end(edge, 1, at_node_) >= 0) {
            chain.emplace_back(edge.t1, vertex_at_end(edge, 1, at_node_));
        }
        for (const auto& [t, v] : chain) {
            for (const int use : edge.uses) {
                ask_uv(use, t, v);
            }
        }
        if (geometry::is_closed(edge) && vertex_at_end(edge, 0, at_node_) < 0 && chain.size() > 2) {
            chain.emplace_back(chain.front().first + edge.t1 - edge.t0, chain.front().second);
        }
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            const int a = chain[i].second;
            const int b = chain[i + 1].second;
            if (a == b) {
                continue;  // the edge is a single vertex of the mesh
            }
            if (surface_.has_edge(a, b)) {
                surface_.set_segment(a, b, e, chain[i].first, chain[i + 1].first);
            } else if (must_be_followed(edge)) {
                throw TopologyError(phrases::kNotFollowed, {{"name", topology_.name_of({1, e})}});
            }
        }
    }

    /// Whether an edge bounds a face that has a mesh. A seam lies between two sides of one face.
    bool must_be_followed(const geometry::Edge& edge) const {
        std::set<int> faces;
        for (const int use : edge.uses) {
            faces.insert(topology_.uses[static_cast<std::size_t>(use)].face);
        }
        const bool seam = edge.uses.size() == 2 && faces.size() == 1;
        return !seam &&
               std::any_of(faces.begin(), faces.end(), [&](int face) { return meshed_faces_.count(face) > 0; });
    }

    void ask_uv(int use, double t, int vertex) {
        if (vertex >= 0) {
            uv_batch_.push_back(Query::use_on_face(use, t));
            uv_vertices_.push_back(vertex);
        }
    }

    void set_uv() {
        const auto answers = session_.ask(uv_batch_);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            if (!answers[i].found()) {
                continue;
            }
            const int face = topology_.uses[static_cast<std::size_t>(uv_batch_[i].index)].face;
            const std::uint64_t key = CurvedSurface::key(uv_vertices_[i], face);
            const Vec2 uv(answers[i].u, answers[i].v);
            const auto known = surface_.uv.emplace(key, uv).first;
            if (degenerate(uv_batch_[i].index)) {
                const Vec2 along = (uv - known->second).cwiseAbs();
                surface_.free_parameter[key] = along.y() > along.x() ? 1 : 0;
            } else if (answers[i].status == geometry::Status::Singular) {
                surface_.free_parameter.emplace(key, 0);
            }
        }
    }

    bool degenerate(int use) const {
        const int edge = topology_.uses[static_cast<std::size_t>(use)].edge;
        return topology_.edges[static_cast<std::size_t>(edge)].degenerate;
    }

    void put_on_faces() {
        std::set<std::pair<int, int>> needed;  // vertex, face
        for (const SurfaceTriangle& t : surface_.triangles) {
            for (const int v : t.corners) {
                if (surface_.uv_of(v, t.face) == nullptr) {
                    needed.emplace(v, t.face);
                }
            }
        }
        geometry::Engine::Batch batch;
        for (const auto& [v, face] : needed) {
            batch.push_back(
                Query::face_nearest_global(face, surface_.shapes.vertices[static_cast<std::size_t>(v)].point));
        }
        const auto answers = session_.ask(std::move(batch));
        std::size_t i = 0;
        for (const auto& [v, face] : needed) {
            const Answer& answer = answers[i++];
            if (!answer.found()) {
                throw GeometryError(phrases::kNoPointNear, {{"name", topology_.name_of({2, face})}});
            }
            surface_.uv[CurvedSurface::key(v, face)] = Vec2(answer.u, answer.v);
            elements::Vertex& vertex = surface_.shapes.vertices[static_cast<std::size_t>(v)];
            if (vertex.entity[0] == 2) {
                vertex.point = answer.point;
            }
        }
    }

    /// Orients each face by the majority of the area: single triangles may be folded.
    void orient() {
        geometry::Engine::Batch batch;
        for (const SurfaceTriangle& t : surface_.triangles) {
            const Vec2* uv = surface_.uv_of(t.corners[0], t.face);
            batch.push_back(Query::face_point(t.face, uv->x(), uv->y()));
        }
        const auto answers = session_.ask(std::move(batch));
        std::vector<double> sums(topology_.faces.size(), 0.0);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const SurfaceTriangle& t = surface_.triangles[i];
            const auto point = [&](std::size_t k) -> const Vec3& {
                return surface_.shapes.vertices[static_cast<std::size_t>(t.corners[k])].point;
            };
            sums[static_cast<std::size_t>(t.face)] +=
                (point(1) - point(0)).cross(point(2) - point(0)).dot(answers[i].normal);
        }
        for (const double sum : sums) {
            surface_.face_sign.push_back(sum < 0.0 ? -1.0 : 1.0);
        }
    }

    geometry::Session& session_;
    const geometry::Topology& topology_;
    CurvedSurface& surface_;
    const std::vector<int>& at_node_;  // by CAD vertex
    std::set<int> meshed_faces_;
    geometry::Engine::Batch uv_batch_;
    std::vector<int> uv_vertices_;
};

}  // namespace

int vertex_at_end(const geometry::Edge& edge, std::size_t end, const std::vector<int>& at_node) {
    return edge.nodes[end] < 0 ? -1 : at_node[static_cast<std::size_t>(edge.nodes[end])];
}

void find_parameters(geometry::Session& session, CurvedSurface& surface, const std::vector<int>& at_node) {
    Parameters(session, surface, at_node).find();
}

}  // namespace mq::curve
