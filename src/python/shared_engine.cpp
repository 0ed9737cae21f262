// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/shared_engine.h"

#include "base/system/system.h"

namespace mq::python {

namespace {

/// Null: not started. Never deleted: a daemon thread may still hold it while the process exits. Its thread is ended
/// before that.
geometry::Engine* engine = nullptr;

}  // namespace

geometry::Engine& shared_engine() {
    if (engine == nullptr) {
        // Threads do not survive a fork: the child could neither use nor join its parent's engine.
        at_fork(nullptr, nullptr, [] { engine = nullptr; });
        engine = new geometry::Engine();
    }
    return *engine;
}

void stop_shared_engine() {
    if (engine != nullptr) {
        engine->shut_down();
    }
}

}  // namespace mq::python
