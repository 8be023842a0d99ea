// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/result.h"

#include <gtest/gtest.h>

#include <string>

#include "robust/base/sign.h"

namespace veritope {
namespace {

TEST(Result, HoldsAValueOrAnError) {
  Result<int> good(7);
  EXPECT_TRUE(good.has_value());
  EXPECT_EQ(*good, 7);
  *good = 8;
  EXPECT_EQ(good.value(), 8);
  EXPECT_THROW(good.error(), InternalError);
  const Result<int> bad(Error{Code::kSyntax, {}, "no"});
  EXPECT_FALSE(bad);
  EXPECT_EQ(bad.error().message, "no");
  EXPECT_THROW(bad.value(), InternalError);
  Result<std::string> text(std::string("abc"));
  EXPECT_EQ(text->size(), 3u);
  const std::string moved = std::move(text).value();
  EXPECT_EQ(moved, "abc");
  EXPECT_TRUE(ok_status().has_value());
}

TEST(Result, PrintsThePlaceThatItKnows) {
  Error e{Code::kSyntax, {}, "bad token \"x\""};
  EXPECT_EQ(to_string(e), "bad token \"x\"");
  e.place.file = "part.obj";
  e.place.line = 12;
  EXPECT_EQ(to_string(e), "part.obj: line 12: bad token \"x\"");
  e.place = {};
  e.place.byte = 3, e.place.face = 4, e.place.vertex = 5;
  EXPECT_EQ(to_string(e), "byte 3: face 4: vertex 5: bad token \"x\"");
  e.place = {};
  e.place.line = 6, e.place.entity = 7;
  EXPECT_EQ(to_string(e), "line 6: entity 7: bad token \"x\"");
}

TEST(Result, NamesEveryCode) {
  for (int i = 0; i <= static_cast<int>(Code::kBadEnvironment); ++i) {
    EXPECT_STRNE(code_name(static_cast<Code>(i)), "unknown");
  }
  EXPECT_STREQ(code_name(static_cast<Code>(999)), "unknown");
}

TEST(Check, ThrowsWithConditionReasonAndPlace) {
  EXPECT_NO_THROW(VT_CHECK(1 + 1 == 2, "arithmetic"));
  try {
    VT_CHECK(1 + 1 == 3, "the reason");
    FAIL();
  } catch (const InternalError& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("1 + 1 == 3"), std::string::npos);
    EXPECT_NE(what.find("the reason"), std::string::npos);
    EXPECT_NE(what.find("result_test.cc"), std::string::npos);
  }
}

TEST(Sign, MultipliesAndNegates) {
  static_assert(-Sign::kPositive == Sign::kNegative && -Sign::kZero == Sign::kZero);
  static_assert(Sign::kNegative * Sign::kNegative == Sign::kPositive);
  static_assert(sign_of(-3) == Sign::kNegative && sign_of(0) == Sign::kZero &&
                sign_of(2.5) == Sign::kPositive);
  static_assert(!is_certain(Sign3::kUncertain) && is_certain(Sign3::kZero));
  static_assert(to_sign(to_sign3(Sign::kNegative)) == Sign::kNegative &&
                to_int(Sign::kNegative) == -1);
}

TEST(Sign, ComparesWithZeroAsTheNumberWhoseSignItIs) {
  for (const int n : {-7, 0, 7}) {
    const Sign s = sign_of(n);
    EXPECT_EQ(s == 0, n == 0);
    EXPECT_EQ(s != 0, n != 0);
    EXPECT_EQ(s < 0, n < 0);
    EXPECT_EQ(s > 0, n > 0);
    EXPECT_EQ(s <= 0, n <= 0);
    EXPECT_EQ(s >= 0, n >= 0);
    EXPECT_EQ(0 == s, 0 == n);
    EXPECT_EQ(0 != s, 0 != n);
    EXPECT_EQ(0 < s, 0 < n);
    EXPECT_EQ(0 > s, 0 > n);
    EXPECT_EQ(0 <= s, 0 <= n);
    EXPECT_EQ(0 >= s, 0 >= n);
  }
  static_assert(Sign::kPositive > 0 && 0 > Sign::kNegative && Sign::kZero == 0);
  static_assert(Sign::kNegative < Sign::kZero && Sign::kZero != Sign::kPositive);  // as before
}

template <typename T>
concept ComparesWithZero = requires(T value) { value > 0; };

TEST(Sign, OnlyTheExactOneComparesWithZero) {
  static_assert(ComparesWithZero<Sign> && !ComparesWithZero<Sign3>);
}

}  // namespace
}  // namespace veritope
