// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/knot_spans.h"
#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

namespace {

const char* surface_name(GeomAbs_SurfaceType type) {
    switch (type) {
        case GeomAbs_Plane:
            return "plane";
        case GeomAbs_Cylinder:
            return "cylinder";
        case GeomAbs_Cone:
            return "cone";
        case GeomAbs_Sphere:
            return "sphere";
        case GeomAbs_Torus:
            return "torus";
        case GeomAbs_BezierSurface:
            return "bezier";
        case GeomAbs_BSplineSurface:
            return "bspline";
        case GeomAbs_SurfaceOfRevolution:
            return "revolution";
        case GeomAbs_SurfaceOfExtrusion:
            return "extrusion";
        case GeomAbs_OffsetSurface:
            return "offset";
        case GeomAbs_OtherSurface:
            break;
    }
    return "other";
}

/// Records which volumes the sides of the faces bound.
class FaceSides {
  public:
    explicit FaceSides(std::size_t faces) : volumes_(2 * faces) {}

    void add(const std::vector<Volume::Side>& sides, int volume) {
        for (const Volume::Side& side : sides) {
            volumes_[index(side.face, side.flipped)].push_back(volume);
        }
    }
    bool has(const Volume::Side& side) const { return !volumes_[index(side.face, side.flipped)].empty(); }
    bool has_face(int face) const { return has(Volume::Side{face, false}) || has(Volume::Side{face, true}); }
    bool has_all(const std::vector<Volume::Side>& sides) const {
        return std::all_of(sides.begin(), sides.end(), [&](const Volume::Side& side) { return has(side); });
    }
    /// Whether one volume has all these faces, seen from either side.
    bool in_one_volume(const std::vector<Volume::Side>& sides) const {
        if (sides.empty()) {
            return true;
        }
        std::vector<int> candidates = volumes_of(sides.front().face);
        for (const Volume::Side& side : sides) {
            const std::vector<int> here = volumes_of(side.face);
            candidates.erase(
                std::remove_if(candidates.begin(), candidates.end(),
                               [&](int volume) { return std::find(here.begin(), here.end(), volume) == here.end(); }),
                candidates.end());
        }
        return !candidates.empty();
    }

  private:
    static std::size_t index(int face, bool flipped) { return 2 * static_cast<std::size_t>(face) + (flipped ? 1 : 0); }

    std::vector<int> volumes_of(int face) const {
        std::vector<int> result = volumes_[index(face, false)];
        const std::vector<int>& others = volumes_[index(face, true)];
        result.insert(result.end(), others.begin(), others.end());
        return result;
    }

