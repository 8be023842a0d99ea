// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/totals.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace veritope::report {
namespace {

FileReport report_with(std::optional<Verdict> verdict) {
  FileReport out;
  out.path = "a\tb\n.stl";
  out.verdict = verdict;
  return out;
}

TEST(Totals, NamesTheVerdictsThatOccurInAFixedOrder) {
  Totals totals;
  EXPECT_EQ(totals.text(), "0 files\n");
  totals.add(report_with(std::nullopt));
  EXPECT_EQ(totals.text(), "1 file: 1 unreadable\n");
  for (const Verdict v : {Verdict::kUndecided, Verdict::kInvalid, Verdict::kValid, Verdict::kInvalid})
    totals.add(report_with(v));
  EXPECT_EQ(totals.text(), "5 files: 1 valid, 2 invalid, 1 undecided, 1 unreadable\n");
}

TEST(Totals, FindThePhaseThatTookLongest) {
  PhaseSeconds seconds;
  EXPECT_EQ(total_and_longest(seconds).first, 0);
  seconds.read = .25, seconds.check = 2, seconds.decide = .5;
  EXPECT_EQ(total_and_longest(seconds).first, 2.75);
  EXPECT_STREQ(total_and_longest(seconds).second.name, "checking");
  EXPECT_EQ(total_and_longest(seconds).second.seconds, 2);
}

TEST(Table, HasOneLineForAFileAndTheColumnsOfItsHead) {
  const std::string head = tsv_head();
  for (const auto& verdict : {std::optional<Verdict>(), std::optional(Verdict::kUndecided)}) {
    FileReport report = report_with(verdict);
    report.fault = fault_of("syntax", "a word with a\ttab and a line\nfeed");
    const std::string row = tsv_row(report);
    EXPECT_EQ(std::count(row.begin(), row.end(), '\t'), std::count(head.begin(), head.end(), '\t'));
    EXPECT_EQ(std::count(row.begin(), row.end(), '\n'), 1);
    EXPECT_NE(row.find("syntax"), row.npos);
  }
}

}  // namespace
}  // namespace veritope::report
