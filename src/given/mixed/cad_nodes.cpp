// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/cad_nodes.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/measuring.h"
#include "elements/product/reference_nodes.h"
#include "given/mixed/layers.h"
#include "given/mixed/transfinite_blending.h"

namespace mq::given {

using elements::ElementKind;
using elements::FaceKey;
using elements::Lattice;

namespace {

using geometry::Query;

/// Displacements below this fraction of the model's size count as rounding.
constexpr double kNoDisplacement = 1e-9;

std::size_t at(std::int64_t i) {
    return static_cast<std::size_t>(i);
}

/// Values of the Lagrange polynomials of equally spaced nodes on [0, 1].
std::vector<double> lagrange(int order, double t) {
    std::vector<double> values(at(order + 1), 1.0);
    for (int i = 0; i <= order; ++i) {
        for (int j = 0; j <= order; ++j) {
            values[at(i)] *= i == j ? 1.0 : (order * t - j) / (i - j);
        }
    }
    return values;
}

/// Weights of points between all nodes of a quadrilateral, one in each cell of its grid: (points, nodes).
Eigen::MatrixXd between_nodes(int order) {
    const std::vector<elements::GridPoint> grid = elements::gmsh_nodes(ElementKind::Quadrilateral, order);
    const int cells = order + 1;
    Eigen::MatrixXd weights(cells * cells, static_cast<Eigen::Index>(grid.size()));
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            const std::vector<double> u = lagrange(order, (i + 0.5) / cells);
            const std::vector<double> v = lagrange(order, (j + 0.5) / cells);
            for (std::size_t k = 0; k < grid.size(); ++k) {
                weights(i * cells + j, static_cast<Eigen::Index>(k)) = u[at(grid[k][0])] * v[at(grid[k][1])];
            }
        }
    }
    return weights;
}

/// The triangles of the matched surface, by the nodes of the mesh that are their corners.
std::map<FaceKey, int> triangles_by_nodes(const MatchedMesh& matched) {
    std::vector<int> node_of_vertex(matched.surface.shapes.vertices.size(), -1);
    for (std::size_t n = 0; n < matched.vertex_of_node.size(); ++n) {
        if (matched.vertex_of_node[n] >= 0) {
            node_of_vertex[at(matched.vertex_of_node[n])] = static_cast<int>(n);
        }
    }
    std::map<FaceKey, int> result;
    for (std::size_t t = 0; t < matched.surface.triangles.size(); ++t) {
        const auto& v = matched.surface.triangles[t].corners;
        result.emplace(elements::face_key(node_of_vertex[at(v[0])], node_of_vertex[at(v[1])], node_of_vertex[at(v[2])]),
                       static_cast<int>(t));
    }
    return result;
}

GeometryError on_two_faces(const MixedMesh& mesh, const std::vector<std::int32_t>& corners,
                           const geometry::Topology& topology, int a, int b) {
    Vec3 middle = Vec3::Zero();
    for (const std::int32_t v : corners) {
        middle += 0.25 * mesh.nodes[at(v)];
    }
    return {phrases::kGivenOnTwoFaces,
            {{"point", in_mm(middle)}, {"name", topology.name_of({2, a})}, {"name2", topology.name_of({2, b})}}};
}

}  // namespace

MatchedFaces match_faces_of(geometry::Session& session, const MixedMesh& mesh, int order) {
    Simplices simplices = divided_into_simplices(mesh);
    orient_tetrahedra(simplices.mesh);
    MatchedFaces result{match(session, simplices.mesh, order), {}, std::vector<int>(mesh.elements.size(), -1)};
    for (std::size_t t = 0; t < result.matched.volume.size(); ++t) {
        result.volume[simplices.element[t]] = result.matched.volume[t];
    }
    const std::map<FaceKey, int> triangles = triangles_by_nodes(result.matched);
    std::set<std::vector<std::int32_t>> met;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        for (std::size_t f = 0; f < elements::sides_of(mesh.elements[e].kind).faces.size(); ++f) {
            CadFace face;
            face.corners = face_corners(mesh.elements[e], f);
            face.kind = face.corners.size() == 3 ? ElementKind::Triangle : ElementKind::Quadrilateral;
            face.element = static_cast<std::int64_t>(e);
            for (const auto& t : triangles_of(face.corners)) {
                const auto found = triangles.find(elements::face_key(t[0], t[1], t[2]));
                if (found != triangles.end()) {
                    face.triangles.push_back(found->second);
                }
            }
            std::vector<std::int32_t> key = face.corners;
            std::sort(key.begin(), key.end());
            if (face.triangles.size() + 2 != face.corners.size() || !met.insert(key).second) {
                continue;
            }
            face.face = result.matched.surface.triangles[at(face.triangles.front())].face;
            const int other = result.matched.surface.triangles[at(face.triangles.back())].face;
            if (other != face.face) {
                throw on_two_faces(mesh, face.corners, session.topology(), face.face, other);
            }
            result.faces.push_back(std::move(face));
        }
    }
    if (!mesh.has_volume() && result.faces.size() != mesh.elements.size()) {
        throw InvalidInput(phrases::kGivenSameCorners, {{"count", mesh.elements.size() - result.faces.size()}});
    }
    return result;
}

