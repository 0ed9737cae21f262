// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/expansion.h"

#include <algorithm>
#include <cmath>

namespace mq {
namespace {

/// A rounded result and its rounding error: sum + error is the exact value.
struct Rounded {
    double value;
    double error;
};

Rounded two_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    const double a_part = sum - b_part;
    return {sum, (a - a_part) + (b - b_part)};
}

/// two_sum for |a| >= |b| or a = 0.
Rounded fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

Rounded two_product(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

}  // namespace

Expansion Expansion::difference(double a, double b) {
    const Rounded difference = two_sum(a, -b);
    Expansion result;
    result.append(difference.error);
    result.append(difference.value);
    return result;
}

Expansion Expansion::product(double a, double b) {
    const Rounded product = two_product(a, b);
    Expansion result;
    result.append(product.error);
    result.append(product.value);
    return result;
}

void Expansion::spill(double term) {
    if (spilled_.empty()) {
        spilled_.reserve(4 * kInline);
        spilled_.assign(inline_.begin(), inline_.end());
    }
    spilled_.push_back(term);
}

int Expansion::sign() const {
    if (size_ == 0) {
        return 0;
    }
    return terms()[size_ - 1] > 0.0 ? 1 : -1;
}

Expansion Expansion::operator-() const {
    Expansion result;
    for (std::size_t i = 0; i < size_; ++i) {
        result.append(-terms()[i]);
    }
    return result;
}

// Shewchuk's FAST-EXPANSION-SUM: merges the terms by magnitude and carries a running sum. Keeps the terms strongly
// non-overlapping under round-to-even (his theorem 13).
Expansion operator+(const Expansion& a, const Expansion& b) {
    if (a.size_ == 0) {
        return b;
    }
    if (b.size_ == 0) {
        return a;
    }
    if (a.size_ == 1 && b.size_ == 1) {
        return Expansion::difference(a[0], -b[0]);
    }
    const double* a_next = a.terms();
    const double* b_next = b.terms();
    const double* a_end = a_next + a.size_;
    const double* b_end = b_next + b.size_;
    const auto next_smallest = [&] {
        const bool from_a = b_next == b_end || (a_next != a_end && std::abs(*a_next) < std::abs(*b_next));
        return from_a ? *a_next++ : *b_next++;
    };
    Expansion result;
    double sum = next_smallest();
    while (a_next != a_end || b_next != b_end) {
        const Rounded step = two_sum(sum, next_smallest());
        result.append(step.error);
        sum = step.value;
    }
    result.append(sum);
    return result;
}

// Shewchuk's SCALE-EXPANSION (his theorem 19).
Expansion Expansion::scaled(double factor) const {
    Expansion result;
    if (size_ == 0 || factor == 0.0) {
        return result;
    }
    const double* term = terms();
    const Rounded first = two_product(term[0], factor);
    result.append(first.error);
    double sum = first.value;
    for (std::size_t i = 1; i < size_; ++i) {
        const Rounded product = two_product(term[i], factor);
        const Rounded low = two_sum(sum, product.error);
        result.append(low.error);
        const Rounded high = fast_two_sum(product.value, low.value);
        result.append(high.error);
        sum = high.value;
    }
    result.append(sum);
    return result;
}

// Shewchuk's COMPRESS (his theorem 23): a pass down collects the value in the largest terms, a pass up makes them
// non-adjacent again.
Expansion Expansion::compressed() const {
    if (size_ < 2) {
        return *this;
    }
    const double* term = terms();
    Expansion down;
    double sum = term[size_ - 1];
    for (std::size_t i = size_ - 1; i-- > 0;) {
        const Rounded step = fast_two_sum(sum, term[i]);
        if (step.error != 0.0) {
            down.append(step.value);
            sum = step.error;
        } else {
            sum = step.value;
        }
    }
    Expansion result;
    const double* larger = down.terms();
    for (std::size_t i = down.size_; i-- > 0;) {
        const Rounded step = fast_two_sum(larger[i], sum);
        result.append(step.error);
        sum = step.value;
    }
    result.append(sum);
    return result;
}

Expansion operator*(const Expansion& a, const Expansion& b) {
    const Expansion& longer = a.size_ < b.size_ ? b : a;
    const Expansion& shorter = a.size_ < b.size_ ? a : b;
    if (longer.size_ == 1 && shorter.size_ == 1) {
        return Expansion::product(longer[0], shorter[0]);
    }
    Expansion sum;
    for (std::size_t i = 0; i < shorter.size_; ++i) {
        sum = sum + longer.scaled(shorter[i]);
    }
    return sum.compressed();
}

bool same_terms(const Expansion& a, const Expansion& b) {
    return a.size_ == b.size_ && std::equal(a.terms(), a.terms() + a.size_, b.terms());
}

}  // namespace mq
