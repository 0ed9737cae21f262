// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/matching/matching.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <numeric>
#include <queue>
#include <string>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/volume/tetrahedral_mesh.h"
#include "given/matching/edge_paths.h"
#include "given/matching/face_matching.h"
#include "given/matching/touching_bodies.h"

namespace mq::given {

using curve::SurfaceTriangle;
using elements::face_key;

namespace {

/// Largest relative difference between the boxes of a mesh and its model, as a fraction of the larger one: coarse
/// meshes of round models have smaller boxes.
constexpr double kOtherPlace = 0.15;

/// Number of pieces of a CAD edge whose ends are examined.
constexpr int kEdgePoints = 8;

/// Factors between units of files of meshes and shapes, with the unit that may have been taken for mm.
constexpr std::array<std::pair<double, Phrase>, 6> kUnits{{{1000.0, phrases::kInMetres},
                                                           {10.0, phrases::kInCentimetres},
                                                           {25.4, phrases::kInInches},
                                                           {304.8, phrases::kInFeet},
                                                           {1e-3, phrases::kInMicrometres},
                                                           {1.0 / 25.4, phrases::kShapeInInches}}};

Box box_of(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles) {
    Box box;
    for (const auto& t : triangles) {
        for (const int v : t) {
            box.add(points[static_cast<std::size_t>(v)]);
        }
    }
    return box;
}

/// A box that the model certainly fills: that of points on the edges of its faces. The box of the model itself may be
/// larger than the model.
Box box_of_edges(geometry::Session& session) {
    const geometry::Topology& topology = session.topology();
    Box box;
    geometry::Engine::Batch batch;
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const geometry::Edge& edge = topology.edges[e];
        for (int k = 0; k <= kEdgePoints && !edge.degenerate && !edge.uses.empty(); ++k) {
            batch.push_back(
                geometry::Query::edge_point(static_cast<int>(e), edge.t0 + (edge.t1 - edge.t0) * k / kEdgePoints));
        }
    }
    for (const geometry::Answer& answer : session.ask(std::move(batch))) {
        if (answer.found()) {
            box.add(answer.point);
        }
    }
    return box;
}

bool holds(const Box& outer, const Box& inner) {
    const Vec3 margin = Vec3::Constant(kOtherPlace * std::max(outer.largest_side(), inner.largest_side()));
    return inner.empty() || (((outer.low - margin).array() <= inner.low.array()) &&
                             (inner.high.array() <= (outer.high + margin).array()))
                                .all();
}

/// Refuses a mesh whose box does not lie between the box of the model's edges and the box of the model: units or place
/// differ.
void require_same_place(const Box& mesh, const Box& edges, const Box& model) {
    const auto fits = [&](const Box& box) { return holds(box, edges) && holds(model, box); };
    if (fits(mesh)) {
        return;
    }
    for (const auto& [factor, unit] : kUnits) {
        Box scaled = mesh;
        scaled.low *= factor;
        scaled.high *= factor;
        if (fits(scaled)) {
            throw InvalidInput(factor > 1.0 ? phrases::kGivenSmaller : phrases::kGivenLarger,
                               {{"number", in_digits(std::max(factor, 1.0 / factor), 4)},
                                {"phrase", unit},
                                {"value", in_digits(factor, 5)},
                                {"value2", in_digits(factor, 5)}});
        }
    }
    const Vec3 shift = model.center() - mesh.center();
    Box shifted;
    shifted.add(mesh.low + shift);
    shifted.add(mesh.high + shift);
    if (fits(shifted)) {
        throw InvalidInput(phrases::kGivenBeside, {{"length", in_mm(shift.norm())}, {"point", in_mm(shift, 5)}});
    }
    throw InvalidInput(phrases::kGivenElsewhere,
                       {{"length", in_mm(mesh.largest_side())}, {"length2", in_mm(model.largest_side())}});
}

class Matcher {
  public:
    Matcher(geometry::Session& session, const GivenMesh& mesh, int order)
        : session_(session), topology_(session.topology()), mesh_(mesh), result_{curve::CurvedSurface(order),
                                                                                 {},
                                                                                 {},
                                                                                 {},
                                                                                 {},
                                                                                 {}} {
        result_.given_node.resize(mesh.nodes.size());
        std::iota(result_.given_node.begin(), result_.given_node.end(), 0);
    }

