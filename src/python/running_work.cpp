// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/running_work.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>

#include "base/system/system.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "python/python_lock.h"
#include "python/shared_engine.h"

namespace mq::python {

namespace {

/// Time for the work to end after it was cancelled: our own loops check for a cancellation several times within 0.2 s.
constexpr std::chrono::seconds kGrace(5);

void end_work();
struct Running;
Running& running();

struct Running {
    /// sys.exit() in a script of FreeCAD's console ends the process without ending Python.
    Running() {
        at_exit(&end_work);
        at_fork([] { running().mutex.lock(); }, [] { running().mutex.unlock(); },
                [] {
                    running().works.clear();  // Their threads exist in the parent process only.
                    running().mutex.unlock();
                });
    }

    std::mutex mutex;
    std::condition_variable changed;
    std::set<RunningWork*> works;
    bool closed = false;
    bool given_up = false;  ///< whether work did not end within the grace: it is not waited for again
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
    all.closed = true;
    for (RunningWork* work : all.works) {
        work->cancel();
    }
    const auto ended = [&] { return all.works.empty(); };
    all.given_up = all.given_up || !all.changed.wait_for(lock, kGrace, ended);
    return ended();
}

void end_work() {
    if (end_all()) {
        stop_shared_engine();
    } else {
        skip_destructors();  // as the work still uses objects that these would end
    }
}

}  // namespace

RunningWork::RunningWork(Progress& progress) : progress_(progress) {
    Running& all = running();
    const std::lock_guard<std::mutex> lock(all.mutex);
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

void end_with_process() {
    // Python calls this on its main thread, which is the one that exits the process, whichever thread imports us.
    Py_AddPendingCall(
        [](void*) {
            at_thread_end(&end_work);
            return 0;
        },
        nullptr);
}

void end_with_python() {
    const FreedLock free;
    end_work();
}

}  // namespace mq::python
