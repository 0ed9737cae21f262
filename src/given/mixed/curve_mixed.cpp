// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/curve_mixed.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "elements/product/reference_nodes.h"
#include "given/mixed/cad_nodes.h"
#include "given/mixed/layers.h"
#include "given/mixed/mixed_proof.h"
#include "given/mixed/node_relaxation.h"
#include "given/mixed/transfinite_blending.h"
#include "given/mixed/unhelpful_moves.h"

namespace mq::given {

using curve::CurveOptions;
using elements::ElementKind;
using elements::sides_of;

namespace {

/// Layers of elements around invalid ones that are relaxed with them, in successive attempts.
constexpr std::array<int, 3> kRelaxedLayers{1, 2, 3};

std::size_t at(std::int64_t i) {
    return static_cast<std::size_t>(i);
}

/// The corners of a mesh edge, ascending.
using Edge = std::array<std::int32_t, 2>;

class MixedCurving {
  public:
    MixedCurving(geometry::Session& session, const MixedMesh& given, const CurveOptions& options, Progress& progress)
        : session_(session),
          given_(given),
          options_(options),
          progress_(progress),
          clock_(report_.seconds),
          found_(match_faces_of(session, given, options.order)),
          mesh_(on_cad()),
          table_(options.order, mesh_.nodes),
          cad_(session, found_, table_) {
        for (const MixedElement& element : mesh_.elements) {
            elements_.push_back({element.kind, table_.nodes_of(element.kind, element.corners.data())});
        }
        for (const CadFace& face : found_.faces) {
            of_faces_.push_back(table_.nodes_of(face.kind, face.corners.data()));
        }
        clock_.end("classifying");
    }

    CurvedMixedMesh run() {
        progress_.stage("curving the surface", 0.2, 0.6);
        nodes_ = table_.straight();
        cad_.place(nodes_);
        fix_nodes();
        clock_.end("curving the surface");
        if (given_.has_volume()) {
            curve_inside();
            clock_.end("curving the layers");
            progress_.stage("repairing the volume", 0.6, 0.9);
            relax();
            clock_.end("repairing the volume");
        } else {
            prove_all();
            report_.invalid_before = invalid().size();
            report_.repairs.emplace_back("edges on faces that follow CAD edges", cad_.follow_edges(nodes_));
            prove_all();
        }
        if (options_.straighten) {
            straighten();
        }
        progress_.stage("measuring", 0.9, 1.0);
        CurvedMixedMesh result = assembled();
        clock_.end("measuring");
        result.report = std::move(report_);
        return result;
    }

  private:
    /// The given mesh with its vertices on the CAD.
    MixedMesh on_cad() const {
        MixedMesh mesh = given_;
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            if (const int v = found_.matched.vertex_of_node[n]; v >= 0) {
                mesh.nodes[n] = found_.matched.surface.shapes.vertices[at(v)].point;
            }
        }
        return mesh;
    }

    void fix_nodes() {
        fixed_.assign(nodes_.size(), 0);
        std::fill(fixed_.begin(), fixed_.begin() + static_cast<std::ptrdiff_t>(table_.vertices()), 1);
        for (const auto& of_face : of_faces_) {
            for (const std::int32_t n : of_face) {
                fixed_[at(n)] = 1;
            }
        }
    }

    /// The quadrilaterals that are not on the CAD.
    std::vector<RowQuadrilateral> inner_quadrilaterals() const {
        std::map<std::vector<std::int32_t>, RowQuadrilateral> all;
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
            for (std::size_t f = 0; f < sides_of(mesh_.elements[e].kind).faces.size(); ++f) {
                const std::vector<std::int32_t> c = face_corners(mesh_.elements[e], f);
                if (c.size() != 4 || cad_.has(c)) {
                    continue;
                }
                std::vector<std::int32_t> key = c;
                std::sort(key.begin(), key.end());
                const auto [found, fresh] = all.try_emplace(
                    key, RowQuadrilateral{{c[0], c[1], c[2], c[3]}, {static_cast<std::int64_t>(e), -1}});
                if (!fresh) {
                    found->second.elements[1] = static_cast<std::int64_t>(e);
                }
            }
        }
        std::vector<RowQuadrilateral> result;
        for (const auto& [key, quadrilateral] : all) {
            result.push_back(quadrilateral);
        }
        return result;
    }

