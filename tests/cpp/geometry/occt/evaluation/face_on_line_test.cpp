// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/elementary/surface_line.h"
#include "geometry/parts.h"

/// Where lines meet the faces of shapes: by Newton's method, and by the surfaces of faces that have closed forms.
namespace mq::geometry {
namespace {

/// Calls check(model, face, point of the face, unit direction that is not along it) for places of all faces.
template <typename Check>
void for_each_line(const Check& check) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> part(0.1, 0.9), any(-1.0, 1.0);
    for (const Part& shape : shape_parts()) {
        const Topology& topology = shape.model->topology();
        for (std::size_t face = 0; face < topology.faces.size(); ++face) {
            const Face& data = topology.faces[face];
            for (int round = 0; round < 5; ++round) {
                const double u = data.low[0] + part(random) * (data.high[0] - data.low[0]);
                const double v = data.low[1] + part(random) * (data.high[1] - data.low[1]);
                const Answer place = shape.model->answer(Query::face_point(static_cast<int>(face), u, v));
                const Vec3 along = Vec3(any(random), any(random), any(random)).normalized();
                if (place.status == Status::Ok && std::abs(along.dot(place.normal)) > 0.3) {
                    SCOPED_TRACE(shape.name + " face " + std::to_string(face));
                    check(*shape.model, static_cast<int>(face), place, along);
                }
            }
        }
    }
}

TEST(FaceOnLine, FindsThePointFromAGuessBeside) {
    int lines = 0;
    for_each_line([&](Model& model, int face, const Answer& place, const Vec3& along) {
        const Face& data = model.topology().faces[static_cast<std::size_t>(face)];
        const double size = model.topology().box.largest_side();
        const Vec3 start = place.point - 0.3 * size * along;
        const double u = place.u + 0.01 * (data.high[0] - data.low[0]), v = place.v;
        const Answer found = model.answer(Query::face_on_line(face, start, along, u, v));
        ASSERT_EQ(found.status, Status::Ok);
        EXPECT_NEAR(found.t, 0.3 * size, 1e-9 * size);
        EXPECT_LT((found.point - place.point).norm(), 1e-9 * size);
        EXPECT_GT(found.normal.dot(place.normal), 1.0 - 1e-9);
        ++lines;
    });
    EXPECT_GT(lines, 200);
}

TEST(FaceOnLine, SurfacesByFormulaStandWhereTheirFacesDo) {
    int lines = 0;
    for_each_line([&](Model& model, int face, const Answer& place, const Vec3& along) {
        const std::optional<ElementarySurface> surface = model.elementary_surface(face);
        if (!surface) {
            return;
        }
        const double size = model.topology().box.largest_side();
        const LineRoots roots = line_roots(*surface, place.point - 0.3 * size * along, along);
        double off = 1e300;
        for (int i = 0; i < roots.count; ++i) {
            off = std::min(off, std::abs(roots.t[static_cast<std::size_t>(i)] - 0.3 * size));
        }
        EXPECT_LT(off, 1e-10 * size);
        EXPECT_LT(normal_near(*surface, place.point).cross(place.normal).norm(), 1e-9);
        ++lines;
    });
    EXPECT_GT(lines, 150);
}

TEST(FaceOnLine, RefusesWhatHasNoAnswer) {
    const auto model = make_shape_model(stored("filleted_box"));
    EXPECT_EQ(model->answer(Query::face_on_line(999, Vec3::Zero(), Vec3::UnitX(), 0.0, 0.0)).status, Status::BadQuery);
    EXPECT_EQ(model->answer(Query::face_on_line(0, Vec3::Zero(), Vec3::UnitX(), 1e80, 0.0)).status, Status::BadQuery);
    EXPECT_NE(model->answer(Query::face_on_line(0, Vec3(1e6, 1e6, 1e6), Vec3::UnitX(), 0.0, 0.0)).status, Status::Ok);
}

}  // namespace
}  // namespace mq::geometry
