// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/distance/shape_distance.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Extrema_ExtPC.hxx>
#include <Extrema_ExtPS.hxx>
#include <Extrema_POnSurf.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pnt2d.hxx>
#include <gp_Trsf.hxx>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/waits.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/box_tree.h"
#include "geometry/occt/distance/patch_tree.h"
#include "geometry/occt/evaluation/failure_text.h"

namespace mq::geometry {

namespace {

// Least size of a shape (mm) that is measured unscaled. OpenCASCADE's search for the nearest point takes 1e-7 mm as
// zero: it misses points on shapes not much larger than that, and is less accurate on shapes of a kilometre. Shapes
// beyond these sizes are measured scaled to them.
constexpr double kLeastSize = 10.0;
/// Largest size of a shape (mm) that is measured unscaled.
constexpr double kMostSize = 1e4;

double scale_to_measure(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box, false);
    const double size = box.IsVoid() || box.IsOpen() ? 0.0 : std::sqrt(box.SquareExtent());
    return size > 0.0 ? std::clamp(size, kLeastSize, kMostSize) / size : 1.0;
}

TopoDS_Shape scaled(const TopoDS_Shape& shape, double factor) {
    gp_Trsf scaling;
    scaling.SetScaleFactor(factor);
    return factor == 1.0 ? shape : BRepBuilderAPI_Transform(shape, scaling, true).Shape();
}

Box box_of(const TopoDS_Shape& shape) {
    Bnd_Box bounds;
    BRepBndLib::Add(shape, bounds, false);
    Box box;
    bounds.Get(box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2]);
    return box;
}

/// The surface from `low` along one vector to `high` along the other; periodic if the curve is.
Handle(Geom_BSplineSurface)
    extruded(const Handle(Geom_BSplineCurve) & curve, const gp_Vec& along, double low, double high) {
    TColgp_Array2OfPnt poles(1, curve->NbPoles(), 1, 2);
    TColStd_Array2OfReal weights(1, curve->NbPoles(), 1, 2);
    for (int i = 1; i <= curve->NbPoles(); ++i) {
        poles(i, 1) = curve->Pole(i).Translated(low * along);
        poles(i, 2) = curve->Pole(i).Translated(high * along);
        weights(i, 1) = weights(i, 2) = curve->Weight(i);
    }
    TColStd_Array1OfReal heights(1, 2);
    heights(1) = low;
    heights(2) = high;
    TColStd_Array1OfInteger ends(1, 2);
    ends.Init(2);
    return new Geom_BSplineSurface(poles, weights, curve->Knots(), heights, curve->Multiplicities(), ends,
                                   curve->Degree(), 1, curve->IsPeriodic());
}

/// The curve as a B-spline; null for other curves.
Handle(Geom_BSplineCurve) spline_of(const Adaptor3d_Curve& curve) {
    switch (curve.GetType()) {
        case GeomAbs_BSplineCurve:
            return curve.BSpline();
        case GeomAbs_BezierCurve:
            return GeomConvert::CurveToBSplineCurve(curve.Bezier());
        default:
            return {};
    }
}

/// The surface as a B-spline with the same parameters; null for other surfaces. An extrusion is cut to the piece from
/// `low` to `high`.
Handle(Geom_BSplineSurface) spline_of(const BRepAdaptor_Surface& surface, double low, double high) {
    switch (surface.GetType()) {
        case GeomAbs_BSplineSurface:
            return surface.BSpline();
        case GeomAbs_BezierSurface:
            return GeomConvert::SurfaceToBSplineSurface(surface.Bezier());
        case GeomAbs_SurfaceOfExtrusion: {
            const Handle(Geom_BSplineCurve) curve = spline_of(*surface.BasisCurve());
            if (curve.IsNull()) {
                return {};
            }
            return extruded(curve, gp_Vec(surface.Direction()), low, high);
        }
        default:
            return {};
    }
}

/// One edge, prepared once for many points.
class EdgeDistance {
  public:
    explicit EdgeDistance(const TopoDS_Edge& edge) : curve_(edge), box_(box_of(edge)) {
        if (const Handle(Geom_BSplineCurve) spline = spline_of(curve_); !spline.IsNull()) {
            tree_.emplace(spline, curve_.FirstParameter(), curve_.LastParameter());
        } else {
            nearest_.Initialize(curve_, curve_.FirstParameter(), curve_.LastParameter());
        }
    }

    /// The smaller of `square`, the smallest known squared distance, and the squared distance from the inside of the
    /// edge.
    double measure(const Vec3& point, double square) {
        if (gap(box_, point).squaredNorm() >= square) {
            return square;
        }
        if (tree_) {
            return tree_->nearest(point, square, [](double, double) { return true; });
        }
        nearest_.Perform(gp_Pnt(point.x(), point.y(), point.z()));
        for (int i = 1; nearest_.IsDone() && i <= nearest_.NbExt(); ++i) {
            square = std::min(square, nearest_.SquareDistance(i));
        }
        return square;
    }

  private:
    BRepAdaptor_Curve curve_;
    Box box_;
    std::optional<PatchTree> tree_;  // for splines
    Extrema_ExtPC nearest_;          // for all others
};

