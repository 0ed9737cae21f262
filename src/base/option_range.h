// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <string>

#include "base/error.h"

namespace mq {

/// The values of an option that is a number. option_ranges.h has those of all options, made of the package's tables.
struct OptionRange {
    const char* name;
    double low, high;
    bool above;    ///< `low` itself is not allowed
    bool or_zero;  ///< 0 stands for no value
    const char* text;

    /// @throws InvalidInput naming the option, its value and its range.
    void require(double value) const {
        const bool holds = std::isfinite(value) && (above ? value > low : value >= low) && value <= high;
        if (!holds && !(or_zero && value == 0.0)) {
            throw InvalidInput(std::string(name) + " is " + std::to_string(value) + ": it must be " + text);
        }
    }
};

}  // namespace mq
