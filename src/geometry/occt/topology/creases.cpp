// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/creases.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeExtend.hxx>
#include <ShapeUpgrade_FaceDivide.hxx>
#include <ShapeUpgrade_ShapeDivide.hxx>
#include <ShapeUpgrade_SplitSurface.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_HSequenceOfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "geometry/occt/topology/crease_lines.h"
#include "geometry/occt/topology/sub_shapes.h"

namespace mq::geometry {

namespace {

/// Splits a surface at given parameters.
class SplitAtLines final : public ShapeUpgrade_SplitSurface {
  public:
    explicit SplitAtLines(int direction) : direction_(direction) {}
    void set(const std::vector<double>& lines) { lines_ = lines; }
    void Compute(const Standard_Boolean) override {
        const Handle(TColStd_HSequenceOfReal)& values = direction_ == 0 ? myUSplitValues : myVSplitValues;
        for (const double at : lines_) {
            values->InsertBefore(values->Length(), at);
            myStatus |= ShapeExtend::EncodeStatus(ShapeExtend_DONE1);
        }
    }

  private:
    int direction_;
    std::vector<double> lines_;
};

using Surfaces = std::set<Handle(Geom_Surface)>;

Handle(Geom_Surface) surface_of(const TopoDS_Face& face) {
    TopLoc_Location place;
    return BRep_Tool::Surface(face, place);
}

template <typename Method>
class FaceDivide;

/// Divides the faces that have creases and leaves all other faces, and those in `uncut`, as they are. SplitSurface has
/// an argument for the area in OpenCASCADE 7.8, and none in 7.6.
template <typename... Area>
class FaceDivide<Standard_Boolean (ShapeUpgrade_FaceDivide::*)(Area...)> final : public ShapeUpgrade_FaceDivide {
  public:
    FaceDivide(int direction, Surfaces uncut)
        : direction_(direction), uncut_(std::move(uncut)), split_(new SplitAtLines(direction)) {
        SetSplitSurfaceTool(split_);
    }
    Standard_Boolean SplitSurface(Area... area) override {
        if (uncut_.count(surface_of(TopoDS::Face(myResult))) > 0) {
            return false;
        }
        const std::vector<double> lines = crease_lines(TopoDS::Face(myResult), direction_);
        split_->set(lines);
        return !lines.empty() && ShapeUpgrade_FaceDivide::SplitSurface(area...);
    }
    Standard_Boolean SplitCurves() override { return Standard_False; }

  private:
    int direction_;
    Surfaces uncut_;
    Handle(SplitAtLines) split_;
};

using DivideAtCreases = FaceDivide<decltype(&ShapeUpgrade_FaceDivide::SplitSurface)>;

/// The shape after several cuts, and the pieces of its sub-shapes.
class Cuts {
  public:
    Cuts(const TopoDS_Shape& shape, const Surfaces& uncut) : result_(shape) {
        // Cutting in both directions at once fails where lines cross in a line that is a point.
        divide(0, uncut);
        divide(1, uncut);
    }
    const TopoDS_Shape& result() const { return result_; }
    TopoDS_Shape pieces_of(TopoDS_Shape part) const {
        for (const Handle(ShapeBuild_ReShape) & change : changes_) {
            part = change->Apply(part);
        }
        return part;
    }

  private:
    void divide(int direction, const Surfaces& uncut) {
        ShapeUpgrade_ShapeDivide divide(result_);
        divide.SetSplitFaceTool(new DivideAtCreases(direction, uncut));
        divide.Perform();
        result_ = divide.Result();
        changes_.push_back(divide.GetContext());
    }

    TopoDS_Shape result_;
    std::vector<Handle(ShapeBuild_ReShape)> changes_;
};

/// The area in (u, v) that the borders of the faces of `shape` enclose.
double parameter_area(const TopoDS_Shape& shape) {
    // Chords by which a curve is approximated.
    constexpr int kPieces = 256;
    double area = 0.0;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
        for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
            double first = 0.0;
            double last = 0.0;
            const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
            const bool bounds = edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
            for (int i = 0; !curve.IsNull() && bounds && i < kPieces; ++i) {
                const gp_Pnt2d a = curve->Value(first + (last - first) * i / kPieces);
                const gp_Pnt2d b = curve->Value(first + (last - first) * (i + 1) / kPieces);
                const double under = 0.5 * (a.X() + b.X()) * (b.Y() - a.Y());
                area += edge.Orientation() == TopAbs_FORWARD ? under : -under;
            }
        }
    }
    return area;
}

