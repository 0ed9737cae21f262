// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/output/curved_mesh.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "base/error.h"
#include "base/single_precision_grid.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "elements/product/reference_nodes.h"

namespace mq::curve {

using elements::Exponents;
using elements::Lattice;

namespace {

class Assembler {
  public:
    Assembler(const CurvedSurface& surface, const std::vector<Tetrahedron>& tetrahedra)
        : surface_(surface), tetrahedra_(tetrahedra) {
        mesh_.order = surface.shapes.order();
        for (int dimension = 1; dimension <= 3; ++dimension) {
            orders_[static_cast<std::size_t>(dimension)] = elements::gmsh_order(Lattice::of(dimension, mesh_.order));
        }
    }

    CurvedMesh run(std::vector<int>* number) {
        number_vertices();
        for (const SurfaceTriangle& t : surface_.triangles) {
            if (t.alive) {
                append<3>(t.corners, mesh_.triangles, {2, t.face});
                mesh_.triangle_face.push_back(t.face);
            }
        }
        append_edges();
        for (const Tetrahedron& tetrahedron : tetrahedra_) {
            append<4>(tetrahedron.corners, mesh_.tetrahedra, {3, tetrahedron.volume});
            mesh_.tetrahedron_volume.push_back(tetrahedron.volume);
        }
        if (number != nullptr) {
            *number = number_;
        }
        return std::move(mesh_);
    }

  private:
    void number_vertices() {
        number_.assign(surface_.shapes.vertices.size(), -1);
        std::vector<char> used(number_.size(), 0);
        for (const SurfaceTriangle& t : surface_.triangles) {
            for (const int v : t.corners) {
                used[static_cast<std::size_t>(v)] |= t.alive ? 1 : 0;
            }
        }
        for (const Tetrahedron& tetrahedron : tetrahedra_) {
            for (const int v : tetrahedron.corners) {
                used[static_cast<std::size_t>(v)] = 1;
            }
        }
        for (std::size_t v = 0; v < used.size(); ++v) {
            if (used[v]) {
                number_[v] = static_cast<int>(mesh_.nodes.size());
                mesh_.nodes.push_back(surface_.shapes.vertices[v].point);
                mesh_.node_entity.push_back(surface_.shapes.vertices[v].entity);
            }
        }
        mesh_.vertices = mesh_.nodes.size();
    }

    void append_edges() {
        std::map<elements::EdgeKey, int> ordered;
        for (const auto& [key, segment] : surface_.segments) {
            const int a = static_cast<int>(key >> 32);
            const int b = static_cast<int>(key & 0xffffffffu);
            if (surface_.has_edge(a, b)) {
                ordered[key] = segment.edge;
            }
        }
        for (const auto& [key, edge] : ordered) {
            const int a = static_cast<int>(key >> 32);
            const int b = static_cast<int>(key & 0xffffffffu);
            const auto nodes = edge_nodes(a, b, {1, edge});
            for (const int i : orders_[1]) {
                const int last = mesh_.order;
                const int node = i == 0      ? number_[static_cast<std::size_t>(a)]
                                 : i == last ? number_[static_cast<std::size_t>(b)]
                                             : nodes[static_cast<std::size_t>(i - 1)];
                mesh_.edges.push_back(node);
                if (i != 0 && i != last) {
                    mesh_.node_entity[static_cast<std::size_t>(node)] = {1, edge};
                }
            }
            mesh_.edge_entity.push_back(edge);
        }
    }

    int add_node(const Vec3& point, mesh::VertexEntity entity) {
        mesh_.nodes.push_back(point);
        mesh_.node_entity.push_back(entity);
        return static_cast<int>(mesh_.nodes.size()) - 1;
    }

    /// The inner nodes of the edge from a to b.
    std::vector<int> edge_nodes(int a, int b, mesh::VertexEntity entity) {
        auto [found, fresh] = edges_.try_emplace(pair_key(a, b));
        if (fresh) {
            const int low = std::min(a, b);
            const int high = std::max(a, b);
            std::vector<Vec3> control{surface_.shapes.vertices[static_cast<std::size_t>(low)].point};
            for (const Vec3& p : surface_.shapes.edge_inner(low, high)) {
                control.push_back(p);
            }
            control.push_back(surface_.shapes.vertices[static_cast<std::size_t>(high)].point);
            const std::vector<Vec3> nodes = elements::bezier_to_nodes(Lattice::of(1, mesh_.order), control);
            for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
                found->second.push_back(add_node(nodes[i], entity));
            }
        }
        std::vector<int> nodes = found->second;
        if (a > b) {
            std::reverse(nodes.begin(), nodes.end());
        }
        return nodes;
    }

