// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/plane_curves.h"

#include <BRep_CurveOnSurface.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_ListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "geometry/occt/stream/shape_copy.h"

namespace mq::geometry {

namespace {

bool has_curve(const BRep_TEdge& edge, const Handle(Geom_Surface) & surface, const TopLoc_Location& place) {
    const BRep_ListOfCurveRepresentation& curves = edge.Curves();
    return std::any_of(curves.begin(), curves.end(), [&](const Handle(BRep_CurveRepresentation) & curve) {
        return curve->IsCurveOnSurface(surface, place);
    });
}

class PlaneCurves final : public ShapeCopy {
  public:
    explicit PlaneCurves(const Progress* progress) : progress_(progress) {}

    TopoDS_Shape add_to(const TopoDS_Shape& shape) {
        for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
            check_cancelled(progress_);
            if (seen_.insert(faces.Current().TShape().get()).second) {
                find_missing(TopoDS::Face(in_own_frame(faces.Current().TShape())));
            }
        }
        return missing_.empty() ? shape : of(shape);
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

    bool changes(const TopoDS_TShape& own) override { return missing_.count(&own) > 0; }

    void change(const TopoDS_TShape& own, TopoDS_TShape& copy) override {
        for (const Handle(BRep_CurveOnSurface) & curve : missing_.at(&own)) {
            static_cast<BRep_TEdge&>(copy).ChangeCurves().Append(curve);
        }
    }

    const Progress* progress_;
    std::unordered_set<const TopoDS_TShape*> seen_;                                               // faces
    std::unordered_map<const TopoDS_TShape*, std::vector<Handle(BRep_CurveOnSurface)>> missing_;  // by edge
};

}  // namespace

TopoDS_Shape with_plane_curves(const TopoDS_Shape& shape, const Progress* progress) {
    return PlaneCurves(progress).add_to(shape);
}

}  // namespace mq::geometry