bool has_creases(const TopoDS_Shape& shape, const Progress* progress) {
    TopTools_IndexedMapOfShape faces;
    map_sub_shapes(shape, TopAbs_FACE, faces, progress);
    for (int i = 1; i <= faces.Extent(); ++i) {
        check_cancelled(progress);
        if (has_crease(TopoDS::Face(faces(i)))) {
            return true;
        }
    }
    return false;
}

/// Numbers the pieces: the first piece gets the number of the entity that was cut, the others follow after all entities
/// of the shape.
class Numbering {
  public:
    Numbering(const OrderedShape& whole, const Cuts& cuts) : whole_(whole), cuts_(cuts) { cut_.shape = cuts.result(); }

    OrderedShape run() {
        number(whole_.faces, TopAbs_FACE, 2, cut_.faces);
        number(whole_.edges, TopAbs_EDGE, 1, cut_.edges);
        number(whole_.vertices, TopAbs_VERTEX, 0, cut_.vertices);
        add_creases();
        add_ends();
        return std::move(cut_);
    }

  private:
    void number(const TopTools_IndexedMapOfShape& own, TopAbs_ShapeEnum kind, int dimension,
                TopTools_IndexedMapOfShape& numbered) {
        std::vector<std::pair<int, TopoDS_Shape>> further;
        for (int i = 1; i <= own.Extent(); ++i) {
            TopTools_IndexedMapOfShape pieces;
            TopExp::MapShapes(cuts_.pieces_of(own(i)), kind, pieces);
            const bool taken = pieces.IsEmpty() || numbered.Contains(pieces(1));
            if (taken) {
                cut_.replaced.Add(own(i));
            }
            numbered.Add(taken ? own(i) : pieces(1));
            for (int k = 2; k <= pieces.Extent(); ++k) {
                further.emplace_back(i - 1, pieces(k));
            }
            if (dimension == 2 && pieces.Extent() > 1) {
                cut_.cut_faces.push_back(i - 1);
            }
        }
        for (const auto& [of, piece] : further) {
            add(piece, dimension, Entity{dimension, of}, numbered);
        }
    }

    void add(const TopoDS_Shape& piece, int dimension, Entity of, TopTools_IndexedMapOfShape& numbered) {
        if (!numbered.Contains(piece)) {
            numbered.Add(piece);
            cut_.parts_of[static_cast<std::size_t>(dimension)].push_back(of);
        }
    }

    // @param own number of entities of this dimension in the shape itself.
    Entity of_shape(Entity entity, int own) const {
        const std::vector<Entity>& parts = cut_.parts_of[static_cast<std::size_t>(entity.dimension)];
        return entity.index < own ? entity : parts[static_cast<std::size_t>(entity.index - own)];
    }

    // Adds edges that are no piece of an edge.
    void add_creases() {
        for (int f = 1; f <= cut_.faces.Extent(); ++f) {
            const Entity face = of_shape({2, f - 1}, whole_.faces.Extent());
            for (TopExp_Explorer it(cut_.faces(f), TopAbs_EDGE); it.More(); it.Next()) {
                add(it.Current(), 1, face, cut_.edges);
            }
        }
    }

    // Adds ends of creases, which lie on an edge that was cut, or inside a face.
    void add_ends() {
        for (const bool of_edges : {true, false}) {
            for (int e = 1; e <= cut_.edges.Extent(); ++e) {
                const Entity of = of_shape({1, e - 1}, whole_.edges.Extent());
                if ((of.dimension == 1) != of_edges) {
                    continue;
                }
                for (TopExp_Explorer it(cut_.edges(e), TopAbs_VERTEX); it.More(); it.Next()) {
                    add(it.Current(), 0, of, cut_.vertices);
                }
            }
        }
    }

    const OrderedShape& whole_;
    const Cuts& cuts_;
    OrderedShape cut_;
};

void move(TopTools_IndexedMapOfShape& entities, const TopLoc_Location& place) {
    TopTools_IndexedMapOfShape moved;
    for (int i = 1; i <= entities.Extent(); ++i) {
        moved.Add(entities(i).Moved(place, Standard_False));
    }
    entities = moved;
}