std::vector<std::int32_t> CadNodes::sorted(std::vector<std::int32_t> corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
}

CadNodes::CadNodes(geometry::Session& session, MatchedFaces& found, NodeTable& table)
    : session_(session), found_(found), table_(table), placement_(session, found.matched.surface) {
    for (const CadFace& face : found_.faces) {
        sides_.insert(sorted(face.corners));
        for (std::size_t k = 0; k < face.corners.size(); ++k) {
            const std::vector<std::int32_t> edge =
                sorted({face.corners[k], face.corners[(k + 1) % face.corners.size()]});
            sides_.insert(edge);
            edges_.insert({edge[0], edge[1]});
        }
    }
}

bool CadNodes::on_cad_edge(std::int32_t a, std::int32_t b) const {
    return found_.matched.surface.segment(vertex(a), vertex(b)) != nullptr;
}

void CadNodes::place(std::vector<Vec3>& nodes) {
    placement_.place(curve::live_triangles(found_.matched.surface));
    write_edges_to(nodes);
    write_triangles_to(nodes);
    place_quadrilaterals(nodes);
}

void CadNodes::write_edges_to(std::vector<Vec3>& nodes) {
    const Lattice& line = Lattice::of(1, table_.order());
    for (const auto& [a, b] : edges_) {
        const std::vector<std::int32_t> numbers = table_.edge(a, b);
        const std::vector<Vec3> inner = found_.matched.surface.shapes.edge_inner(vertex(a), vertex(b));
        std::vector<Vec3> control{nodes[at(numbers.front())]};
        control.insert(control.end(), inner.begin(), inner.end());
        control.push_back(nodes[at(numbers.back())]);
        const std::vector<Vec3> places = elements::bezier_to_nodes(line, control);
        for (std::size_t i = 1; i < inner.size() + 1; ++i) {
            nodes[at(numbers[i])] = places[i];
        }
    }
}

void CadNodes::put_edge(std::int32_t a, std::int32_t b, const std::vector<Vec3>& nodes) {
    std::vector<Vec3> places;
    for (const std::int32_t n : table_.edge(a, b)) {
        places.push_back(nodes[at(n)]);
    }
    const std::vector<Vec3> control = elements::nodes_to_bezier(Lattice::of(1, table_.order()), places);
    found_.matched.surface.shapes.set_edge(vertex(a), vertex(b), {control.begin() + 1, control.end() - 1});
}

void CadNodes::write_triangles_to(std::vector<Vec3>& nodes) {
    const Lattice& lattice = Lattice::of(2, table_.order());
    const Blending& blending = Blending::of(ElementKind::Triangle, table_.order());
    std::vector<Vec3> control;
    for (const CadFace& face : found_.faces) {
        if (face.kind != ElementKind::Triangle) {
            continue;
        }
        found_.matched.surface.shapes.triangle(
            {vertex(face.corners[0]), vertex(face.corners[1]), vertex(face.corners[2])}, control);
        const std::vector<Vec3> places = elements::bezier_to_gmsh(lattice, control);
        const std::vector<std::int32_t> numbers = table_.nodes_of(face.kind, face.corners.data());
        for (const int i : blending.inner) {
            nodes[at(numbers[at(i)])] = places[at(i)];
        }
    }
}

void CadNodes::read_from(const std::vector<Vec3>& nodes) {
    const Lattice& lattice = Lattice::of(2, table_.order());
    for (const auto& [a, b] : edges_) {
        put_edge(a, b, nodes);
    }
    std::vector<int> triangles;
    std::vector<Vec3> places(at(lattice.size()));
    for (const CadFace& face : found_.faces) {
        if (face.kind != ElementKind::Triangle) {
            continue;
        }
        const std::vector<std::int32_t> numbers = table_.nodes_of(face.kind, face.corners.data());
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            places[i] = nodes[at(numbers[i])];
        }
        found_.matched.surface.shapes.set_inside(
            {vertex(face.corners[0]), vertex(face.corners[1]), vertex(face.corners[2])},
            elements::gmsh_to_bezier(lattice, places));
        triangles.push_back(face.triangles.front());
    }
    placement_.measure(triangles);
}

