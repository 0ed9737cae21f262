// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>

#include "base/error.h"
#include "curve/surface/curved_surface.h"
#include "curve/surface/tuning.h"

namespace mq::curve {

namespace {

using geometry::Answer;
using geometry::Query;

/// Vertices of the triangulation are rounded to single precision: this fraction of the model's size is their largest
/// distance from their curves.
constexpr double kOnCurve = 2e-7;

class Classifier {
  public:
    Classifier(geometry::Session& session, const mesh::TriangleMesh& mesh, int order)
        : session_(session),
          topology_(session.topology()),
          mesh_(mesh),
          vertex_entity_(mesh.vertex_piece.empty() ? mesh.vertex_entity : mesh.vertex_piece),
          triangle_face_(mesh.triangle_piece.empty() ? mesh.triangle_face : mesh.triangle_piece),
          surface_(order) {}

    CurvedSurface run() {
        if (vertex_entity_.size() != mesh_.vertices.size() || triangle_face_.size() != mesh_.triangles.size()) {
            throw InvalidInput("the mesh does not say which CAD entities it lies on: curve one made by triangulate()");
        }
        require_entities();
        join_vertices();
        join_triangles();
        put_on_nodes_and_edges();
        put_on_faces();
        orient();
        return std::move(surface_);
    }

  private:
    /// Refuses a mesh of another shape, or of this one before it was changed or moved: its vertices are not on the
    /// vertices of the shape on which they should lie.
    void require_entities() const {
        const double near = SurfaceTuning::kNearVertex * topology_.box.largest_side();
        const std::array<std::size_t, 3> counts = {topology_.nodes.size(), topology_.edges.size(),
                                                   topology_.faces.size()};
        for (std::size_t v = 0; v < vertex_entity_.size(); ++v) {
            const auto [dimension, index] = vertex_entity_[v];
            const bool known = dimension >= 0 && dimension <= 2 && index >= 0 &&
                               static_cast<std::size_t>(index) < counts[static_cast<std::size_t>(dimension)];
            if (known && dimension != 0) {
                continue;
            }
            const geometry::Node* node = known ? &topology_.nodes[static_cast<std::size_t>(index)] : nullptr;
            if (node == nullptr ||
                (mesh_.vertices[v] + mesh_.origin - node->point).norm() > near + 2.0 * node->tolerance) {
                throw InvalidInput("the mesh does not belong to the shape: its vertex " + std::to_string(v) +
                                   " is not on " + geometry::name_of({dimension, index}) +
                                   "; give the shape that it was made from, where it was");
            }
        }
    }

    /// Each volume has vertices of its own in the mesh; the same point on the same entity becomes one vertex.
    void join_vertices() {
        std::map<std::tuple<int, int, double, double, double>, int> known;
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
            const Vec3 p = mesh_.vertices[i] + mesh_.origin;
            const mesh::VertexEntity& entity = vertex_entity_[i];
            const auto [found, fresh] = known.emplace(std::make_tuple(entity[0], entity[1], p.x(), p.y(), p.z()), -1);
            if (fresh) {
                found->second = surface_.add_vertex({p, entity});
            }
            joined_.push_back(found->second);
        }
    }

    /// Triangles come volume by volume, face by face. A face that is known already is only recorded as a side of the
    /// new volume.
    void join_triangles() {
        std::vector<int> first_of_face(topology_.faces.size(), -1);
        std::size_t next = 0;
        for (const geometry::Volume& volume : topology_.volumes) {
            surface_.volume_faces.emplace_back();
            for (const auto& side : volume.sides) {
                const auto face = static_cast<std::size_t>(side.face);
                const bool known = first_of_face[face] >= 0;
                bool flipped = false;
                // The side after this one may be of the same face, of another volume or of this one: a triangle that
                // comes again belongs to it.
                std::set<FaceKey> run;
                for (; next < mesh_.triangles.size() && triangle_face_[next] == side.face; ++next) {
                    const std::array<int, 3> corners = joined(mesh_.triangles[next]);
                    if (!run.insert(face_key(corners[0], corners[1], corners[2])).second) {
                        break;
                    }
                    if (!known) {
                        const int added = surface_.add_triangle(corners, side.face);
                        first_of_face[face] = first_of_face[face] < 0 ? added : first_of_face[face];
                    } else if (run.size() == 1) {
                        flipped = !same_turn(corners, first_of_face[face]);
                    }
                }
                const auto met = [&](const auto& other) { return other.first == side.face; };
                auto& faces = surface_.volume_faces.back();
                // A solid may see a face inside it from both sides.
                if (!run.empty() && std::none_of(faces.begin(), faces.end(), met)) {
                    faces.emplace_back(side.face, flipped);
                }
            }
        }
        if (next != mesh_.triangles.size()) {
            throw InvalidInput("the triangles of the mesh do not follow the faces of the shape: was it made from it?");
        }
    }

    std::array<int, 3> joined(const mesh::Triangle& t) const {
        return {joined_[static_cast<std::size_t>(t[0])], joined_[static_cast<std::size_t>(t[1])],
                joined_[static_cast<std::size_t>(t[2])]};
    }

    bool same_turn(const std::array<int, 3>& corners, int triangle) const {
        const auto& other = surface_.triangles[static_cast<std::size_t>(triangle)].corners;
        const auto at = std::find(other.begin(), other.end(), corners[0]) - other.begin();
        return at == 3 || other[static_cast<std::size_t>((at + 1) % 3)] == corners[1];
    }

