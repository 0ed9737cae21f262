// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/tuning.h"

#ifdef MESHQUALITY_TUNABLE

#include <cstdlib>
#include <sstream>
#include <string>

namespace mq {

double tuning_factor(const char* name) {
    const char* all = std::getenv("MESHQUALITY_TUNING");
    std::istringstream entries(all != nullptr ? all : "");
    for (std::string entry; std::getline(entries, entry, ',');) {
        const std::size_t equals = entry.find('=');
        if (entry.substr(0, equals) == name && equals != std::string::npos) {
            return std::stod(entry.substr(equals + 1));
        }
    }
    return 1.0;
}

}  // namespace mq

#endif
