// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/simplex_lattice.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace mq::elements {
namespace {

TEST(Lattice, HoldsEveryPointOnce) {
    for (int dimension = 1; dimension <= 3; ++dimension) {
        for (int degree = 0; degree <= kMaxDegree; ++degree) {
            const Lattice& lattice = Lattice::of(dimension, degree);
            const int n = degree;
            const int size = dimension == 1   ? n + 1
                             : dimension == 2 ? (n + 1) * (n + 2) / 2
                                              : (n + 1) * (n + 2) * (n + 3) / 6;
            ASSERT_EQ(lattice.size(), size);
            for (int i = 0; i < size; ++i) {
                EXPECT_EQ(lattice.index(lattice.exponents(i)), i);
            }
        }
    }
    EXPECT_THROW(Lattice::of(3, kMaxDegree + 1), InvalidInput);
    EXPECT_THROW(Lattice::of(0, 2), InvalidInput);
}

}  // namespace
}  // namespace mq::elements