/// One trimmed face: its inside, its edges and its vertices, each prepared once for many points.
class FaceDistance {
  public:
    explicit FaceDistance(const TopoDS_Face& face)
        : surface_(face, false), trimmed_(face, resolution(surface_, BRep_Tool::Tolerance(face))), box_(box_of(face)) {
        double u[2];
        double v[2];
        BRepTools::UVBounds(face, u[0], u[1], v[0], v[1]);
        if (const Handle(Geom_BSplineSurface) spline = spline_of(surface_, v[0], v[1]); !spline.IsNull()) {
            tree_.emplace(spline, ParameterBox{{u[0], v[0]}, {u[1], v[1]}});
        } else {
            inside_.SetFlag(Extrema_ExtFlag_MIN);
            inside_.Initialize(surface_, u[0], u[1], v[0], v[1], surface_.UResolution(Precision::Confusion()),
                               surface_.VResolution(Precision::Confusion()));
        }
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(face, TopAbs_EDGE, edges);
        for (int i = 1; i <= edges.Extent(); ++i) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
            if (!BRep_Tool::Degenerated(edge) && BRep_Tool::IsGeometric(edge)) {
                edges_.push_back(std::make_unique<EdgeDistance>(edge));
            }
        }
        TopTools_IndexedMapOfShape vertices;
        TopExp::MapShapes(face, TopAbs_VERTEX, vertices);
        for (int i = 1; i <= vertices.Extent(); ++i) {
            corners_.push_back(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i))));
        }
    }

    const Box& box() const { return box_; }
    /// The smaller of the squared distance and the smallest known one.
    double measure(const Vec3& point, double square) {
        const gp_Pnt p(point.x(), point.y(), point.z());
        for (const gp_Pnt& corner : corners_) {
            square = std::min(square, corner.SquareDistance(p));
        }
        square = measure_inside(point, square);
        for (const auto& edge : edges_) {
            square = edge->measure(point, square);
        }
        return square;
    }

  private:
    static double resolution(const BRepAdaptor_Surface& surface, double tolerance) {
        const double least = std::min(tolerance, Precision::Confusion());
        return std::max(Precision::PConfusion(), std::min(surface.UResolution(least), surface.VResolution(least)));
    }

    double measure_inside(const Vec3& point, double square) {
        if (tree_) {
            return tree_->nearest(point, square, [this](double u, double v) { return on_face(u, v); });
        }
        inside_.Perform(gp_Pnt(point.x(), point.y(), point.z()));
        for (int i = 1; inside_.IsDone() && i <= inside_.NbExt(); ++i) {
            double u = 0.0;
            double v = 0.0;
            inside_.Point(i).Parameter(u, v);
            if (inside_.SquareDistance(i) < square && on_face(u, v)) {
                square = inside_.SquareDistance(i);
            }
        }
        return square;
    }

    // Not BRepExtrema_ExtPF, whose classifier takes points inside of large plane faces with holes for outside.
    bool on_face(double u, double v) const {
        const TopAbs_State state = trimmed_.Perform(gp_Pnt2d(u, v));
        return state == TopAbs_IN || state == TopAbs_ON;
    }

    BRepAdaptor_Surface surface_;
    BRepTopAdaptor_FClass2d trimmed_;
    std::optional<PatchTree> tree_;  // for splines
    Extrema_ExtPS inside_;           // for all others
    std::vector<std::unique_ptr<EdgeDistance>> edges_;
    std::vector<gp_Pnt> corners_;
    Box box_;
};

/// The faces of a shape in a tree of boxes.
class ShapeDistance {
  public:
    ShapeDistance(const TopoDS_Shape& shape, Progress* progress) {
        TopTools_IndexedMapOfShape map;
        TopExp::MapShapes(shape, TopAbs_FACE, map);
        if (map.IsEmpty()) {
            throw InvalidInput(phrases::kNoFacesToMeasure);
        }
        for (int i = 1; i <= map.Extent(); ++i) {
            check_cancelled(progress);
            const OpenCascadeWait wait(progress, Message(phrases::kReading, {{"name", "Face" + std::to_string(i)}}));
            faces_.items.push_back(std::make_unique<FaceDistance>(TopoDS::Face(map(i))));
        }
        faces_.build(1);
    }

    /// The face that was nearest to the point before is tried first: it often is to the next point, too.
    double measure(const Vec3& point) {
        double square = faces_.items[last_]->measure(point, std::numeric_limits<double>::infinity());
        const std::size_t tried = last_;
        faces_.search(
            square, [&](const Bounds& bounds) { return gap(bounds.box, point).squaredNorm(); },
            [&](std::size_t face) {
                const double nearer = face == tried ? square : faces_.items[face]->measure(point, square);
                if (nearer < square) {
                    square = nearer;
                    last_ = face;
                }
            });
        return std::sqrt(square);
    }

  private:
    struct Bounds {
        Box box;
        void add(const std::unique_ptr<FaceDistance>& face) { box.add(face->box()); }
        static Vec3 position(const std::unique_ptr<FaceDistance>& face) { return face->box().center(); }
    };

    BoxTree<std::unique_ptr<FaceDistance>, Bounds> faces_;
    std::size_t last_ = 0;  // the face that was nearest
};

}  // namespace

std::vector<double> distances_to_faces(const TopoDS_Shape& shape, const std::vector<Vec3>& points, Progress* progress) {
    try {
        const double factor = scale_to_measure(shape);
        ShapeDistance faces(scaled(shape, factor), progress);
        std::vector<double> distances(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (progress != nullptr) {
                progress->check();
                progress->advance(static_cast<double>(i) / static_cast<double>(points.size()));
            }
            const OpenCascadeWait wait(progress, "measuring the distance");
            distances[i] = faces.measure(factor * points[i]) / factor;
        }
        return distances;
    } catch (const Standard_Failure& failure) {
        throw GeometryError(phrases::kKernelFails, {{"text", failure_text(failure)}});
    }
}

}  // namespace mq::geometry
