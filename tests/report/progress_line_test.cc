// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/progress_line.h"

#include <gtest/gtest.h>

namespace veritope::report {
namespace {

TEST(ProgressLine, HasTheShareOnlyWhereItIsKnown) {
  const ProgressText one{1, 1, "part.stl", "deciding"}, many{3, 58, "part.stl", "deciding"};
  EXPECT_EQ(progress_line(one, {}, 3.25), "part.stl: deciding, 3.2 s");
  EXPECT_EQ(progress_line(many, {}, 0.4), "3 of 58, part.stl: deciding, 0.4 s");
  EXPECT_EQ(progress_line(many, {2, 5, 11}, 12),
            "3 of 58, part.stl: deciding, 45 % of step 2, 12.0 s");
}

TEST(ProgressLine, IsCutInTheNameOfTheFileAndBetweenCharacters) {
  const ProgressText text{3, 58, std::string(100, 'n'), "looking for a collar"};
  const std::string line = progress_line(text, {1, 1, 2}, 1);
  EXPECT_EQ(line.size(), 78U);
  EXPECT_TRUE(line.starts_with("3 of 58, nnn")) << line;
  EXPECT_TRUE(line.ends_with("n...: looking for a collar, 50 % of step 1, 1.0 s")) << line;
  EXPECT_EQ(progress_line({1, 1, "\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4", "x"}, {}, 0,
                          18),
            "\u00e4\u00e4...: x, 0.0 s");
}

}  // namespace
}  // namespace veritope::report