    void put_on_nodes_and_edges() {
        std::vector<std::vector<int>> on_edge(topology_.edges.size());
        std::vector<int> at_node(topology_.nodes.size(), -1);
        for (std::size_t v = 0; v < surface_.shapes.vertices.size(); ++v) {
            Vertex& vertex = surface_.shapes.vertices[v];
            const auto index = static_cast<std::size_t>(vertex.entity[1]);
            if (vertex.entity[0] == 0) {
                at_node[index] = static_cast<int>(v);
                vertex.point = topology_.nodes[index].point;
            } else if (vertex.entity[0] == 1) {
                on_edge[index].push_back(static_cast<int>(v));
            }
        }
        share_collapsed_nodes(at_node);
        for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
            const geometry::Edge& edge = topology_.edges[e];
            if (edge.degenerate) {
                for (const int use : edge.uses) {
                    ask_uv(use, edge.t0, node_vertex(edge, 0, at_node));
                    ask_uv(use, edge.t1, node_vertex(edge, 0, at_node));
                }
            } else if (!edge.uses.empty()) {  // others were joined with one that lies along them
                follow_edge(static_cast<int>(e), sorted_along(static_cast<int>(e), on_edge[e]), at_node);
            }
        }
        set_uv();
    }

    /// Where a short edge is one vertex of the mesh, that vertex stands for both its nodes.
    void share_collapsed_nodes(std::vector<int>& at_node) const {
        const double step = kOnCurve * topology_.box.largest_side();
        bool any = true;
        while (any) {
            any = false;
            for (const geometry::Edge& edge : topology_.edges) {
                for (const std::size_t end : {0U, 1U}) {
                    if (edge.uses.empty() || node_vertex(edge, end, at_node) < 0 || edge.nodes[1 - end] < 0 ||
                        node_vertex(edge, 1 - end, at_node) >= 0) {
                        continue;
                    }
                    const geometry::Node& met = topology_.nodes[static_cast<std::size_t>(edge.nodes[end])];
                    const geometry::Node& open = topology_.nodes[static_cast<std::size_t>(edge.nodes[1 - end])];
                    if ((met.point - open.point).norm() <= std::max({10.0 * step, met.tolerance, open.tolerance})) {
                        at_node[static_cast<std::size_t>(edge.nodes[1 - end])] = node_vertex(edge, end, at_node);
                        any = true;
                    }
                }
            }
        }
    }

    static int node_vertex(const geometry::Edge& edge, std::size_t end, const std::vector<int>& at_node) {
        return edge.nodes[end] < 0 ? -1 : at_node[static_cast<std::size_t>(edge.nodes[end])];
    }

    /// Vertices with their parameters on the edge, ascending. The search for the nearest point is a local one, and a
    /// curve may come near a vertex more than once: the search is repeated from more and more parameters until the
    /// vertex lies on the curve.
    std::vector<std::pair<double, int>> sorted_along(int e, const std::vector<int>& vertices) {
        const double near = kOnCurve * topology_.box.largest_side();
        std::vector<Answer> best(vertices.size());
        std::vector<std::size_t> open(vertices.size());
        std::iota(open.begin(), open.end(), std::size_t{0});
        for (int starts = 1; starts <= SurfaceTuning::kMostCurveStarts && !open.empty(); starts *= 4) {
            search(e, vertices, open, starts, best);
            open.erase(std::remove_if(open.begin(), open.end(),
                                      [&](std::size_t i) { return best[i].found() && best[i].distance <= near; }),
                       open.end());
        }
        std::vector<std::pair<double, int>> sorted;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            if (!best[i].found()) {
                throw GeometryError("no point of " + topology_.name_of({1, e}) + " near a vertex of its mesh");
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
    void follow_edge(int e, std::vector<std::pair<double, int>> chain, const std::vector<int>& at_node) {
        const geometry::Edge& edge = topology_.edges[static_cast<std::size_t>(e)];
        if (node_vertex(edge, 0, at_node) >= 0) {
            chain.insert(chain.begin(), {edge.t0, node_vertex(edge, 0, at_node)});
        }
        if (node_vertex(edge, 1, at_node) >= 0) {
            chain.emplace_back(edge.t1, node_vertex(edge, 1, at_node));
        }
        for (const auto& [t, v] : chain) {
            for (const int use : edge.uses) {
                ask_uv(use, t, v);
            }
        }
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            const int a = chain[i].second;
            const int b = chain[i + 1].second;
            if (a == b) {
                continue;  // an edge that is a vertex of the mesh
            }
            if (surface_.has_edge(a, b)) {
                surface_.set_segment(a, b, e, chain[i].first, chain[i + 1].first);
            } else if (meshed(edge)) {
                throw TopologyError("the mesh does not follow " + topology_.name_of({1, e}));
            }
        }
    }

    bool meshed(const geometry::Edge& edge) const {
        return std::any_of(edge.uses.begin(), edge.uses.end(), [&](int use) {
            const int face = topology_.uses[static_cast<std::size_t>(use)].face;
            return std::find(triangle_face_.begin(), triangle_face_.end(), face) != triangle_face_.end();
        });
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
                throw GeometryError("no point of " + topology_.name_of({2, face}) + " near a vertex of its mesh");
            }
            surface_.uv[CurvedSurface::key(v, face)] = Vec2(answer.u, answer.v);
            Vertex& vertex = surface_.shapes.vertices[static_cast<std::size_t>(v)];
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
    const mesh::TriangleMesh& mesh_;
    const std::vector<mesh::VertexEntity>& vertex_entity_;
    const std::vector<std::int32_t>& triangle_face_;
    CurvedSurface surface_;
    std::vector<int> joined_;
    geometry::Engine::Batch uv_batch_;
    std::vector<int> uv_vertices_;
};

}  // namespace

CurvedSurface classify(geometry::Session& session, const mesh::TriangleMesh& mesh, int order) {
    return Classifier(session, mesh, order).run();
}

}  // namespace mq::curve
