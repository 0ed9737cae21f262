// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace mq {

/// The folder of the parts that tests read, tests/cpp/geometry/parts.
std::string stored_parts();

}  // namespace mq
