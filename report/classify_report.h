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
#include "solids/classify/point_answer.h"

namespace veritope::report {

struct ClassifyReport {
  /// Lists hold no more.
  static constexpr std::size_t kMostListed = 100;

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

  /// What --orient auto reversed.
  struct ReversedParts {
    std::string parts;  ///< "faces" of a mesh, "entities" of a spline model
    std::uint64_t total = 0;
    std::vector<std::uint64_t> first;  ///< numbers, ascending: the first kMostListed

    void add(std::uint64_t number) {
      ++total;
      if (first.size() < kMostListed) first.push_back(number);
    }
  };

  std::string path, sha256;
  std::optional<Verdict> verdict;  ///< nothing: --winding, which does not ask for it
  bool are_decimals_exact = false;
  std::string by = "service";             ///< as --by has it
  std::optional<ExactPoint> origin;       ///< of the chain
  bool is_winding = false;                ///< --winding
  std::optional<ReversedParts> reversed;  ///< nothing: --orient auto reversed nothing
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
