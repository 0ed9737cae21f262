// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/samples.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

TEST(DeviationSamples, CornersMiddlesAndCentroidsOnceEachInThePartsFrame) {
    TriangleMesh mesh = samples::tetrahedron();
    mesh.vertices.push_back(Vec3(9, 9, 9));  // of no triangle
    mesh.vertex_entity.clear();
    mesh.origin = Vec3(100, 0, 0);
    const std::vector<Vec3> found = deviation_samples(mesh);
    EXPECT_EQ(found.size(), 4u + 6u + 4u);
    for (const Vec3& expected : {Vec3(100, 0, 1), Vec3(100.5, 0.5, 0), Vec3(100, 0, 0.5)}) {
        EXPECT_EQ(std::count(found.begin(), found.end(), expected), 1);
    }
}

}  // namespace
}  // namespace mq::mesh
