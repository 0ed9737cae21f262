// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/graded_fans.h"

#include "triangulate/checks.h"

namespace mq::triangulate {
namespace {

Result mesh_wedge(double angle, double bound, Insertion insertion) {
    TriangulateOptions options;
    options.min_angle = bound;
    options.insertion = insertion;
    return mesh_of(geometry::make_shape_model(geometry::wedge(angle, 10.0, 3.0)), options);
}

std::size_t count_of(const Result& result, Cause cause) {
    return static_cast<std::size_t>(std::count_if(result.report.exempt.begin(), result.report.exempt.end(),
                                                  [&](const auto& entry) { return entry.second.cause == cause; }));
}

/// A wedge has two corners, at the ends of its tip. Beside each of their innermost pieces, whose next pieces are up to
/// 40 times shorter, lies another face. One triangle in each corner has the angle of the shape; nothing else is exempt.
TEST(GradedFans, LeaveOneTriangleInEachCornerBelowTheBound) {
    for (const double angle : {0.4, 0.7, 1.0, 2.0, 3.0, 5.0, 8.0, 12.0}) {
        for (const double bound : {20.0, 25.0}) {
            SCOPED_TRACE(std::to_string(angle) + " degrees, bound " + std::to_string(bound));
            const Result result = mesh_wedge(angle, bound, Insertion::OffCentre);
            expect_sound(result, 2, true);
            expect_angles(result, bound);
            EXPECT_EQ(result.report.exempt.size(), 2u);
            EXPECT_EQ(count_of(result, Cause::NarrowCorner), 2u);
        }
    }
}

/// Fans are no part of the paper's refinement.
TEST(GradedFans, AreNotWrittenByThePapersRule) {
    const Result result = mesh_wedge(1.0, 25.0, Insertion::Circumcentre);
    EXPECT_GT(result.report.exempt.size(), 2u);
}

}  // namespace
}  // namespace mq::triangulate
