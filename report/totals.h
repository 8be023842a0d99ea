// SPDX-License-Identifier: LGPL-3.0-or-later
// report/totals.h: a run over several files as a whole, and as a table for other programs.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "report/file_report.h"

namespace veritope::report {

/// A phase of certify with the seconds that it took.
struct PhaseTime {
  const char* name = "";  ///< "reading", "checking"
  double seconds = 0;
};
/// The sum of the phases, and the one that took longest.
std::pair<double, PhaseTime> total_and_longest(const PhaseSeconds& seconds);

/// How many files had which verdict.
class Totals {
 public:
  void add(const FileReport& report);
  /// "58 files: 16 valid, 31 invalid, 11 unreadable\n", without the verdicts that no file has.
  std::string text() const;

 private:
  std::size_t files_ = 0;
  std::array<std::size_t, 4> verdicts_{};  ///< valid, invalid, undecided, unreadable
};

/// The names of the columns of tsv_row, with the line feed.
std::string tsv_head();
/// One line for one file: its columns separated by tabs, in text that has no tabs or line feeds. Unknown values are
/// empty.
std::string tsv_row(const FileReport& report);

}  // namespace veritope::report
