// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/print_row.h: a row of ./dev bench in nanoseconds.
#pragma once
#include <cstdio>
#include <string>

namespace veritope::bench {

/// @param peer  a row without a peer has a number that is not positive
/// @param more  further keys with their values, as in JSON, or nothing
inline void print_row(const std::string& row, double ours, double peer, const std::string& more) {
  std::printf("{\"row\":\"%s\",\"ours\":%.1f,\"peer\":", row.c_str(), ours);
  if (peer > 0) {
    std::printf("%.1f,\"ratio\":%.4f", peer, ours / peer);
  } else {
    std::printf("null");
  }
  std::printf(",\"unit\":\"ns\"%s%s}\n", more.empty() ? "" : ",", more.c_str());
  std::fflush(stdout);
}

}  // namespace veritope::bench
