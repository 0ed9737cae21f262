// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <string>

#include "triangulate/triangulate.h"

namespace mq::triangulate {

namespace {

void check_length(const char* name, double value) {
    if (!std::isfinite(value) || value < 0.0) {
        throw InvalidInput(std::string(name) + " is " + std::to_string(value) +
                           ": it must be a number of at least 0 mm");
    }
}

}  // namespace

void Options::validate() const {
    if (!(min_angle > 0.0 && min_angle <= 34.0)) {
        throw InvalidInput("min_angle is " + std::to_string(min_angle) +
                           " degrees: it must be above 0 and at most 34; 25 to 30 is usual");
    }
    check_length("chord_height", chord_height);
    check_length("chord_height_relative", chord_height_relative);
    check_length("max_edge", max_edge);
    check_length("min_edge", min_edge);
    if (chord_height > 0.0 && chord_height_relative > 0.0) {
        throw InvalidInput("chord_height and chord_height_relative are both given: choose one");
    }
    if (max_edge > 0.0 && min_edge > max_edge) {
        throw InvalidInput("min_edge is larger than max_edge");
    }
}

}  // namespace mq::triangulate
