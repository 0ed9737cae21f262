// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/front/angular_sectors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mq::triangulate {
namespace {

TEST(AngularSectors, KnowsWhatIsFree) {
    AngularSectors fan(Vec3::UnitZ());
    const auto at = [&](double degrees) {
        return fan.angle_of(Vec3(std::cos(degrees * M_PI / 180.0), std::sin(degrees * M_PI / 180.0), 0.3));
    };
    EXPECT_TRUE(fan.free(at(10), at(80)));
    EXPECT_FALSE(fan.free(at(80), at(10))) << "more than half a turn";
    fan.occupy(at(350), at(40));
    EXPECT_FALSE(fan.free(at(10), at(80)));
    EXPECT_FALSE(fan.free(at(355), at(5)));
    EXPECT_FALSE(fan.free(at(340), at(60)));
    EXPECT_TRUE(fan.free(at(40), at(80))) << "side by side";
    EXPECT_TRUE(fan.free(at(300), at(350)));
    fan.occupy(at(200), at(200));  // the seam of a periodic face
    EXPECT_FALSE(fan.free(at(190), at(210)));
    EXPECT_TRUE(fan.free(at(200), at(210)));
    EXPECT_TRUE(fan.free(at(190), at(200)));
}

}  // namespace
}  // namespace mq::triangulate
