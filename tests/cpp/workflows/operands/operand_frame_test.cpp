// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/operands/operand_frame.h"

#include <gtest/gtest.h>

#include "boolean/closed_solids.h"

namespace mq::workflows {
namespace {

using boolean::solids::box;

TEST(OperandFrame, OperandsInItAreUsedWithoutACopy) {
    const mesh::TriangleMesh a = box(Vec3(0, 0, 0), Vec3(1, 1, 1)), b = box(Vec3(1, 1, 1), Vec3(4, 2, 2));
    const OperandFrame frame({{&a, false}, {&b, true}});
    EXPECT_EQ(frame.meshes()[0], &a);
    EXPECT_EQ(frame.meshes()[1], &b);
    EXPECT_EQ(frame.size(), 4.0);
    EXPECT_TRUE(frame.single());
}

TEST(OperandFrame, FarFromTheOriginOperandsGetOneLocalFrame) {
    mesh::TriangleMesh a = box(Vec3(0, 0, 0), Vec3(1, 1, 1)), b = a;
    a.origin = Vec3(1e6, 0, 0);
    b.origin = Vec3(1e6 + 0.5, 0, 0);
    const OperandFrame frame({{&a, true}, {&b, true}});
    EXPECT_TRUE(frame.single());
    EXPECT_EQ(frame.meshes()[0]->origin, frame.meshes()[1]->origin);
    EXPECT_NEAR(frame.size(), 1.5, 1e-6);
    for (std::size_t i = 0; i < 2; ++i) {
        const mesh::TriangleMesh& given = i == 0 ? a : b;
        const mesh::TriangleMesh& moved = *frame.meshes()[i];
        for (std::size_t v = 0; v < given.vertices.size(); ++v) {
            EXPECT_TRUE(is_single(moved.vertices[v]));
            EXPECT_LT((moved.vertices[v] + moved.origin - given.vertices[v] - given.origin).norm(), 1e-6);
        }
    }
}

TEST(OperandFrame, MoreDigitsThanSinglePrecisionAreKeptUnlessTheyMayBeRounded) {
    mesh::TriangleMesh a = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    a.vertices[0].x() = 0.1;
    EXPECT_FALSE(OperandFrame({{&a, false}}).single());
    EXPECT_EQ(OperandFrame({{&a, false}}).meshes()[0]->vertices[0].x(), 0.1);
    const OperandFrame rounded({{&a, true}});
    EXPECT_TRUE(rounded.single());
    EXPECT_TRUE(is_single(rounded.meshes()[0]->vertices[0]));
}

}  // namespace
}  // namespace mq::workflows
