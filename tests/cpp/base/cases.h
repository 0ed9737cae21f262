// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace mq {

/// The number of random cases in a loop. Under a sanitizer the memory accesses are tested, not the odds of a rare case,
/// and each of them takes ten times as long.
constexpr int scaled_cases(int cases) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return cases / 20;
#else
    return cases;
#endif
}

}  // namespace mq
