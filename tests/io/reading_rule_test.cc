// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/reading_rule.h"

#include <gtest/gtest.h>

#include "tests/io/io_test_util.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

TEST(ReadingRule, IsTheQuotationInThePageJoinedWithSingleSpaces) {
  const std::string page =
      io_test::slurp(test::source_dir() + "/docs/certificates/reading-rule-1.md");
  ASSERT_FALSE(page.empty());
  std::istringstream lines(page);
  std::string joined;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("> ")) continue;
    if (!joined.empty()) joined += ' ';
    joined += line.substr(2);
  }
  EXPECT_EQ(kReadingRule, joined);
}

TEST(ReadingRule, NeedsNoEscapesInAStatement) {
  for (const char c : kReadingRule) EXPECT_TRUE(c >= ' ' && c <= '~' && c != '"' && c != '\\') << c;
}

}  // namespace
}  // namespace veritope
