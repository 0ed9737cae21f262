// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/creases.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepCheck_Analyzer.hxx>
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
#include <map>
#include <set>
#include <string>

#include "geometry/occt/topology/crease_lines.h"

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

/// How a face is cut, in the order in which it is tried. Both directions at once fail if lines cross in a line that is
/// a single point; where the side of a piece is such a line, OpenCASCADE mixes up edges in one of both orders.
enum class Way { UFirst, VFirst, UFirstUnchecked, Uncut };
using Ways = std::map<Handle(Geom_Surface), Way>;  // UFirst where there is none

/// The shape after several cuts, and the pieces of its sub-shapes.
class Cuts {
  public:
    Cuts(const TopoDS_Shape& shape, const Ways& ways) : result_(shape) {
        Surfaces uncut;
        Surfaces later;
        for (const auto& [surface, way] : ways) {
            if (way == Way::Uncut) {
                uncut.insert(surface);
            }
            if (way == Way::Uncut || way == Way::VFirst) {
                later.insert(surface);
            }
        }
        divide(0, later);
        divide(1, uncut);
        if (later.size() > uncut.size()) {
            divide(0, uncut);
        }
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

bool has_creases(const OrderedShape& shape, const Progress* progress) {
    for (int i = 1; i <= shape.faces.Extent(); ++i) {
        check_cancelled(progress);
        if (has_crease(TopoDS::Face(shape.faces(i)))) {
            return true;
        }
    }
    return false;
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

/// @param checked  whether OpenCASCADE's checks must find nothing wrong with the pieces that is not wrong with the face
bool is_whole(const TopoDS_Shape& face, const TopoDS_Shape& pieces, bool checked) {
    // Largest relative change of the area by a correct cut.
    constexpr double kOfArea = 1e-3;
    const double area = parameter_area(face);
    return std::abs(parameter_area(pieces) - area) <= kOfArea * std::abs(area) &&
           ends_are_on_edges(pieces, largest_tolerance(face)) &&
           (!checked || BRepCheck_Analyzer(pieces).IsValid() || !BRepCheck_Analyzer(face).IsValid());
}

/// @return the numbers of faces whose pieces do not cover them, and how each was cut
std::map<int, Way> badly_cut(const OrderedShape& whole, const Cuts& cuts, const Ways& ways) {
    std::map<int, Way> bad;
    for (int i = 1; i <= whole.faces.Extent(); ++i) {
        const TopoDS_Shape pieces = cuts.pieces_of(whole.faces(i));
        const auto found = ways.find(surface_of(TopoDS::Face(whole.faces(i))));
        const Way way = found == ways.end() ? Way::UFirst : found->second;
        if (!pieces.IsSame(whole.faces(i)) && !is_whole(whole.faces(i), pieces, way < Way::UFirstUnchecked)) {
            bad.emplace(i, way);
        }
    }
    return bad;
}

/// Divides faces except those that their pieces do not cover, which are named in `left`.
OrderedShape cut_where_possible(const OrderedShape& whole, std::string& left) {
    Ways ways;
    for (;;) {
        const Cuts cuts(whole.shape, ways);
        const std::map<int, Way> bad = badly_cut(whole, cuts, ways);
        if (bad.empty()) {
            return number_pieces(whole, cuts.result(), [&](const TopoDS_Shape& part) { return cuts.pieces_of(part); });
        }
        for (const auto& [face, way] : bad) {
            if (way == Way::Uncut) {
                return whole;
            }
            const Way next = static_cast<Way>(static_cast<int>(way) + 1);
            ways[surface_of(TopoDS::Face(whole.faces(face)))] = next;
            if (next == Way::Uncut) {
                left += (left.empty() ? "" : ", ") + name_of(Entity{2, face - 1});
            }
        }
    }
}

}  // namespace

OrderedShape cut_at_creases(OrderedShape whole, std::vector<std::string>& faults, const Progress* progress) {
    if (!has_creases(whole, progress)) {
        return whole;
    }
    // The cut is made in the shape's own frame, so that the geometry of the pieces does not depend on its placement.
    const TopLoc_Location place = whole.shape.Location();
    whole = moved(std::move(whole), place.Inverted());
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
