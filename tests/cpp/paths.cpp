// SPDX-License-Identifier: LGPL-2.1-or-later
#include "paths.h"

namespace mq {

std::string stored_parts() {
    return MESHQUALITY_STORED_PARTS;
}

}  // namespace mq
