// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>
#include <immintrin.h>

#include <bit>
#include <cstring>
#include <functional>

#include "interval/batch.h"
#include "tests/interval/batch_oracle.h"

namespace veritope {
namespace {

using namespace test;
using B = IntervalBatch;
using In = ConstIntervalSpan;

bool same_bits(const Array& a, const Array& b) {
  const std::size_t bytes = a.size() * sizeof(double);
  return a.size() == b.size() &&
         (bytes == 0 || (std::memcmp(a.hi.data(), b.hi.data(), bytes) == 0 &&
                         std::memcmp(a.neg_lo.data(), b.neg_lo.data(), bytes) == 0));
}

struct Operation {
  const char* name;
  std::function<void(const B&, In, In, In, IntervalSpan)> run;
};
const std::vector<Operation>& operations() {
  static const std::vector<Operation> all{
      {"neg", [](const B& m, In a, In, In, IntervalSpan out) { m.neg(a, out); }},
      {"add", [](const B& m, In a, In b, In, IntervalSpan out) { m.add(a, b, out); }},
      {"sub", [](const B& m, In a, In b, In, IntervalSpan out) { m.sub(a, b, out); }},
      {"mul", [](const B& m, In a, In b, In, IntervalSpan out) { m.mul(a, b, out); }},
      {"div", [](const B& m, In a, In b, In, IntervalSpan out) { m.div(a, b, out); }},
      {"sqr", [](const B& m, In a, In, In, IntervalSpan out) { m.sqr(a, out); }},
      {"fma", [](const B& m, In a, In b, In c, IntervalSpan out) { m.fma(a, b, c, out); }},
      {"mul_add", [](const B& m, In a, In b, In c, IntervalSpan out) { m.mul_add(a, b, c, out); }},
      {"orient3d", [](const B& m, In a, In b, In c, IntervalSpan out) {
         m.orient3d({a, b, c}, {b, c, a}, {c, a, a}, {b, b, c}, out);
       }}};
  return all;
}

// NaN bits may differ: x86 gives the sign that it likes.
void make_empty_ones_equal(Array& a) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a.at(i).is_empty()) a.neg_lo[i] = a.hi[i] = kNaN;
  }
}

TEST(IntervalBatch, GivesTheSameBitsOnAllBackEndsThatRoundUpward) {
  Random random(11);
  const std::size_t n = 20011;
  const Array a(many(random, n)), b(many(random, n)), c(many(random, n));
  for (const Operation& op : operations()) {
    Array first;
    for (const BatchBackEnd back_end : back_ends()) {
      if (back_end == BatchBackEnd::kNearest) continue;
      Array out(n);
      op.run(B(back_end), a.in(), b.in(), c.in(), out.out());
      make_empty_ones_equal(out);
      if (first.size() == 0) first = out;
      EXPECT_TRUE(same_bits(first, out)) << op.name << ' ' << to_string(back_end);
    }
  }
}

TEST(IntervalBatch, AgreesWithTheScalarIntervalOnNonEmptyOperands) {
  Random random(12);
  for (int i = 0; i < 20000; ++i) {
    const Bounds x = bounds(random), y = bounds(random);
    if (x.is_empty() || y.is_empty()) continue;
    const Array a(std::vector{x}), b(std::vector{y});
    const Interval p = Interval::from_bounds(x.lo, x.hi), q = Interval::from_bounds(y.lo, y.hi);
    Interval sum, difference, product, square;
    {
      const ScopedUpward upward;
      sum = p + q, difference = p - q, product = p * q, square = sqr(p);
    }
    Array s(1), d(1), m(1), r(1);
    const B batch;
    batch.add(a.in(), b.in(), s.out()), batch.sub(a.in(), b.in(), d.out());
    batch.mul(a.in(), b.in(), m.out()), batch.sqr(a.in(), r.out());
    const auto expect_same = [&](const Array& got, const Interval& want) {
      EXPECT_TRUE(got.at(0).lo == want.lo() && got.at(0).hi == want.hi())
          << text(x) << ' ' << text(y) << " got " << text(got.at(0)) << ", not " << to_string(want);
    };
    expect_same(s, sum), expect_same(d, difference), expect_same(m, product),
        expect_same(r, square);
    if (HasFailure()) FAIL() << i;
  }
}