    std::vector<std::vector<int>> volumes_;
};

/// The width (mm) below which a face has no area; smaller for very small shapes, whose edges may be that short.
double least_width(const std::vector<Node>& nodes) {
    // This width as a fraction of the size of very small shapes.
    constexpr double kPart = 1e-6;
    Box box;
    for (const Node& node : nodes) {
        box.add(node.point);
    }
    const double size = box.empty() ? 0.0 : box.largest_side();
    return size > 0.0 ? std::min(Precision::Confusion(), kPart * size) : Precision::Confusion();
}

/// Whether the surface is a line or a point within the tolerance, as at the sharp end of some wings.
bool has_no_area(const GeomAdaptor_Surface& surface, const Face& face, double least) {
    // Intervals along each parameter, at whose ends area and length are estimated.
    constexpr int kCells = 4;
    const double du = face.high[0] - face.low[0];
    const double dv = face.high[1] - face.low[1];
    double area = 0.0;
    double length = 0.0;
    for (int i = 0; i <= kCells; ++i) {
        for (int k = 0; k <= kCells; ++k) {
            // The samples avoid the border, where curves may have overshot the surface.
            const double a = 0.01 + 0.98 * i / kCells;
            const double b = 0.01 + 0.98 * k / kCells;
            gp_Pnt p;
            gp_Vec su;
            gp_Vec sv;
            surface.D1(face.low[0] + a * du, face.low[1] + b * dv, p, su, sv);
            area = std::max(area, su.Crossed(sv).Magnitude() * du * dv);
            length = std::max(length, std::max(su.Magnitude() * du, sv.Magnitude() * dv));
        }
    }
    return area <= least * length;
}

bool bounds_a_face(const TopoDS_Shape& edge) {
    return edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
}

/// The edges of a wire as they follow each other from the first one on, where only one of them starts at each vertex;
/// none elsewhere, and for long wires. OpenCASCADE's explorer, which also compares points in (u, v), gives the same
/// order.
std::vector<TopoDS_Edge> chained(const std::vector<TopoDS_Edge>& edges) {
    // Most edges among which the next edge is searched one by one.
    constexpr std::size_t kMostWireEdges = 24;
    std::vector<TopoDS_Vertex> starts(edges.size());
    std::vector<TopoDS_Vertex> ends(edges.size());
    if (edges.empty() || edges.size() > kMostWireEdges) {
        return {};
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
        TopExp::Vertices(edges[i], starts[i], ends[i], Standard_True);
        const auto same = [&](const TopoDS_Vertex& other) { return other.IsSame(starts[i]); };
        if (starts[i].IsNull() || ends[i].IsNull() || std::any_of(starts.begin(), starts.begin() + i, same)) {
            return {};
        }
    }
    std::vector<TopoDS_Edge> result;
    std::size_t at = 0;
    while (at < edges.size() && result.size() < edges.size()) {
        result.push_back(edges[at]);
        const TopoDS_Vertex end = ends[at];
        const auto next = std::find_if(starts.begin(), starts.end(), [&](const auto& v) { return v.IsSame(end); });
        at = static_cast<std::size_t>(next - starts.begin());
    }
    return at == 0 && result.size() == edges.size() ? result : std::vector<TopoDS_Edge>();
}

class TopologyBuilder {
  public:
    TopologyBuilder(const OrderedShape& ordered, ShapeMap& live, const Progress* progress)
        : ordered_(ordered),
          live_(live),
          progress_(progress),
          vertices_(ordered.vertices),
          edges_(ordered.edges),
          faces_(ordered.faces) {
        topology_.parts_of = ordered.parts_of;
    }

    Topology build() {
        add_nodes();
        least_width_ = least_width(topology_.nodes);
        add_edges();
        add_faces();
        add_volumes();
        for (std::size_t i = 0; i < topology_.edges.size(); ++i) {
            if (topology_.edges[i].uses.empty() && !ordered_.replaced.Contains(live_.edges[i])) {
                fault(Entity{1, static_cast<int>(i)}, "belongs to no face");
            }
        }
        return std::move(topology_);
    }

  private:
    void fault(Entity entity, const std::string& what) {
        topology_.faults.push_back(topology_.name_of(entity) + ": " + what);
    }
    void add_nodes();
    void add_edges();
    void set_range(int index, Edge& edge) const;
    void add_faces();
    void add_face(int index);
    void add_wire(int index, const TopoDS_Face& face, const TopoDS_Wire& wire);
    void add_loop(int index, const TopoDS_Face& face, const std::vector<TopoDS_Edge>& run);
    PCurve use_curve(int edge_index, int face_index, const TopoDS_Edge& edge, const TopoDS_Face& face);
    void add_volumes();
    std::vector<Volume::Side> sides_of(const TopoDS_Shape& part) const;
    void add_volume(const TopoDS_Shape& part, Volume::Kind kind, const std::vector<Volume::Side>& sides,
                    FaceSides& bounding);