    MatchedMesh run() {
        const SurfaceGraph graph(mesh_.nodes, surface_of(mesh_));
        require_same_place(box_of(mesh_.nodes, graph.triangles), box_of_edges(session_), topology_.box);
        const EdgePaths edges = find_edge_discretisation(session_, graph);
        const std::vector<int> face = match_faces(session_, graph, edges);
        add_vertices(graph, edges, face);
        add_triangles(graph, face);
        turn_alike();
        curve::find_parameters(session_, result_.surface, at_node_);
        turn_outward();
        keep_places();
        find_volumes();
        return std::move(result_);
    }

  private:
    curve::CurvedSurface& surface() { return result_.surface; }
    int& vertex_of(int node) { return result_.vertex_of_node[static_cast<std::size_t>(node)]; }

    /// Adds vertices in the order of the given nodes, each on the entity of lowest dimension that contains it.
    void add_vertices(const SurfaceGraph& graph, const EdgePaths& edges, const std::vector<int>& face) {
        std::map<int, mesh::VertexEntity> entity;
        for (std::size_t t = 0; t < graph.triangles.size(); ++t) {
            for (const int v : graph.triangles[t]) {
                entity[v] = {2, face[t]};
            }
        }
        for (std::size_t e = 0; e < edges.polylines.size(); ++e) {
            for (const int v : edges.polylines[e].vertices) {
                entity[v] = {1, static_cast<std::int32_t>(e)};
            }
        }
        for (std::size_t n = edges.of_node.size(); n-- > 0;) {
            if (edges.of_node[n] >= 0) {
                entity[edges.of_node[n]] = {0, static_cast<std::int32_t>(n)};
            }
        }
        result_.vertex_of_node.assign(mesh_.nodes.size(), -1);
        for (const auto& [v, on] : entity) {
            vertex_of(v) = surface().add_vertex({mesh_.nodes[static_cast<std::size_t>(v)], on});
        }
        for (const int v : edges.of_node) {
            at_node_.push_back(v < 0 ? -1 : vertex_of(v));
        }
    }

    void add_triangles(const SurfaceGraph& graph, const std::vector<int>& face) {
        for (std::size_t t = 0; t < graph.triangles.size(); ++t) {
            const auto& v = graph.triangles[t];
            surface().add_triangle({vertex_of(v[0]), vertex_of(v[1]), vertex_of(v[2])}, face[t]);
        }
    }

    /// Gives neighbours on a face the same orientation. Faces between two solids may be seen from either side.
    void turn_alike() {
        std::vector<char> done(surface().triangles.size(), 0);
        for (std::size_t start = 0; start < done.size(); ++start) {
            if (done[start]) {
                continue;
            }
            done[start] = 1;
            std::queue<int> open({static_cast<int>(start)});
            while (!open.empty()) {
                const int t = open.front();
                open.pop();
                for (std::size_t k = 0; k < 3; ++k) {
                    const int next = neighbour_on_face(t, k);
                    if (next >= 0 && !done[static_cast<std::size_t>(next)]) {
                        done[static_cast<std::size_t>(next)] = 1;
                        turn_against(t, k, next);
                        open.push(next);
                    }
                }
            }
        }
    }

    SurfaceTriangle& triangle(int t) { return surface().triangles[static_cast<std::size_t>(t)]; }

    /// The other triangle of the same face at side k; -1 if there is none.
    int neighbour_on_face(int t, std::size_t k) {
        int found = -1;
        const auto& v = triangle(t).corners;
        for (const int other : surface().triangles_of_edge(v[k], v[(k + 1) % 3])) {
            if (other != t && triangle(other).face == triangle(t).face) {
                if (found >= 0) {
                    return -1;
                }
                found = other;
            }
        }
        return found;
    }

    void turn_against(int t, std::size_t k, int other) {
        const int from = triangle(t).corners[k];
        const int to = triangle(t).corners[(k + 1) % 3];
        auto& v = triangle(other).corners;
        for (std::size_t i = 0; i < 3; ++i) {
            if (v[i] == from && v[(i + 1) % 3] == to) {
                std::swap(v[1], v[2]);
                return;
            }
        }
    }

