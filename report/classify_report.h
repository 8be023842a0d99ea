// SPDX-License-Identifier: LGPL-3.0-or-later
// report/classify_report.h: what veritope classify says beside its answers.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solids/base/verdict.h"

namespace veritope::report {

struct ClassifyReport {
  struct Undecided {
    std::uint64_t line = 0;  ///< of the answers, from 1
    std::string reason;
  };
  struct KeptCertificate {
    std::string path;
    std::uint64_t bytes = 0;
    std::uint64_t uncovered = 0;  ///< answers of which it does not speak
    bool is_checked = false;
  };

  /// Lists hold no more.
  static constexpr std::size_t kMostListed = 100;

  std::string path, sha256;
  std::optional<Verdict> verdict;  ///< nothing: --winding, which does not ask for it
  bool are_decimals_exact = false;
  std::uint64_t points = 0, in = 0, on = 0, out = 0;
  std::uint64_t num_undecided = 0;
  std::vector<Undecided> undecided;  ///< the first kMostListed
  std::uint64_t lookup_cells = 0, lookup_bytes = 0;
  std::optional<KeptCertificate> certificate;
  double seconds_read = 0, seconds_build = 0, seconds_classify = 0;

  /// The last one of `points`.
  void add_undecided(std::string reason) {
    ++num_undecided;
    if (undecided.size() < kMostListed) undecided.push_back({points, std::move(reason)});
  }
};

/// The schema: docs/report.schema.json, classification. One line.
std::string classify_json(const ClassifyReport& report);

}  // namespace veritope::report
