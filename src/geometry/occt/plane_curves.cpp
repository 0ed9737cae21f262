// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/plane_curves.h"

#include <BRep_Builder.hxx>
#include <BRep_CurveOnSurface.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_ListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TFace.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_TShape.hxx>
#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace mq::geometry {

namespace {

using Definition = Handle(TopoDS_TShape);

/// A shape where it was defined, before any location.
TopoDS_Shape in_own_frame(const Definition& own) {
    TopoDS_Shape shape;
    shape.TShape(own);
    return shape;
}

bool has_curve(const BRep_TEdge& edge, const Handle(Geom_Surface) & surface, const TopLoc_Location& place) {
    const BRep_ListOfCurveRepresentation& curves = edge.Curves();
    return std::any_of(curves.begin(), curves.end(), [&](const Handle(BRep_CurveRepresentation) & curve) {
        return curve->IsCurveOnSurface(surface, place);
    });
}

class PlaneCurves {
  public:
    explicit PlaneCurves(const Progress* progress) : progress_(progress) {}

    TopoDS_Shape add_to(const TopoDS_Shape& shape) {
        for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
            check_cancelled(progress_);
            if (seen_.insert(faces.Current().TShape().get()).second) {
                find_missing(TopoDS::Face(in_own_frame(faces.Current().TShape())));
            }
        }
        return missing_.empty() ? shape : copied(shape);
    }

  private:
    void find_missing(const TopoDS_Face& face) {
        TopLoc_Location place;
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, place);
        if (surface.IsNull()) {
            return;
        }
        for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
            const auto& definition = static_cast<const BRep_TEdge&>(*edge.TShape());
            const TopLoc_Location on_edge = place.Predivided(edge.Location());
            std::vector<Handle(BRep_CurveOnSurface)>& added = missing_[edge.TShape().get()];
            const bool known = has_curve(definition, surface, on_edge) ||
                               std::any_of(added.begin(), added.end(), [&](const Handle(BRep_CurveOnSurface) & curve) {
                                   return curve->IsCurveOnSurface(surface, on_edge);
                               });
            double first = 0.0;
            double last = 0.0;
            const Handle(Geom2d_Curve) curve =
                known ? Handle(Geom2d_Curve)() : BRep_Tool::CurveOnSurface(edge, surface, place, first, last);
            if (!curve.IsNull()) {
                Handle(BRep_CurveOnSurface) on_plane = new BRep_CurveOnSurface(curve, surface, on_edge);
                on_plane->SetRange(first, last);
                gp_Pnt2d start;
                gp_Pnt2d end;
                BRep_Tool::UVPoints(edge, surface, place, start, end);  // the vertices on the plane
                on_plane->SetUVPoints(start, end);
                added.push_back(on_plane);
            }
            if (added.empty()) {
                missing_.erase(edge.TShape().get());
            }
        }
    }

    TopoDS_Shape copied(const TopoDS_Shape& shape) {
        TopoDS_Shape result = shape;
        result.TShape(copy_of(shape.TShape()));
        return result;
    }

    /// The definition itself where none of its edges lacks a curve.
    Definition copy_of(const Definition& own) {
        if (own->ShapeType() == TopAbs_VERTEX) {
            return own;
        }
        const auto known = copies_.find(own.get());
        if (known != copies_.end()) {
            return known->second;
        }
        std::vector<TopoDS_Shape> children;
        bool changed = missing_.count(own.get()) > 0;
        for (TopoDS_Iterator each(in_own_frame(own), Standard_False, Standard_False); each.More(); each.Next()) {
            children.push_back(copied(each.Value()));
            changed = changed || children.back().TShape() != each.Value().TShape();
        }
        const Definition copy = changed ? copy_with(own, children) : own;
        copies_.emplace(own.get(), copy);
        return copy;
    }

    Definition copy_with(const Definition& own, const std::vector<TopoDS_Shape>& children) const {
        const Definition copy = own->ShapeType() == TopAbs_EDGE ? copy_of_edge(own) : own->EmptyCopy();
        if (own->ShapeType() == TopAbs_FACE) {
            const auto& from = static_cast<const BRep_TFace&>(*own);
            auto& to = static_cast<BRep_TFace&>(*copy);
            to.NaturalRestriction(from.NaturalRestriction());
            to.Triangulation(from.Triangulation());
        }
        TopoDS_Shape shape = in_own_frame(copy);
        for (const TopoDS_Shape& child : children) {
            BRep_Builder().Add(shape, child);
        }
        copy->Orientable(own->Orientable());
        copy->Closed(own->Closed());
        copy->Infinite(own->Infinite());
        copy->Convex(own->Convex());
        return copy;
    }

    Definition copy_of_edge(const Definition& own) const {
        const auto& from = static_cast<const BRep_TEdge&>(*own);
        Handle(BRep_TEdge) to = new BRep_TEdge();
        to->Tolerance(from.Tolerance());
        to->SameParameter(from.SameParameter());
        to->SameRange(from.SameRange());
        to->Degenerated(from.Degenerated());
        for (const Handle(BRep_CurveRepresentation) & curve : from.Curves()) {
            to->ChangeCurves().Append(curve);
        }
        for (const Handle(BRep_CurveOnSurface) & curve : missing_.at(own.get())) {
            to->ChangeCurves().Append(curve);
        }
        return to;
    }

    const Progress* progress_;
    std::unordered_set<const TopoDS_TShape*> seen_;                                               // faces
    std::unordered_map<const TopoDS_TShape*, std::vector<Handle(BRep_CurveOnSurface)>> missing_;  // by edge
    std::unordered_map<const TopoDS_TShape*, Definition> copies_;
};

}  // namespace

TopoDS_Shape with_plane_curves(const TopoDS_Shape& shape, const Progress* progress) {
    return PlaneCurves(progress).add_to(shape);
}

}  // namespace mq::geometry
