// SPDX-License-Identifier: LGPL-3.0-or-later
// report/classify_report.h: what veritope classify says beside its answers.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
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

  std::string path, sha256;
  std::optional<Verdict> verdict;  ///< nothing: --winding, which does not ask for it
  bool are_decimals_exact = false;
  std::uint64_t points = 0, in = 0, on = 0, out = 0;
  std::vector<Undecided> undecided;
  std::uint64_t lookup_cells = 0, lookup_bytes = 0;
  std::optional<KeptCertificate> certificate;
  double seconds_read = 0, seconds_build = 0, seconds_classify = 0;
};

/// The schema: docs/report.schema.json, classification. One line.
std::string classify_json(const ClassifyReport& report);

}  // namespace veritope::report
