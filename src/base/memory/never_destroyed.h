// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <utility>

namespace mq {

/// Returns a value that is never destroyed, for tables that functions keep: when the process exits, threads that still
/// work may use them, and static objects are destroyed before the work is told to end (see python/running_work.cpp).
template <typename T>
T& never_destroyed(T value) {
    return *new T(std::move(value));
}

}  // namespace mq
