// SPDX-License-Identifier: LGPL-3.0-or-later
// Words at rational points of curved edges whose parameters are irrational. The truth is that of points near them, by
// the exact signs of polynomials.
#include <gtest/gtest.h>

#include <functional>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/expression/expression_classifier.h"
#include "solids/patches/patch_transform.h"
#include "tests/predicates/test_scale.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeedOfEdges = 20261211;

Rational quotient(std::int64_t p, std::int64_t q = 1) { return Rational(p) / Rational(q); }

using Membership = std::function<bool(const ExactPoint&)>;  // of points off the boundary
struct KnownSolid {
  std::shared_ptr<const Operand> operand;
  Membership has;
};

ExactPoint moved(ExactPoint p, const ExactPoint& by, int sign) {
  for (std::size_t k = 0; k < 3; ++k) p[k] += Rational(sign) * by[k];
  return p;
}

// 0 <= x, y <= 1, c x^2 <= z <= 1 + x y + c x^2, moved.
KnownSolid bent_block(const Rational& c, const ExactPoint& by) {
  Patches patches = patch_shapes::placed(sheared(bent_graph(), {2, 0, 0, c}), 1, by);
  return {patch_operand(std::make_unique<const PatchComplex>(complex_of(std::move(patches)))),
          [c, by](const ExactPoint& at) {
            const auto [x, y, z] = moved(at, by, -1);
            const Rational height = z - c * x * x;
            const auto is_between = [](const Rational& t, const Rational& most) {
              return t.sign() > 0 && t < most;
            };
            return is_between(x, 1) && is_between(y, 1) && is_between(height, Rational(1) + x * y);
          }};
}
// A box around it without it: all its edges have more than a half turn.
KnownSolid bent_hole(const Rational& c) {
  Patches patches =
      patch_shapes::joined({patch_shapes::box({-8, -8, -8}, {8, 8, 8}),
                            patch_shapes::reversed(sheared(bent_graph(), {2, 0, 0, c}))});
  const Membership block = bent_block(c, {0, 0, 0}).has;
  return {patch_operand(std::make_unique<const PatchComplex>(complex_of(std::move(patches)))),
          [block](const ExactPoint& p) {
            return !block(p) && std::all_of(p.begin(), p.end(),
                                            [](const Rational& x) { return abs(x) < Rational(8); });
          }};
}
KnownSolid box_of_solid(const ExactBox<3>& box) {
  return {box_operand(box), [box](const ExactPoint& p) {
            bool out = true;
            for (std::size_t k = 0; k < 3; ++k) out = out && box[k].lo < p[k] && p[k] < box[k].hi;
            return out;
          }};
}

// Points of edges: top and bottom, beside the four walls.
ExactPoint on_edge(const Rational& c, int edge, const Rational& t) {
  const Rational x = edge % 4 == 0   ? Rational(0)
                     : edge % 4 == 1 ? Rational(1)
                                     : t,
                 y = edge % 4 == 2   ? Rational(0)
                     : edge % 4 == 3 ? Rational(1)
                                     : t;
  return {x, y, c * x * x + (edge < 4 ? Rational(1) + x * y : Rational(0))};
}

struct Tally {
  int undecided = 0, on = 0, other = 0;
};

// Compares the words of four expressions of two solids with values near the point.
void compare(const KnownSolid& a, const KnownSolid& b, const ExactPoint& q, Random& random,
             const std::string& where, Tally& tally) {
  std::vector<std::array<bool, 2>> near;
  for (int i = 0; i < 400; ++i) {
    ExactPoint p = q;
    const Rational unit = Rational::power_of_two(-30 - static_cast<int>(random.below(20)));
    for (Rational& x : p) x += Rational::from_double(2 * random.unit() - 1) * unit;
    near.push_back({a.has(p), b.has(p)});
  }
  const Formula x = Formula::variable(0), y = Formula::variable(1);
  const std::pair<Formula, std::function<bool(bool, bool)>> all[] = {
      {Formula::any_of({x, y}), [](bool s, bool t) { return s || t; }},
      {Formula::all_of({x, y}), [](bool s, bool t) { return s && t; }},
      {Formula::all_of({x, y.negated()}), [](bool s, bool t) { return s && !t; }},
      {Formula::all_of({y, x.negated()}), [](bool s, bool t) { return t && !s; }}};
  for (std::size_t i = 0; i < std::size(all); ++i) {
    const PointWord word = ExpressionClassifier(all[i].first, {a.operand, b.operand}).classify(q);
    bool has[2] = {};
    for (const auto& [s, t] : near) has[all[i].second(s, t) ? 1 : 0] = true;
    const std::string text = where + " expression " + std::to_string(i);
    if (word == PointWord::kUndecided) ++tally.undecided;
    if (word == PointWord::kOn) {
      ++tally.on;
      EXPECT_TRUE(has[0] && has[1]) << text;
    }
    if (word != PointWord::kIn && word != PointWord::kOut) continue;
    ++tally.other;
    EXPECT_FALSE(has[word == PointWord::kIn ? 0 : 1]) << text;
  }
}

