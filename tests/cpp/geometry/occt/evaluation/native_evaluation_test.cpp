// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "geometry/evaluation.h"
#include "geometry/parts.h"

namespace mq::geometry {
namespace {

/// Largest difference between the answers of OpenCASCADE and ours, as a fraction of the size.
constexpr double kAgreement = 1e-9;

struct Pair {
    std::string name;
    std::shared_ptr<Model> fast;
    std::shared_ptr<Model> native;
    double size() const { return fast->topology().box.largest_side(); }
};

/// A shape as it is, as B-splines, and moved, turned and scaled.
void add_pairs(const char* name, const TopoDS_Shape& shape, std::vector<Pair>& pairs) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1.0, 2.0, 3.0), gp_Dir(1.0, 1.0, 0.5)), 0.7);
    gp_Trsf scale;
    scale.SetScale(gp_Pnt(0.0, 0.0, 0.0), 2.5);
    const TopoDS_Shape nurbs = BRepBuilderAPI_NurbsConvert(shape, Standard_True).Shape();
    const TopoDS_Shape moved = BRepBuilderAPI_Transform(shape, turn * scale, Standard_False).Shape();
    const std::pair<const char*, TopoDS_Shape> all[] = {{"", shape}, {" as splines", nurbs}, {" moved", moved}};
    for (const auto& [what, one] : all) {
        pairs.push_back({std::string(name) + what, make_shape_model(one),
                         make_shape_model(one, nullptr, Creases::Keep, {}, Evaluation::Native)});
    }
}

std::vector<Pair> pairs() {
    std::vector<Pair> all;
    add_pairs("cylinder", BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape(), all);
    add_pairs("cone", BRepPrimAPI_MakeCone(2.0, 1.0, 5.0).Shape(), all);
    add_pairs("sphere", BRepPrimAPI_MakeSphere(2.0).Shape(), all);
    add_pairs("torus", BRepPrimAPI_MakeTorus(3.0, 1.0).Shape(), all);
    return all;
}

TEST(NativeEvaluation, AgreesOnFaces) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0.1, 0.9);
    for (const Pair& pair : pairs()) {
        SCOPED_TRACE(pair.name);
        const double tolerance = kAgreement * pair.size();
        for (int f = 0; f < static_cast<int>(pair.fast->topology().faces.size()); ++f) {
            const Face& face = pair.fast->topology().faces[f];
            for (int i = 0; i < 40; ++i) {
                const double u = face.low[0] + part(random) * (face.high[0] - face.low[0]);
                const double v = face.low[1] + part(random) * (face.high[1] - face.low[1]);
                const Answer here = pair.fast->answer(Query::face_point(f, u, v));
                const Answer there = pair.native->answer(Query::face_point(f, u, v));
                EXPECT_LE((here.point - there.point).norm(), tolerance);
                EXPECT_LE((here.normal - there.normal).norm(), kAgreement);
                const Vec3 p = here.point + 0.1 * (part(random) - 0.5) * here.normal;
                const Query query = Query::face_nearest(f, p, u + 0.02, v - 0.02);
                const Answer near = pair.fast->answer(query);
                const Answer other = pair.native->answer(query);
                ASSERT_EQ(other.status, near.status);
                EXPECT_LE((near.point - other.point).norm(), tolerance);
                EXPECT_NEAR(near.distance, other.distance, tolerance);
                EXPECT_NEAR(near.u, other.u, 1e-7);
                EXPECT_NEAR(near.v, other.v, 1e-7);
            }
        }
    }
}

TEST(NativeEvaluation, AgreesOnEdges) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> part(0.1, 0.9);
    for (const Pair& pair : pairs()) {
        SCOPED_TRACE(pair.name);
        const double tolerance = 1e-8 * pair.size();
        for (int e = 0; e < static_cast<int>(pair.fast->topology().edges.size()); ++e) {
            const Edge& edge = pair.fast->topology().edges[e];
            for (int i = 0; i < 10 && !edge.degenerate; ++i) {
                const double a = edge.t0 + 0.5 * part(random) * (edge.t1 - edge.t0);
                const double b = edge.t1 - 0.5 * part(random) * (edge.t1 - edge.t0);
                const Vec3 aside(0.01, 0.02, -0.01);
                const double middle = 0.5 * (a + b);
                const Vec3 p = pair.fast->answer(Query::edge_point(e, middle)).point + aside;
                for (const Query& query :
                     {Query::edge_point(e, a), Query::edge_middle(e, a, b), Query::edge_middle(e, b, a),
                      Query::edge_length(e, a, b), Query::edge_nearest(e, p, middle, edge.t0, edge.t1)}) {
                    const Answer fast = pair.fast->answer(query);
                    const Answer native = pair.native->answer(query);
                    ASSERT_EQ(native.status, Status::Ok);
                    EXPECT_LE((fast.point - native.point).norm(), tolerance) << "kind " << static_cast<int>(query.kind);
                    EXPECT_NEAR(fast.distance, native.distance, tolerance) << "kind " << static_cast<int>(query.kind);
                }
            }
        }
    }
}

}  // namespace
}  // namespace mq::geometry
