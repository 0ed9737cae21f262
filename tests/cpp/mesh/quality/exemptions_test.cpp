// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/exemptions.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

using samples::tetrahedron;

TEST(Report, ExemptionsAreSummedUpByCause) {
    MeshReport r = measure(tetrahedron());
    r.exempt = {{0, "a further point would fold the mesh on Face1"},
                {1, "the shape itself has a corner of 7.25° between Edge1 and Edge12 at Vertex3 on Face2"},
                {2, "the shape itself has a corner of 10.00° between Edge4 and Edge5 at Vertex6 on Face10"},
                {3, "the shape itself has a corner of 9° between Edge4 and Edge6 at Vertex6 on Face2"}};
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
        r.exempt.emplace_back(i, "the triangle limit max_triangles was reached on Face" + std::to_string(i + 1));
    }
    const std::string text = exemptions_text(r);
    EXPECT_LT(text.size(), 300u) << text;
    EXPECT_NE(text.find("and 992 more"), std::string::npos) << text;
    EXPECT_TRUE(exemptions_text(measure(tetrahedron())).empty());
}

}  // namespace
}  // namespace mq::mesh
