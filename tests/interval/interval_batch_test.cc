// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/batch.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "tests/interval/batch_oracle.h"

namespace veritope {
namespace {

using namespace test;

void expect_result(BatchBackEnd back_end, const Bounds& got, const Bounds& exact,
                   const std::string& operands) {
  const bool is_right = exact.is_empty() ? got.is_empty()
                        : back_end != BatchBackEnd::kNearest
                            ? got.lo == exact.lo && got.hi == exact.hi
                            : got.lo <= exact.lo && got.hi >= exact.hi;
  EXPECT_TRUE(is_right) << to_string(back_end) << ' ' << operands << " got " << text(got)
                        << " exact " << text(exact);
}

template <typename Op, typename Exact>
void compare(const char* name, const std::vector<Bounds>& a, const std::vector<Bounds>& b,
             const std::vector<Bounds>& c, Op op, Exact exact) {
  const Array x(a), y(b), z(c);
  for (const BatchBackEnd back_end : back_ends()) {
    Array out(a.size());
    op(IntervalBatch(back_end), x.in(), y.in(), z.in(), out.out());
    for (std::size_t i = 0; i < a.size(); ++i) {
      const bool empty = a[i].is_empty() || b[i].is_empty() || c[i].is_empty();
      expect_result(back_end, out.at(i), empty ? kEmpty : exact(a[i], b[i], c[i]),
                    name + (' ' + text(a[i])) + ' ' + text(b[i]) + ' ' + text(c[i]));
      if (testing::Test::HasFailure()) FAIL();
    }
  }
}

using B = IntervalBatch;
using In = ConstIntervalSpan;
using Out = IntervalSpan;
#define VT_OP(call) [](const B& batch, In a, In b, In c, Out out) { (void)b, (void)c, batch.call; }
#define VT_EXACT(value) \
  [](const Bounds& a, const Bounds& b, const Bounds& c) { return (void)b, (void)c, value; }

void compare_all(const std::vector<Bounds>& a, const std::vector<Bounds>& b,
                 const std::vector<Bounds>& c) {
  const std::vector<Bounds> none(a.size());  // [0, 0], for the operands that do not count
  compare("neg", a, none, none, VT_OP(neg(a, out)), VT_EXACT((Bounds{-a.hi, -a.lo})));
  compare("add", a, b, none, VT_OP(add(a, b, out)), VT_EXACT(exact_add(a, b)));
  compare("sub", a, b, none, VT_OP(sub(a, b, out)), VT_EXACT(exact_add(a, (Bounds{-b.hi, -b.lo}))));
  compare("mul", a, b, none, VT_OP(mul(a, b, out)), VT_EXACT(exact_mul(a, b)));
  compare("div", a, b, none, VT_OP(div(a, b, out)), VT_EXACT(exact_div(a, b)));
  compare("sqr", a, none, none, VT_OP(sqr(a, out)), VT_EXACT(exact_sqr(a)));
  compare("fma", a, b, c, VT_OP(fma(a, b, c, out)), VT_EXACT(exact_fma(a, b, c)));
  compare("mul_add", a, b, c, VT_OP(mul_add(a, b, c, out)),
          VT_EXACT(exact_add(exact_mul(a, b), c)));
}

TEST(IntervalBatch, GivesTheTightestBoundsForAnyOperandsOnEveryBackEnd) {
  for (const BatchBackEnd b : back_ends()) std::printf("back end %s\n", to_string(b));
  for (const std::uint64_t seed : {1, 2}) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::size_t n = 4003;
    const auto a = many(random, n), b = many(random, n), c = many(random, n);
    compare_all(a, b, c);
  }
}

TEST(IntervalBatch, GivesTheTightestBoundsForZeroInfinityAndLimitsInEveryPlace) {
  const std::vector<Bounds> all = special();
  std::vector<Bounds> a, b, c;
  Random random(5);
  for (const Bounds& x : all) {
    for (const Bounds& y : all)
      a.push_back(x), b.push_back(y), c.push_back(all[random.below(all.size())]);
  }
  compare_all(a, b, c);
}

}  // namespace
}  // namespace veritope
