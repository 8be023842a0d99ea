// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/stopwatch.h: time that this thread spent.
#pragma once
#include <time.h>

#include <algorithm>

namespace veritope::bench {

/// Nanoseconds since construction: by the wall clock, or this thread's processor time if that is less because the
/// thread had to wait for a processor. The second one costs a system call, too much to be used alone.
class Stopwatch {
 public:
  double ns() const {
    const double wall = now(CLOCK_MONOTONIC) - wall_, own = now(CLOCK_THREAD_CPUTIME_ID) - own_;
    return std::min(wall, own);
  }

 private:
  static double now(clockid_t clock) {
    timespec t;
    clock_gettime(clock, &t);
    return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
  }
  double own_ = now(CLOCK_THREAD_CPUTIME_ID);
  double wall_ = now(CLOCK_MONOTONIC);
};

}  // namespace veritope::bench
