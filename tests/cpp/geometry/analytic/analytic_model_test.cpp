// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/analytic/analytic_model.h"

#include <cmath>
#include <limits>
#include <random>

#include "base/error.h"
#include "geometry/shapes.h"

namespace mq::geometry {
namespace {

struct Pair {
    const char* name;
    std::shared_ptr<Model> analytic;
    std::shared_ptr<Model> occt;
};

std::vector<Pair> pairs() {
    return {{"sphere", make_sphere(2.0), make_shape_model(BRepPrimAPI_MakeSphere(2.0).Shape())},
            {"cylinder", make_cylinder(2.0, 5.0), make_shape_model(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape())},
            {"cone", make_cone(2.0, 5.0), make_shape_model(BRepPrimAPI_MakeCone(2.0, 0.0, 5.0).Shape())},
            {"torus", make_torus(5.0, 1.5), make_shape_model(BRepPrimAPI_MakeTorus(5.0, 1.5).Shape())},
            {"box", make_box(1.0, 2.0, 3.0), make_shape_model(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape())}};
}

void expect_same(const Answer& a, const Answer& b, const char* what) {
    // Largest difference between answers that count as equal.
    constexpr double kSame = 1e-6;
    ASSERT_EQ(a.status, b.status) << what;
    EXPECT_EQ(a.side, b.side) << what;
    EXPECT_NEAR(a.u, b.u, kSame) << what;
    EXPECT_NEAR(a.v, b.v, kSame) << what;
    EXPECT_NEAR(a.t, b.t, kSame) << what;
    EXPECT_LT((a.point - b.point).norm(), kSame) << what;
    EXPECT_LT((a.normal - b.normal).norm(), kSame)
        << what << " " << a.normal.transpose() << " / " << b.normal.transpose();
    ASSERT_EQ(a.derivatives.size(), b.derivatives.size()) << what;
    for (std::size_t i = 0; i < a.derivatives.size(); ++i) {
        EXPECT_LT((a.derivatives[i] - b.derivatives[i]).norm(), kSame) << what << " derivative " << i;
    }
}

TEST(AnalyticModel, HasTheTopologyOfOpenCascadesPrimitives) {
    for (const Pair& pair : pairs()) {
        SCOPED_TRACE(pair.name);
        const Topology& a = pair.analytic->topology();
        const Topology& b = pair.occt->topology();
        EXPECT_TRUE(b.faults.empty());
        ASSERT_EQ(a.nodes.size(), b.nodes.size());
        for (std::size_t i = 0; i < a.nodes.size(); ++i) {
            EXPECT_LT((a.nodes[i].point - b.nodes[i].point).norm(), 1e-12);
        }
        ASSERT_EQ(a.edges.size(), b.edges.size());
        for (std::size_t i = 0; i < a.edges.size(); ++i) {
            EXPECT_EQ(a.edges[i].nodes, b.edges[i].nodes) << i;
            EXPECT_EQ(a.edges[i].uses, b.edges[i].uses) << i;
            EXPECT_EQ(a.edges[i].degenerate, b.edges[i].degenerate) << i;
            EXPECT_NEAR(a.edges[i].t0, b.edges[i].t0, 1e-12) << i;
            EXPECT_NEAR(a.edges[i].t1, b.edges[i].t1, 1e-12) << i;
        }
        ASSERT_EQ(a.faces.size(), b.faces.size());
        for (std::size_t i = 0; i < a.faces.size(); ++i) {
            EXPECT_STREQ(a.faces[i].surface, b.faces[i].surface);
            EXPECT_EQ(a.faces[i].reversed, b.faces[i].reversed) << i;
            ASSERT_EQ(a.faces[i].loops.size(), b.faces[i].loops.size());
            for (std::size_t k = 0; k < a.faces[i].loops.size(); ++k) {
                EXPECT_EQ(a.faces[i].loops[k].uses, b.faces[i].loops[k].uses) << i;
            }
            for (std::size_t k = 0; k < 2; ++k) {
                EXPECT_NEAR(a.faces[i].low[k], b.faces[i].low[k], 1e-6);
                EXPECT_NEAR(a.faces[i].high[k], b.faces[i].high[k], 1e-6);
                EXPECT_NEAR(a.faces[i].period[k], b.faces[i].period[k], 1e-12);
            }
        }
        ASSERT_EQ(a.uses.size(), b.uses.size());
        for (std::size_t i = 0; i < a.uses.size(); ++i) {
            EXPECT_EQ(a.uses[i].edge, b.uses[i].edge) << i;
            EXPECT_EQ(a.uses[i].face, b.uses[i].face) << i;
            EXPECT_EQ(a.uses[i].forward, b.uses[i].forward) << i;
        }
        ASSERT_EQ(a.volumes.size(), b.volumes.size());
        EXPECT_EQ(a.volumes[0].sides.size(), b.volumes[0].sides.size());
        EXPECT_LT((a.box.low - b.box.low).norm() + (a.box.high - b.box.high).norm(), 1e-4);
    }
}

TEST(AnalyticModel, AnswersOnEdgesAsOpenCascade) {
    for (const Pair& pair : pairs()) {
        SCOPED_TRACE(pair.name);
        const Topology& topology = pair.analytic->topology();
        for (int e = 0; e < static_cast<int>(topology.edges.size()); ++e) {
            const Edge& edge = topology.edges[static_cast<std::size_t>(e)];
            const auto both = [&](const Query& query, const char* what) {
                const Answer a = pair.analytic->answer(query);
                const Answer b = pair.occt->answer(query);
                expect_same(a, b, what);
                EXPECT_NEAR(a.distance, b.distance, 1e-6) << what;
            };
            for (int i = 0; i <= 8; ++i) {
                const double t = edge.t0 + i * (edge.t1 - edge.t0) / 8.0;
                both(Query::edge_point(e, t), "point");
                both(Query::edge_middle(e, edge.t0, t), "middle");
                both(Query::edge_length(e, t, edge.t1), "length");
                both(Query::edge_at_distance(e, edge.t0, t, 0.3), "at distance");
                both(Query::edge_at_distance(e, t, edge.t0, 0.7), "at distance, backwards");
                const Vec3 p(0.3 * i, 1.0 - 0.2 * i, 0.4 * i);
                both(Query::edge_nearest(e, p, t, edge.t0, edge.t1), "nearest");
                both(Query::edge_nearest(e, p, t, edge.t0, 0.5 * (edge.t0 + t)), "nearest in a part");
            }
            both(Query::edge_point(e, edge.t1 + 1.0), "out of range");
        }
    }
}

TEST(AnalyticModel, AnswersOnUsesAsOpenCascade) {
    for (const Pair& pair : pairs()) {
        SCOPED_TRACE(pair.name);
        const Topology& topology = pair.analytic->topology();
        for (int u = 0; u < static_cast<int>(topology.uses.size()); ++u) {
            const EdgeUse& use = topology.uses[static_cast<std::size_t>(u)];
            const Edge& edge = topology.edges[static_cast<std::size_t>(use.edge)];
            for (int i = 0; i <= 8; ++i) {
                const Query query = Query::use_on_face(u, edge.t0 + i * (edge.t1 - edge.t0) / 8.0);
                expect_same(pair.analytic->answer(query), pair.occt->answer(query), "use");
            }
        }
    }
}

TEST(AnalyticModel, AnswersOnFacesAsOpenCascade) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (const Pair& pair : pairs()) {
        SCOPED_TRACE(pair.name);
        const Topology& topology = pair.analytic->topology();
        for (int f = 0; f < static_cast<int>(topology.faces.size()); ++f) {
            const Face& face = topology.faces[static_cast<std::size_t>(f)];
            for (int i = 0; i < 200; ++i) {
                const double u = face.low[0] + part(random) * (face.high[0] - face.low[0]);
                const double v = face.low[1] + part(random) * (face.high[1] - face.low[1]);
                const auto both = [&](const Query& query, const char* what) {
                    const Answer a = pair.analytic->answer(query);
                    expect_same(a, pair.occt->answer(query), what);
                    return a;
                };
                const Answer here = both(Query::face_point(f, u, v), "point");
                both(Query::face_derivatives(f, u, v), "derivatives");
                both(Query::face_curvatures(f, u, v), "curvatures");
                both(Query::face_contains(f, u, v), "contains");
                // Near the apex of the cone a larger step inward would cross the axis.
                const double room = std::min(1.0, std::hypot(here.point.x(), here.point.y()));
                const Vec3 p = here.point + 0.3 * room * (part(random) - 0.5) * here.normal;
                const Answer foot = both(Query::face_nearest(f, p, u + 0.1, v - 0.1), "nearest");
                EXPECT_LT((foot.point - here.point).norm(), 1e-6);
                both(Query::face_nearest_global(f, p), "nearest, global");
            }
        }
    }
}

TEST(AnalyticModel, KnowsInsideAsOpenCascade) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(-0.1, 1.1);
    for (const Pair& pair : pairs()) {
        SCOPED_TRACE(pair.name);
        const Box& box = pair.analytic->topology().box;
        for (int i = 0; i < 200; ++i) {
            const Vec3 x(part(random), part(random), part(random));
            const Query query = Query::volume_contains(0, box.low + x.cwiseProduct(box.high - box.low));
            EXPECT_EQ(pair.analytic->answer(query).side, pair.occt->answer(query).side) << query.point.transpose();
        }
    }
}

