// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/shared_engine.h"

#include <unistd.h>

namespace mq::python {

namespace {

struct Shared {
    // Never deleted: a daemon thread may still hold it while the process exits. Its thread is ended before that.
    geometry::Engine* engine = nullptr;
    pid_t owner = 0;
};

Shared& shared() {
    static Shared instance;
    return instance;
}

}  // namespace

geometry::Engine& shared_engine() {
    Shared& s = shared();
    // Threads do not survive a fork: the child could neither use nor join its parent's engine.
    if (s.engine == nullptr || s.owner != getpid()) {
        s.engine = new geometry::Engine();
        s.owner = getpid();
    }
    return *s.engine;
}

void stop_shared_engine() {
    const Shared& s = shared();
    if (s.engine != nullptr && s.owner == getpid()) {
        s.engine->shut_down();
    }
}

}  // namespace mq::python