    /// Reverses faces that are seen from inside, and lists the faces of each volume.
    void turn_outward() {
        for (SurfaceTriangle& t : surface().triangles) {
            if (surface().face_sign[static_cast<std::size_t>(t.face)] < 0.0) {
                std::swap(t.corners[1], t.corners[2]);
            }
        }
        std::fill(surface().face_sign.begin(), surface().face_sign.end(), 1.0);
        std::vector<char> meshed(topology_.faces.size(), 0);
        for (const SurfaceTriangle& t : surface().triangles) {
            meshed[static_cast<std::size_t>(t.face)] = 1;
        }
        for (const geometry::Volume& volume : topology_.volumes) {
            surface().volume_faces.emplace_back();
            std::vector<int> bare;
            for (const auto& side : volume.sides) {
                if (meshed[static_cast<std::size_t>(side.face)]) {
                    surface().volume_faces.back().emplace_back(side.face, side.flipped);
                } else if (!topology_.faces[static_cast<std::size_t>(side.face)].no_area) {
                    bare.push_back(side.face);
                }
            }
            if (!surface().volume_faces.back().empty()) {
                result_.bare_faces.insert(result_.bare_faces.end(), bare.begin(), bare.end());
            }
        }
    }

    /// Given nodes within rounding of the CAD keep their coordinates exactly.
    void keep_places() {
        const double rounding = curve::kOnCurve * topology_.box.largest_side();
        for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
            const int v = result_.vertex_of_node[n];
            if (v < 0) {
                continue;
            }
            Vec3& point = surface().shapes.vertices[static_cast<std::size_t>(v)].point;
            const double distance = (point - mesh_.nodes[n]).norm();
            if (distance > kNear.back() * topology_.box.largest_side()) {
                throw far_off(n, distance);
            }
            if (distance > rounding) {
                result_.moved.push_back({static_cast<int>(n), distance});
            } else {
                point = mesh_.nodes[n];
            }
        }
    }

    GeometryError far_off(std::size_t node, double distance) {
        const auto& entity = surface().shapes.vertices[static_cast<std::size_t>(result_.vertex_of_node[node])].entity;
        return {phrases::kGivenOff,
                {{"length", in_mm(distance, 3)},
                 {"name", topology_.name_of({entity[0], entity[1]})},
                 {"point", in_mm(mesh_.nodes[node])}}};
    }

    /// Tetrahedra that are connected without crossing the surface are in one volume: the volume that most of the
    /// triangles around them belong to.
    void find_volumes() {
        if (mesh_.tetrahedra.empty()) {
            return;
        }
        std::map<elements::FaceKey, int> on_surface;
        for (std::size_t t = 0; t < surface().triangles.size(); ++t) {
            const auto& v = surface().triangles[t].corners;
            on_surface.emplace(face_key(v[0], v[1], v[2]), static_cast<int>(t));
        }
        DisjointSets<std::size_t> joined(mesh_.tetrahedra.size());
        std::map<std::size_t, std::map<std::pair<int, bool>, std::size_t>>
            sides;  // by connected tetrahedra: number of triangles by face and side
        std::map<elements::FaceKey, std::size_t> inner;
        std::vector<std::pair<std::size_t, std::pair<int, bool>>> touching;
        for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
            for (const auto& face : curve::outward_faces(mesh_.tetrahedra[t])) {
                const std::array<int, 3> v{vertex_of(face[0]), vertex_of(face[1]), vertex_of(face[2])};
                const auto met =
                    std::min({v[0], v[1], v[2]}) < 0 ? on_surface.end() : on_surface.find(face_key(v[0], v[1], v[2]));
                if (met != on_surface.end()) {
                    touching.emplace_back(
                        t, std::make_pair(triangle(met->second).face, !same_turn(v, triangle(met->second).corners)));
                } else {
                    const auto [other, fresh] = inner.emplace(face_key(face[0], face[1], face[2]), t);
                    if (!fresh) {
                        joined.unite(other->second, t);
                    }
                }
            }
        }
        for (const auto& [t, side] : touching) {
            ++sides[joined.find(t)][side];
        }
        std::map<std::size_t, int> volume;
        for (const auto& [root, around] : sides) {
            volume[root] = volume_with(around);
        }
        require_whole_volumes(volume);
        for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
            const auto found = volume.find(joined.find(t));
            result_.volume.push_back(found == volume.end() ? -1 : found->second);
        }
    }

    /// Refuses tetrahedra in a volume if one of its faces has no triangles, for example a void that the mesh does not
    /// have.
    void require_whole_volumes(const std::map<std::size_t, int>& volumes) const {
        for (const auto& [root, volume] : volumes) {
            for (const auto& side : topology_.volumes[static_cast<std::size_t>(volume)].sides) {
                if (std::count(result_.bare_faces.begin(), result_.bare_faces.end(), side.face) > 0) {
                    throw TopologyError(phrases::kGivenBareFace, {{"name", topology_.name_of({2, side.face})}});
                }
            }
        }
    }

    int volume_with(const std::map<std::pair<int, bool>, std::size_t>& around) const {
        std::size_t most = 0;
        int best = -1;
        for (std::size_t i = 0; i < topology_.volumes.size(); ++i) {
            std::size_t count = 0;
            for (const auto& side : topology_.volumes[i].sides) {
                const auto met = around.find({side.face, side.flipped});
                count += met == around.end() ? 0 : met->second;
            }
            if (count > most) {
                most = count;
                best = static_cast<int>(i);
            }
        }
        if (best < 0) {
            throw TopologyError(phrases::kGivenOutside,
                                {{"name", topology_.name_of({2, around.begin()->first.first})}});
        }
        const auto& sides = topology_.volumes[static_cast<std::size_t>(best)].sides;
        for (const auto& [side, count] : around) {
            const auto same = [&, side = side](const auto& own) {
                return own.face == side.first && own.flipped == side.second;
            };
            if (std::none_of(sides.begin(), sides.end(), same)) {
                throw SolidsShareNodes(phrases::kGivenJoinsSolids);
            }
        }
        return best;
    }

    geometry::Session& session_;
    const geometry::Topology& topology_;
    const GivenMesh& mesh_;
    MatchedMesh result_;
    std::vector<int> at_node_;  // by CAD vertex: the vertex of the surface
};

