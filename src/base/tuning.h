// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// Constants that tune a heuristic are declared with MESHQUALITY_TUNED, those of a stage in one struct. They are
/// constants; only a build with the CMake option MESHQUALITY_TUNABLE multiplies each by the factor that the environment
/// variable MESHQUALITY_TUNING gives for the end of its folder and name ("refine/kMaxShrinks=0.5,kMaxRings=2"), so that
/// benchmarks/tuning can measure all of them at half and at double with one build.
#ifdef MESHQUALITY_TUNABLE

#include <cstdlib>
#include <sstream>
#include <string>

namespace mq {

/// Returns the factor that the environment gives for a constant of a file, or 1.
inline double tuning_factor(const std::string& file, const std::string& name) {
    const char* all = std::getenv("MESHQUALITY_TUNING");
    std::istringstream entries(all != nullptr ? all : "");
    const std::string whole = file.substr(0, file.rfind('/') + 1) + name;
    for (std::string entry; std::getline(entries, entry, ',');) {
        const std::size_t equals = entry.find('=');
        const std::string end = '/' + entry.substr(0, equals);
        if (equals != std::string::npos && end.size() <= whole.size() &&
            whole.compare(whole.size() - end.size(), end.size(), end) == 0) {
            return std::stod(entry.substr(equals + 1));
        }
    }
    return 1.0;
}

}  // namespace mq

#define MESHQUALITY_TUNED(type, name, value) \
    static inline const type name = static_cast<type>(mq::tuning_factor(__FILE__, #name) * static_cast<double>(value))

#else

#define MESHQUALITY_TUNED(type, name, value) static constexpr type name = value

#endif

namespace mq {

/// Bounds of work that ended by itself in all measurements (docs/measurements/tuning.md). They take effect if states
/// recur, for instance by rounding. The bound of rounds through a whole model, and of places looked at around one ...
constexpr int kMostRounds = 16;
/// ... of steps that take little time ...
constexpr int kMostSteps = 100;
/// ... and of Newton steps of a projection; each about squares the distance.
constexpr int kNewtonSteps = 8;
/// Least gain in a quality of at most 1, so that changes do not cycle by rounding.
constexpr double kLeastGain = 1e-3;

}  // namespace mq