// PROVES POINT-8.D3
TEST(EnclosedEdges, OfTwoSolidsThatCross) {
  Random random(kSeedOfEdges);
  Tally tally;
  const Rational c = quotient(1, 3);
  const KnownSolid a = bent_block(c, {0, 0, 0});
  for (int i = 0; i < scaled(16); ++i) {
    const int first = i % 8, second = static_cast<int>(random.below(8));
    const Rational s = quotient(1 + static_cast<std::int64_t>(random.below(9)), 11),
                   t = quotient(1 + static_cast<std::int64_t>(random.below(11)), 13);
    const Rational other = i % 2 == 0 ? quotient(-2, 5) : quotient(3, 4);
    const ExactPoint q = on_edge(c, first, s);
    const KnownSolid b = bent_block(other, moved(q, on_edge(other, second, t), -1));
    compare(a, b, q, random,
            "seed " + std::to_string(kSeedOfEdges) + " edges " + std::to_string(first) + "," +
                std::to_string(second) + " at " + s.to_string() + "," + t.to_string(),
            tally);
  }
  EXPECT_GT(tally.on, scaled(16) * 3);
  EXPECT_GT(tally.other, 0);
  EXPECT_LT(tally.undecided, scaled(16) / 4);
}

// PROVES POINT-8.D3
TEST(EnclosedEdges, ThatPlanesCross) {
  Random random(kSeedOfEdges);
  const Rational c = quotient(1, 3);
  const KnownSolid block = bent_block(c, {0, 0, 0}), hole = bent_hole(c);
  for (int i = 0; i < 16; ++i) {
    const int edge = i % 8;
    const KnownSolid& a = i < 8 ? block : hole;
    const ExactPoint q = on_edge(c, edge, quotient(4, 11));
    // Across the edge: a face of a block with its normal along it.
    const std::size_t axis = edge % 4 < 2 ? 1 : 0;
    ExactBox<3> half;
    for (std::size_t k = 0; k < 3; ++k) half[k] = {-5, 5};
    half[axis].hi = q[axis];
    Tally here;
    compare(a, box_of_solid(half), q, random, "case " + std::to_string(i), here);
    EXPECT_EQ(here.on, 4) << i;
  }
}

// A block whose face is in the plane of the flat wall at the edge, on either side of it.
// PROVES POINT-8.D3
TEST(EnclosedEdges, InTheFacesOfBlocks) {
  Random random(kSeedOfEdges);
  const Rational c = quotient(1, 3);
  const KnownSolid block = bent_block(c, {0, 0, 0}), hole = bent_hole(c);
  for (int i = 0; i < 8; ++i)
    for (const bool is_below : {false, true}) {
      const int edge = std::array{2, 3, 6, 7}[i % 4];  // y is 0 or 1
      const KnownSolid& a = i < 4 ? block : hole;
      const ExactPoint q = on_edge(c, edge, quotient(4, 11));
      ExactBox<3> half;
      for (std::size_t k = 0; k < 3; ++k) half[k] = {-5, 5};
      (is_below ? half[1].hi : half[1].lo) = q[1];
      Tally here;
      const std::string where = "case " + std::to_string(i) + (is_below ? " below" : " above");
      compare(a, box_of_solid(half), q, random, where, here);
      EXPECT_EQ(here.undecided, 0) << where;
      EXPECT_EQ(here.other, 1) << where;  // in its complement, or without it
    }
}

}  // namespace
}  // namespace veritope
