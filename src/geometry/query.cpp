// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/query.h"

namespace mq::geometry {

namespace {

Query make(Query::Kind kind, int index) {
    Query query;
    query.kind = kind;
    query.index = index;
    return query;
}

Query on_face(Query::Kind kind, int face, double u, double v) {
    Query query = make(kind, face);
    query.u = u;
    query.v = v;
    return query;
}

}  // namespace

Query Query::edge_point(int edge, double t) {
    Query query = make(Kind::EdgePoint, edge);
    query.t = t;
    return query;
}

Query Query::edge_middle(int edge, double t, double t2) {
    Query query = make(Kind::EdgeMiddle, edge);
    query.t = t;
    query.t2 = t2;
    return query;
}

Query Query::edge_at_distance(int edge, double from, double to, double distance) {
    Query query = make(Kind::EdgeAtDistance, edge);
    query.t = from;
    query.t2 = to;
    query.distance = distance;
    return query;
}

Query Query::edge_nearest(int edge, const Vec3& point, double guess, double low, double high) {
    Query query = make(Kind::EdgeNearest, edge);
    query.point = point;
    query.t = guess;
    query.u = low;
    query.v = high;
    return query;
}

Query Query::edge_length(int edge, double t, double t2) {
    Query query = make(Kind::EdgeLength, edge);
    query.t = t;
    query.t2 = t2;
    return query;
}

Query Query::use_on_face(int use, double t) {
    Query query = make(Kind::UseOnFace, use);
    query.t = t;
    return query;
}

Query Query::face_point(int face, double u, double v) {
    return on_face(Kind::FacePoint, face, u, v);
}

Query Query::face_derivatives(int face, double u, double v) {
    return on_face(Kind::FaceDerivatives, face, u, v);
}

Query Query::face_curvatures(int face, double u, double v) {
    return on_face(Kind::FaceCurvatures, face, u, v);
}

Query Query::face_nearest(int face, const Vec3& point, double u, double v) {
    Query query = on_face(Kind::FaceNearest, face, u, v);
    query.point = point;
    return query;
}

Query Query::face_nearest_global(int face, const Vec3& point) {
    Query query = make(Kind::FaceNearestGlobal, face);
    query.point = point;
    return query;
}

Query Query::face_on_line(int face, const Vec3& point, const Vec3& along, double u, double v) {
    Query query = on_face(Kind::FaceOnLine, face, u, v);
    query.point = point;
    query.along = along;
    return query;
}

Query Query::face_contains(int face, double u, double v, double border) {
    Query query = on_face(Kind::FaceContains, face, u, v);
    query.distance = border;
    return query;
}

Query Query::volume_contains(int volume, const Vec3& point) {
    Query query = make(Kind::VolumeContains, volume);
    query.point = point;
    return query;
}

const char* to_string(Status status) {
    switch (status) {
        case Status::Ok:
            return "ok";
        case Status::NotFound:
            return "not found";
        case Status::Singular:
            return "singular";
        case Status::BadQuery:
            return "bad query";
        case Status::KernelFailure:
            return "kernel failure";
        case Status::Stopped:
            return "stopped";
    }
    return "unknown";
}

}  // namespace mq::geometry
