// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/stopwatch.h: wall-clock time, for reports.
#pragma once
#include <chrono>
#include <utility>

namespace veritope {

class Stopwatch {
 public:
  /// Seconds since construction or the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace veritope
