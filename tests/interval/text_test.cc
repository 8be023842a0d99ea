// SPDX-License-Identifier: LGPL-3.0-or-later
// Literals and decorations beyond ITF1788: round trips, limits, laws of decorations.
#include "interval/text.h"

#include <gtest/gtest.h>

#include "interval/decorated_relations.h"
#include "interval/functions.h"
#include "interval/reverse.h"
#include "tests/interval/draw.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

TEST(IntervalText, ExactTextReadsBackToTheSameValue) {
  Random random(81);
  for (long i = 0; i < scaled(5000); ++i) {
    const Interval a =
        i < 2 ? (i == 0 ? Interval::empty() : Interval::entire()) : draw_interval(random);
    const auto back = text_to_interval(exact_text(a));
    ASSERT_EQ(back.signal, Signal::kNone) << exact_text(a);
    ASSERT_EQ(back.value, a) << exact_text(a);
    const auto d = static_cast<Decoration>(4 * random.below(5));
    const DecoratedInterval b(a, d);
    const auto again = text_to_decorated(exact_text(b));
    ASSERT_EQ(again.signal, Signal::kNone) << exact_text(b);
    ASSERT_EQ(again.value.decoration(), b.decoration()) << exact_text(b);
    ASSERT_EQ(again.value.interval(), b.interval()) << exact_text(b);
  }
}

TEST(IntervalText, WhatIsNoLiteralIsRefusedWithEmptyOrNai) {
  const std::string nines(kMaxLiteralDigits + 1, '9');
  const std::string bad[] = {"",        "[",        "]",      "1",          "[1",
                             "[1,2",    "[1,2]x",   "[2,1]",  "[1,2,3]",    "[a]",
                             "[1/0]",   "[1.5/2]",  "[1/-2]", "[0x1]",      "[0x1p]",
                             "[1e]",    "[1e5001]", "[--1]",  "[+inf,inf]", "[nan]",
                             "?",       "1??x",     "1?1?",   "1?ud",       "[" + nines + "]",
                             "[,-inf]", "[empty",   "[entire"};
  for (const std::string& text : bad) {
    EXPECT_EQ(text_to_interval(text).signal, Signal::kUndefinedOperation) << text;
    EXPECT_TRUE(text_to_interval(text).value.is_empty()) << text;
    EXPECT_EQ(text_to_decorated(text).signal, Signal::kUndefinedOperation) << text;
    EXPECT_TRUE(text_to_decorated(text).value.is_nai()) << text;
  }
  EXPECT_EQ(text_to_interval("[" + nines.substr(1) + "]").signal, Signal::kNone);
}

TEST(IntervalText, BoundsAreTheNearestNumbersOutside) {
  Random random(82);
  for (long i = 0; i < scaled(2000); ++i) {
    const Integer p(random.between(-1000000, 1000000)), q(random.between(1, 1000000));
    const Rational x(p, q);
    ASSERT_EQ(text_to_interval("[" + p.to_string() + "/" + q.to_string() + "]").value, enclose(x));
    const std::string decimal = p.to_string() + "?" + q.to_string() + "e-3";
    const Rational thousand(1000);
    ASSERT_EQ(text_to_interval(decimal).value,
              hull(enclose((Rational(p) - Rational(q)) / thousand),
                   enclose((Rational(p) + Rational(q)) / thousand)))
        << decimal;
  }
}

TEST(DecoratedInterval, KeepsItsInvariantsAndPropagatesTheWeakest) {
  Random random(83);
  for (long i = 0; i < scaled(5000); ++i) {
    const auto draw = [&] {
      return DecoratedInterval(random.below(20) == 0 ? Interval::empty() : draw_interval(random),
                               static_cast<Decoration>(4 * random.below(5)));
    };
    const DecoratedInterval a = draw(), b = draw();
    const Decoration most = weakest(a.decoration(), b.decoration());
    for (const DecoratedInterval& c :
         {a + b, a - b, a * b, a / b, min(a, b), max(a, b), fma(a, b, a), pow(a, b), atan2(a, b),
          hypot(a, b), intersection(a, b), hull(a, b), cancel_minus(a, b)}) {
      ASSERT_LE(c.decoration(), most) << to_string(a) << to_string(b) << to_string(c);
      ASSERT_EQ(c.is_nai(), a.is_nai() || b.is_nai());
      ASSERT_TRUE(c.decoration() != Decoration::kCom || is_common(c)) << to_string(c);
      ASSERT_TRUE(!c.interval().is_empty() || c.decoration() <= Decoration::kTrv) << to_string(c);
    }
    for (const DecoratedInterval& c :
         {-a, sqr(a), sqrt(a), recip(a), sin(a), tan(a), log(a), exp(a), floor(a), pown(a, -3)}) {
      ASSERT_LE(c.decoration(), a.decoration()) << to_string(a) << to_string(c);
      ASSERT_TRUE(c.decoration() != Decoration::kCom || is_common(c)) << to_string(c);
    }
  }
}

TEST(DecoratedInterval, NaiIsNoIntervalAndRelatedToNothing) {
  const DecoratedInterval nai = DecoratedInterval::nai(), one(Interval(1.0));
  EXPECT_FALSE(nai == nai);
  EXPECT_FALSE(is_subset(nai, one) || is_subset(one, nai) || precedes(nai, one) ||
               is_disjoint(nai, one));
  EXPECT_FALSE(is_empty(nai) || is_entire(nai) || is_common(nai) || is_singleton(nai) ||
               is_member(0, nai));
  EXPECT_TRUE(internal::is_nan(mid(nai)) && internal::is_nan(inf(nai)));
  EXPECT_EQ(interval_part(nai).signal, Signal::kIntervalPartOfNai);
  EXPECT_EQ(set_decoration(Interval(1.0), Decoration::kIll).signal, Signal::kUndefinedOperation);
  EXPECT_TRUE(mul_rev_to_pair(nai, one).first.is_nai());
  EXPECT_THROW(overlap(nai, one), InternalError);
  EXPECT_EQ(to_string(nai), "[nai]");
  EXPECT_EQ(to_string(one / one), "[1, 1]_com");
}

}  // namespace
}  // namespace veritope
