// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/shape_distance.h"

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
#include <Precision.hxx>
#include <Standard_Failure.hxx>
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
#include <string>

#include "base/error.h"

namespace mq::geometry {

namespace {

// OpenCASCADE's search for the nearest point takes 1e-7 mm for nothing: it misses points on parts not much larger than
// that, and does not come that near on parts of a kilometre. Parts beyond these sizes, in mm, are measured scaled to
// them.
constexpr double kLeastSize = 10.0;
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

/// A box around a shape.
class BoundingBox {
  public:
    explicit BoundingBox(const TopoDS_Shape& shape) {
        Bnd_Box box;
        BRepBndLib::Add(shape, box, false);
        box.Get(low_[0], low_[1], low_[2], high_[0], high_[1], high_[2]);
    }

    /// Never more than the distance of what is inside.
    double distance(const Vec3& p) const { return (low_ - p).cwiseMax(p - high_).cwiseMax(0.0).norm(); }

  private:
    Vec3 low_;
    Vec3 high_;
};

/// One edge, prepared once for many points.
class EdgeDistance {
  public:
    explicit EdgeDistance(const TopoDS_Edge& edge) : curve_(edge), box_(edge) {
        nearest_.Initialize(curve_, curve_.FirstParameter(), curve_.LastParameter());
    }

    /// The smaller of the squared distance from the inside of the edge and of what is known.
    double measure(const Vec3& point, double square) {
        if (const double bound = box_.distance(point); bound * bound >= square) {
            return square;
        }
        nearest_.Perform(gp_Pnt(point.x(), point.y(), point.z()));
        for (int i = 1; nearest_.IsDone() && i <= nearest_.NbExt(); ++i) {
            square = std::min(square, nearest_.SquareDistance(i));
        }
        return square;
    }

  private:
    BRepAdaptor_Curve curve_;
    BoundingBox box_;
    Extrema_ExtPC nearest_;
};

/// One trimmed face: its inside, its edges and its vertices, each prepared once for many points.
class FaceDistance {
  public:
    explicit FaceDistance(const TopoDS_Face& face)
        : surface_(face, false), trimmed_(face, resolution(surface_, BRep_Tool::Tolerance(face))), box_(face) {
        double u[2];
        double v[2];
        BRepTools::UVBounds(face, u[0], u[1], v[0], v[1]);
        inside_.SetFlag(Extrema_ExtFlag_MIN);
        inside_.Initialize(surface_, u[0], u[1], v[0], v[1], surface_.UResolution(Precision::Confusion()),
                           surface_.VResolution(Precision::Confusion()));
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

    /// Never more than the distance.
    double lower_bound(const Vec3& point) const { return box_.distance(point); }
    double measure(const Vec3& point) {
        const gp_Pnt p(point.x(), point.y(), point.z());
        double square = std::numeric_limits<double>::infinity();
        for (const gp_Pnt& corner : corners_) {
            square = std::min(square, corner.SquareDistance(p));
        }
        inside_.Perform(p);
        for (int i = 1; inside_.IsDone() && i <= inside_.NbExt(); ++i) {
            if (inside_.SquareDistance(i) < square && on_face(inside_.Point(i))) {
                square = inside_.SquareDistance(i);
            }
        }
        for (const auto& edge : edges_) {
            square = edge->measure(point, square);
        }
        return std::sqrt(square);
    }

  private:
    static double resolution(const BRepAdaptor_Surface& surface, double tolerance) {
        const double least = std::min(tolerance, Precision::Confusion());
        return std::max(Precision::PConfusion(), std::min(surface.UResolution(least), surface.VResolution(least)));
    }

    // Not by BRepExtrema_ExtPF: its classifier takes points inside of large plane faces with holes for outside.
    bool on_face(const Extrema_POnSurf& foot) const {
        double u = 0.0;
        double v = 0.0;
        foot.Parameter(u, v);
        const TopAbs_State state = trimmed_.Perform(gp_Pnt2d(u, v));
        return state == TopAbs_IN || state == TopAbs_ON;
    }

    BRepAdaptor_Surface surface_;
    BRepTopAdaptor_FClass2d trimmed_;
    Extrema_ExtPS inside_;
    std::vector<std::unique_ptr<EdgeDistance>> edges_;
    std::vector<gp_Pnt> corners_;
    BoundingBox box_;
};

/// `start`: the face to try first; becomes the nearest one, which often is the next point's too.
double nearest(std::vector<std::unique_ptr<FaceDistance>>& faces, const Vec3& point, std::size_t& start,
               std::vector<std::pair<double, std::size_t>>& order) {
    double best = faces[start]->measure(point);
    order.clear();
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const double bound = faces[f]->lower_bound(point);
        if (f != start && bound < best) {
            order.emplace_back(bound, f);
        }
    }
    std::sort(order.begin(), order.end());
    for (const auto& [bound, f] : order) {
        if (bound >= best) {
            break;
        }
        const double distance = faces[f]->measure(point);
        if (distance < best) {
            best = distance;
            start = f;
        }
    }
    return best;
}

}  // namespace

std::vector<double> distances_to_faces(const TopoDS_Shape& shape, const std::vector<Vec3>& points, Progress* progress) {
    try {
        const double factor = scale_to_measure(shape);
        TopTools_IndexedMapOfShape map;
        TopExp::MapShapes(scaled(shape, factor), TopAbs_FACE, map);
        std::vector<std::unique_ptr<FaceDistance>> faces;
        for (int i = 1; i <= map.Extent(); ++i) {
            faces.push_back(std::make_unique<FaceDistance>(TopoDS::Face(map(i))));
        }
        if (faces.empty()) {
            throw InvalidInput("the shape to measure against has no faces");
        }
        std::vector<double> distances(points.size());
        std::size_t start = 0;
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (progress != nullptr) {
                progress->check();
                progress->advance(static_cast<double>(i) / static_cast<double>(points.size()));
            }
            distances[i] = nearest(faces, factor * points[i], start, order) / factor;
        }
        return distances;
    } catch (const Standard_Failure& failure) {
        throw GeometryError(std::string("the distance to the shape cannot be measured: ") + failure.GetMessageString());
    }
}

}  // namespace mq::geometry