TEST(AnalyticModel, RefusesWhatIsNoQuery) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Pair& pair : pairs()) {
        for (Model* model : {pair.analytic.get(), pair.occt.get()}) {
            EXPECT_EQ(model->answer(Query::face_point(99, 0.0, 0.0)).status, Status::BadQuery);
            EXPECT_EQ(model->answer(Query::face_point(-1, 0.0, 0.0)).status, Status::BadQuery);
            EXPECT_EQ(model->answer(Query::face_point(0, nan, 0.0)).status, Status::BadQuery);
            EXPECT_EQ(model->answer(Query::edge_point(99, 0.0)).status, Status::BadQuery);
            EXPECT_EQ(model->answer(Query::use_on_face(99, 0.0)).status, Status::BadQuery);
            EXPECT_EQ(model->answer(Query::volume_contains(3, Vec3::Zero())).status, Status::BadQuery);
            EXPECT_EQ(model->answer(Query::face_nearest(0, Vec3(nan, 0.0, 0.0), 0.0, 0.0)).status, Status::BadQuery);
        }
    }
    EXPECT_THROW(make_sphere(0.0), InvalidInput);
    EXPECT_THROW(make_torus(1.0, 2.0), InvalidInput);
    EXPECT_THROW(make_box(1.0, nan, 1.0), InvalidInput);
}

