// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/running_work.h"

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <set>

#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "python/python_lock.h"
#include "python/shared_engine.h"

namespace mq::python {

namespace {

/// Time for the work to end after it was cancelled: our own loops check for a cancellation several times within 0.2 s.
constexpr std::chrono::seconds kGrace(5);

void end_work();

struct Running {
    /// sys.exit() in a script of FreeCAD's console ends the process without ending Python.
    Running() { std::atexit(&end_work); }

    std::mutex mutex;
    std::condition_variable changed;
    std::set<RunningWork*> works;
    bool closed = false;
    pid_t owner = getpid();

    /// Threads do not survive a fork: the child has no work yet. Call it with the mutex held.
    void forget_parent() {
        if (owner != getpid()) {
            works.clear();
            owner = getpid();
        }
    }
};

Running& running() {
    // Never deleted: threads that Python has stopped may still hold it while the process exits.
    static Running& instance = *new Running();
    return instance;
}

/// @returns whether all work has ended
bool end_all() {
    Running& all = running();
    std::unique_lock<std::mutex> lock(all.mutex);
    all.forget_parent();
    all.closed = true;
    for (RunningWork* work : all.works) {
        work->cancel();
    }
    return all.changed.wait_for(lock, kGrace, [&] { return all.works.empty(); });
}

/// Makes the process end with its status, but without the destructors of objects that the work still uses.
void skip_destructors() {
#ifdef __GLIBC__
    on_exit(
        [](int status, void* /*argument*/) {
            std::fflush(nullptr);
            _exit(status);
        },
        nullptr);
#endif
}

void end_work() {
    if (end_all()) {
        stop_shared_engine();
    } else {
        skip_destructors();
    }
}

}  // namespace

RunningWork::RunningWork(Progress& progress) : progress_(progress) {
    Running& all = running();
    const std::lock_guard<std::mutex> lock(all.mutex);
    all.forget_parent();
    if (all.closed) {
        throw Cancelled(phrases::kPythonEnds);
    }
    all.works.insert(this);
}

void RunningWork::end() {
    Running& all = running();
    const std::lock_guard<std::mutex> lock(all.mutex);
    if (all.works.erase(this) > 0) {
        all.changed.notify_all();
    }
}

void end_with_python() {
    const FreedLock free;
    end_work();
}

}  // namespace mq::python
