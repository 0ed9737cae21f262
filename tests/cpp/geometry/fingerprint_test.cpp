// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/fingerprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace mq::geometry {
namespace {

Fingerprint of(const std::vector<double>& numbers) {
    Fingerprint result{};
    for (const double x : numbers) {
        add_to(result, x);
    }
    return result;
}

TEST(Fingerprint, IsThatOfTheNumbersInTheirOrder) {
    EXPECT_EQ(of({1.0, 2.0, 3.0}), of({1.0, 2.0, 3.0}));
    EXPECT_NE(of({1.0, 2.0, 3.0}), of({2.0, 1.0, 3.0}));
    EXPECT_NE(of({1.0}), of({1.0, 0.0}));
    EXPECT_NE(of({1.0}), of({std::nextafter(1.0, 2.0)}));
    EXPECT_EQ(of({0.0}), of({-0.0}));
}

TEST(Fingerprint, TellsTypesAndNestingApartAsTheyAreAdded) {
    Fingerprint vector{};
    add_to(vector, Vec3(1.0, 2.0, 3.0));
    EXPECT_EQ(vector, of({1.0, 2.0, 3.0}));
    Fingerprint nested{};
    add_to(nested, of({1.0}));
    EXPECT_NE(nested, of({1.0}));
}

TEST(Fingerprint, SmallDifferencesSpreadOverAllBits) {
    std::set<Fingerprint> all;
    std::set<std::uint32_t> low_bits;
    for (int i = 0; i < 10000; ++i) {
        Fingerprint one{};
        add_to(one, i);
        all.insert(one);
        low_bits.insert(static_cast<std::uint32_t>(one[0]));
    }
    EXPECT_EQ(all.size(), 10000u);
    EXPECT_GT(low_bits.size(), 9990u);
}

}  // namespace
}  // namespace mq::geometry