    std::vector<Vec3> displacement() const {
        std::vector<Vec3> result = nodes_;
        for (std::size_t n = 0; n < result.size(); ++n) {
            result[n] -= table_.straight()[n];
        }
        return result;
    }

    /// Sets the nodes inside of faces and elements that are not on the CAD, except those given in `own`, by blending
    /// from their boundaries.
    /// @param own  by node: its deviation from the blend of the face's edges
    void blend(const std::map<std::int32_t, Vec3>& own) {
        std::vector<Vec3> by = displacement();
        const auto fill = [&](ElementKind kind, const std::vector<std::int32_t>& numbers) {
            const Blending& blending = Blending::of(kind, options_.order);
            if (blending.inner.empty()) {
                return;
            }
            std::vector<Vec3> values;
            for (const std::int32_t n : numbers) {
                values.push_back(by[at(n)]);
            }
            blending.apply(values);
            for (const int i : blending.inner) {
                const std::int32_t n = numbers[at(i)];
                if (!fixed_[at(n)]) {
                    const auto more = own.find(n);
                    by[at(n)] = more == own.end() ? values[at(i)] : Vec3(values[at(i)] + more->second);
                }
            }
        };
        for (const MixedElement& element : mesh_.elements) {
            for (std::size_t f = 0; f < sides_of(element.kind).faces.size(); ++f) {
                const std::vector<std::int32_t> corners = face_corners(element, f);
                const ElementKind kind = corners.size() == 3 ? ElementKind::Triangle : ElementKind::Quadrilateral;
                fill(kind, table_.nodes_of(kind, corners.data()));
            }
        }
        for (const ElementNodes& element : elements_) {
            fill(element.kind, element.nodes);
        }
        for (std::size_t n = 0; n < by.size(); ++n) {
            if (!fixed_[n]) {
                nodes_[n] = table_.straight()[n] + by[n];
            }
        }
    }

    void curve_inside() {
        blend({});
        prove_all();
        report_.invalid_before = invalid().size();
        report_.repairs.emplace_back("edges on faces that follow CAD edges", cad_.follow_edges(nodes_));
        const auto on_cad = [&](const std::vector<std::int32_t>& side) { return cad_.has(side); };
        const std::vector<Vec3> of_surface = displacement();
        Layers edges(table_, of_surface);
        std::size_t rows = 0;
        for (const SideRow& row : rows_of_edges(inner_quadrilaterals(), mesh_.nodes, on_cad)) {
            edges.add_edges(row);
            ++rows;
        }
        for (const auto& [n, by] : edges.result()) {
            nodes_[at(n)] = table_.straight()[at(n)] + by;
        }
        std::map<std::int32_t, Vec3> own;
        Layers faces(table_, of_surface);
        for (const SideRow& row : rows_of_faces(mesh_, on_cad)) {
            faces.add_faces(row);
            ++rows;
        }
        for (const auto& [n, by] : faces.result()) {
            own.emplace(n, by);
        }
        blend(own);
        prove_all();
        report_.repairs.emplace_back("rows of edges and faces that follow the CAD", rows);
    }

