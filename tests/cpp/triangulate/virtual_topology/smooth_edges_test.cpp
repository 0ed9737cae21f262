// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/virtual_topology/smooth_edges.h"

#include "triangulate/checks.h"
#include "triangulate/virtual_topology/stadium.h"

namespace mq::triangulate {
namespace {

TEST(SmoothEdges, AreThoseAcrossWhichTheNormalIsContinuous) {
    Pipeline rounded(stadium(1));
    const std::vector<char> smooth = smooth_edges(rounded.work, 10.0, {});
    EXPECT_EQ(std::count(smooth.begin(), smooth.end(), 1), 4);  // where half circles meet straight sides
    Pipeline box(geometry::make_shape_model(geometry::wedge(40.0, 5.0, 1.0)));
    const std::vector<char> sharp = smooth_edges(box.work, 10.0, {});
    EXPECT_EQ(std::count(sharp.begin(), sharp.end(), 1), 0);
    Pipeline seam(geometry::make_cylinder(2.0, 5.0));
    const std::vector<char> none = smooth_edges(seam.work, 10.0, {});
    EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);
}

TEST(SmoothEdges, ThatSizesNameStay) {
    Pipeline pipeline(stadium(1));
    const auto count = [&](const std::vector<LocalSize>& sizes) {
        const std::vector<char> smooth = smooth_edges(pipeline.work, 10.0, sizes);
        return std::count(smooth.begin(), smooth.end(), 1);
    };
    const std::vector<char> all = smooth_edges(pipeline.work, 10.0, {});
    const int first = static_cast<int>(std::find(all.begin(), all.end(), 1) - all.begin());
    EXPECT_EQ(count({{1, first, 0.1}}), 3);
}

}  // namespace
}  // namespace mq::triangulate
