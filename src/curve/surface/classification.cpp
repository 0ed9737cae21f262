// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/surface/curved_surface.h"
#include "curve/surface/tuning.h"

namespace mq::curve {

namespace {

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
            throw InvalidInput(phrases::kNoEntities);
        }
        require_entities();
        join_vertices();
        join_triangles();
        find_parameters(session_, surface_, vertices_at_nodes());
        return std::move(surface_);
    }

  private:
    /// Refuses a mesh of another shape, or of this shape before it was changed or moved: vertices of the mesh are off
    /// the vertices of the shape that they should lie on.
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
                throw InvalidInput(phrases::kOtherShape,
                                   {{"count", v}, {"name", geometry::name_of({dimension, index})}});
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
                // The next side may belong to the same face, of another volume or of this one: a repeated triangle
                // belongs to it.
                std::set<elements::FaceKey> run;
                for (; next < mesh_.triangles.size() && triangle_face_[next] == side.face; ++next) {
                    const std::array<int, 3> corners = joined(mesh_.triangles[next]);
                    if (!run.insert(elements::face_key(corners[0], corners[1], corners[2])).second) {
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
            throw InvalidInput(phrases::kFacesNotFollowed);
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

    std::vector<int> vertices_at_nodes() const {
        std::vector<int> at_node(topology_.nodes.size(), -1);
        for (std::size_t v = 0; v < surface_.shapes.vertices.size(); ++v) {
            const mesh::VertexEntity& entity = surface_.shapes.vertices[v].entity;
            if (entity[0] == 0) {
                at_node[static_cast<std::size_t>(entity[1])] = static_cast<int>(v);
            }
        }
        share_collapsed_nodes(at_node);
        return at_node;
    }

    /// Where a short edge is one vertex of the mesh, that vertex stands for both its nodes.
    void share_collapsed_nodes(std::vector<int>& at_node) const {
        const double step = kOnCurve * topology_.box.largest_side();
        bool any = true;
        while (any) {
            any = false;
            for (const geometry::Edge& edge : topology_.edges) {
                for (const std::size_t end : {0U, 1U}) {
                    if (edge.uses.empty() || vertex_at_end(edge, end, at_node) < 0 || edge.nodes[1 - end] < 0 ||
                        vertex_at_end(edge, 1 - end, at_node) >= 0) {
                        continue;
                    }
                    const geometry::Node& met = topology_.nodes[static_cast<std::size_t>(edge.nodes[end])];
                    const geometry::Node& open = topology_.nodes[static_cast<std::size_t>(edge.nodes[1 - end])];
                    if ((met.point - open.point).norm() <= std::max({10.0 * step, met.tolerance, open.tolerance})) {
                        at_node[static_cast<std::size_t>(edge.nodes[1 - end])] = vertex_at_end(edge, end, at_node);
                        any = true;
                    }
                }
            }
        }
    }

    geometry::Session& session_;
    const geometry::Topology& topology_;
    const mesh::TriangleMesh& mesh_;
    const std::vector<mesh::VertexEntity>& vertex_entity_;
    const std::vector<std::int32_t>& triangle_face_;
    CurvedSurface surface_;
    std::vector<int> joined_;
};

}  // namespace

CurvedSurface classify(geometry::Session& session, const mesh::TriangleMesh& mesh, int order) {
    return Classifier(session, mesh, order).run();
}

}  // namespace mq::curve
