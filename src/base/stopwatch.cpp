// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/stopwatch.h"

#include <sys/resource.h>

#include <initializer_list>

namespace mq {

double cpu_seconds() {
    double sum = 0.0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        getrusage(who, &usage);
        for (const timeval& t : {usage.ru_utime, usage.ru_stime}) {
            sum += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
        }
    }
    return sum;
}

}  // namespace mq