std::vector<Vec3> CadNodes::projected(int face, const std::vector<Vec3>& points) {
    if (placement_.planar(face)) {
        return points;
    }
    geometry::Engine::Batch batch;
    for (const Vec3& point : points) {
        batch.push_back(Query::face_nearest_global(face, point));
    }
    std::vector<Vec3> result = points;
    const auto answers = session_.ask(std::move(batch));
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (answers[i].found()) {
            result[i] = answers[i].point;
        }
    }
    return result;
}

void CadNodes::place_quadrilaterals(std::vector<Vec3>& nodes) {
    const Blending& blending = Blending::of(ElementKind::Quadrilateral, table_.order());
    std::map<int, std::pair<std::vector<std::int32_t>, std::vector<Vec3>>> of_face;
    for (const CadFace& face : found_.faces) {
        if (face.kind != ElementKind::Quadrilateral) {
            continue;
        }
        const std::vector<std::int32_t> numbers = table_.nodes_of(face.kind, face.corners.data());
        std::vector<Vec3> own;
        for (const std::int32_t n : numbers) {
            own.push_back(nodes[at(n)]);
        }
        blending.apply(own);
        for (const int i : blending.inner) {
            of_face[face.face].first.push_back(numbers[at(i)]);
            of_face[face.face].second.push_back(own[at(i)]);
        }
    }
    for (const auto& [face, placed] : of_face) {
        const std::vector<Vec3> points = projected(face, placed.second);
        for (std::size_t i = 0; i < points.size(); ++i) {
            nodes[at(placed.first[i])] = points[i];
        }
    }
}

std::set<int> CadNodes::faces_with_quadrilaterals() const {
    std::set<int> faces;
    for (const CadFace& face : found_.faces) {
        if (face.kind == ElementKind::Quadrilateral) {
            faces.insert(face.face);
        }
    }
    return faces;
}

std::vector<SideRow> CadNodes::rows() const {
    std::vector<SideRow> all;
    for (const int face : faces_with_quadrilaterals()) {
        std::vector<SideRow> of_face = rows_on(face);
        std::move(of_face.begin(), of_face.end(), std::back_inserter(all));
    }
    return all;
}

std::vector<SideRow> CadNodes::rows_on(int face) const {
    std::vector<RowQuadrilateral> quadrilaterals;
    for (const CadFace& f : found_.faces) {
        if (f.face == face && f.kind == ElementKind::Quadrilateral) {
            quadrilaterals.push_back({{f.corners[0], f.corners[1], f.corners[2], f.corners[3]}, {-1, -1}});
        }
    }
    return rows_of_edges(quadrilaterals, table_.straight(),
                         [&](const std::vector<std::int32_t>& side) { return on_cad_edge(side[0], side[1]); });
}

std::size_t CadNodes::follow_edges(std::vector<Vec3>& nodes) {
    std::size_t changed = 0;
    bool any = false;
    for (const int face : faces_with_quadrilaterals()) {
        any = follow_edges_of(face, nodes, changed) || any;
    }
    if (any) {
        placement_.place(curve::live_triangles(found_.matched.surface));
        write_triangles_to(nodes);
        place_quadrilaterals(nodes);
    }
    return changed;
}

bool CadNodes::bends_much(const SideRow& row, const std::vector<Vec3>& displacement) {
    constexpr double kNotable = 0.05;
    double most = 0.0;
    for (const auto* side : {&row.sides.front(), &row.sides.back()}) {
        for (const std::int32_t n : table_.edge((*side)[0], (*side)[1])) {
            most = std::max(most, displacement[at(n)].norm());
        }
    }
    const std::size_t before_last = row.fractions.size() - 2;
    const double first = 0.5 * (row.fractions[1][0] + row.fractions[1][1]);
    const double last = 1.0 - 0.5 * (row.fractions[before_last][0] + row.fractions[before_last][1]);
    return most > kNotable * row.height * std::min(first, last);
}

