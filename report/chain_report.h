// SPDX-License-Identifier: LGPL-3.0-or-later
// report/chain_report.h: what veritope chain says of the chains of a model.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robust/rational.h"

namespace veritope::report {

struct ChainReport {
  struct Counts {
    std::uint64_t plus = 0, minus = 0, zero = 0, mixed = 0, open = 0;
  };
  struct Hypothesis {
    std::optional<bool> holds;  ///< nothing: undecided
    std::uint64_t places = 0, violations = 0, undecided = 0;
    std::string first;
  };
  struct Origin {
    std::string name;  ///< for people: "0,0,0", "centre of the box"
    std::array<Rational, 3> point;
    double cell_tests = 0;
  };

  struct Refusal {
    std::string figure, why;
  };

  std::string path, sha256;
  std::array<Rational, 3> origin;
  Counts simplices;  ///< mixed, open: 0
  Counts free_form;
  bool is_normal = false;
  Hypothesis planes_share_lines, curves_in_planes, graphs;
  /// The cells of definition 9, and the conditions of definition 1 on them.
  std::uint64_t plus_cells = 0, minus_cells = 0, split = 0, undecided_cells = 0, without_wedge = 0;
  Hypothesis connected, on_one_side, with_vertices_on_patch;
  std::vector<Refusal> refused;
  std::vector<Origin> origins;
};

/// The schema: docs/report.schema.json, chain. One line.
std::string chain_json(const ChainReport& report);
std::string chain_text(const ChainReport& report);

}  // namespace veritope::report
