// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/exempt_reason.h"

#include <gtest/gtest.h>

#include <string>

#include "mesh/quality/named_entities.h"

namespace mq::mesh {
namespace {

TEST(ExemptReason, IsSaidWithItsEntitiesAndItsAngle) {
    const ExemptReason corner{ExemptCause::NarrowCorner, 7.25, {edge(1), edge(12)}, vertex(3), face(2)};
    EXPECT_EQ(message_of(corner).text(),
              "the shape itself has a corner of 7.25° between Edge1 and Edge12 at Vertex3 on Face2");
    const ExemptReason crowded{ExemptCause::Resolution, -1.0, {edge(4), {}}, {}, face(2)};
    EXPECT_EQ(message_of(crowded).text(), "points cannot be placed any closer in single precision at Edge4 on Face2");
    EXPECT_EQ(message_of({ExemptCause::SharpEdges}).text(),
              "its smallest angle lies between two sharp edges that must stay");
}

TEST(ExemptReason, NamesWhatCountsAsOne) {
    ExemptReason corner{ExemptCause::IdentifiedCorner, 11.25, {edge(4), edge(9)}, vertex(3), face(2)};
    corner.joined = {edge(5), edge(9)};
    corner.apart = 0.00212;
    EXPECT_EQ(
        message_of(corner).text(),
        "Edge5 and Edge9 count as one, as they are no farther apart than 0.00212 mm: that makes a corner of 11.25°, "
        "which the shape does not have and a smaller max. deviation avoids, between Edge4 and Edge9 at Vertex3 on "
        "Face2");
    EXPECT_FALSE(is_forced(corner.cause));
    corner.cause = ExemptCause::ToleranceCorner;
    EXPECT_EQ(
        message_of(corner).text(),
        "Edge5 and Edge9 count as one, as the shape's tolerances do not tell them apart (0.00212 mm): that makes a "
        "corner of 11.25° between Edge4 and Edge9 at Vertex3 on Face2");
    EXPECT_TRUE(is_forced(corner.cause));
}

TEST(ExemptReason, NamesCreasesByTheFaceThatTheyLieOn) {
    const ExemptReason apex{ExemptCause::Apex, -1.0, {}, {0, {2, 4}}, face(5)};
    EXPECT_EQ(message_of(apex).text(),
              "the surface comes to a point with too little angle around it at the end of a crease on Face5 on Face5");
    EXPECT_EQ(name_of(NamedEntity{1, {2, 4}}).text(), "a crease of Face5");
}

TEST(ExemptReason, TheCatalogueFollowsTheCauses) {
    EXPECT_EQ(name_of(ExemptCause::NarrowCorner), std::string("narrow_corner"));
    EXPECT_EQ(name_of(ExemptCause::SharpEdges), std::string("sharp_edges"));
    EXPECT_EQ(name_of(ExemptCause::MinEdge), std::string("min_edge"));
    EXPECT_EQ(name_of(ExemptCause::NoChangeWithinTolerance), std::string("no_change_within_tolerance"));
    for (int i = 0; i <= static_cast<int>(ExemptCause::NoChangeWithinTolerance); ++i) {
        const auto cause = static_cast<ExemptCause>(i);
        EXPECT_EQ(is_forced(cause), cause <= ExemptCause::SharpEdges) << name_of(cause);
    }
}

}  // namespace
}  // namespace mq::mesh
