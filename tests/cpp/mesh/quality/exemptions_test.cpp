// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/exemptions.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mesh/quality/named_entities.h"
#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

using samples::tetrahedron;

TEST(Report, ExemptionsAreSummedUpByCause) {
    MeshReport r = measure(tetrahedron());
    r.exempt = {{0, {ExemptCause::Fold, -1.0, {}, {}, face(1)}},
                {1, {ExemptCause::NarrowCorner, 7.25, {edge(1), edge(12)}, vertex(3), face(2)}},
                {2, {ExemptCause::NarrowCorner, 10.0, {edge(4), edge(5)}, vertex(6), face(10)}},
                {3, {ExemptCause::NarrowCorner, 9.0, {edge(4), edge(6)}, vertex(6), face(2)}}};
    const auto causes = exempt_causes(r);
    ASSERT_EQ(causes.size(), 2u);
    EXPECT_EQ(causes[0].cause, "the shape itself has a corner of #° between Edge# and Edge# at Vertex# on Face#");
    EXPECT_EQ(causes[0].count, 3u);
    EXPECT_EQ(causes[0].first, 1u);
    EXPECT_EQ(causes[0].faces, (std::vector<std::string>{"Face2", "Face10"}));
    EXPECT_EQ(causes[1].cause, "a further point would fold the mesh on Face#");
    EXPECT_EQ(causes[1].count, 1u);

    const std::string text = to_text(r);
    for (const char* words :
         {"1 triangle below the limit: triangle 0: a further point",
          "3 triangles below the limit, same cause, e.g. triangle 1:", "Edge12", "on Face2, Face10"}) {
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    }
    EXPECT_EQ(text.find("triangle 3"), std::string::npos) << text;
}

TEST(Report, ManyExemptionsMakeAShortText) {
    MeshReport r = measure(tetrahedron());
    for (int i = 0; i < 1000; ++i) {
        r.exempt.push_back({i, {ExemptCause::Budget, -1.0, {}, {}, face(i + 1)}});
    }
    const std::string text = exemptions_text(r);
    EXPECT_LT(text.size(), 300u) << text;
    EXPECT_NE(text.find("and 991 more"), std::string::npos) << text;
    EXPECT_TRUE(exemptions_text(measure(tetrahedron())).empty());
}

}  // namespace
}  // namespace mq::mesh