    const OrderedShape& ordered_;
    ShapeMap& live_;
    const Progress* progress_;
    const TopTools_IndexedMapOfShape& vertices_;
    const TopTools_IndexedMapOfShape& edges_;
    const TopTools_IndexedMapOfShape& faces_;
    Topology topology_;
    double least_width_ = 0.0;
};

void TopologyBuilder::add_nodes() {
    for (int i = 1; i <= vertices_.Extent(); ++i) {
        const TopoDS_Vertex& vertex = TopoDS::Vertex(vertices_(i));
        live_.nodes.push_back(vertex);
        const Vec3 point = to_vec(BRep_Tool::Pnt(vertex));
        if (!point.allFinite()) {
            throw InvalidInput(phrases::kVertexNotFinite, {{"count", i}});
        }
        topology_.nodes.push_back(Node{point, BRep_Tool::Tolerance(vertex)});
    }
}

void TopologyBuilder::add_edges() {
    for (int i = 1; i <= edges_.Extent(); ++i) {
        check_cancelled(progress_);
        const TopoDS_Edge shape = TopoDS::Edge(edges_(i).Oriented(TopAbs_FORWARD));
        Edge edge;
        TopoDS_Vertex ends[2];
        TopExp::Vertices(shape, ends[0], ends[1]);
        for (std::size_t k = 0; k < 2; ++k) {
            edge.nodes[k] = ends[k].IsNull() ? -1 : vertices_.FindIndex(ends[k]) - 1;
        }
        edge.tolerance = BRep_Tool::Tolerance(shape);
        live_.edges.push_back(shape);
        set_range(i - 1, edge);
        if (!edge.degenerate) {
            edge.spans = spans_of(shape);
        }
        topology_.edges.push_back(edge);
    }
}

/// Sets the range of the curve in space or, without such a curve, of the first curve on a surface.
void TopologyBuilder::set_range(int index, Edge& edge) const {
    const TopoDS_Edge& shape = live_.edges[static_cast<std::size_t>(index)];
    TopLoc_Location location;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(shape, location, edge.t0, edge.t1);
    if (!curve.IsNull()) {
        edge.degenerate = BRep_Tool::Degenerated(shape);
        return;
    }
    Handle(Geom2d_Curve) pcurve;
    Handle(Geom_Surface) surface;
    BRep_Tool::CurveOnSurface(shape, pcurve, surface, location, edge.t0, edge.t1);
    // An edge without any curve has no point in space either: it can only be skipped.
    edge.degenerate = BRep_Tool::Degenerated(shape) || pcurve.IsNull();
    if (pcurve.IsNull()) {
        edge.t0 = 0.0;
        edge.t1 = 0.0;
    }
}

void TopologyBuilder::add_faces() {
    topology_.faces.resize(static_cast<std::size_t>(faces_.Extent()));
    for (int i = 0; i < faces_.Extent(); ++i) {
        check_cancelled(progress_);
        add_face(i);
    }
}

void TopologyBuilder::add_face(int index) {
    const TopoDS_Shape& met = faces_(index + 1);
    const TopoDS_Face face = TopoDS::Face(met.Oriented(TopAbs_FORWARD));
    live_.faces.push_back(face);
    if (ordered_.replaced.Contains(met)) {
        topology_.faces[static_cast<std::size_t>(index)].no_area = true;
        return;
    }
    TopLoc_Location location;
    const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, location);
    if (surface.IsNull()) {
        throw GeometryError(phrases::kNoSurface, {{"name", topology_.name_of(Entity{2, index})}});
    }
    Face& data = topology_.faces[static_cast<std::size_t>(index)];
    data.tolerance = BRep_Tool::Tolerance(face);
    const auto behind = ordered_.behind.find(index);
    data.behind = behind != ordered_.behind.end() ? behind->second : -1;
    const GeomAdaptor_Surface adaptor(surface);
    data.surface = surface_name(adaptor.GetType());
    data.period = periods_of(adaptor, data.tolerance);
    // A mirror in the location reverses Su x Sv, compared with the surface's own.
    data.reversed = (met.Orientation() == TopAbs_REVERSED) != mirrors(face.Location().Transformation());
    BRepTools::UVBounds(face, data.low[0], data.high[0], data.low[1], data.high[1]);
    for (TopoDS_Iterator it(face); it.More(); it.Next()) {
        if (it.Value().ShapeType() == TopAbs_WIRE) {
            add_wire(index, face, TopoDS::Wire(it.Value()));
        } else if (it.Value().ShapeType() == TopAbs_VERTEX) {
            data.points.push_back(vertices_.FindIndex(it.Value()) - 1);
        }
    }
    if (data.loops.empty()) {
        fault(Entity{2, index}, "has no wire");
    }
    data.no_area = has_no_area(adaptor, data, least_width_);
    if (data.no_area && !ordered_.is_cut(topology_.of_shape({2, index}).index)) {
        fault(Entity{2, index}, "has no area");
    }
    const double bounds = std::max(std::max(std::abs(data.low[0]), std::abs(data.high[0])),
                                   std::max(std::abs(data.low[1]), std::abs(data.high[1])));
    if (!(bounds < 1e50)) {
        fault(Entity{2, index}, "has no bounds");
    } else if (data.low[0] < data.high[0] && data.low[1] < data.high[1]) {
        data.spans = spans_of(GeomAdaptor_Surface(surface, data.low[0], data.high[0], data.low[1], data.high[1]));
    }
}

