// SPDX-License-Identifier: LGPL-2.1-or-later
#include "view/quality_scene.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/SoDB.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/nodes/SoSeparator.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace mq::view {
namespace {

const std::vector<float> kTwo{0, 0, 0, 2, 0, 0, 0, 3, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0};

class Scene : public testing::Test {
  protected:
    static void SetUpTestSuite() { SoDB::init(); }
    static void TearDownTestSuite() { SoDB::finish(); }

    int triangles() {
        SoGetPrimitiveCountAction action;
        action.apply(scene.root());
        return action.getTriangleCount();
    }

    int lines() {
        SoGetPrimitiveCountAction action;
        action.apply(scene.root());
        return action.getLineCount();
    }

    QualityScene scene;
};

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

TEST_F(Scene, FitAllDoesNotSeeTheLegend) {
    scene.show(kTwo.data(), 2);
    scene.legend("Smallest angle", {{255, 0, 0, 255}, {0, 0, 255, 255}}, {"0", "60"});
    SoGetBoundingBoxAction action{SbViewportRegion(400, 300)};
    action.apply(scene.root());
    const SbVec3f size = action.getBoundingBox().getSize();
    EXPECT_FLOAT_EQ(size[0], 2.0F);
    EXPECT_FLOAT_EQ(size[1], 3.0F);
}

TEST_F(Scene, LegendGoesAgain) {
    const int before = scene.root()->getNumChildren();
    auto* legend = static_cast<SoSeparator*>(scene.root()->getChild(before - 1));
    scene.legend("Smallest angle", {{255, 0, 0, 255}}, {"0"});
    EXPECT_GT(legend->getNumChildren(), 0);
    scene.legend("", {}, {});
    EXPECT_EQ(legend->getNumChildren(), 0);
}

}  // namespace
}  // namespace mq::view
