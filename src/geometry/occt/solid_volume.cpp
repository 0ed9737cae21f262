// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/solid_volume.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Pnt2d.hxx>
#include <gp_Vec2d.hxx>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/waits.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/failure_text.h"

namespace mq::geometry {

namespace {

/// The rule of Gauss and Kronrod with 7 and 15 points (Kronrod 1965): places from 0 on and the weights of both.
constexpr std::array<double, 8> kPlaces{0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
                                        0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
                                        0.586087235467691130294144691693470, 0.405845151377397166906606412076961,
                                        0.207784955007898467600689403773245, 0.0};
constexpr std::array<double, 8> kKronrod{0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
                                         0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
                                         0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
                                         0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
constexpr std::array<double, 4> kGauss{0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
                                       0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

/// An integral and its error; the integral of the absolute value, relative to which the error is bounded; and that of
/// the magnitudes of the integrand's terms, which bounds rounding even where the terms cancel.
struct Integral {
    double value = 0.0;
    double error = 0.0;
    double absolute = 0.0;
    double of_terms = 0.0;

    void operator+=(const Integral& other) {
        value += other.value;
        error += other.error;
        absolute += other.absolute;
        of_terms += other.of_terms;
    }
};

/// The integrand at a point.
struct Sample {
    double value = 0.0;
    double terms = 0.0;  ///< sum of the magnitudes of its terms
};

template <typename Function>
Integral by_rule(const Function& f, double low, double high) {
    const double middle = 0.5 * (low + high);
    const double half = 0.5 * (high - low);
    Integral found;
    double coarse = 0.0;
    for (std::size_t i = 0; i < kPlaces.size(); ++i) {
        for (const double sign : {-1.0, 1.0}) {
            if (sign > 0.0 && kPlaces[i] == 0.0) {
                continue;
            }
            const Sample at = f(middle + sign * half * kPlaces[i]);
            found.value += half * kKronrod[i] * at.value;
            found.absolute += std::abs(half * kKronrod[i] * at.value);
            found.of_terms += std::abs(half * kKronrod[i] * at.terms);
            coarse += i % 2 == 1 ? half * kGauss[i / 2] * at.value : 0.0;
        }
    }
    found.error = std::abs(found.value - coarse);
    return found;
}

/// Fraction of the terms' size by which an integrand is rounded at most: no halving makes that less.
constexpr double kIntegrandRounding = 0x1p-46;

/// Halves the interval until the error is at most `allowed` or, if `allowed` < 0, -`allowed` times the integral of the
/// absolute value over the whole interval; or as small as rounding.
template <typename Function>
Integral adaptive(const Function& f, double low, double high, double allowed, int halvings) {
    const Integral whole = by_rule(f, low, high);
    const double most =
        std::max(allowed > 0.0 ? allowed : -allowed * whole.absolute, kIntegrandRounding * whole.of_terms);
    if (whole.error <= most || halvings == 0) {
        return whole;
    }
    const double middle = 0.5 * (low + high);
    Integral found = adaptive(f, low, middle, std::max(0.5 * most, 1e-300), halvings - 1);
    found += adaptive(f, middle, high, std::max(0.5 * most, 1e-300), halvings - 1);
    return found;
}

/// Fraction of the integral of the absolute value along an edge that its error may be.
constexpr double kAccuracy = 1e-7;
constexpr int kHalvings = 10;

/// `low`, the numbers of `breaks` between `low` and `high`, and `high`.
std::vector<double> pieces(const TColStd_Array1OfReal& breaks, double low, double high) {
    std::vector<double> found{low};
    for (int i = breaks.Lower(); i <= breaks.Upper(); ++i) {
        if (breaks(i) > found.back() && breaks(i) < high) {
            found.push_back(breaks(i));
        }
    }
    found.push_back(high);
    return found;
}

/// A third of the flux of the distance from a point through a trimmed face, by Green's theorem in its (u, v): the
/// integral over u, from the least one of the face on, is integrated by v along the face's curves.
class FaceFlux {
  public:
    FaceFlux(const TopoDS_Face& face, const Vec3& from) : face_(face), surface_(face, false), from_(from) {
        double v[2];
        BRepTools::UVBounds(face, low_, high_, v[0], v[1]);
        const int count = surface_.NbUIntervals(GeomAbs_CN);
        TColStd_Array1OfReal breaks(1, count + 1);
        surface_.UIntervals(breaks, GeomAbs_CN);
        for (int i = 1; i <= count + 1; ++i) {
            breaks_.push_back(breaks(i));
        }
    }

    Integral along(const TopoDS_Edge& edge) const {
        double first = 0.0;
        double last = 0.0;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face_, first, last);
        if (curve.IsNull() || !(first < last)) {
            return {};
        }
        const Geom2dAdaptor_Curve adaptor(curve, first, last);
        const int count = adaptor.NbIntervals(GeomAbs_CN);
        TColStd_Array1OfReal breaks(1, count + 1);
        adaptor.Intervals(breaks, GeomAbs_CN);
        double inner_error = 0.0;
        double rise = 0.0;
        const auto integrand = [&](double t) {
            gp_Pnt2d at;
            gp_Vec2d by_t;
            adaptor.D1(t, at, by_t);
            if (by_t.Y() == 0.0) {
                return Sample{};
            }
            const Integral across = over_u(at.X(), at.Y());
            inner_error = std::max(inner_error, across.error);
            rise = std::max(rise, std::abs(by_t.Y()));
            // Along parameter lines the range of the integral over u, or the derivative of v, is mere rounding of
            // coordinates as large as the face.
            const double terms = across.of_terms + flux(at.X(), at.Y()).terms * (high_ - low_);
            return Sample{across.value * by_t.Y(), terms * by_t.Magnitude()};
        };
        Integral found;
        const std::vector<double> parts = pieces(breaks, first, last);
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
            found += adaptive(integrand, parts[i], parts[i + 1], -kAccuracy, kHalvings);
        }
        found.error += inner_error * rise * (last - first);
        found.value *= edge.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
        return found;
    }

  private:
    Sample flux(double u, double v) const {
        gp_Pnt point;
        gp_Vec by_u;
        gp_Vec by_v;
        surface_.D1(u, v, point, by_u, by_v);
        const Vec3 away = to_vec(point) - from_;
        const Vec3 area = to_vec(by_u).cross(to_vec(by_v));
        return {away.dot(area) / 3.0, away.norm() * area.norm() / 3.0};
    }

    Integral over_u(double to, double v) const {
        const double low = std::min(low_, to);
        const double high = std::max(low_, to);
        Integral found;
        double last = low;
        const auto add = [&](double next) {
            found += adaptive([&](double u) { return flux(u, v); }, last, next, -0.1 * kAccuracy, kHalvings / 2);
            last = next;
        };
        for (const double at : breaks_) {
            if (at > last && at < high) {
                add(at);
            }
        }
        add(high);
        found.value *= to < low_ ? -1.0 : 1.0;
        return found;
    }

    TopoDS_Face face_;
    BRepAdaptor_Surface surface_;
    Vec3 from_;
    double low_ = 0.0;
    double high_ = 0.0;
    std::vector<double> breaks_;
};

Integral volume_of(const TopoDS_Shape& solid, const Progress* progress) {
    Bnd_Box box;
    BRepBndLib::Add(solid, box, false);
    if (box.IsVoid()) {
        return {};
    }
    const Vec3 middle = 0.5 * (to_vec(box.CornerMin()) + to_vec(box.CornerMax()));
    const double reach = 0.5 * std::sqrt(box.SquareExtent());
    Integral sum;
    for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
        check_cancelled(progress);
        if (face.Current().Orientation() != TopAbs_FORWARD && face.Current().Orientation() != TopAbs_REVERSED) {
            continue;  // a face inside, which bounds nothing
        }
        const double sign = face.Current().Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
        const TopoDS_Face forward = TopoDS::Face(face.Current().Oriented(TopAbs_FORWARD));
        const FaceFlux flux(forward, middle);
        for (TopExp_Explorer edge(forward, TopAbs_EDGE); edge.More(); edge.Next()) {
            if (edge.Current().Orientation() != TopAbs_FORWARD && edge.Current().Orientation() != TopAbs_REVERSED) {
                continue;
            }
            Integral part = flux.along(TopoDS::Edge(edge.Current()));
            part.value *= sign;
            sum += part;
        }
    }
    // Faces meet within the tolerance of their edges: a gap as wide as the tolerance changes the volume by that of the
    // cone from the middle over the gap.
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(solid, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        if (!BRep_Tool::Degenerated(edge) && BRep_Tool::IsGeometric(edge)) {
            const BRepAdaptor_Curve curve(edge);
            sum.error += BRep_Tool::Tolerance(edge) * GCPnts_AbscissaPoint::Length(curve, 1e-3 * reach) * reach / 3.0;
        }
    }
    return sum;
}

}  // namespace

SolidContent solid_content(const TopoDS_Shape& shape, const Progress* progress) {
    try {
        TopTools_IndexedMapOfShape solids;
        TopExp::MapShapes(shape, TopAbs_SOLID, solids);
        SolidContent content;
        for (int i = 1; i <= solids.Extent(); ++i) {
            check_cancelled(progress);
            const OpenCascadeWait wait(progress,
                                       Message(phrases::kMeasuringVolume, {{"name", "Solid" + std::to_string(i)}}));
            const Integral own = volume_of(solids(i), progress);
            content.volume += std::abs(own.value);
            content.error += own.error;
        }
        return content;
    } catch (const Standard_Failure& failure) {
        throw GeometryError(phrases::kKernelFails, {{"text", failure_text(failure)}});
    }
}

}  // namespace mq::geometry