double largest_tolerance(const TopoDS_Shape& shape) {
    double most = 0.0;
    for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next()) {
        most = std::max(most, BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())));
    }
    return most;
}

// On surfaces that are closed in both directions OpenCASCADE makes vertices elsewhere than on their edges.
bool ends_are_on_edges(const TopoDS_Shape& pieces, double tolerance) {
    for (TopExp_Explorer it(pieces, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD));
        if (BRep_Tool::Degenerated(edge)) {
            continue;
        }
        const BRepAdaptor_Curve curve(edge);
        const double most = 2.0 * std::max(tolerance, BRep_Tool::Tolerance(edge));
        const TopoDS_Vertex first = TopExp::FirstVertex(edge);
        const TopoDS_Vertex last = TopExp::LastVertex(edge);
        if (first.IsNull() || last.IsNull() ||
            curve.Value(curve.FirstParameter()).Distance(BRep_Tool::Pnt(first)) > most ||
            curve.Value(curve.LastParameter()).Distance(BRep_Tool::Pnt(last)) > most) {
            return false;
        }
    }
    return true;
}

bool is_whole(const TopoDS_Shape& face, const TopoDS_Shape& pieces) {
    // Largest relative change of the area by a correct cut.
    constexpr double kOfArea = 1e-3;
    const double area = parameter_area(face);
    return std::abs(parameter_area(pieces) - area) <= kOfArea * std::abs(area) &&
           ends_are_on_edges(pieces, largest_tolerance(face));
}

/// @return the numbers of faces whose pieces do not cover them
std::vector<int> badly_cut(const OrderedShape& whole, const Cuts& cuts) {
    std::vector<int> bad;
    for (int i = 1; i <= whole.faces.Extent(); ++i) {
        const TopoDS_Shape pieces = cuts.pieces_of(whole.faces(i));
        if (!pieces.IsSame(whole.faces(i)) && !is_whole(whole.faces(i), pieces)) {
            bad.push_back(i);
        }
    }
    return bad;
}

OrderedShape moved(OrderedShape cut, const TopLoc_Location& place) {
    cut.shape = cut.shape.Moved(place, Standard_False);
    move(cut.vertices, place);
    move(cut.edges, place);
    move(cut.faces, place);
    move(cut.replaced, place);
    return cut;
}

/// Leaves faces whose pieces do not cover them as they are, and names them in `left`.
OrderedShape cut_where_possible(const OrderedShape& whole, std::string& left) {
    Surfaces uncut;
    for (;;) {
        const Cuts cuts(whole.shape, uncut);
        const std::vector<int> bad = badly_cut(whole, cuts);
        if (bad.empty()) {
            return Numbering(whole, cuts).run();
        }
        const std::size_t before = uncut.size();
        for (const int face : bad) {
            uncut.insert(surface_of(TopoDS::Face(whole.faces(face))));
            left += (left.empty() ? "" : ", ") + name_of(Entity{2, face - 1});
        }
        if (uncut.size() == before) {
            return whole;
        }
    }
}

}  // namespace

OrderedShape ordered(const TopoDS_Shape& shape, const Progress* progress) {
    OrderedShape result;
    result.shape = shape;
    map_sub_shapes(shape, TopAbs_VERTEX, result.vertices, progress);
    map_sub_shapes(shape, TopAbs_EDGE, result.edges, progress);
    map_sub_shapes(shape, TopAbs_FACE, result.faces, progress);
    return result;
}

OrderedShape cut_at_creases(const TopoDS_Shape& shape, std::vector<std::string>& faults, const Progress* progress) {
    if (!has_creases(shape, progress)) {
        return ordered(shape, progress);
    }
    // The cut is made in the shape's own frame, so that the geometry of the pieces does not depend on its placement.
    const TopLoc_Location place = shape.Location();
    const OrderedShape whole = ordered(shape.Located(TopLoc_Location()), progress);
    OrderedShape cut;
    std::string left;
    try {
        cut = cut_where_possible(whole, left);
    } catch (const Standard_Failure& raised) {
        cut = whole;
        left = raised.DynamicType()->Name();
    }
    if (!left.empty()) {
        faults.push_back("creases inside faces are not followed: OpenCASCADE cannot cut along them (" + left + ")");
    }
    return moved(std::move(cut), place);
}

}  // namespace mq::geometry
