// SPDX-License-Identifier: LGPL-2.1-or-later
#include "view/quality_scene.h"

#include <gtest/gtest.h>

#include "view/scene.h"

namespace mq::view {
namespace {

TEST_F(Scene, IsFoundByItsName) {
    const QualityScene other;
    EXPECT_EQ(SoNode::getByName(scene.name().c_str()), scene.root());
    EXPECT_EQ(SoNode::getByName(other.name().c_str()), other.root());
    EXPECT_NE(scene.root(), other.root());
}

TEST_F(Scene, IsEmptyAtFirst) {
    EXPECT_EQ(scene.triangles().count(), 0U);
    EXPECT_EQ(triangles(), 0);
}

TEST_F(Scene, EdgesAreLines) {
    scene.draw_edges(kTwo.data(), 3, {0, 1, 2, -1, 2, 0, -1});
    EXPECT_EQ(lines(), 3);
    scene.draw_edges(nullptr, 0, {});
    EXPECT_EQ(lines(), 0);
}

TEST_F(Scene, LitTrianglesAreDrawnAgainWithOutlines) {
    scene.show(kTwo.data(), 2);
    scene.light_up(kTwo.data(), 1);
    EXPECT_EQ(lines(), 3);
    scene.show(kTwo.data(), 2);
    EXPECT_EQ(lines(), 0);
}

}  // namespace
}  // namespace mq::view
