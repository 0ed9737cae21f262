// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/stream/canonical_locations.h"

#include <BRep_CurveOn2Surfaces.hxx>
#include <BRep_PointOnCurve.hxx>
#include <BRep_PointOnCurveOnSurface.hxx>
#include <BRep_PointOnSurface.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TFace.hxx>
#include <BRep_TVertex.hxx>
#include <TopLoc_Datum3D.hxx>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/stream/byte_reader.h"
#include "geometry/occt/stream/shape_copy.h"

namespace mq::geometry {

namespace {

bool same_bits(const gp_Trsf& a, const gp_Trsf& b) {
    const gp_Mat& matrix = a.HVectorialPart();
    return a.ScaleFactor() == b.ScaleFactor() && a.Form() == b.Form() &&
           std::memcmp(&matrix, &b.HVectorialPart(), sizeof(matrix)) == 0;
}

class CanonicalLocations final : public ShapeCopy {
  private:
    TopLoc_Location placed(const TopLoc_Location& own) override {
        if (own.IsIdentity()) {
            return own;
        }
        Handle(TopLoc_Datum3D)& datum = data_[own.FirstDatum().get()];
        if (datum.IsNull()) {
            const gp_Trsf& motion = own.FirstDatum()->Transformation();
            const gp_Trsf canonical = canonical_transformation(motion.VectorialPart(), motion.TranslationPart());
            datum = same_bits(canonical, motion) ? own.FirstDatum() : new TopLoc_Datum3D(canonical);
        }
        return placed(own.NextLocation()) * TopLoc_Location(datum).Powered(own.FirstPower());
    }

    bool moves(const TopLoc_Location& own) { return placed(own) != own; }

    bool changes(const TopoDS_TShape& own) override {
        switch (own.ShapeType()) {
            case TopAbs_FACE:
                return moves(static_cast<const BRep_TFace&>(own).Location());
            case TopAbs_EDGE: {
                const BRep_ListOfCurveRepresentation& curves = static_cast<const BRep_TEdge&>(own).Curves();
                return std::any_of(curves.begin(), curves.end(), [&](const Handle(BRep_CurveRepresentation) & curve) {
                    return moves(curve->Location()) || (curve->IsRegularity() && moves(curve->Location2()));
                });
            }
            case TopAbs_VERTEX: {
                const BRep_ListOfPointRepresentation& points = static_cast<const BRep_TVertex&>(own).Points();
                return std::any_of(points.begin(), points.end(), [&](const Handle(BRep_PointRepresentation) & point) {
                    return moves(point->Location());
                });
            }
            default:
                return false;
        }
    }

    void change(const TopoDS_TShape& own, TopoDS_TShape& copy) override {
        if (own.ShapeType() == TopAbs_FACE) {
            auto& face = static_cast<BRep_TFace&>(copy);
            face.Location(placed(face.Location()));
        } else if (own.ShapeType() == TopAbs_EDGE) {
            for (Handle(BRep_CurveRepresentation) & curve : static_cast<BRep_TEdge&>(copy).ChangeCurves()) {
                if (curve->IsRegularity() && !curve->IsCurveOnSurface()) {
                    curve = new BRep_CurveOn2Surfaces(curve->Surface(), curve->Surface2(), curve->Location(),
                                                      placed(curve->Location2()), curve->Continuity());
                }
                curve->Location(placed(curve->Location()));
            }
        } else {
            for (const Handle(BRep_PointRepresentation) & point : static_cast<const BRep_TVertex&>(own).Points()) {
                static_cast<BRep_TVertex&>(copy).ChangePoints().Append(copy_of(*point));
            }
        }
    }

    Handle(BRep_PointRepresentation) copy_of(const BRep_PointRepresentation& point) {
        const TopLoc_Location place = placed(point.Location());
        if (point.IsPointOnCurve()) {
            return new BRep_PointOnCurve(point.Parameter(), point.Curve(), place);
        }
        if (point.IsPointOnCurveOnSurface()) {
            return new BRep_PointOnCurveOnSurface(point.Parameter(), point.PCurve(), point.Surface(), place);
        }
        return new BRep_PointOnSurface(point.Parameter(), point.Parameter2(), point.Surface(), place);
    }

    std::unordered_map<const TopLoc_Datum3D*, Handle(TopLoc_Datum3D)> data_;  // the canonical one of each
};

}  // namespace

gp_Trsf canonical_transformation(const gp_Mat& rows, const gp_XYZ& shift) {
    struct Bits {
        double scale;
        gp_TrsfForm form;
        gp_Mat matrix;
        gp_XYZ shift;
    };
    double scale = std::cbrt(rows.Determinant());
    if (std::abs(std::abs(scale) - 1.0) < kScaleRounding) {
        scale = std::copysign(1.0, scale);
    }
    return with_bits<gp_Trsf>(Bits{scale, gp_CompoundTrsf, rows.Divided(scale), shift});
}

std::shared_ptr<const TopoDS_Shape> with_canonical_locations(const TopoDS_Shape& shape) {
    return std::make_shared<TopoDS_Shape>(CanonicalLocations().of(shape));
}

}  // namespace mq::geometry
