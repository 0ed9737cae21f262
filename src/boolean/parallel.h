// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace mq::boolean {

/// Runs work(k) for k = 0 .. count - 1 on all cores, in no particular order; an exception of any of them comes through.
/// Results must be written to places of their own, so that they do not depend on the number of threads.
template <typename Work>
void for_all(int count, Work&& work) {
    std::atomic<int> next{0};
    const auto worker = [&] {
        for (int k = next++; k < count; k = next++) {
            work(k);
        }
    };
    const int threads = std::min<int>(count, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
    std::vector<std::future<void>> others;
    for (int i = 1; i < threads; ++i) {
        others.push_back(std::async(std::launch::async, worker));
    }
    worker();
    for (std::future<void>& other : others) {
        other.get();
    }
}

}  // namespace mq::boolean