void TopologyBuilder::add_wire(int index, const TopoDS_Face& face, const TopoDS_Wire& wire) {
    std::vector<TopoDS_Edge> plain;
    std::vector<TopoDS_Edge> internal;
    for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Value());
        if (bounds_a_face(edge)) {
            plain.push_back(edge);
        } else if (edge.Orientation() == TopAbs_INTERNAL) {
            internal.push_back(edge);
        }
    }
    std::vector<TopoDS_Edge> ordered = bounds_a_face(wire) ? chained(plain) : std::vector<TopoDS_Edge>();
    if (bounds_a_face(wire) && ordered.empty()) {
        for (BRepTools_WireExplorer it(wire, face); it.More() && ordered.size() <= plain.size(); it.Next()) {
            ordered.push_back(it.Current());
        }
    }
    // The explorer stops where the wire is not connected.
    add_loop(index, face, ordered.size() == plain.size() ? ordered : plain);
    add_loop(index, face, internal);
}

void TopologyBuilder::add_loop(int index, const TopoDS_Face& face, const std::vector<TopoDS_Edge>& run) {
    if (run.empty()) {
        return;
    }
    Loop loop;
    for (const TopoDS_Edge& edge : run) {
        EdgeUse use;
        use.edge = edges_.FindIndex(edge) - 1;
        use.face = index;
        use.forward = edge.Orientation() != TopAbs_REVERSED;
        use.internal = edge.Orientation() == TopAbs_INTERNAL;
        const int id = static_cast<int>(topology_.uses.size());
        live_.uses.push_back(use_curve(use.edge, index, edge, face));
        topology_.uses.push_back(use);
        topology_.edges[static_cast<std::size_t>(use.edge)].uses.push_back(id);
        loop.uses.push_back(id);
    }
    topology_.faces[static_cast<std::size_t>(index)].loops.push_back(loop);
}

PCurve TopologyBuilder::use_curve(int edge_index, int face_index, const TopoDS_Edge& edge, const TopoDS_Face& face) {
    PCurve result;
    result.curve = BRep_Tool::CurveOnSurface(edge, face, result.first, result.last);
    if (result.curve.IsNull()) {
        fault(Entity{1, edge_index}, "has no curve on " + topology_.name_of(Entity{2, face_index}));
    }
    return result;
}

