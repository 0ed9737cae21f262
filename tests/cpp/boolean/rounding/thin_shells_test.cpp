// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/thin_shells.h"

#include <gtest/gtest.h>

#include "boolean/closed_solids.h"

namespace mq::boolean {
namespace {

/// A block and a film beside it of 2 by 2 by 0.01.
ResultMesh block_and_film() {
    const mesh::TriangleMesh both =
        solids::together(solids::box(Vec3(0, 0, 0), Vec3(2, 2, 2)), solids::box(Vec3(0, 0, 3), Vec3(2, 2, 3.01)));
    ResultMesh draft;
    draft.vertices = both.vertices;
    draft.made.assign(both.vertices.size(), kFromOperand);
    draft.triangles = both.triangles;
    draft.source.resize(both.triangles.size());
    draft.displacement.resize(both.triangles.size(), 0.0);
    for (std::size_t t = 0; t < both.triangles.size(); ++t) {
        draft.from.push_back(static_cast<std::int32_t>(t));
    }
    return draft;
}

/// Operand 0 has the first `count` triangles, operand 1 the others.
Soup soup_of(std::size_t count) {
    Soup soup;
    soup.operands = 2;
    for (std::size_t t = 0; t < 24; ++t) {
        soup.source.push_back({t < count ? 0 : 1, static_cast<std::int32_t>(t)});
    }
    return soup;
}

TEST(ThinShells, OfCommonFacesAreRemoved) {
    ResultMesh draft = block_and_film();
    std::vector<char> in_contact(24, 0);
    in_contact[20] = 1;
    EXPECT_EQ(remove_thin_shells(draft, soup_of(18), in_contact, {0.02, 0.0}), 12u);
    ASSERT_EQ(draft.triangles.size(), 12u);
    EXPECT_EQ(draft.vertices.size(), 8u);
    EXPECT_EQ(draft.vertices.back().z(), 2.0);
}

TEST(ThinShells, ThickerOnesStay) {
    ResultMesh draft = block_and_film();
    EXPECT_EQ(remove_thin_shells(draft, soup_of(18), std::vector<char>(24, 1), {0.005, 0.0}), 0u);
    EXPECT_EQ(draft.triangles.size(), 24u);
}

TEST(ThinShells, SoDoThoseOfOneOperandAndThoseWithoutACommonFace) {
    ResultMesh draft = block_and_film();
    EXPECT_EQ(remove_thin_shells(draft, soup_of(12), std::vector<char>(24, 1), {0.02, 0.0}), 0u);
    EXPECT_EQ(remove_thin_shells(draft, soup_of(18), std::vector<char>(24, 0), {0.02, 0.0}), 0u);
}

TEST(ThinShells, ThatSinglePrecisionFlattensAreRemovedWhoeverMadeThem) {
    ResultMesh draft = block_and_film();
    draft.source.assign(24, {0, 0});
    EXPECT_EQ(remove_thin_shells(draft, soup_of(24), {}, {0.0, 0.02}), 0u) << "an operand's own shell stays";
    draft.source[23].operand = -1;
    EXPECT_EQ(remove_thin_shells(draft, soup_of(24), {}, {0.0, 0.005}), 0u) << "a thicker one stays";
    EXPECT_EQ(remove_thin_shells(draft, soup_of(24), {}, {0.0, 0.02}), 12u);
}

}  // namespace
}  // namespace mq::boolean
