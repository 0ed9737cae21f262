// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>

#include "base/parallel.h"

namespace mq {

/// Runs work(k) for k = 0 .. count - 1, a chunk of neighbours at a time, see parallel_for; in this thread where there
/// is one chunk only.
template <typename Work>
void for_chunks(int count, const Work& work) {
    // Calls in a chunk: enough of them that starting it costs little.
    constexpr int kChunk = 64;
    const auto chunk = [&](int i) {
        const int end = std::min((i + 1) * kChunk, count);
        for (int k = i * kChunk; k < end; ++k) {
            work(k);
        }
    };
    parallel_for((count + kChunk - 1) / kChunk, chunk);
}

}  // namespace mq