/// Each side of a face bounds one volume: shapes that are listed again beside the solid to which they belong, such as
/// its shells and faces in a compound that Gmsh wrote, add nothing.
void TopologyBuilder::add_volumes() {
    FaceSides bounding(topology_.faces.size());
    TopTools_MapOfShape solids;
    for (TopExp_Explorer it(ordered_.shape, TopAbs_SOLID); it.More(); it.Next()) {
        check_cancelled(progress_);
        const std::vector<Volume::Side> sides = sides_of(it.Current());
        if (solids.Add(it.Current()) && (sides.empty() || !bounding.has_all(sides))) {
            add_volume(it.Current(), Volume::Kind::Solid, sides, bounding);
            topology_.volumes.back().solid = solids.Extent() - 1;
        }
    }
    for (TopExp_Explorer it(ordered_.shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next()) {
        check_cancelled(progress_);
        std::vector<Volume::Side> sides = sides_of(it.Current());
        if (!bounding.in_one_volume(sides)) {
            sides.erase(std::remove_if(sides.begin(), sides.end(),
                                       [&](const Volume::Side& side) { return bounding.has(side); }),
                        sides.end());
            add_volume(it.Current(), Volume::Kind::Shell, sides, bounding);
        }
    }
    std::vector<Volume::Side> rest;
    for (std::size_t i = 0; i < topology_.faces.size(); ++i) {
        const bool replaced = ordered_.replaced.Contains(faces_(static_cast<int>(i) + 1));
        if (!bounding.has_face(static_cast<int>(i)) && !replaced) {
            rest.push_back(Volume::Side{static_cast<int>(i), false});
        }
    }
    if (!rest.empty()) {
        add_volume(TopoDS_Shape(), Volume::Kind::Faces, rest, bounding);
    }
}

void TopologyBuilder::add_volume(const TopoDS_Shape& part, Volume::Kind kind, const std::vector<Volume::Side>& sides,
                                 FaceSides& bounding) {
    Volume volume;
    volume.kind = kind;
    volume.sides = sides;
    bounding.add(sides, static_cast<int>(topology_.volumes.size()));
    topology_.volumes.push_back(volume);
    live_.volumes.push_back(part);
}

/// Faces that are INTERNAL or EXTERNAL to a solid do not bound it.
std::vector<Volume::Side> TopologyBuilder::sides_of(const TopoDS_Shape& part) const {
    std::vector<Volume::Side> sides;
    for (TopExp_Explorer it(part, TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Shape& face = it.Current();
        if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) {
            continue;
        }
        const int index = faces_.FindIndex(face);
        const TopAbs_Orientation first = faces_(index).Orientation();
        sides.push_back(Volume::Side{index - 1, (face.Orientation() == TopAbs_REVERSED) != (first == TopAbs_REVERSED)});
    }
    return sides;
}

/// Whether the surface is closed in the given direction (0 = u) within the tolerance, and not because the whole row is
/// a point.
bool closed_within(const GeomAdaptor_Surface& s, int direction, double tolerance) {
    const double low[2] = {s.FirstUParameter(), s.FirstVParameter()};
    const double high[2] = {s.LastUParameter(), s.LastVParameter()};
    for (int i = 0; i < 2; ++i) {
        if (Precision::IsInfinite(low[i]) || Precision::IsInfinite(high[i])) {
            return false;
        }
    }
    const auto at = [&](double along, double across) {
        const double a = low[direction] + along * (high[direction] - low[direction]);
        const double b = low[1 - direction] + across * (high[1 - direction] - low[1 - direction]);
        return direction == 0 ? s.Value(a, b) : s.Value(b, a);
    };
    double width = 0.0;
    for (int i = 0; i <= 8; ++i) {
        const double across = i / 8.0;
        const gp_Pnt start = at(0.0, across);
        if (start.Distance(at(1.0, across)) > tolerance) {
            return false;
        }
        width = std::max(width, std::max(start.Distance(at(0.35, across)), start.Distance(at(0.6, across))));
    }
    return width > 10.0 * tolerance;
}

}  // namespace

std::array<double, 2> periods_of(const GeomAdaptor_Surface& surface, double tolerance) {
    const double within = std::max(tolerance, Precision::Confusion());
    std::array<double, 2> periods{0.0, 0.0};
    if (surface.IsUPeriodic()) {
        periods[0] = surface.UPeriod();
    } else if (closed_within(surface, 0, within)) {
        periods[0] = surface.LastUParameter() - surface.FirstUParameter();
    }
    if (surface.IsVPeriodic()) {
        periods[1] = surface.VPeriod();
    } else if (closed_within(surface, 1, within)) {
        periods[1] = surface.LastVParameter() - surface.FirstVParameter();
    }
    return periods;
}

Topology build_topology(const OrderedShape& shape, ShapeMap& live, const Progress* progress) {
    return TopologyBuilder(shape, live, progress).build();
}

}  // namespace mq::geometry
