// SPDX-License-Identifier: LGPL-3.0-or-later
// report/sweep_report.h: what veritope cover --sweep says: the paper's conditions at eps, eps / 2, ...
// (solids/interval_boxes/condition_sweep.h).
#pragma once
#include <string>
#include <vector>

#include "solids/interval_boxes/condition_sweep.h"

namespace veritope::report {

/// The table, and for the smallest eps with boxes one reason for every condition that does not hold there.
std::string sweep_text(const std::vector<SweepRow>& rows);

/// The schema: docs/report.schema.json, sweep.
std::string sweep_json(const std::string& path, const std::string& sha256,
                       const std::vector<SweepRow>& rows);

/// The row of the smallest eps whose boxes were made; null: none.
const SweepRow* finest_row(const std::vector<SweepRow>& rows);

}  // namespace veritope::report