TEST(IntervalBatch, TakesAnyLengthAndAlignmentAndWritesNothingElse) {
  Random random(13);
  const std::size_t n = 40;
  const Array a(many(random, n)), b(many(random, n)), c(many(random, n));
  for (const BatchBackEnd back_end : back_ends()) {
    for (const Operation& op : operations()) {
      Array whole(n);
      op.run(B(back_end), a.in(), b.in(), c.in(), whole.out());
      for (std::size_t from = 0; from < 9; ++from) {
        for (std::size_t count = 0; from + count <= 28; ++count) {
          Array out(std::vector<Bounds>(n, Bounds{-77, 77}));
          const auto part = [&](const Array& x) {
            return In{x.neg_lo.data() + from, x.hi.data() + from, count};
          };
          op.run(B(back_end), part(a), part(b), part(c),
                 {out.neg_lo.data() + from, out.hi.data() + from, count});
          Array want(std::vector<Bounds>(n, Bounds{-77, 77}));
          for (std::size_t i = from; i < from + count; ++i)
            want.neg_lo[i] = whole.neg_lo[i], want.hi[i] = whole.hi[i];
          make_empty_ones_equal(out), make_empty_ones_equal(want);
          ASSERT_TRUE(same_bits(out, want))
              << to_string(back_end) << ' ' << op.name << " [" << from << ", +" << count << ")";
        }
      }
    }
  }
}

TEST(IntervalBatch, MayWriteOverAnOperand) {
  Random random(14);
  const std::size_t n = 101;
  const Array a(many(random, n)), b(many(random, n)), c(many(random, n));
  for (const BatchBackEnd back_end : back_ends()) {
    for (const Operation& op : operations()) {
      Array apart(n), x = a, y = b, z = c;
      op.run(B(back_end), a.in(), b.in(), c.in(), apart.out());
      op.run(B(back_end), x.in(), b.in(), c.in(), x.out());
      op.run(B(back_end), a.in(), y.in(), c.in(), y.out());
      op.run(B(back_end), a.in(), b.in(), z.in(), z.out());
      for (Array* r : {&apart, &x, &y, &z}) make_empty_ones_equal(*r);
      EXPECT_TRUE(same_bits(apart, x) && same_bits(apart, y) && same_bits(apart, z))
          << to_string(back_end) << ' ' << op.name;
    }
  }
}

TEST(IntervalBatch, DoesNotCareForTheCallersModeNorForFlushing) {
  Random random(15);
  const std::size_t n = 1001;
  const Array a(many(random, n)), b(many(random, n)), c(many(random, n));
  for (const BatchBackEnd back_end : back_ends()) {
    for (const Operation& op : operations()) {
      Array usual(n), odd(n);
      op.run(B(back_end), a.in(), b.in(), c.in(), usual.out());
      const unsigned saved = _mm_getcsr();
      _mm_setcsr(saved | 0xe040u);  // toward zero, FTZ, DAZ
      op.run(B(back_end), a.in(), b.in(), c.in(), odd.out());
      const unsigned after = _mm_getcsr();
      _mm_setcsr(saved);
      EXPECT_EQ(after & 0xe040u, 0xe040u);
      make_empty_ones_equal(usual), make_empty_ones_equal(odd);
      EXPECT_TRUE(same_bits(usual, odd)) << to_string(back_end) << ' ' << op.name;
    }
  }
}

TEST(IntervalBatch, DotEnclosesTheSumAndIsTheSameOnAllBackEndsThatRoundUpward) {
  Random random(16);
  for (std::size_t n = 0; n < 70; ++n) {
    std::vector<Bounds> x, y;
    Rational lo(0), hi(0);
    while (x.size() < n) {  // finite ones: the sum of rationals says what must be inside
      const Bounds p = bounds(random), q = bounds(random);
      if (!is_finite(p.lo) || !is_finite(p.hi) || !is_finite(q.lo) || !is_finite(q.hi)) continue;
      const Rational c[] = {Rational::from_double(p.lo) * Rational::from_double(q.lo),
                            Rational::from_double(p.lo) * Rational::from_double(q.hi),
                            Rational::from_double(p.hi) * Rational::from_double(q.lo),
                            Rational::from_double(p.hi) * Rational::from_double(q.hi)};
      lo += *std::min_element(c, c + 4), hi += *std::max_element(c, c + 4);
      x.push_back(p), y.push_back(q);
    }
    const Array a(x), b(y);
    const Interval first = B(BatchBackEnd::kBaseline).dot(a.in(), b.in());
    for (const BatchBackEnd back_end : back_ends()) {
      const Interval got = B(back_end).dot(a.in(), b.in());
      EXPECT_TRUE(contains(got, lo) && contains(got, hi)) << to_string(back_end) << ' ' << n;
      if (back_end == BatchBackEnd::kNearest) continue;
      EXPECT_EQ(std::bit_cast<std::uint64_t>(got.lo()), std::bit_cast<std::uint64_t>(first.lo()));
      EXPECT_EQ(std::bit_cast<std::uint64_t>(got.hi()), std::bit_cast<std::uint64_t>(first.hi()));
    }
  }
  // {0} times the whole line is {0}; infinity in one bound does not hide in the other.
  const Array a(std::vector<Bounds>{{0, 0}, {-3, 0}, {2, 3}}),
      b(std::vector<Bounds>{{-kInf, kInf}, {1, kInf}, {1, 1}});
  for (const BatchBackEnd back_end : back_ends()) {
    const Interval got = B(back_end).dot(a.in(), b.in());
    EXPECT_EQ(got.lo(), -kInf);
    EXPECT_TRUE(contains(got, Rational(3))) << to_string(back_end);
    EXPECT_LT(got.hi(), 3.001);
  }
}

