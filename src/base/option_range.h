// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq {

/// The values of an option that is a number. option_ranges.h has those of all options, made of the package's tables.
struct OptionRange {
    const char* name;
    double low, high;
    bool above;    ///< `low` itself is not allowed
    bool or_zero;  ///< 0 stands for no value
    Phrase range;  ///< with places for `low` and `high`

    /// @throws InvalidInput naming the option, its value and its range.
    void require(double value) const {
        const bool holds = std::isfinite(value) && (above ? value > low : value >= low) && value <= high;
        if (!holds && !(or_zero && value == 0.0)) {
            throw InvalidInput(phrases::kNotAllowed, {{"option", name},
                                                      {"value", in_digits(value, 10)},
                                                      {"range", Message(range, {{"number", in_digits(low, 10)},
                                                                                {"number2", in_digits(high, 10)},
                                                                                {"length", in_mm(low)}})}});
        }
    }
};

}  // namespace mq
