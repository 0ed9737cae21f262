// SPDX-License-Identifier: LGPL-2.1-or-later
#include "view/shaded_triangles.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "view/scene.h"

namespace mq::view {
namespace {

TEST_F(Scene, ShowsTrianglesAndForgetsThoseBefore) {
    scene.show(kTwo.data(), 2);
    EXPECT_EQ(triangles(), 2);
    scene.show(kTwo.data(), 1);
    EXPECT_EQ(scene.triangles().count(), 1U);
    EXPECT_EQ(triangles(), 1);
}

TEST_F(Scene, WantsOneColourATriangle) {
    scene.show(kTwo.data(), 2);
    scene.triangles().colour({{255, 0, 0, 255}, {0, 255, 0, 255}});
    EXPECT_THROW(scene.triangles().colour({{255, 0, 0, 255}}), InvalidInput);
}

}  // namespace
}  // namespace mq::view
