// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/operation.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace mq::boolean
