// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/inside_out.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepClass3d_SolidExplorer.hxx>
#include <Bnd_Box.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <gp_Lin.hxx>
#include <limits>
#include <vector>

#include "geometry/occt/evaluation/conversion.h"

namespace mq::geometry {

namespace {

/// A face and a box around it.
struct BoxedFace {
    TopoDS_Face face;
    Box box;
    bool plane;
};

std::vector<BoxedFace> boxed_faces(const TopoDS_Shape& solid) {
    std::vector<BoxedFace> result;
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
        const TopoDS_Face& face = TopoDS::Face(faces.Current());
        Bnd_Box bounds;
        BRepBndLib::Add(face, bounds, Standard_False);
        if (bounds.IsVoid() || bounds.IsOpen() ||
            (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED)) {
            return {};
        }
        result.push_back({face, to_box(bounds), BRepAdaptor_Surface(face, Standard_False).GetType() == GeomAbs_Plane});
    }
    return result;
}

bool meets(const Box& box, const gp_Lin& ray) {
    const Vec3 origin = to_vec(ray.Location());
    const Vec3 along = to_vec(ray.Direction());
    double from = 0.0;
    double to = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (along[axis] == 0.0) {
            if (origin[axis] < box.low[axis] || origin[axis] > box.high[axis]) {
                return false;
            }
            continue;
        }
        const double a = (box.low[axis] - origin[axis]) / along[axis];
        const double b = (box.high[axis] - origin[axis]) / along[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

/// Whether a ray from a point of a face, on its outer side, meets no face.
bool sees_nothing(const BoxedFace& start, const std::vector<BoxedFace>& faces, double size) {
    // Crossings within this length from the start of the ray do not count; a fraction of the size.
    constexpr double kStart = 1e-6;
    gp_Pnt point;
    double u = 0.0;
    double v = 0.0;
    double share =
        0.512345;  // the position on an edge at which OpenCASCADE starts to look for a point: not a special one
    gp_Vec su;
    gp_Vec sv;
    if (!BRepClass3d_SolidExplorer::FindAPointInTheFace(start.face, point, u, v, share, su, sv)) {
        return false;
    }
    const gp_Vec normal = su.Crossed(sv) * (start.face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0);
    if (!(normal.Magnitude() > gp::Resolution())) {
        return false;
    }
    const gp_Lin ray(point, gp_Dir(normal));
    return std::none_of(faces.begin(), faces.end(), [&](const BoxedFace& other) {
        const bool itself = other.face.IsSame(start.face);
        if ((itself && start.plane) || !meets(other.box, ray)) {
            return false;
        }
        IntCurvesFace_Intersector intersector(other.face, Precision::Confusion(), Standard_True, Standard_False);
        intersector.Perform(ray, itself ? kStart * size : 0.0, Precision::Infinite());
        return !intersector.IsDone() || intersector.NbPnt() > 0;
    });
}

bool any_sees_nothing(const TopoDS_Shape& solid) {
    // Number of faces from which a ray is tried.
    constexpr std::size_t kTries = 3;
    const std::vector<BoxedFace> faces = boxed_faces(solid);
    Box box;
    for (const BoxedFace& face : faces) {
        box.add(face.box);
    }
    // Planes come first, and among them faces in a thin layer at a side of the box: no face lies in front of these.
    const auto depth = [&](const BoxedFace& face) {
        return std::min((face.box.high - box.low).minCoeff(), (box.high - face.box.low).minCoeff());
    };
    const std::size_t tries = std::min(kTries, faces.size());
    std::vector<BoxedFace> first(tries);
    std::partial_sort_copy(
        faces.begin(), faces.end(), first.begin(), first.end(),
        [&](const BoxedFace& a, const BoxedFace& b) { return a.plane != b.plane ? a.plane : depth(a) < depth(b); });
    return std::any_of(first.begin(), first.end(),
                       [&](const BoxedFace& face) { return sees_nothing(face, faces, (box.high - box.low).norm()); });
}

}  // namespace

bool looks_outward(const TopoDS_Shape& solid) {
    try {
        return any_sees_nothing(solid);
    } catch (const Standard_Failure&) {
        return false;
    }
}

bool is_inside_out(const TopoDS_Shape& solid) {
    BRepClass3d_SolidClassifier classifier(solid);
    classifier.PerformInfinitePoint(Precision::Confusion());
    return classifier.State() == TopAbs_IN;
}

}  // namespace mq::geometry
