// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <vector>

namespace mq {

/// A number held exactly as a sum of doubles (Shewchuk 1997), for the predicates whose filter cannot decide.
///
/// The terms grow in magnitude, none is zero, and they are strongly non-overlapping; so the last one has the sign of
/// the whole. Arithmetic is exact as long as no term over- or underflows. Zero has no terms.
class Expansion {
  public:
    // Entries beyond the terms are not cleared, which halves the time of an exact predicate; memcpy may copy them.
    Expansion() {}
    Expansion(const Expansion& other) { *this = other; }
    Expansion& operator=(const Expansion& other) {
        size_ = other.size_;
        if (size_ > kInline || !spilled_.empty()) {
            spilled_ = other.spilled_;
        }
        std::memcpy(inline_.data(), other.inline_.data(), sizeof inline_);
        return *this;
    }
    explicit Expansion(double value) { append(value); }

    /// a - b, exactly.
    static Expansion difference(double a, double b);
    /// a b, exactly.
    static Expansion product(double a, double b);

    std::size_t size() const { return size_; }
    double operator[](std::size_t i) const { return terms()[i]; }
    int sign() const;

    Expansion scaled(double factor) const;
    /// The same value with few terms: the last term alone differs from the value by at most one unit in its last place.
    Expansion compressed() const;

    Expansion operator-() const;
    friend Expansion operator+(const Expansion& a, const Expansion& b);
    friend Expansion operator-(const Expansion& a, const Expansion& b) { return a + (-b); }
    /// Compressed, so that polynomials of high degree stay small.
    friend Expansion operator*(const Expansion& a, const Expansion& b);
    /// Whether both have the same terms. A value may have two forms: true implies equal values, false does not imply
    /// different ones.
    friend bool same_terms(const Expansion& a, const Expansion& b);

  private:
    /// Terms held in place: enough for nearly all degree-8 polynomials of single-precision coordinates; longer sums go
    /// to the heap.
    static constexpr std::size_t kInline = 16;

    const double* terms() const { return spilled_.empty() ? inline_.data() : spilled_.data(); }
    /// Appends a term unless it is zero.
    void append(double term) {
        if (term != 0.0) {
            if (size_ < kInline) {
                inline_[size_] = term;
            } else {
                spill(term);
            }
            ++size_;
        }
    }
    void spill(double term);

    std::size_t size_ = 0;
    std::array<double, kInline> inline_;
    std::vector<double> spilled_;
};

}  // namespace mq
