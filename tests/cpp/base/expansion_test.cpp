// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/expansion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "base/cases.h"
#include "base/exact.h"

namespace mq {
namespace {

/// Random expansions with terms of very different magnitude.
class ExpansionTest : public testing::Test {
  protected:
    double number() {
        const int exponent = std::uniform_int_distribution<int>(-60, 60)(random_);
        const double digits = std::uniform_real_distribution<double>(-1.0, 1.0)(random_);
        return std::uniform_int_distribution<int>(0, 9)(random_) == 0 ? 0.0 : std::ldexp(digits, exponent);
    }
    Expansion expansion() {
        Expansion sum;
        for (int i = std::uniform_int_distribution<int>(0, 6)(random_); i > 0; --i) {
            sum = sum + Expansion::product(number(), number());
        }
        return sum;
    }

    std::mt19937_64 random_{11};
};

double lowest_bit(double x) {
    int exponent = 0;
    const double digits = std::ldexp(std::frexp(x, &exponent), 53);
    const auto bits = static_cast<std::int64_t>(digits);
    return std::ldexp(static_cast<double>(bits & -bits), exponent - 53);
}

void expect_valid(const Expansion& e) {
    for (std::size_t i = 0; i < e.size(); ++i) {
        ASSERT_NE(e[i], 0.0);
        if (i > 0) {
            ASSERT_GT(lowest_bit(e[i]), std::abs(e[i - 1])) << "terms overlap";
        }
    }
    ASSERT_EQ(e.sign(), sgn(exact::value(e)));
}

TEST_F(ExpansionTest, DifferenceAndProductOfNumbersAreExact) {
    for (int i = 0; i < scaled_cases(100000); ++i) {
        const double a = number();
        const double b = number();
        const mpq_class difference = mpq_class(a) - mpq_class(b);
        const mpq_class product = mpq_class(a) * mpq_class(b);
        ASSERT_EQ(exact::value(Expansion::difference(a, b)), difference);
        ASSERT_EQ(exact::value(Expansion::product(a, b)), product);
    }
}

TEST_F(ExpansionTest, ArithmeticIsExact) {
    for (int i = 0; i < scaled_cases(20000); ++i) {
        const Expansion a = expansion();
        const Expansion b = expansion();
        const double factor = number();
        const mpq_class a_exact = exact::value(a);
        const mpq_class b_exact = exact::value(b);
        const std::array<Expansion, 5> results{a + b, a - b, a * b, a.scaled(factor), a.compressed()};
        const std::array<mpq_class, 5> expected{a_exact + b_exact, a_exact - b_exact, a_exact * b_exact,
                                                a_exact * factor, a_exact};
        for (std::size_t k = 0; k < results.size(); ++k) {
            ASSERT_EQ(exact::value(results[k]), expected[k]) << "operation " << k << " of case " << i;
            expect_valid(results[k]);
        }
    }
}

TEST_F(ExpansionTest, CompressionGathersTheValueInTheLastTerm) {
    for (int i = 0; i < scaled_cases(20000); ++i) {
        const Expansion e = expansion();
        const Expansion compressed = e.compressed();
        ASSERT_LE(compressed.size(), e.size());
        if (compressed.size() > 0) {
            const mpq_class value = exact::value(e);
            const mpq_class unit = abs(value) * mpq_class(std::ldexp(1.0, -52));
            ASSERT_LE(abs(value - mpq_class(compressed[compressed.size() - 1])), unit);
        }
    }
}

TEST_F(ExpansionTest, HighPowersStaySmallAndExact) {
    const Expansion base = Expansion::difference(0x1p60 / 3.0, 0x1p-20 / 7.0);
    Expansion power(1.0);
    mpq_class expected = 1;
    for (int i = 0; i < 12; ++i) {
        power = power * base;
        expected *= exact::value(base);
        ASSERT_EQ(exact::value(power), expected);
    }
    // 12 factors of about 135 bits each, within the range of exponents: more than the terms held in place.
    EXPECT_GT(power.size(), 16u);
    EXPECT_LE(power.size(), 40u);

    Expansion copy = power;
    EXPECT_TRUE(same_terms(copy, power));
    copy = base;
    EXPECT_TRUE(same_terms(copy, base));
    copy = power;
    EXPECT_TRUE(same_terms(copy, power));
}

TEST_F(ExpansionTest, ZeroHasNoTerms) {
    EXPECT_EQ(Expansion().size(), 0u);
    EXPECT_EQ(Expansion(0.0).size(), 0u);
    EXPECT_EQ(Expansion::difference(0.1, 0.1).sign(), 0);
    const Expansion a = expansion() + Expansion(1.0);
    EXPECT_EQ((a - a).size(), 0u);
    EXPECT_EQ((a * Expansion()).size(), 0u);
    EXPECT_EQ(Expansion().compressed().size(), 0u);
}

TEST_F(ExpansionTest, SameTermsComparesTerms) {
    const Expansion a = Expansion::product(0.1, 0.1);
    EXPECT_TRUE(same_terms(a, Expansion::product(0.1, 0.1)));
    EXPECT_FALSE(same_terms(a, -a));
    EXPECT_FALSE(same_terms(a, Expansion()));
}

}  // namespace
}  // namespace mq