    /// The node at a point of the triangle's lattice; -1 unless the point is an inner one.
    int face_node(const std::array<int, 3>& corners, const Exponents& e, mesh::VertexEntity entity) {
        const Lattice& lattice = Lattice::of(2, mesh_.order);
        std::array<std::size_t, 3> order{0, 1, 2};
        std::sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return corners[x] < corners[y]; });
        const std::array<int, 3> sorted{corners[order[0]], corners[order[1]], corners[order[2]]};
        auto [found, fresh] = faces_.try_emplace(sorted);
        if (fresh) {
            std::vector<Vec3> control;
            surface_.shapes.triangle(sorted, control);
            const std::vector<Vec3> nodes = elements::bezier_to_nodes(lattice, control);
            found->second.assign(nodes.size(), -1);
            for (int i = 0; i < lattice.size(); ++i) {
                if (lattice.carriers(i) == 3) {
                    found->second[static_cast<std::size_t>(i)] = add_node(nodes[static_cast<std::size_t>(i)], entity);
                }
            }
        }
        const Exponents turned{e[order[0]], e[order[1]], e[order[2]], 0};
        return found->second[static_cast<std::size_t>(lattice.index(turned))];
    }

    template <std::size_t N>
    void append(const std::array<int, N>& corners, std::vector<std::int32_t>& list, mesh::VertexEntity entity) {
        const Lattice& lattice = Lattice::of(static_cast<int>(N) - 1, mesh_.order);
        std::vector<Vec3> inside;
        for (const int i : orders_[N - 1]) {
            const Exponents& e = lattice.exponents(i);
            std::vector<std::size_t> on;
            for (std::size_t k = 0; k < N; ++k) {
                if (e[k] > 0) {
                    on.push_back(k);
                }
            }
            int node = -1;
            if (on.size() == 1) {
                node = number_[static_cast<std::size_t>(corners[on[0]])];
            } else if (on.size() == 2) {
                node = edge_nodes(corners[on[0]], corners[on[1]], entity)[static_cast<std::size_t>(e[on[1]] - 1)];
            } else if (on.size() == 3) {
                node = face_node({corners[on[0]], corners[on[1]], corners[on[2]]}, {e[on[0]], e[on[1]], e[on[2]], 0},
                                 entity);
            } else {
                node = add_node(region_point(corners, lattice.node(i), inside), entity);
            }
            list.push_back(node);
        }
    }

    template <std::size_t N>
    Vec3 region_point(const std::array<int, N>& corners, const elements::Barycentric& at,
                      std::vector<Vec3>& control) const {
        if constexpr (N == 4) {
            if (control.empty()) {
                surface_.shapes.tetrahedron(corners, control);
            }
            return elements::value(Lattice::of(3, mesh_.order), control, at);
        } else {
            return Vec3::Zero();  // a triangle has no point with four carriers
        }
    }

    const CurvedSurface& surface_;
    const std::vector<Tetrahedron>& tetrahedra_;
    CurvedMesh mesh_;
    std::vector<int> number_;
    std::array<std::vector<int>, 4> orders_;  // by dimension: Gmsh's order of the nodes
    std::unordered_map<elements::EdgeKey, std::vector<int>> edges_;
    std::unordered_map<elements::FaceKey, std::vector<int>, KeyHash> faces_;
};

}  // namespace

CurvedMesh assemble(const CurvedSurface& surface, const std::vector<Tetrahedron>& tetrahedra,
                    std::vector<int>* number) {
    return Assembler(surface, tetrahedra).run(number);
}

void classify_on_original_entities(CurvedMesh& mesh, const geometry::Topology& topology) {
    if (!topology.has_pieces()) {
        return;
    }
    const auto touches = [](const geometry::Face& face) { return face.behind >= 0; };
    const bool any = std::any_of(topology.faces.begin(), topology.faces.end(), touches);
    for (std::int32_t& face : mesh.triangle_face) {
        if (any) {
            mesh.triangle_face_behind.push_back(topology.faces[static_cast<std::size_t>(face)].behind);
        }
        face = topology.of_shape({2, face}).index;
    }
    for (mesh::VertexEntity& entity : mesh.node_entity) {
        const geometry::Entity whole = topology.of_shape({entity[0], entity[1]});
        entity = {whole.dimension, whole.index};
    }
    const auto width = static_cast<std::ptrdiff_t>(mesh.nodes_per_edge());
    CurvedMesh kept;
    for (std::size_t e = 0; e < mesh.edge_entity.size(); ++e) {
        const geometry::Entity whole = topology.of_shape({1, mesh.edge_entity[e]});
        if (whole.dimension == 1) {
            const auto first = mesh.edges.begin() + static_cast<std::ptrdiff_t>(e) * width;
            kept.edges.insert(kept.edges.end(), first, first + width);
            kept.edge_entity.push_back(whole.index);
        }
    }
    mesh.edges = std::move(kept.edges);
    mesh.edge_entity = std::move(kept.edge_entity);
}

