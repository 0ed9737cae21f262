// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace mq {

/// The exponent of the lowest bit that is set in any of the numbers.
inline int lowest_bit(std::initializer_list<double> numbers) {
    int lowest = std::numeric_limits<double>::max_exponent;
    for (const double number : numbers) {
        int exponent = 0;
        const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(number, &exponent), 53));
        if (mantissa != 0) {
            lowest = std::min(lowest, exponent - 53 + std::ilogb(static_cast<double>(mantissa & -mantissa)));
        }
    }
    return lowest;
}

}  // namespace mq
