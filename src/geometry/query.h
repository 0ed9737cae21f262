// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/vec.h"

/// Queries to the geometry engine, and its answers, as plain values that cross threads by copy.
namespace mq::geometry {

struct Query {
    enum class Kind {
        EdgePoint,        ///< index = edge, t: point; normal = the (unnormalised) derivative dC/dt
        EdgeMiddle,       ///< index = edge, t, t2: the t that halves the arc between them; point
        EdgeAtDistance,   ///< index = edge, t, t2, distance: t between them at that straight distance from C(t); point
        EdgeNearest,      ///< index = edge, t = a guess, t and u, v = range [u, v]; point: nearest t; point, distance
        EdgeLength,       ///< index = edge, t, t2: arc length in `distance`
        UseOnFace,        ///< index = use, t: (u, v) on the use's face; point of the surface there, outward unit normal
        FacePoint,        ///< index = face, u, v: point, outward unit normal
        FaceDerivatives,  ///< index = face, u, v: as FacePoint, and derivatives
        FaceCurvatures,   ///< index = face, u, v: as FacePoint, principal curvatures in u, v (1/mm, |u| >= |v|)
        FaceNearest,      ///< index = face, point, u, v = a guess: local Newton, global search when it fails
        FaceNearestGlobal,  ///< index = face, point: nearest point of the (untrimmed) surface within the face's bounds
        FaceOnLine,         ///< index = face, point, along = unit direction of a line, u, v = a guess: point of the
                     ///< (untrimmed) surface on the line by Newton's method, outward unit normal; t = its place along
                     ///< the line
        FaceContains,    ///< index = face, u, v: `side` 1 inside the trimmed face, 0 on its border, -1 outside;
                         ///< distance = half the width of the border at most, mm, 0: its tolerance
        VolumeContains,  ///< index = volume, point: `side` likewise
    };
    Kind kind = Kind::FacePoint;
    int index = -1;
    double u = 0.0;
    double v = 0.0;
    double t = 0.0;
    double t2 = 0.0;
    double distance = 0.0;
    Vec3 point = Vec3::Zero();
    Vec3 along = Vec3::Zero();

    static Query edge_point(int edge, double t);
    static Query edge_middle(int edge, double t, double t2);
    static Query edge_at_distance(int edge, double from, double to, double distance);
    static Query edge_nearest(int edge, const Vec3& point, double guess, double low, double high);
    static Query edge_length(int edge, double t, double t2);
    static Query use_on_face(int use, double t);
    static Query face_point(int face, double u, double v);
    static Query face_derivatives(int face, double u, double v);
    static Query face_curvatures(int face, double u, double v);
    static Query face_nearest(int face, const Vec3& point, double u, double v);
    static Query face_nearest_global(int face, const Vec3& point);
    static Query face_on_line(int face, const Vec3& point, const Vec3& along, double u, double v);
    static Query face_contains(int face, double u, double v, double border = 0.0);
    static Query volume_contains(int volume, const Vec3& point);
};

/// A failed query is a value too. The caller decides how to treat a failure.
enum class Status {
    Ok,
    NotFound,       ///< no such point: the search did not converge, or the range holds none
    Singular,       ///< the point is right, but the surface has no normal there (pole, apex, cusp); normal is zero
    BadQuery,       ///< an index or a parameter out of range, or not a number
    KernelFailure,  ///< the modeler raised an exception
    Stopped,        ///< the engine was shut down or the batch cancelled before the query was answered
};

const char* to_string(Status status);

struct Answer {
    Status status = Status::Stopped;
    int side = 0;
    double u = 0.0;
    double v = 0.0;
    double t = 0.0;
    double distance = 0.0;
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    /// Su, Sv, Suu, Suv, Svv, for queries of derivatives only: most answers are small without.
    std::vector<Vec3> derivatives{};

    /// Whether the point is valid; the normal too unless the surface is singular there.
    bool found() const { return status == Status::Ok || status == Status::Singular; }
};

}  // namespace mq::geometry