std::vector<Vec3> CadNodes::displacement_of_ends(int face, const std::vector<SideRow>& rows,
                                                 const std::vector<Vec3>& nodes) {
    std::vector<std::int32_t> numbers;
    std::vector<Vec3> chords;
    for (const SideRow& row : rows) {
        for (const auto* side : {&row.sides.front(), &row.sides.back()}) {
            for (const std::int32_t n : table_.edge((*side)[0], (*side)[1])) {
                if (on_cad_edge((*side)[0], (*side)[1]) && at(n) >= table_.vertices()) {
                    numbers.push_back(n);
                    chords.push_back(table_.straight()[at(n)]);
                }
            }
        }
    }
    const std::vector<Vec3> by_itself = projected(face, chords);
    std::vector<Vec3> displacement(nodes.size(), Vec3::Zero());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        displacement[at(numbers[i])] = nodes[at(numbers[i])] - by_itself[i];
    }
    return displacement;
}

bool CadNodes::follow_edges_of(int face, std::vector<Vec3>& nodes, std::size_t& changed) {
    std::vector<SideRow> rows = rows_on(face);
    const std::vector<Vec3> displacement = displacement_of_ends(face, rows, nodes);
    // The nodes of bent faces are spaced evenly already, which is better than displacing rows if layers are thick.
    if (!placement_.planar(face)) {
        rows.erase(std::remove_if(rows.begin(), rows.end(),
                                  [&](const SideRow& row) { return !bends_much(row, displacement); }),
                   rows.end());
    }
    Layers layers(table_, displacement);
    for (const SideRow& row : rows) {
        layers.add_edges(row);
    }
    std::vector<std::int32_t> numbers;
    std::vector<Vec3> chords;
    std::vector<Vec3> by;
    const double rounding = kNoDisplacement * session_.topology().box.largest_side();
    for (const auto& [node, of_node] : layers.result()) {
        if (of_node.norm() > rounding) {
            numbers.push_back(node);
            chords.push_back(table_.straight()[at(node)]);
            by.push_back(of_node);
        }
    }
    std::vector<Vec3> moved = projected(face, chords);
    for (std::size_t i = 0; i < moved.size(); ++i) {
        moved[i] += by[i];
    }
    moved = projected(face, moved);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        nodes[at(numbers[i])] = moved[i];
    }
    for (const auto& [a, b] : edges_) {
        const std::vector<std::int32_t> of_edge = table_.edge(a, b);
        const bool touched = std::any_of(of_edge.begin(), of_edge.end(), [&](std::int32_t n) {
            return std::binary_search(numbers.begin(), numbers.end(), n);
        });
        if (touched) {
            put_edge(a, b, nodes);
            ++changed;
        }
    }
    return !numbers.empty();
}

std::vector<double> CadNodes::deviations(const std::vector<Vec3>& nodes) {
    std::vector<double> result(found_.faces.size(), 0.0);
    std::vector<int> triangles;
    std::vector<std::size_t> owners;
    const Eigen::MatrixXd weights = between_nodes(table_.order());
    std::vector<geometry::TrimmedFaceDistances::Place> places;
    std::vector<std::size_t> asked;
    for (std::size_t f = 0; f < found_.faces.size(); ++f) {
        const CadFace& face = found_.faces[f];
        if (face.kind == ElementKind::Triangle) {
            triangles.push_back(face.triangles.front());
            owners.push_back(f);
            continue;
        }
        const std::vector<std::int32_t> numbers = table_.nodes_of(face.kind, face.corners.data());
        for (Eigen::Index i = 0; i < weights.rows(); ++i) {
            Vec3 point = Vec3::Zero();
            for (std::size_t k = 0; k < numbers.size(); ++k) {
                point += weights(i, static_cast<Eigen::Index>(k)) * nodes[at(numbers[k])];
            }
            places.push_back({face.face, point});
            asked.push_back(f);
        }
    }
    const std::vector<double> distances = geometry::TrimmedFaceDistances(session_).measure(places);
    for (std::size_t i = 0; i < distances.size(); ++i) {
        result[asked[i]] = std::max(result[asked[i]], distances[i]);
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::vector<double> own = placement_.deviations({triangles[i]});
        result[owners[i]] = own.empty() ? 0.0 : *std::max_element(own.begin(), own.end());
    }
    return result;
}

std::vector<double> CadNodes::triangle_qualities() {
    std::vector<double> result;
    for (const CadFace& face : found_.faces) {
        const bool triangle = face.kind == ElementKind::Triangle;
        result.push_back(triangle ? found_.matched.surface.triangles[at(face.triangles.front())].quality : 1.0);
    }
    return result;
}

}  // namespace mq::given
