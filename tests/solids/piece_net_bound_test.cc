// SPDX-License-Identifier: LGPL-3.0-or-later
// The constants of solids/pieces/piece_bounds.h against docs/bounds/piece_net.md: the derivation rerun in
// exact rationals on the lines that the code executes, then the worst inputs that a search has found
// (piece_bound_search prints them).
#include <map>

#include "solids/pieces/piece_net_quarters_internal.h"
#include "tests/solids/piece_bound_cases.h"
#include "tests/support/directed_bounds.h"
#include "tests/support/piece_bound_subjects.h"

namespace veritope {
namespace bounds {

// What the formulas of piece_bounds.h need beyond those of predicates.
RoundingCount operator*(double, RoundingCount a) { return a; }  // by 1/2: exact
RoundingCount abs(RoundingCount a) { return a; }
bool operator<(RoundingCount, int) { return false; }

}  // namespace bounds

namespace {

using bounds::power;
using bounds::RoundingCount;
using bounds::UnderflowCount;

Rational unit() { return Rational::from_double(internal::kNetUnit); }
Rational slack() { return Rational::from_double(internal::kNetSlack); }

// The constant times the slack is the derived one.
void expect_tight(double constant, int k, int bound_roundings) {
  bounds::expect_tight_directed(Rational::from_double(constant) * slack(), k, bound_roundings);
}

// The slack alone pays for an error term that is exact but for `k` roundings on the way and in the bound.
void expect_slack_pays_for(int k) {
  EXPECT_LE(Rational(1) / power(Rational(1) - unit(), k), slack());
}

constexpr RoundingCount kExact;
const RoundingCount kDifference = kExact - kExact;

TEST(PieceNetBound, TheUnitIsThatOfDirectedRounding) {
  // Twice that of rounding to nearest: 1 + 2^-60 rounded upward is 1 + 2^-52.
  EXPECT_EQ(unit(), Rational(2) * bounds::unit_roundoff());
}

// ---- halving

// Counts averages that follow each other.
struct Steps {
  int n = 0;
  friend Steps operator+(Steps a, Steps b) { return {std::max(a.n, b.n)}; }
  friend Steps operator*(double, Steps a) { return {a.n + 1}; }
};

int steps_of_quarters(const FormShape& shape) {
  std::vector<Steps> net(shape.count());
  std::vector<std::vector<Steps>> children(4, net);
  Steps* const to[4] = {children[0].data(), children[1].data(), children[2].data(),
                        children[3].data()};
  if (shape.is_triangle)
    internal::quarter_triangle(shape.p, net.data(), to);
  else
    internal::quarter_tensor(shape, net.data(), to);
  int most = 0;
  for (const auto& child : children)
    for (const Steps s : child) most = std::max(most, s.n);
  return most;
}

TEST(PieceNetBound, AQuarterTakesAsManyAveragesAsItsDepthSays) {
  for (int p = 1; p <= 12; ++p) {
    const FormShape triangle{true, p, 0};
    EXPECT_EQ(steps_of_quarters(triangle), internal::quarter_depth(triangle));
    for (const int q : {1, 2, 7}) {
      const FormShape tensor{false, p, q};
      EXPECT_EQ(steps_of_quarters(tensor), internal::quarter_depth(tensor));
    }
    std::vector<Steps> line(static_cast<std::size_t>(p) + 1), right = line;
    internal::split_keeping_left(line.data(), 1, p, right.data(), 1, internal::kHalves);
    int most = 0;
    for (const Steps s : line) most = std::max(most, s.n);
    for (const Steps s : right) most = std::max(most, s.n);
    EXPECT_EQ(most, p);  // what Curve::halve and make_root_net ask for
  }
}

TEST(PieceNetBound, HalvingAddsAUnitOfTheSizeForEachAverage) {
  EXPECT_EQ(internal::average(kExact, kExact).roundings, 1);
  for (const int steps : {1, 2, 22, 1024}) {
    // The i-th average errs by at most u (1 + u)^(i - 1) times the size: its terms have grown by that
    // much. Four roundings are the bound's.
    Rational sum, grown = unit();
    for (int i = 0; i < steps; ++i, grown *= Rational(1) + unit()) sum += grown;
    const Rational needed = sum / power(Rational(1) - unit(), 5);
    const Rational paid = Rational(steps) * unit() * slack();
    EXPECT_LE(needed, paid);
    EXPECT_LE(paid, needed * (Rational(1) + Rational::power_of_two(-20)));
    EXPECT_GT(Rational(steps + 1) * unit(), paid);
  }
  expect_slack_pays_for(3);
  EXPECT_LE(Rational(1024) * bounds::flush_unit(), Rational::from_double(internal::kNetTiny));
}

// ---- signs

TEST(PieceNetBound, SideConstantFollowsFromTheRoundings) {
  const std::array<RoundingCount, 3> x{kDifference, kDifference, kDifference};
  const int k = internal::side_value(kExact, kExact, kExact, kExact, x).roundings;
  const int sum = internal::side_sum(kExact, kExact, kExact, kExact, x).roundings;
  EXPECT_EQ(k, 5);
  expect_tight(internal::kSideRel, k, sum + 4);  // kSideRel *, + error, * kNetSlack, + kNetTiny
  expect_slack_pays_for(sum + 3);                // of the errors' sum
}

TEST(PieceNetBound, SideUnderflowIsPaidFor) {
  for (const Rational& lost : {bounds::underflow_unit(), bounds::flush_unit()}) {
    const auto g = UnderflowCount::bounded_by(0, lost), x = UnderflowCount::bounded_by(1, lost);
    const auto value = internal::side_value(g, g, g, g, {x, x, x});
    for (const auto& [exponent, c] : value.error.coefficient)
      EXPECT_EQ(exponent, (std::array<int, 4>{}));
    // The two sums of the bound lose as much, its two products once more each.
    EXPECT_LE(Rational(3) * value.error.at(0) + Rational(2) * lost,
              Rational::from_double(internal::kNetTiny));
  }
}

TEST(PieceNetBound, ACommonSignNeedsEveryNumberBeyondTheBound) {
  using internal::common_sign, internal::CommonSign;
  EXPECT_EQ(common_sign(1.5, 2, 1), CommonSign::kPositive);
  EXPECT_EQ(common_sign(1, 2, 1), CommonSign::kUnknown);
  EXPECT_EQ(common_sign(-2, -1.5, 1), CommonSign::kNegative);
  EXPECT_EQ(common_sign(-2, -1, 1), CommonSign::kUnknown);
  EXPECT_EQ(common_sign(-2, 2, 1), CommonSign::kMixed);
  EXPECT_EQ(common_sign(-1, 2, 1), CommonSign::kUnknown);
  EXPECT_EQ(common_sign(-2, 1, 1), CommonSign::kUnknown);
  EXPECT_TRUE(internal::is_surely_positive(1.5, 1) && !internal::is_surely_positive(1, 1));
  EXPECT_TRUE(internal::is_surely_negative(-1.5, 1) && !internal::is_surely_negative(-1, 1));
}

// ---- hulls

TEST(PieceNetBound, HullConstantsFollowFromTheRoundings) {
  const int ends = internal::hull_ends(kExact, kExact)[0].roundings;
  const int rational_ends = internal::hull_ends(kExact, kExact, kExact, kExact)[0].roundings;
  // origin + end - slack
  const auto placed = [](int k) { return ((kExact + RoundingCount{k}) - kExact).roundings; };
  EXPECT_EQ(placed(ends), 3);
  EXPECT_EQ(placed(rational_ends), 5);
  // rel *, the sum, * kNetSlack, + kNetTiny, and what the last difference takes from the slack itself.
  expect_tight(internal::kRationalHullRel, placed(rational_ends), rational_ends + 5);
  // One and two roundings more than needed, for the reason in docs/bounds/piece_net.md, 4.
  expect_tight(internal::kHullRel, placed(ends) + 1, ends + 5);
  EXPECT_EQ(placed(0), 2);
  expect_tight(internal::kHullOriginRel, placed(0) + 2, 5);
}

// The slack had 4 u for both kinds; the same search as for the cases found this input against it.
TEST(PieceNetBound, FourUnitsWereTooFewForRationalHulls) {
  using namespace piece_bounds;
  const Numbers in{-0x1.3ecfbe5aabf89p+10, 0x1.fd4ffffffff08p-30, 0x1.000f419b8d4a2p-3,
                   0x1.00fffffe80d5ep-47, 0x1.d828ac36102dp-107};
  const Numbers ends = computed(Rounding::kUpward, in, [](const Numbers& v) {
    const auto end = internal::hull_ends(v[0], v[1], v[2], v[3]);
    const double size = std::max(std::abs(end[0]), std::abs(end[1]));
    const double four =
        4 * internal::kNetUnit * (size + std::abs(v[4]) + v[1]) + internal::kNetTiny;
    return Numbers{v[4] + end[0] - four,
                   v[4] + end[0] - internal::hull_slack(end[0], end[1], v[4], true)};
  });
  const auto v = exactly(in);
  const Rational exact = v[4] + (v[0] - v[1]) / (v[2] - v[3]);
  EXPECT_LT(exact, Rational::from_double(ends[0]));
  EXPECT_LE(Rational::from_double(ends[1]), exact);
}

// ---- crossing numbers

TEST(PieceNetBound, CrossingConstantsFollowFromTheRoundings) {
  const RoundingCount p = internal::relative_to_centre(kExact, kExact, kDifference);
  const RoundingCount x = internal::projected(p, p, kDifference, kDifference);
  const RoundingCount turned = internal::turned(kExact, kExact, x, x)[0];
  EXPECT_EQ(p.roundings, 3);
  EXPECT_EQ(x.roundings, 6);
  EXPECT_EQ(turned.roundings, 8);
  // The size |m| + w |c| (3) and the reach (1) are computed; * reach, rel *, + error, the product, *
  // kNetSlack, + kNetTiny.
  expect_tight(internal::kProjectedRel, x.roundings, 3 + 1 + 6);
  expect_tight(internal::kTurnedRel, turned.roundings, 3 + 1 + 6);
  // The errors of m and w: |c| w_error + error (3), the same on the way, and what they grow by in the
  // roundings of the value.
  expect_slack_pays_for(3 + 1 + 6 + turned.roundings);
}

// Where all errors add up: p and p_k err by 1 in opposite directions, both coordinates in the worst one.
TEST(PieceNetBound, CrossingBoundPaysForBothTermsOfBothCoordinates) {
  const double x = internal::projected(1.0, -1.0, 1.0, 1.0);
  for (const auto& turn : {std::array<double, 2>{1, 0}, std::array<double, 2>{0.8125, 0.59375},
                           std::array<double, 2>{-0.375, 0.90625}}) {
    const double worst = internal::turned(std::abs(turn[0]), std::abs(turn[1]), x, x)[1];
    EXPECT_GE(internal::crossing_bound(1, 0, 1, turn), worst);
    EXPECT_LE(internal::crossing_bound(1, 0, 1, turn), worst * (1 + 0x1p-20));
  }
}

TEST(PieceNetBound, CrossingUnderflowIsPaidFor) {
  for (const Rational& lost : {bounds::underflow_unit(), bounds::flush_unit()}) {
    // Symbols: 0 the homogeneous coordinates, 1 what is relative to the centre, 2 the direction.
    const auto m = UnderflowCount::bounded_by(0, lost), c = UnderflowCount::bounded_by(1, lost),
               d = UnderflowCount::bounded_by(2, lost);
    const auto p = internal::relative_to_centre(m, m, c);
    const auto x = internal::projected(p, p, d, d);
    const auto t = UnderflowCount::bounded_by(3, lost);
    const auto turned = internal::turned(t, t, x, x)[0];
    const Rational tiny = Rational::from_double(internal::kNetTiny), most = Rational(4) * lost;
    for (const auto& [exponent, loss] : turned.error.coefficient) {
      // Either a multiple of |t| |d|, which stands in the bound with kNetTiny, or of |t|, which is at
      // most 1, or constant.
      EXPECT_TRUE(exponent[0] == 0 && exponent[1] == 0 && exponent[2] <= 1 && exponent[3] <= 1);
      EXPECT_LE(loss, most * Rational(2));
    }
    EXPECT_LE(Rational(32) * lost, tiny);
  }
}

// ---- what a search has found

TEST(PieceNetBound, NoFoundInputBreaksABoundAndSomeComeNear) {
  using namespace piece_bounds;
  std::map<std::string, double> most;
  for (const BoundCase& c : kBoundCases) {
    const double used = share_of(c);
    EXPECT_LE(used, 1) << c.what << ' ' << c.p << ' ' << c.q;
    most[c.what] = std::max(most[c.what], used);
  }
  // Half of a constant would be too little, so it would fail above.
  for (const auto& [what, used] : most) EXPECT_GT(used, kLeastShare) << what;
  EXPECT_EQ(most.size(), 7u);
}

}  // namespace
}  // namespace veritope
