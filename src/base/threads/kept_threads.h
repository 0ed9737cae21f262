// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

namespace mq {

/// Calls work(0) in the calling thread and work(1) .. work(others) in other threads at the same time, and returns when
/// all have ended. Calls that have not begun at the end of work(0) are left out, and so are those for which the system
/// gives no more threads. The threads are kept for later: to wake one takes less time than to start one. Several
/// threads may call it at a time, also from `work`.
/// @param work  must not throw
void run_with_others(int others, const std::function<void(int)>& work);

}  // namespace mq