namespace {

void require_count(std::size_t count, std::size_t expected, const char* name) {
    if (count != expected) {
        throw InvalidInput(phrases::kOneForEach, {{"name", name}, {"count", count}, {"count2", expected}});
    }
}

/// The number from 1 that files have is an int32, too.
void require_entity(std::int32_t dimension, std::int32_t index, const char* owner) {
    constexpr std::int32_t kMostEntities =
        std::numeric_limits<std::int32_t>::max() - 1;  // so that the number of nodes fits into the type, too
    if (dimension < 0 || dimension > 3 || index < 0 || index > kMostEntities) {
        throw InvalidInput(phrases::kEntityNumber, {{"kind", owner}, {"count", index}, {"count2", dimension}});
    }
}

struct Elements {
    const char* name;
    const char* owner;
    int dimension;
    const std::vector<std::int32_t>& nodes;
    int width;
    const std::vector<std::int32_t>& entity;
};

void require_elements(const CurvedMesh& mesh, const Elements& elements) {
    const std::size_t count = elements.entity.size();
    if (elements.nodes.size() != count * static_cast<std::size_t>(elements.width)) {
        throw InvalidInput(phrases::kNodesEach, {{"kind", elements.name},
                                                 {"count", mesh.order},
                                                 {"count2", elements.width},
                                                 {"count3", elements.nodes.size()},
                                                 {"count4", count}});
    }
    for (const std::int32_t node : elements.nodes) {
        if (node < 0 || static_cast<std::size_t>(node) >= mesh.nodes.size()) {
            throw InvalidInput(phrases::kElementsNameNode,
                               {{"kind", elements.name}, {"count", node}, {"count2", mesh.nodes.size()}});
        }
    }
    for (const std::int32_t index : elements.entity) {
        require_entity(elements.dimension, index, elements.owner);
    }
}

}  // namespace

void require_sound(const CurvedMesh& mesh) {
    if (mesh.order < 1 || mesh.order > elements::kMaxOrder) {
        throw InvalidInput(phrases::kElementOrder, {{"count", elements::kMaxOrder}, {"count2", mesh.order}});
    }
    require_count(mesh.node_entity.size(), mesh.nodes.size(), "node_entity");
    Box box;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        if (!mesh.nodes[i].allFinite()) {
            throw InvalidInput(phrases::kNodeNotFinite, {{"count", i}});
        }
        require_entity(mesh.node_entity[i][0], mesh.node_entity[i][1], "a node");
        box.add(mesh.nodes[i]);
    }
    SinglePrecisionGrid{box};  // refuses coordinates whose polynomials overflow
    require_elements(mesh, {"edges", "an edge", 1, mesh.edges, mesh.nodes_per_edge(), mesh.edge_entity});
    require_elements(mesh,
                     {"triangles", "a triangle", 2, mesh.triangles, mesh.nodes_per_triangle(), mesh.triangle_face});
    require_elements(mesh, {"tetrahedra", "a tetrahedron", 3, mesh.tetrahedra, mesh.nodes_per_tetrahedron(),
                            mesh.tetrahedron_volume});
    if (!mesh.triangle_face_behind.empty()) {
        require_count(mesh.triangle_face_behind.size(), mesh.triangle_face.size(), "triangle_face_behind");
    }
    if (!mesh.triangle_quality.empty()) {
        require_count(mesh.triangle_quality.size(), mesh.triangle_face.size(), "triangle_quality");
    }
    if (!mesh.tetrahedron_quality.empty()) {
        require_count(mesh.tetrahedron_quality.size(), mesh.tetrahedron_volume.size(), "tetrahedron_quality");
    }
}

std::vector<std::int32_t> tetrahedra_behind(const CurvedMesh& mesh) {
    std::unordered_map<elements::FaceKey, std::int32_t, KeyHash> faces;
    const auto width = static_cast<std::size_t>(mesh.nodes_per_tetrahedron());
    for (std::size_t e = 0; e < mesh.tetrahedron_volume.size(); ++e) {
        for (std::size_t k = 0; k < 4; ++k) {
            const auto corner = [&](std::size_t i) { return mesh.tetrahedra[e * width + (k + i) % 4]; };
            faces.try_emplace(elements::face_key(corner(1), corner(2), corner(3)), static_cast<std::int32_t>(e));
        }
    }
    std::vector<std::int32_t> behind;
    const auto step = static_cast<std::size_t>(mesh.nodes_per_triangle());
    for (std::size_t t = 0; t < mesh.triangle_face.size(); ++t) {
        const std::int32_t* corners = &mesh.triangles[t * step];
        const auto found = faces.find(elements::face_key(corners[0], corners[1], corners[2]));
        behind.push_back(found == faces.end() ? -1 : found->second);
    }
    return behind;
}

}  // namespace mq::curve
