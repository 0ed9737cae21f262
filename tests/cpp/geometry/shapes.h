// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopoDS_Shape.hxx>
#include <memory>

#include "geometry/occt/shape_model.h"

/// Helpers that the tests of the OpenCASCADE model share.
namespace mq::geometry {

inline Vec3 middle_normal(Model& model, int face, Vec3* point = nullptr) {
    const Face& data = model.topology().faces[static_cast<std::size_t>(face)];
    const Answer answer =
        model.answer(Query::face_point(face, 0.5 * (data.low[0] + data.high[0]), 0.5 * (data.low[1] + data.high[1])));
    EXPECT_EQ(answer.status, Status::Ok);
    if (point != nullptr) {
        *point = answer.point;
    }
    return answer.normal;
}

/// The faces' uses run around them with the interior on the left: a step to the left in (u, v) stays inside, and seen
/// along the outward normal the left of the walk is n x d. Skips poles.
inline void expect_uses_run_left(Model& model) {
    const Topology& topology = model.topology();
    for (std::size_t i = 0; i < topology.uses.size(); ++i) {
        const EdgeUse& use = topology.uses[i];
        const Edge& edge = topology.edges[static_cast<std::size_t>(use.edge)];
        const Face& face = topology.faces[static_cast<std::size_t>(use.face)];
        if (use.internal) {
            continue;
        }
        const double t = 0.47 * edge.t0 + 0.53 * edge.t1;
        const double step = 1e-3 * (edge.t1 - edge.t0);
        const Answer a = model.answer(Query::use_on_face(static_cast<int>(i), t - step));
        const Answer b = model.answer(Query::use_on_face(static_cast<int>(i), t + step));
        const Vec2 along = (use.forward ? 1.0 : -1.0) * Vec2(b.u - a.u, b.v - a.v);
        const Vec2 range(face.high[0] - face.low[0], face.high[1] - face.low[1]);
        Vec2 left(-along.y() / range.y() * range.x(), along.x() / range.x() * range.y());
        left *= 1e-3 / std::max(std::abs(left.x() / range.x()), std::abs(left.y() / range.y()));
        const Vec2 inside = 0.5 * Vec2(a.u + b.u, a.v + b.v) + left;
        EXPECT_EQ(model.answer(Query::face_contains(use.face, inside.x(), inside.y())).side, 1)
            << "use " << i << " of edge " << use.edge << " on face " << use.face;
    }
}

/// A closed solid that is seen from outside: the volume by the divergence theorem over a grid of each rectangular face.
inline double flux_of_rectangles(Model& model) {
    /// Cells along each parameter of a face.
    constexpr int kCells = 60;
    double volume = 0.0;
    const Topology& topology = model.topology();
    for (std::size_t i = 0; i < topology.faces.size(); ++i) {
        const Face& face = topology.faces[i];
        const double du = (face.high[0] - face.low[0]) / kCells;
        const double dv = (face.high[1] - face.low[1]) / kCells;
        for (int a = 0; a < kCells; ++a) {
            for (int b = 0; b < kCells; ++b) {
                const double u = face.low[0] + (a + 0.5) * du;
                const double v = face.low[1] + (b + 0.5) * dv;
                const int index = static_cast<int>(i);
                if (model.answer(Query::face_contains(index, u, v)).side < 1) {
                    continue;
                }
                const Answer s = model.answer(Query::face_derivatives(index, u, v));
                volume += s.point.dot(s.normal) * s.derivatives[0].cross(s.derivatives[1]).norm() * du * dv / 3.0;
            }
        }
    }
    return volume;
}

}  // namespace mq::geometry
