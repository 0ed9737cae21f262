// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/inspect_solids.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "mesh/quality/mesh_report.h"

namespace mq::workflows {
namespace {

/// A box of 12 triangles, 20 by 10 by 2, its faces numbered.
triangulate::Result plate() {
    triangulate::Result result;
    mesh::TriangleMesh& mesh = result.mesh;
    for (int k = 0; k < 8; ++k) {
        mesh.vertices.emplace_back((k & 1) * 20.0, (k >> 1 & 1) * 10.0, (k >> 2 & 1) * 2.0);
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    mesh.triangle_face = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
    result.report = mesh::measure(mesh);
    return result;
}

double least(const inspection::ThicknessValues& values) {
    return *std::min_element(values.value.begin(), values.value.end());
}

TEST(InspectSolids, RepairsADirtyMeshAndSaysSo) {
    triangulate::Result given = plate();
    std::swap(given.mesh.triangles[4][0], given.mesh.triangles[4][1]);  // turned around
    given.mesh.triangles.pop_back();                                    // a hole
    given.mesh.triangle_face.pop_back();
    given.report = mesh::measure(given.mesh);
    Progress progress;
    const ThicknessSurface found = measure_thickness(given, {}, progress);
    EXPECT_TRUE(found.solids.surface.report.closed);
    ASSERT_EQ(found.solids.surface.mesh.triangles.size(), 12u);
    EXPECT_EQ(found.solids.surface.mesh.triangle_face[0], 0);
    EXPECT_EQ(found.solids.surface.mesh.triangle_face[11], -1);
    ASSERT_EQ(found.solids.surface.report.notes.size(), 1u);
    EXPECT_NE(found.solids.surface.report.notes[0].text().find("1 hole closed"), std::string::npos);
    EXPECT_NEAR(least(found.thickness.rays), 2.0, 1e-12);
    EXPECT_EQ(found.seconds.size(), 2u);
}

TEST(InspectSolids, MeasuresEachSolidOfAShapeByItself) {
    triangulate::Result given = plate();
    const triangulate::Result other = plate();
    for (const Vec3& p : other.mesh.vertices) {
        given.mesh.vertices.push_back(p + Vec3(0, 0, 2));  // lies on the first
    }
    for (const mesh::Triangle& t : other.mesh.triangles) {
        given.mesh.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
        given.mesh.triangle_face.push_back(6);
    }
    given.mesh.triangle_solid.assign(12, 0);
    given.mesh.triangle_solid.insert(given.mesh.triangle_solid.end(), 12, 1);
    given.report = mesh::measure(given.mesh);
    Progress progress;
    const ThicknessSurface found = measure_thickness(given, {}, progress);
    EXPECT_EQ(found.solids.body, given.mesh.triangle_solid);
    EXPECT_NEAR(found.thickness.rays.value[0], 2.0, 1e-12);
    EXPECT_NEAR(found.thickness.rays.value[14], 2.0, 1e-12);
}

TEST(InspectSolids, RefusesASheet) {
    triangulate::Result given = plate();
    given.mesh.triangles.resize(2);
    given.mesh.triangle_face.resize(2);
    Progress progress;
    EXPECT_THROW(measure_thickness(given, {}, progress), InvalidInput);
}

}  // namespace
}  // namespace mq::workflows