TEST(AnalyticModel, HasNoNearestPointAtTheCentreOfASphere) {
    for (const auto& model : {make_sphere(2.0), make_shape_model(BRepPrimAPI_MakeSphere(2.0).Shape())}) {
        EXPECT_EQ(model->answer(Query::face_nearest(0, Vec3::Zero(), 1.0, 0.0)).status, Status::NotFound);
    }
}

TEST(AnalyticModel, HasANormalAtThePoleAndNoneAtTheApex) {
    for (const auto& model : {make_sphere(2.0), make_shape_model(BRepPrimAPI_MakeSphere(2.0).Shape())}) {
        const Answer pole = model->answer(Query::face_point(0, 1.0, 0.5 * M_PI));
        EXPECT_EQ(pole.status, Status::Ok);
        EXPECT_LT((pole.normal - Vec3::UnitZ()).norm(), 1e-6);
        const Answer bent = model->answer(Query::face_curvatures(0, 1.0, 0.5 * M_PI));
        EXPECT_NEAR(bent.u, -0.5, 1e-6);
        EXPECT_NEAR(bent.v, -0.5, 1e-6);
    }
    for (const auto& model : {make_cone(2.0, 5.0), make_shape_model(BRepPrimAPI_MakeCone(2.0, 0.0, 5.0).Shape())}) {
        const Answer apex = model->answer(Query::face_point(0, 1.0, std::hypot(2.0, 5.0)));
        EXPECT_EQ(apex.status, Status::Singular);
        EXPECT_TRUE(apex.found());
        EXPECT_LT((apex.point - Vec3(0.0, 0.0, 5.0)).norm(), 1e-9);
        EXPECT_EQ(apex.normal.norm(), 0.0);
    }
}

TEST(Names, AreFreeCadsAndCountFromOne) {
    EXPECT_EQ(name_of({0, 2}), "Vertex3");
    EXPECT_EQ(name_of({1, 11}), "Edge12");
    EXPECT_EQ(name_of({2, 6}), "Face7");
    EXPECT_EQ(name_of({}), "(no entity)");
    EXPECT_STREQ(to_string(Status::KernelFailure), "kernel failure");
}

}  // namespace
}  // namespace mq::geometry
