// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "geometry/session.h"

namespace mq::triangulate {

/// Calls `work(session, progress, k)` for k = 0 .. count - 1, as Session::run_apart does. The progress of a call is
/// cancelled with `whole`, and once an earlier one has failed, so that it ends soon.
/// @throws the exception of the call with the lowest k that fails, for any number of threads
template <typename Work>
void run_apart(geometry::Session& session, const Progress& whole, int count, const Work& work) {
    std::vector<std::unique_ptr<Progress>> progress;
    for (int k = 0; k < count; ++k) {
        progress.push_back(std::make_unique<Progress>(&whole));
    }
    const auto cancel_from = [&](int first) {
        std::for_each(progress.begin() + first, progress.end(), [](const auto& later) { later->cancel(); });
    };
    if (count == 0) {
        return;
    }
    session.run_apart(count, [&](geometry::Session& own, int k) {
        try {
            work(own, *progress[static_cast<std::size_t>(k)], k);
        } catch (...) {
            cancel_from(k + 1);
            throw;
        }
    });
}

}  // namespace mq::triangulate
