// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "base/vec.h"

/// What libFuzzer and replay.cpp call with each input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/// What fuzz targets make of the bytes that they are given.
namespace mq::fuzz {

/// Ends the program, which is how a fuzz target reports a broken promise.
inline void require(bool holds, const char* promise) {
    if (!holds) {
        std::fprintf(stderr, "broken promise: %s\n", promise);
        std::abort();
    }
}

/// Takes values off the front of an input; zeros after its end.
class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

    std::size_t left() const { return left_; }

    template <typename T>
    T take() {
        T value{};
        const std::size_t count = sizeof value < left_ ? sizeof value : left_;
        if (count > 0) {
            std::memcpy(&value, data_, count);
        }
        data_ += count;
        left_ -= count;
        return value;
    }

    /// From `low` to `high`, both included, at most 256 values.
    int number(int low, int high) { return low + take<std::uint8_t>() % (high - low + 1); }

    /// From `low` to `high`, in 65,535 steps.
    double part(double low, double high) {
        return low + (high - low) * take<std::uint16_t>() / std::numeric_limits<std::uint16_t>::max();
    }

    /// Mostly quarters from -32 to 31.75, so that values coincide; sometimes any single or double, NaN among them.
    double real() {
        constexpr int kQuarters = 160;  // of 256
        constexpr int kThousandths = 224;
        constexpr int kSingles = 240;
        const int kind = take<std::uint8_t>();
        if (kind < kQuarters) {
            return 0.25 * take<std::int8_t>();
        }
        if (kind < kThousandths) {
            return 1e-3 * take<std::int16_t>();
        }
        return kind < kSingles ? static_cast<double>(take<float>()) : take<double>();
    }

    /// As `real`, of a size that predicates are exact for, or 0.
    double safe_real() { return safe(real()); }

    /// As `safe_real`, or a little beside another value, where filters of predicates must give up.
    double near(double other) {
        constexpr int kNeighbours = 3;
        const int kind = number(0, 3);
        if (kind > 0) {
            return safe_real();
        }
        double value = other;
        for (int i = number(0, kNeighbours); i > 0; --i) {
            value = std::nextafter(value, std::numeric_limits<double>::max());
        }
        return safe(value);
    }

    /// The value, or 0 where predicates are not exact.
    static double safe(double value) {
        constexpr double kLargest = 1e15;
        constexpr double kSmallest = 1e-15;
        const double size = std::abs(value);
        return size >= kSmallest && size <= kLargest ? value : 0.0;
    }

    Vec3 point() {
        const double x = real();
        const double y = real();
        return {x, y, real()};
    }

    Vec3 safe_point() {
        const double x = safe_real();
        const double y = safe_real();
        return {x, y, safe_real()};
    }

  private:
    const std::uint8_t* data_;
    std::size_t left_;
};

}  // namespace mq::fuzz