/// By tetrahedron: the solid that contains its centroid, or -1.
std::vector<int> solids_of(geometry::Session& session, const GivenMesh& mesh) {
    const geometry::Topology& topology = session.topology();
    std::vector<int> solid(mesh.tetrahedra.size(), -1);
    for (std::size_t i = 0; i < topology.volumes.size(); ++i) {
        geometry::Engine::Batch batch;
        std::vector<std::size_t> asked;
        for (std::size_t t = 0; t < solid.size() && topology.volumes[i].kind == geometry::Volume::Kind::Solid; ++t) {
            if (solid[t] < 0) {
                Vec3 centroid = Vec3::Zero();
                for (const int v : mesh.tetrahedra[t]) {
                    centroid += 0.25 * mesh.nodes[static_cast<std::size_t>(v)];
                }
                batch.push_back(geometry::Query::volume_contains(static_cast<int>(i), centroid));
                asked.push_back(t);
            }
        }
        const auto answers = session.ask(std::move(batch));
        for (std::size_t k = 0; k < answers.size(); ++k) {
            if (answers[k].found() && answers[k].side > 0) {
                solid[asked[k]] = static_cast<int>(i);
            }
        }
    }
    return solid;
}

}  // namespace

MatchedMesh match(geometry::Session& session, const GivenMesh& mesh, int order) {
    try {
        return Matcher(session, mesh, order).run();
    } catch (const SolidsShareNodes&) {
        if (!session.topology().imprinted) {
            throw;
        }
    }
    GivenMesh divided = mesh;
    divided.regions = solids_of(session, mesh);
    return Matcher(session, divided, order).run();
}

MatchedMesh match_bodies(geometry::Session& session, GivenMesh& mesh, int order) {
    std::exception_ptr refusal;
    try {
        return match(session, mesh, order);
    } catch (const TopologyError&) {
        refusal = std::current_exception();
    } catch (const GeometryError&) {
        refusal = std::current_exception();
    }
    GivenMesh separated = mesh;
    std::vector<int> given_node = separate_touching_bodies(separated);
    if (given_node.size() == mesh.nodes.size()) {
        std::rethrow_exception(refusal);
    }
    MatchedMesh matched = match(session, separated, order);
    matched.given_node = std::move(given_node);
    mesh = std::move(separated);
    return matched;
}

}  // namespace mq::given
