// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/filter.h"

#include <gtest/gtest.h>

#include <limits>

namespace veritope {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(SignBeyond, IsTheSignOfWhatIsFartherFromZeroThanTheBound) {
  EXPECT_EQ(sign_beyond(3, 2), Sign3::kPositive);
  EXPECT_EQ(sign_beyond(-3, 2), Sign3::kNegative);
  EXPECT_EQ(sign_beyond(kInf, 2), Sign3::kPositive);
  EXPECT_EQ(sign_beyond(-kInf, 2), Sign3::kNegative);
  EXPECT_EQ(sign_beyond(0x1p-899, 0), Sign3::kPositive);
  EXPECT_EQ(sign_beyond(0x1p-900, 0), Sign3::kUncertain);  // the floor
}

TEST(SignBeyond, IsUncertainAtTheBoundAndWithin) {
  for (const double v : {2.0, -2.0, 1.0, 0.0, -0.0})
    EXPECT_EQ(sign_beyond(v, 2), Sign3::kUncertain);
  EXPECT_EQ(sign_beyond(0, 0), Sign3::kUncertain);
}

TEST(SignBeyond, OverflowIsNoAnswer) {
  for (const double v : {kInf, -kInf, kNan, 1e308}) {
    EXPECT_EQ(sign_beyond(v, kInf), Sign3::kUncertain);
    EXPECT_EQ(sign_beyond(v, kNan), Sign3::kUncertain);
  }
  EXPECT_EQ(sign_beyond(kNan, 0), Sign3::kUncertain);
}

TEST(Larger, IsTheGreaterOne) {
  EXPECT_EQ(larger(1, 2), 2);
  EXPECT_EQ(larger(2, 1), 2);
  EXPECT_EQ(larger(-1, kInf), kInf);
  EXPECT_EQ(larger(kInf, -kInf), kInf);
}

}  // namespace
}  // namespace veritope
