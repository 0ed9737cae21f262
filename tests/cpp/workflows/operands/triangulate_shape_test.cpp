// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/operands/triangulate_shape.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "triangulate/incremental/mesh_cache.h"

namespace mq::workflows {
namespace {

class Triangulating : public testing::Test {
  protected:
    triangulate::Result mesh_of(const TopoDS_Shape& shape, triangulate::MeshCache* cache = nullptr) {
        return triangulate_shape(engine, shape, options, progress, cache);
    }

    geometry::Engine engine{geometry::Engine::Mode::Direct};
    Progress progress;
    triangulate::TriangulateOptions options;
};

TEST_F(Triangulating, AShapeIsReadMeshedAndMeasured) {
    options.chord_height = 0.01;
    const triangulate::Result result = mesh_of(BRepPrimAPI_MakeSphere(1.0).Shape());
    EXPECT_TRUE(result.report.closed);
    EXPECT_LE(result.report.max_chord_height, 0.01);
    EXPECT_EQ(result.report.seconds.front().first, "read the shape");
    options.min_angle = 80.0;
    EXPECT_THROW(mesh_of(BRepPrimAPI_MakeSphere(1.0).Shape()), InvalidInput);
}

TEST_F(Triangulating, ACacheKnowsTheShapeAgain) {
    triangulate::MeshCache cache;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    const triangulate::Result first = mesh_of(box, &cache);
    const triangulate::Result again = mesh_of(box, &cache);
    EXPECT_EQ(again.mesh.triangles, first.mesh.triangles);
    EXPECT_EQ(again.report.reused_faces, 6u);
}

TEST_F(Triangulating, AThinModelFarAwayLosesVolumeAndANoteSaysSo) {
    const auto tells = [](const triangulate::Result& result) {
        return std::any_of(result.report.notes.begin(), result.report.notes.end(), [](const Message& note) {
            return note.text().find("so thin that single precision changes its volume") != std::string::npos;
        });
    };
    EXPECT_FALSE(tells(mesh_of(BRepPrimAPI_MakeBox(100.0, 100.0, 1.0).Shape())));
    EXPECT_TRUE(tells(mesh_of(BRepPrimAPI_MakeBox(gp_Pnt(0.3, 0.3, 77.7), 1000.0, 1000.0, 1.3e-4).Shape())));
}

TEST_F(Triangulating, DistancesFromAShapeAreToItsNearestFace) {
    const TopoDS_Shape unit = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
    const triangulate::Result box = mesh_of(unit);
    const TopoDS_Shape higher = BRepPrimAPI_MakeBox(1.0, 1.0, 1.25).Shape();
    const mesh::MeshReport report = measure_against_shape(box, higher, progress);
    EXPECT_TRUE(report.to_nearest_face);
    EXPECT_NEAR(report.max_chord_height, 0.25, 1e-6);
    EXPECT_NEAR((report.max_chord_point).z(), 1.0, 1e-6);
    const std::vector<double> deviations = triangle_deviations(box.mesh, higher, progress);
    ASSERT_EQ(deviations.size(), box.mesh.triangles.size());
    EXPECT_EQ(*std::max_element(deviations.begin(), deviations.end()),
              deviations[static_cast<std::size_t>(report.max_chord_triangle)]);
    EXPECT_NEAR(measure_against_shape(box, unit, progress).max_chord_height, 0.0, 1e-6);
}

}  // namespace
}  // namespace mq::workflows