    void prove_all() {
        std::vector<std::size_t> all(elements_.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        quality_.assign(elements_.size(), 0.0);
        prove_mixed(elements_, options_.order, nodes_, all, quality_, progress_);
    }

    std::vector<std::size_t> invalid() const {
        std::vector<std::size_t> result;
        for (std::size_t e = 0; e < quality_.size(); ++e) {
            if (!(quality_[e] > 0.0)) {
                result.push_back(e);
            }
        }
        return result;
    }

    /// Relaxes invalid elements. An attempt is kept if fewer elements are invalid after it.
    void relax() {
        std::size_t patches = 0;
        for (const int layers : kRelaxedLayers) {
            const std::vector<std::size_t> bad = invalid();
            if (bad.empty() || options_.order < 2 || !options_.repair) {
                break;
            }
            const std::vector<Vec3> nodes = nodes_;
            const std::vector<double> quality = quality_;
            const std::size_t done =
                relax_nodes(elements_, options_.order, table_.straight(), fixed_, bad, layers, nodes_, progress_);
            prove_all();
            if (invalid().size() < bad.size()) {
                patches += done;
            } else {
                nodes_ = nodes;
                quality_ = quality;
                if (layers > 1) {
                    break;  // more elements around do not help: the fault lies in the corners
                }
            }
        }
        report_.repairs.emplace_back("patches of elements relaxed", patches);
    }

    /// By edge the edges that bend together with it: those of the thinnest row that contains the edge.
    std::map<Edge, std::vector<Edge>> columns() {
        const auto on_cad = [&](const std::vector<std::int32_t>& side) { return cad_.has(side); };
        std::vector<SideRow> rows = rows_of_edges(inner_quadrilaterals(), mesh_.nodes, on_cad);
        std::vector<SideRow> more = cad_.rows();
        std::move(more.begin(), more.end(), std::back_inserter(rows));
        std::stable_sort(rows.begin(), rows.end(),
                         [](const SideRow& a, const SideRow& b) { return a.height < b.height; });
        std::map<Edge, std::vector<Edge>> result;
        for (const SideRow& row : rows) {
            std::vector<Edge> edges;
            for (const auto& side : row.sides) {
                const Edge edge{std::min(side[0], side[1]), std::max(side[0], side[1])};
                if (result.count(edge) == 0) {
                    edges.push_back(edge);
                }
            }
            for (const Edge& edge : edges) {
                result[edge] = edges;
            }
        }
        return result;
    }

    std::set<Edge> edges_of(std::size_t e) const {
        std::set<Edge> result;
        for (const auto& [a, b] : sides_of(elements_[e].kind).edges) {
            const std::int32_t from = mesh_.elements[e].corners[a];
            const std::int32_t to = mesh_.elements[e].corners[b];
            result.insert({std::min(from, to), std::max(from, to)});
        }
        return result;
    }

    /// Invalid elements whose straight element is valid.
    std::vector<std::size_t> curable() const {
        std::vector<std::size_t> result = invalid();
        const auto hopeless = [&](std::size_t e) { return !(straight_quality_[e] > 0.0); };
        result.erase(std::remove_if(result.begin(), result.end(), hopeless), result.end());
        return result;
    }

    bool has_any(std::size_t e, const std::set<Edge>& edges) const {
        const std::set<Edge> own = edges_of(e);
        return std::any_of(own.begin(), own.end(), [&](const Edge& edge) { return edges.count(edge) > 0; });
    }

    /// Bends the edges of invalid elements less and less, together with all edges of their columns, until they are
    /// straight.
    void soften() {
        constexpr int kRounds = 8;
        constexpr int kHalvings = 4;
        const std::map<Edge, std::vector<Edge>> together = columns();
        for (int round = 0; round < kRounds && !curable().empty(); ++round) {
            std::set<Edge> now;
            for (const std::size_t e : curable()) {
                for (const Edge& edge : edges_of(e)) {
                    const auto column = together.find(edge);
                    now.insert(edge);
                    if (column != together.end()) {
                        now.insert(column->second.begin(), column->second.end());
                    }
                }
            }
            const double share = round < kHalvings ? 0.5 : 0.0;
            for (const auto& [a, b] : now) {
                for (const std::int32_t n : table_.edge(a, b)) {
                    const Vec3& straight = table_.straight()[at(n)];
                    nodes_[at(n)] = straight + share * (nodes_[at(n)] - straight);
                }
            }
            blend_at(now);
            prove_all();
        }
    }

    /// Blends again the nodes inside of all faces and elements that have one of these edges, also on the CAD.
    void blend_at(const std::set<Edge>& edges) {
        const auto fill = [&](ElementKind kind, const std::vector<std::int32_t>& numbers) {
            std::vector<Vec3> by;
            for (const std::int32_t n : numbers) {
                by.push_back(nodes_[at(n)] - table_.straight()[at(n)]);
            }
            const Blending& blending = Blending::of(kind, options_.order);
            blending.apply(by);
            for (const int i : blending.inner) {
                nodes_[at(numbers[at(i)])] = table_.straight()[at(numbers[at(i)])] + by[at(i)];
            }
        };
        for (std::size_t e = 0; e < elements_.size(); ++e) {
            if (!has_any(e, edges)) {
                continue;
            }
            for (std::size_t f = 0; f < sides_of(elements_[e].kind).faces.size(); ++f) {
                const std::vector<std::int32_t> c = face_corners(mesh_.elements[e], f);
                bool touched = false;
                for (std::size_t k = 0; k < c.size(); ++k) {
                    const std::int32_t next = c[(k + 1) % c.size()];
                    touched = touched || edges.count({std::min(c[k], next), std::max(c[k], next)}) > 0;
                }
                if (touched) {
                    const ElementKind kind = c.size() == 3 ? ElementKind::Triangle : ElementKind::Quadrilateral;
                    fill(kind, table_.nodes_of(kind, c.data()));
                }
            }
        }
        for (std::size_t e = 0; e < elements_.size() && given_.has_volume(); ++e) {
            if (has_any(e, edges)) {
                fill(elements_[e].kind, elements_[e].nodes);
            }
        }
    }

    /// Bends invalid elements less, together with their columns. Elements that stay invalid get straight sides, and so
    /// do neighbours that become invalid by it. Elements that are invalid when straight are left alone, and changes
    /// that do not help are undone.
    void straighten() {
        const std::vector<Vec3> before = nodes_;
        const std::vector<double> quality_before = quality_;
        if (!invalid().empty()) {
            straight_quality_.assign(elements_.size(), 1.0);
            prove_mixed(elements_, options_.order, table_.straight(), invalid(), straight_quality_, progress_);
        }
        soften();
        std::set<std::size_t> straight;
        for (bool more = true; more;) {
            more = false;
            for (const std::size_t e : curable()) {
                if (straight.insert(e).second) {
                    more = true;
                    for (const std::int32_t n : elements_[e].nodes) {
                        nodes_[at(n)] = table_.straight()[at(n)];
                    }
                }
            }
            if (more) {
                prove_all();
            }
        }
        const std::set<std::size_t> straightened =
            revert_unhelpful_moves(elements_, before, quality_before, quality_, nodes_);
        if (nodes_ != before || quality_ != quality_before) {
            prove_all();
            cad_.read_from(nodes_);
        }
        for (const std::size_t e : straightened) {
            report_.straightened.push_back(name_of_element(e));
        }
        report_.repairs.emplace_back("elements made straight or straighter", straightened.size());
    }

    /// "prism 3 of Solid1": 3 is the index in the list of prisms.
    std::string name_of_element(std::size_t e) const {
        const auto before = std::count_if(elements_.begin(), elements_.begin() + static_cast<std::ptrdiff_t>(e),
                                          [&](const ElementNodes& other) { return other.kind == elements_[e].kind; });
        const std::string name = std::string(elements::name_of(elements_[e].kind)) + " " + std::to_string(before);
        if (!given_.has_volume()) {
            return name + " on " + session_.topology().name_of({2, found_.faces[e].face});
        }
        return found_.volume[e] < 0 ? name : name + " of Solid" + std::to_string(found_.volume[e] + 1);
    }

    int entity_of_face(const CadFace& face) const { return session_.topology().of_shape({2, face.face}).index; }

    void add_blocks(CurvedMixedMesh& mesh) {
        std::map<ElementKind, ElementBlock> solids;
        for (std::size_t e = 0; e < elements_.size() && given_.has_volume(); ++e) {
            ElementBlock& block = solids[elements_[e].kind];
            block.kind = elements_[e].kind;
            block.nodes.insert(block.nodes.end(), elements_[e].nodes.begin(), elements_[e].nodes.end());
            block.entity.push_back(found_.volume[e]);
            block.quality.push_back(quality_[e]);
            block.given.push_back(static_cast<std::int32_t>(e));
        }
        std::map<ElementKind, ElementBlock> flat;
        std::vector<ElementNodes> of_faces;
        std::vector<std::size_t> all;
        for (std::size_t f = 0; f < found_.faces.size(); ++f) {
            of_faces.push_back({found_.faces[f].kind, of_faces_[f]});
            all.push_back(f);
        }
        std::vector<double> bounds(of_faces.size(), 0.0);
        prove_mixed(of_faces, options_.order, nodes_, all, bounds, progress_);
        for (std::size_t f = 0; f < found_.faces.size(); ++f) {
            ElementBlock& block = flat[found_.faces[f].kind];
            block.kind = found_.faces[f].kind;
            block.nodes.insert(block.nodes.end(), of_faces_[f].begin(), of_faces_[f].end());
            block.entity.push_back(entity_of_face(found_.faces[f]));
            block.quality.push_back(bounds[f]);
            block.given.push_back(given_.has_volume() ? -1 : static_cast<std::int32_t>(found_.faces[f].element));
        }
        for (auto* blocks : {&solids, &flat}) {
            for (auto& [kind, block] : *blocks) {
                mesh.blocks.push_back(std::move(block));
            }
        }
    }

    void add_edges(CurvedMixedMesh& mesh) {
        std::set<std::array<std::int32_t, 2>> met;
        const curve::CurvedSurface& surface = found_.matched.surface;
        for (const CadFace& face : found_.faces) {
            for (std::size_t k = 0; k < face.corners.size(); ++k) {
                const std::int32_t a = std::min(face.corners[k], face.corners[(k + 1) % face.corners.size()]);
                const std::int32_t b = std::max(face.corners[k], face.corners[(k + 1) % face.corners.size()]);
                const curve::Segment* segment =
                    surface.segment(found_.matched.vertex_of_node[at(a)], found_.matched.vertex_of_node[at(b)]);
                const int entity = segment == nullptr ? -1 : session_.topology().of_shape({1, segment->edge}).index;
                if (entity >= 0 && met.insert({a, b}).second) {
                    const std::vector<std::int32_t> nodes = table_.edge(a, b);
                    mesh.edges.push_back(nodes.front());
                    mesh.edges.push_back(nodes.back());
                    mesh.edges.insert(mesh.edges.end(), nodes.begin() + 1, nodes.end() - 1);
                    mesh.edge_entity.push_back(entity);
                }
            }
        }
    }

    /// Removes nodes that no element has, and numbers the others.
    void number_nodes(CurvedMixedMesh& mesh) {
        std::vector<std::int32_t> number(nodes_.size(), -1);
        for (const ElementBlock& block : mesh.blocks) {
            for (const std::int32_t n : block.nodes) {
                number[at(n)] = 0;
            }
        }
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            if (number[n] < 0) {
                continue;
            }
            number[n] = static_cast<std::int32_t>(mesh.nodes.size());
            mesh.nodes.push_back(nodes_[n]);
            if (n < table_.vertices()) {
                mesh.given_node.push_back(static_cast<std::int32_t>(n));
                if (nodes_[n] != given_.nodes[n]) {
                    mesh.moved_nodes.push_back(static_cast<std::int32_t>(n));
                }
            }
        }
        for (ElementBlock& block : mesh.blocks) {
            for (std::int32_t& n : block.nodes) {
                n = number[at(n)];
            }
        }
        for (std::int32_t& n : mesh.edges) {
            n = number[at(n)];
        }
    }

