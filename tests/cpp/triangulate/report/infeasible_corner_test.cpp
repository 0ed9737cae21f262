// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "triangulate/checks.h"

/// The report on corners that force angles below the bound beside them.
namespace mq::triangulate {
namespace {

int told(const Result& result, mesh::ExemptCause cause) {
    return static_cast<int>(std::count_if(result.report.exempt.begin(), result.report.exempt.end(),
                                          [&](const auto& exempt) { return exempt.second.cause == cause; }));
}

Result mesh_wedge(double degrees, double bound) {
    TriangulateOptions options;
    options.min_angle = bound;
    return mesh_of(geometry::make_shape_model(geometry::wedge(degrees, 10.0, 3.0)), options);
}

/// Six triangles of 30 degrees fit into half a turn: lengths grow at most 27-fold there. Edges that separate by 0.3
/// degrees need a factor of 55.
TEST(InfeasibleCorner, IsNamedWhereNoFanFits) {
    const Result result = mesh_wedge(0.3, 30.0);
    expect_angles(result, 30.0);
    EXPECT_GT(told(result, mesh::ExemptCause::InfeasibleCorner), 0);
    EXPECT_EQ(told(result, mesh::ExemptCause::NarrowCluster), 0);
    for (const auto& [t, why] : result.report.exempt) {
        if (why.cause == mesh::ExemptCause::InfeasibleCorner) {
            EXPECT_EQ(mesh::message_of(why).text().rfind(
                          "edges of the shape that meet at 0.30° leave no room for larger angles at Vertex", 0),
                      0u);
        }
    }
}

TEST(InfeasibleCorner, IsNotBlamedWhereAFanFits) {
    for (const double degrees : {1.0, 5.0, 15.0}) {
        SCOPED_TRACE(degrees);
        EXPECT_EQ(told(mesh_wedge(degrees, 25.0), mesh::ExemptCause::InfeasibleCorner), 0);
    }
    // Tangent curves separate with increasing speed.
    const Result crescent = mesh_of(geometry::make_shape_model(geometry::crescent(10.0, 11.0, 60.0, 55.0)));
    EXPECT_EQ(told(crescent, mesh::ExemptCause::InfeasibleCorner), 0);
}

}  // namespace
}  // namespace mq::triangulate
