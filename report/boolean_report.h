// SPDX-License-Identifier: LGPL-3.0-or-later
// report/boolean_report.h: what veritope boolean says of an expression.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "interval/exact_box.h"

namespace veritope::report {

struct BooleanReport {
  struct Operand {
    std::string name, path, sha256, format;
    std::uint64_t bytes = 0;
  };

  std::string path;  ///< of the chain file
  std::string sha256;
  std::uint64_t bytes = 0;
  std::string expression;   ///< with the names of the operands
  std::string normal_form;  ///< unions and intersections of variables with signs
  std::uint64_t leaves = 0, depth = 0, variables = 0;
  std::vector<Operand> operands;
  ExactBox<3> box;
  double seconds = 0;
};

/// The schema: docs/report.schema.json, expression. One line.
std::string boolean_json(const BooleanReport& report);

}  // namespace veritope::report