    CurvedMixedMesh assembled() {
        CurvedMixedMesh mesh;
        mesh.order = options_.order;
        add_blocks(mesh);
        add_edges(mesh);
        number_nodes(mesh);
        measure(mesh);
        return mesh;
    }

    void measure(const CurvedMixedMesh& mesh) {
        report_.elements = elements_.size();
        report_.vertices = mesh.given_node.size();
        report_.moved_vertices = mesh.moved_nodes.size();
        report_.min_distortion = 1.0;
        double sum = 0.0;
        for (const double quality : quality_) {
            report_.min_distortion = std::min(report_.min_distortion, quality);
            sum += quality;
        }
        report_.min_scaled_jacobian = report_.min_distortion;
        report_.mean_distortion = sum / static_cast<double>(quality_.size());
        for (const std::size_t e : invalid()) {
            report_.invalid_elements.push_back(name_of_element(e));
        }
        const std::vector<double> of_triangles = cad_.triangle_qualities();
        for (std::size_t f = 0; f < of_triangles.size(); ++f) {
            if (!(of_triangles[f] > 0.0) && (given_.has_volume() || quality_[f] > 0.0)) {
                report_.invalid_elements.push_back("triangle at the surface on " +
                                                   session_.topology().name_of({2, found_.faces[f].face}));
            }
        }
        report_.invalid = report_.invalid_elements.size();
        double squares = 0.0;
        const std::vector<double> distances = cad_.deviations(nodes_);
        for (const double d : distances) {
            report_.max_deviation = std::max(report_.max_deviation, d);
            squares += d * d;
        }
        report_.rms_deviation = distances.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(distances.size()));
        if (given_.has_volume()) {
            report_.volume = volume_of(elements_, options_.order, nodes_);
        }
        const auto lost = std::count(found_.volume.begin(), found_.volume.end(), -1);
        if (given_.has_volume() && lost > 0) {
            report_.notes.push_back({phrases::kElementsWithoutOutside, {{"count", lost}}});
        }
    }

    geometry::Session& session_;
    const MixedMesh& given_;
    const CurveOptions& options_;
    Progress& progress_;
    curve::CurveReport report_;
    StageTimer clock_;
    MatchedFaces found_;
    MixedMesh mesh_;
    NodeTable table_;
    CadNodes cad_;
    std::vector<ElementNodes> elements_;
    std::vector<std::vector<std::int32_t>> of_faces_;
    std::vector<Vec3> nodes_;
    std::vector<char> fixed_;
    std::vector<double> quality_;
    std::vector<double> straight_quality_;  // by element that was invalid
};

}  // namespace

CurvedMixedMesh curve_mixed(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                            const MixedMesh& given, const CurveOptions& options, Progress* progress) {
    require_sound(given);
    CurveOptions checked = options;
    checked.volume = given.has_volume();
    checked.validate();
    Progress unwatched;
    Progress& watched = progress != nullptr ? *progress : unwatched;
    const double start = cpu_seconds();
    geometry::Session session(engine, model, &watched);
    watched.stage("classifying", 0.0, 0.2);
    MixedMesh oriented = given;
    const std::size_t turned = orient_elements(oriented);
    CurvedMixedMesh mesh = MixedCurving(session, oriented, checked, watched).run();
    if (turned > 0) {
        mesh.report.notes.push_back({phrases::kElementsTurned, {{"count", turned}}});
    }
    mesh.report.cpu_seconds = cpu_seconds() - start;
    return mesh;
}

}  // namespace mq::given
