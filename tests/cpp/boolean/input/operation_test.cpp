// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/input/operation.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "base/error.h"

namespace mq::boolean {
namespace {

TEST(Operation, NamesAreReadBack) {
    for (const char* text : {"union", "intersection", "difference", "symmetric_difference"}) {
        EXPECT_STREQ(name(operation_from(text)), text);
    }
    EXPECT_THROW(operation_from("subtract"), InvalidInput);
}

TEST(Operation, TruthTables) {
    const auto table = [](Operation operation) {
        return std::string{in_result(operation, false, false) ? '1' : '0',
                           in_result(operation, true, false) ? '1' : '0', in_result(operation, false, true) ? '1' : '0',
                           in_result(operation, true, true) ? '1' : '0'};
    };
    EXPECT_EQ(table(Operation::Union), "0111");
    EXPECT_EQ(table(Operation::Intersection), "0001");
    EXPECT_EQ(table(Operation::Difference), "0100");
    EXPECT_EQ(table(Operation::SymmetricDifference), "0110");
}

/// Tokens of the operations in postfix order.
constexpr std::int32_t kOr = -1;
constexpr std::int32_t kAnd = -2;
constexpr std::int32_t kLess = -3;
constexpr std::int32_t kXor = -4;

TEST(Expression, ChainsAreAppliedFromTheFirstOperandOn) {
    const Expression less = Expression::chain(Operation::Difference, 3);
    EXPECT_EQ(less.chained(), Operation::Difference);
    for (int bits = 0; bits < 8; ++bits) {
        const std::int32_t winding[3] = {bits & 1, bits >> 1 & 1, bits >> 2 & 1};
        EXPECT_EQ(less.contains(winding), bits == 1) << bits;
    }
}

TEST(Expression, OperandsMayOccurSeveralTimes) {
    // (a - b) | (b - a)
    const Expression both = Expression::from({0, 1, kLess, 1, 0, kLess, kOr}, 2);
    EXPECT_FALSE(both.chained().has_value());
    for (int bits = 0; bits < 4; ++bits) {
        const std::int32_t winding[2] = {2 * (bits & 1), bits >> 1};
        EXPECT_EQ(both.contains(winding), bits == 1 || bits == 2) << bits;
    }
    EXPECT_EQ(both.pairing(0, 1), Pairing::None);
}

TEST(Expression, WhatIsNoExpressionIsRefused) {
    const std::vector<std::vector<std::int32_t>> wrong{{}, {0}, {0, 1}, {0, kOr}, {kOr}, {0, 2, kOr}, {0, 1, -5}};
    for (const std::vector<std::int32_t>& postfix : wrong) {
        EXPECT_THROW(Expression::from(postfix, 2), InvalidInput);
    }
}

TEST(Expression, ComplementsFollowDeMorgan) {
    // (a - b) - c: b and c are joined where they meet, and both are taken from a.
    const Expression chain = Expression::from({0, 1, kLess, 2, kLess}, 3);
    EXPECT_EQ(chain.pairing(0, 1), Pairing::FirstLessSecond);
    EXPECT_EQ(chain.pairing(1, 0), Pairing::SecondLessFirst);
    EXPECT_EQ(chain.pairing(1, 2), Pairing::Union);
    // a - (b - c): where b and c meet, b ends at c.
    const Expression nested = Expression::from({0, 1, 2, kLess, kLess}, 3);
    EXPECT_EQ(nested.pairing(0, 1), Pairing::FirstLessSecond);
    EXPECT_EQ(nested.pairing(1, 2), Pairing::FirstLessSecond);
    EXPECT_EQ(nested.pairing(0, 2), Pairing::Intersection);
    // a - (b & c), (a - b) | c, (a ^ b) | c
    EXPECT_EQ(Expression::from({0, 1, 2, kAnd, kLess}, 3).pairing(1, 2), Pairing::Intersection);
    EXPECT_EQ(Expression::from({0, 1, kLess, 2, kOr}, 3).pairing(1, 2), Pairing::FirstLessSecond);
    EXPECT_EQ(Expression::from({0, 1, kXor, 2, kOr}, 3).pairing(0, 2), Pairing::None);
}

/// The point that moves is told as one that is looked up, whatever is passed in whatever order.
TEST(Membership, FollowsAPoint) {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        const int operands = 2 + static_cast<int>(random() % 5);
        std::vector<std::int32_t> postfix;
        int open = 0;
        for (int k = 0; k < 2 * operands; ++k) {  // each operand at least once, some twice
            postfix.push_back(k % operands);
            for (++open; open > 1 && (random() % 2 == 0 || k + 1 == 2 * operands); --open) {
                postfix.push_back(-1 - static_cast<std::int32_t>(random() % 4));
            }
        }
        const Expression expression = Expression::from(postfix, operands);
        Membership point(expression);
        std::vector<std::int32_t> winding(static_cast<std::size_t>(operands), 0);
        EXPECT_FALSE(point.inside());
        for (int step = 0; step < 50; ++step) {
            const std::size_t k = random() % winding.size();
            winding[k] = winding[k] == 0 ? 1 : 0;
            point.set(k, winding[k] != 0);
            ASSERT_EQ(point.inside(), expression.contains(winding.data()));
        }
    }
}

}  // namespace
}  // namespace mq::boolean