// The determinant step by step, each step the tightest: what three times-and-minus chains must give.
Bounds stepwise_orient3d(const Bounds* p) {
  const auto neg = [](const Bounds& x) { return Bounds{-x.hi, -x.lo}; };
  const auto less = [&](const Bounds& x, const Bounds& y) { return exact_add(x, neg(y)); };
  Bounds u[3], v[3], w[3];
  for (int k = 0; k < 3; ++k)
    u[k] = less(p[3 + k], p[k]), v[k] = less(p[6 + k], p[k]), w[k] = less(p[9 + k], p[k]);
  const auto term = [&](int i, int j, int k) {
    return exact_mul(w[i], less(exact_mul(u[j], v[k]), exact_mul(u[k], v[j])));
  };
  return exact_add(exact_add(term(0, 1, 2), term(1, 2, 0)), term(2, 0, 1));
}

TEST(IntervalBatch, Orient3dIsRightForZerosInfinitiesAndEmptyOnesInEveryPlace) {
  Random random(17);
  const std::vector<Bounds> all = special();
  for (const bool from_special : {true, false}) {
    const std::size_t n = 3001;
    std::vector<std::vector<Bounds>> p(12);
    for (auto& coordinate : p) {
      while (coordinate.size() < n) {
        coordinate.push_back(from_special && random.below(3) == 0 ? all[random.below(all.size())]
                             : from_special                       ? Bounds{1, 1}
                                                                  : bounds(random));
      }
    }
    const std::vector<Array> arrays(p.begin(), p.end());
    const auto point = [&](int k) {
      return IntervalPointSpan{arrays[3 * k].in(), arrays[3 * k + 1].in(), arrays[3 * k + 2].in()};
    };
    for (const BatchBackEnd back_end : back_ends()) {
      Array out(n);
      B(back_end).orient3d(point(0), point(1), point(2), point(3), out.out());
      for (std::size_t i = 0; i < n; ++i) {
        Bounds t[12], got = out.at(i);
        bool empty = false;
        std::string operands;
        for (int k = 0; k < 12; ++k)
          t[k] = p[k][i], empty |= t[k].is_empty(), operands += text(t[k]) + ' ';
        if (empty) {
          ASSERT_TRUE(got.is_empty()) << to_string(back_end) << ' ' << operands;
          continue;
        }
        const Bounds want = stepwise_orient3d(t);
        ASSERT_TRUE(back_end == BatchBackEnd::kNearest ? got.lo <= want.lo && got.hi >= want.hi
                                                       : got.lo == want.lo && got.hi == want.hi)
            << to_string(back_end) << ' ' << operands << "got " << text(got) << " want "
            << text(want);
      }
    }
  }
}

TEST(IntervalBatch, SignsAreThoseThatAllMembersHave) {
  const std::vector<Bounds> all = special();
  const Array a(all);
  for (const BatchBackEnd back_end : back_ends()) {
    std::vector<Sign3> s(all.size());
    B(back_end).signs(a.in(), s.data());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Bounds& b = all[i];
      const Sign3 want = b.lo > 0                 ? Sign3::kPositive
                         : b.hi < 0               ? Sign3::kNegative
                         : b.lo == 0 && b.hi == 0 ? Sign3::kZero
                                                  : Sign3::kUncertain;
      EXPECT_EQ(s[i], want) << text(b);
    }
  }
}

}  // namespace
}  // namespace veritope
