// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/stream/stream_geometry.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_Parabola.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <gp_Ax2.hxx>
#include <gp_Ax22d.hxx>
#include <gp_Ax2d.hxx>
#include <gp_Ax3.hxx>

namespace mq::geometry {

namespace {

// The numbers of types are those of OpenCASCADE's BinTools_Curve2dSet, BinTools_CurveSet and BinTools_SurfaceSet.
enum class CurveType : char { Line = 1, Circle, Ellipse, Parabola, Hyperbola, Bezier, BSpline, Trimmed, Offset };
enum class SurfaceType : char {
    Plane = 1,
    Cylinder,
    Cone,
    Sphere,
    Torus,
    Extrusion,
    Revolution,
    Bezier,
    BSpline,
    Trimmed,
    Offset
};

constexpr int kDeepest = 32;  // curves and surfaces in one another, such as the trimmed offset of an extrusion
constexpr std::size_t kKnotBytes = sizeof(double) + sizeof(std::int32_t);

void require_depth(int depth) {
    if (depth > kDeepest) {
        ByteReader::refuse("its geometry is nested too deeply");
    }
}

int at_least_one(int count) {
    if (count < 1) {
        ByteReader::refuse("a spline has no poles or no knots");
    }
    return count;
}

/// The written order is location, Z, X, Y; in memory Y comes before X.
template <typename Frame>
Frame read_frame(ByteReader& bytes) {
    std::array<double, 12> numbers = bytes.numbers<12>();
    std::swap_ranges(numbers.begin() + 6, numbers.begin() + 9, numbers.begin() + 9);
    return with_bits<Frame>(numbers);
}

gp_Ax22d read_plane_frame(ByteReader& bytes) {
    std::array<double, 6> numbers = bytes.numbers<6>();
    std::swap_ranges(numbers.begin() + 2, numbers.begin() + 4, numbers.begin() + 4);
    return with_bits<gp_Ax22d>(numbers);
}

struct Knots {
    explicit Knots(int count) : values(1, at_least_one(count)), multiplicities(1, count) {}
    void read(ByteReader& bytes) {
        for (int i = values.Lower(); i <= values.Upper(); ++i) {
            values(i) = bytes.get<double>();
            multiplicities(i) = bytes.get<std::int32_t>();
        }
    }
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
};

/// Poles of a curve, each with its weight where it is rational.
template <typename Points>
struct Poles {
    Poles(int count, bool is_rational) : points(1, at_least_one(count)), weights(1, count), rational(is_rational) {}
    void read(ByteReader& bytes) {
        for (int i = points.Lower(); i <= points.Upper(); ++i) {
            points(i) = read_bits<typename Points::value_type>(bytes);
            weights(i) = rational ? bytes.get<double>() : 1.0;
        }
    }
    Points points;
    TColStd_Array1OfReal weights;
    bool rational;
};

template <typename Curve, typename Points>
opencascade::handle<Curve> read_bezier_curve(ByteReader& bytes) {
    const bool rational = bytes.flag();
    Poles<Points> poles(bytes.get<std::uint16_t>() + 1, rational);
    poles.read(bytes);
    return rational ? new Curve(poles.points, poles.weights) : new Curve(poles.points);
}

template <typename Curve, typename Points>
opencascade::handle<Curve> read_spline_curve(ByteReader& bytes) {
    const bool rational = bytes.flag();
    const bool periodic = bytes.flag();
    const int degree = bytes.get<std::uint16_t>();
    const int pole_count = bytes.count(sizeof(typename Points::value_type));
    const int knot_count = bytes.count(kKnotBytes);
    Poles<Points> poles(pole_count, rational);
    poles.read(bytes);
    Knots knots(knot_count);
    knots.read(bytes);
    return rational ? new Curve(poles.points, poles.weights, knots.values, knots.multiplicities, degree, periodic)
                    : new Curve(poles.points, knots.values, knots.multiplicities, degree, periodic);
}

/// What differs between curves in the plane and in space.
struct PlaneKind {
    using Curve = Geom2d_Curve;
    using Axis = gp_Ax2d;
    using Line = Geom2d_Line;
    using Circle = Geom2d_Circle;
    using Ellipse = Geom2d_Ellipse;
    using Parabola = Geom2d_Parabola;
    using Hyperbola = Geom2d_Hyperbola;
    using Bezier = Geom2d_BezierCurve;
    using BSpline = Geom2d_BSplineCurve;
    using Trimmed = Geom2d_TrimmedCurve;
    using Points = TColgp_Array1OfPnt2d;
    static gp_Ax22d frame(ByteReader& bytes) { return read_plane_frame(bytes); }
};

struct SpaceKind {
    using Curve = Geom_Curve;
    using Axis = gp_Ax1;
    using Line = Geom_Line;
    using Circle = Geom_Circle;
    using Ellipse = Geom_Ellipse;
    using Parabola = Geom_Parabola;
    using Hyperbola = Geom_Hyperbola;
    using Bezier = Geom_BezierCurve;
    using BSpline = Geom_BSplineCurve;
    using Trimmed = Geom_TrimmedCurve;
    using Points = TColgp_Array1OfPnt;
    static gp_Ax2 frame(ByteReader& bytes) { return read_frame<gp_Ax2>(bytes); }
};

template <typename Kind>
opencascade::handle<typename Kind::Curve> any_curve(ByteReader& bytes, int depth);

/// Offset curves were accepted as they are when they were made: whether they are smooth is not checked again.
template <typename Kind>
opencascade::handle<typename Kind::Curve> offset_curve(ByteReader& bytes, int depth) {
    const double distance = bytes.get<double>();
    if constexpr (std::is_same_v<Kind, SpaceKind>) {
        const gp_Dir direction = read_bits<gp_Dir>(bytes);
        return new Geom_OffsetCurve(any_curve<Kind>(bytes, depth + 1), distance, direction, true);
    } else {
        return new Geom2d_OffsetCurve(any_curve<Kind>(bytes, depth + 1), distance, true);
    }
}

/// Ends of a trimmed curve stay in the period in which they are.
template <typename Kind>
opencascade::handle<typename Kind::Curve> trimmed_curve(ByteReader& bytes, int depth) {
    const auto [first, last] = bytes.numbers<2>();
    return new typename Kind::Trimmed(any_curve<Kind>(bytes, depth + 1), first, last, true, false);
}

template <typename Conic, typename Frame>
opencascade::handle<Conic> conic_of_two_radii(const Frame& frame, ByteReader& bytes) {
    const auto [major, minor] = bytes.numbers<2>();
    return new Conic(frame, major, minor);
}

template <typename Kind>
opencascade::handle<typename Kind::Curve> any_curve(ByteReader& bytes, int depth) {
    require_depth(depth);
    switch (static_cast<CurveType>(bytes.get<char>())) {
        case CurveType::Line:
            return new typename Kind::Line(read_bits<typename Kind::Axis>(bytes));
        case CurveType::Circle: {
            const auto frame = Kind::frame(bytes);
            return new typename Kind::Circle(frame, bytes.get<double>());
        }
        case CurveType::Ellipse:
            return conic_of_two_radii<typename Kind::Ellipse>(Kind::frame(bytes), bytes);
        case CurveType::Parabola: {
            const auto frame = Kind::frame(bytes);
            return new typename Kind::Parabola(frame, bytes.get<double>());
        }
        case CurveType::Hyperbola:
            return conic_of_two_radii<typename Kind::Hyperbola>(Kind::frame(bytes), bytes);
        case CurveType::Bezier:
            return read_bezier_curve<typename Kind::Bezier, typename Kind::Points>(bytes);
        case CurveType::BSpline:
            return read_spline_curve<typename Kind::BSpline, typename Kind::Points>(bytes);
        case CurveType::Trimmed:
            return trimmed_curve<Kind>(bytes, depth);
        case CurveType::Offset:
            return offset_curve<Kind>(bytes, depth);
    }
    ByteReader::refuse("a curve has an unknown type");
}

/// Poles of a surface, each with its weight where it is rational.
struct PoleGrid {
    PoleGrid(int rows, int columns, bool is_rational)
        : points(1, at_least_one(rows), 1, at_least_one(columns)),
          weights(1, rows, 1, columns),
          rational(is_rational) {}
    void read(ByteReader& bytes) {
        for (int i = 1; i <= points.UpperRow(); ++i) {
            for (int j = 1; j <= points.UpperCol(); ++j) {
                points(i, j) = read_bits<gp_Pnt>(bytes);
                weights(i, j) = rational ? bytes.get<double>() : 1.0;
            }
        }
    }
    TColgp_Array2OfPnt points;
    TColStd_Array2OfReal weights;
    bool rational;
};

PoleGrid read_grid(ByteReader& bytes, int rows, int columns, bool rational) {
    bytes.checked(std::int64_t{rows} * columns, sizeof(gp_Pnt));
    PoleGrid grid(rows, columns, rational);
    grid.read(bytes);
    return grid;
}

Handle(Geom_Surface) read_bezier_surface(ByteReader& bytes) {
    const bool rational_u = bytes.flag();
    const bool rational_v = bytes.flag();
    const int rows = bytes.get<std::uint16_t>() + 1;
    const int columns = bytes.get<std::uint16_t>() + 1;
    const PoleGrid grid = read_grid(bytes, rows, columns, rational_u || rational_v);
    return grid.rational ? new Geom_BezierSurface(grid.points, grid.weights) : new Geom_BezierSurface(grid.points);
}

Handle(Geom_Surface) read_spline_surface(ByteReader& bytes) {
    const bool rational_u = bytes.flag();
    const bool rational_v = bytes.flag();
    const bool periodic_u = bytes.flag();
    const bool periodic_v = bytes.flag();
    const int degree_u = bytes.get<std::uint16_t>();
    const int degree_v = bytes.get<std::uint16_t>();
    const int rows = bytes.count(1);
    const int columns = bytes.count(1);
    const int knots_u = bytes.count(kKnotBytes);
    const int knots_v = bytes.count(kKnotBytes);
    const PoleGrid grid = read_grid(bytes, rows, columns, rational_u || rational_v);
    Knots u(knots_u);
    u.read(bytes);
    Knots v(knots_v);
    v.read(bytes);
    if (grid.rational) {
        return new Geom_BSplineSurface(grid.points, grid.weights, u.values, v.values, u.multiplicities,
                                       v.multiplicities, degree_u, degree_v, periodic_u, periodic_v);
    }
    return new Geom_BSplineSurface(grid.points, u.values, v.values, u.multiplicities, v.multiplicities, degree_u,
                                   degree_v, periodic_u, periodic_v);
}

Handle(Geom_Surface) any_surface(ByteReader& bytes, int depth);

Handle(Geom_Surface) elementary_surface(SurfaceType type, ByteReader& bytes) {
    const auto frame = read_frame<gp_Ax3>(bytes);
    if (type == SurfaceType::Plane) {
        return new Geom_Plane(frame);
    }
    const double radius = bytes.get<double>();
    switch (type) {
        case SurfaceType::Cylinder:
            return new Geom_CylindricalSurface(frame, radius);
        case SurfaceType::Cone:
            return new Geom_ConicalSurface(frame, bytes.get<double>(), radius);
        case SurfaceType::Sphere:
            return new Geom_SphericalSurface(frame, radius);
        default:
            return new Geom_ToroidalSurface(frame, radius, bytes.get<double>());
    }
}

/// A surface that another one, or a curve, makes.
Handle(Geom_Surface) derived_surface(SurfaceType type, ByteReader& bytes, int depth) {
    if (type == SurfaceType::Extrusion) {
        const auto direction = read_bits<gp_Dir>(bytes);
        return new Geom_SurfaceOfLinearExtrusion(any_curve<SpaceKind>(bytes, depth + 1), direction);
    }
    if (type == SurfaceType::Revolution) {
        const auto axis = read_bits<gp_Ax1>(bytes);
        return new Geom_SurfaceOfRevolution(any_curve<SpaceKind>(bytes, depth + 1), axis);
    }
    if (type == SurfaceType::Trimmed) {
        const auto [u0, u1, v0, v1] = bytes.numbers<4>();
        return new Geom_RectangularTrimmedSurface(any_surface(bytes, depth + 1), u0, u1, v0, v1);
    }
    const double distance = bytes.get<double>();
    return new Geom_OffsetSurface(any_surface(bytes, depth + 1), distance, true);
}

Handle(Geom_Surface) any_surface(ByteReader& bytes, int depth) {
    require_depth(depth);
    const auto type = static_cast<SurfaceType>(bytes.get<char>());
    switch (type) {
        case SurfaceType::Plane:
        case SurfaceType::Cylinder:
        case SurfaceType::Cone:
        case SurfaceType::Sphere:
        case SurfaceType::Torus:
            return elementary_surface(type, bytes);
        case SurfaceType::Bezier:
            return read_bezier_surface(bytes);
        case SurfaceType::BSpline:
            return read_spline_surface(bytes);
        case SurfaceType::Extrusion:
        case SurfaceType::Revolution:
        case SurfaceType::Trimmed:
        case SurfaceType::Offset:
            return derived_surface(type, bytes, depth);
    }
    ByteReader::refuse("a surface has an unknown type");
}

}  // namespace

Handle(Geom2d_Curve) read_plane_curve(ByteReader& bytes) {
    return any_curve<PlaneKind>(bytes, 0);
}

Handle(Geom_Curve) read_curve(ByteReader& bytes) {
    return any_curve<SpaceKind>(bytes, 0);
}

Handle(Geom_Surface) read_surface(ByteReader& bytes) {
    return any_surface(bytes, 0);
}

}  // namespace mq::geometry
