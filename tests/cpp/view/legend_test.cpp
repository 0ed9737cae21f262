// SPDX-License-Identifier: LGPL-2.1-or-later
#include "view/legend.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "view/scene.h"

namespace mq::view {
namespace {

LegendPicture picture_of(int width, int height, Corner corner = Corner::TopRight, int reach = 0) {
    const std::size_t numbers = std::size_t{4} * width * height;
    return {width, height, std::vector<std::uint8_t>(numbers, 255), corner, reach};
}

TEST_F(Scene, FitAllDoesNotSeeTheLegend) {
    scene.show(kTwo.data(), 2);
    scene.legend().show(picture_of(20, 30));
    SoGetBoundingBoxAction action{SbViewportRegion(400, 300)};
    action.apply(scene.root());
    const SbVec3f size = action.getBoundingBox().getSize();
    EXPECT_FLOAT_EQ(size[0], 2.0F);
    EXPECT_FLOAT_EQ(size[1], 3.0F);
}

TEST_F(Scene, LegendGoesAgain) {
    scene.legend().show(picture_of(20, 30));
    EXPECT_GT(scene.legend().getNumChildren(), 0);
    scene.legend().show({});
    EXPECT_EQ(scene.legend().getNumChildren(), 0);
}

TEST_F(Scene, LegendIsGivenAllItsPixels) {
    LegendPicture picture = picture_of(20, 30);
    picture.rgba.pop_back();
    EXPECT_THROW(scene.legend().show(picture), InvalidInput);
}

TEST_F(Scene, LegendIsAtTheRightAndInTheMiddle) {
    scene.legend().show(picture_of(100, 200));
    EXPECT_EQ(scene.legend().place_in({800, 600}), SbVec2s(690, 200));
}

// The square that must stay free, and the picture: both within the window, and disjoint.
TEST_F(Scene, LegendLeavesACornerFree) {
    // Width and height of the picture, and side of the free square, pixels.
    constexpr short kWidth = 100, kHeight = 200, kReach = 150;
    for (const short high : {600, 400, 300, 220}) {
        for (const Corner corner : {Corner::TopLeft, Corner::TopRight, Corner::BottomLeft, Corner::BottomRight}) {
            scene.legend().show(picture_of(kWidth, kHeight, corner, kReach));
            const SbVec2s place = scene.legend().place_in({800, high});
            const bool at_left = corner == Corner::TopLeft || corner == Corner::BottomLeft;
            const bool at_top = corner == Corner::TopLeft || corner == Corner::TopRight;
            const bool beside = at_left ? place[0] >= kReach : place[0] + kWidth <= 800 - kReach;
            const bool above_or_below = at_top ? place[1] + kHeight <= high - kReach : place[1] >= kReach;
            EXPECT_TRUE(beside || above_or_below) << high << " " << static_cast<int>(corner);
            EXPECT_TRUE(place[0] >= 0 && place[1] >= 0 && place[0] + kWidth <= 800 && place[1] + kHeight <= high);
        }
    }
}

}  // namespace
}  // namespace mq::view
