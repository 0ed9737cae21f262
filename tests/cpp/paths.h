// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace mq {

/// The folder of the parts that tests read, tests/cpp/geometry/parts.
std::string stored_parts();
/// The program that fills volumes, as it was built.
std::string fill_program();

}  // namespace mq
