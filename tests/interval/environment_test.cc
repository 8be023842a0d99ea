// SPDX-License-Identifier: LGPL-3.0-or-later
// What the control word, the locale and MPFR's limits must not change.
#include <gtest/gtest.h>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <clocale>
#include <cmath>
#include <limits>
#include <string>

#include "interval/functions.h"
#include "interval/numeric.h"
#include "interval/text.h"

namespace veritope {
namespace {

constexpr double kLeast = 0x1p-1074;

#if defined(__SSE2__)
TEST(IntervalEnvironment, DenormalsThatCountAsZeroChangeNoBound) {
  const unsigned word = _mm_getcsr();
  _mm_setcsr(word | 0x8040u);
  const Interval wider =
      cancel_minus(Interval::from_bounds(0, kLeast), Interval::from_bounds(0, 2 * 0x1p-1073));
  const std::string text = exact_text(Interval(kLeast));
  _mm_setcsr(word);
  EXPECT_TRUE(wider.is_entire()) << to_string(wider);
  EXPECT_EQ(text, exact_text(Interval(kLeast)));
}
#endif

TEST(IntervalEnvironment, TextHasAPointInEveryLocale) {
  const std::string saved = std::setlocale(LC_ALL, nullptr);
  const bool has_comma = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  const std::string exact = exact_text(Interval::from_bounds(1.5, 2.5)),
                    rounded = to_string(Interval::from_bounds(1.5, 2.5));
  std::setlocale(LC_ALL, saved.c_str());
  EXPECT_EQ(exact, "[0x1.8p+0,0x1.4p+1]") << has_comma;
  EXPECT_EQ(rounded, "[1.5, 2.5]");
  EXPECT_EQ(internal::number_text("%.1f,", 1), "1.0.");  // as a comma locale would write it
}

// MPFR 4.2.0 calls such roots 1, exactly.
TEST(IntervalEnvironment, RootsOfHugeDegreeContainTheRoot) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t n : {kMost, kMost - 1, std::int64_t{1} << 62}) {
    for (const double x : {2.0, 4.0, 0.25}) {
      const Interval up = rootn(Interval(x), n), down = rootn(Interval(x), -n);
      const bool above = x > 1;
      EXPECT_TRUE(above ? up.lo() <= 1 && up.hi() > 1 : up.lo() < 1 && up.hi() >= 1)
          << x << ' ' << n;
      EXPECT_TRUE(above ? down.lo() < 1 && down.hi() >= 1 : down.lo() <= 1 && down.hi() > 1)
          << x << ' ' << n;
    }
    EXPECT_EQ(rootn(Interval(1), n), Interval(1));
  }
  EXPECT_LT(rootn(Interval(4), std::numeric_limits<std::int64_t>::min()).lo(), 1);
}

}  // namespace
}  // namespace veritope
