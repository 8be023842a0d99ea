// SPDX-License-Identifier: LGPL-3.0-or-later
// The constants of solids/interval_boxes/box_bounds.h against docs/bounds/box_bounds.md: the derivation rerun in exact
// rationals, inputs that a search finds against each constant, and decisions that doubles without it would get wrong.
#include "solids/interval_boxes/box_bounds.h"

#include <cmath>

#include "models/patch_shapes.h"
#include "solids/interval_boxes/c3_exceptions.h"
#include "solids/interval_boxes/condition_sweep.h"
#include "solids/pieces/find_pieces.h"
#include "tests/support/directed_bounds.h"
#include "tests/support/piece_bound_search.h"
#include "topology/octree_key.h"

namespace veritope {
namespace bounds {
inline bool operator<(RoundingCount a, RoundingCount b) { return a.roundings < b.roundings; }
}  // namespace bounds

namespace {

using bounds::RoundingCount;
using piece_bounds::Numbers;
using piece_bounds::Rounding;

constexpr RoundingCount kExact;
const Rational kPart = Rational(1) + Rational::power_of_two(-20);

// ---- distances

TEST(BoxBounds, DistanceConstantFollowsFromTheRoundings) {
  const RoundingCount gap = internal::gap(kExact, kExact, kExact, kExact);
  const RoundingCount reach = internal::reach(kExact, kExact, kExact, kExact);
  EXPECT_EQ(gap.roundings, reach.roundings);
  const int sum = internal::sum_of_squares(std::array{gap, gap, gap}).roundings;
  EXPECT_EQ(sum, 5);
  // In halves: the root halves those of the sum; then come its own and that of the last sum or difference.
  const int halves = sum + 2 + 2;
  const Rational down = Rational(1) - bounds::directed_unit();
  // The product and the sum in the bound round, too. The square of what the bound may add to 1 against the derived one.
  const auto square = [&](const Rational& c) {
    return bounds::power(Rational(1) + c * bounds::power(down, 2), 2);
  };
  const auto derived = [&](int n) { return Rational(1) / bounds::power(down, n); };
  const Rational c = Rational::from_double(internal::kDistanceRel);
  EXPECT_LE(derived(halves), square(c));
  EXPECT_LE(square(c / kPart), derived(halves));
  EXPECT_GT(derived(halves + 1), square(c));
  EXPECT_GT(square(c / kPart), derived(halves - 1));
}

TEST(BoxBounds, UnderflowOfSquaresIsPaidFor) {
  // sqrt(S + e) <= sqrt(S) + sqrt(e): three products, whose losses grow in two sums.
  const Rational lost = Rational(3) * bounds::flush_unit() * Rational(2);
  const Rational tiny = Rational::from_double(internal::kDistanceTiny);
  EXPECT_LE(lost, tiny * tiny);
  for (const double d : {0x1p-510, 0x1p-537, 0x1p-540, 0x1p-900}) {
    const Box3d a{{0, 0, 0}, {0, 0, 0}}, b{{d, d, d}, {d, d, d}};
    EXPECT_EQ(internal::least_distance(a, b), 0);
    EXPECT_GT(internal::greatest_distance(a, b), 2 * d);
  }
}

// How much of the bound the two ends of a distance use, between points: x and y on each axis.
double share_of_distance(const Numbers& in, Rounding mode) {
  const Numbers found = piece_bounds::computed(mode, in, [](const Numbers& v) {
    const Box3d a{{v[0], v[1], v[2]}, {v[0], v[1], v[2]}},
        b{{v[3], v[4], v[5]}, {v[3], v[4], v[5]}};
    const double least = internal::least_distance(a, b),
                 greatest = internal::greatest_distance(a, b);
    return Numbers{least, greatest, internal::distance_bound(0.5 * (least + greatest))};
  });
  const auto v = piece_bounds::exactly(in);
  const Rational square =
      internal::sum_of_squares(std::array<Rational, 3>{v[0] - v[3], v[1] - v[4], v[2] - v[5]});
  const auto below = Rational::from_double(found[0]), above = Rational::from_double(found[1]);
  if (square < below * below || above * above < square) return 2;
  if (square.sign() == Sign::kZero) return 0;
  // One step of Newton's method from the nearest double: 100 bits.
  const Rational first = Rational::from_double(std::sqrt(nearest_double(square)));
  const Rational root = (first + square / first) / Rational(2);
  const Rational bound = Rational::from_double(found[2]);
  return nearest_double(std::max(below + bound - root, root - (above - bound)) / bound);
}

TEST(BoxBounds, FoundBoxesUseMoreThanHalfOfTheDistancesBoundAndNoneBreaksIt) {
  double most = 0;
  for (const Rounding mode : {Rounding::kNearest, Rounding::kUpward}) {
    const auto found = piece_bounds::climb(
        {[mode](const Numbers& in) { return share_of_distance(in, mode); },
         [](Random& r) { return piece_bounds::draw_numbers(r, 6); }, piece_bounds::change_numbers},
        8, 1500, 1);
    EXPECT_LE(found.share, 1);
    most = std::max(most, found.share);
  }
  EXPECT_GT(most, 0.5) << "half of the constant would do";
}

TEST(BoxBounds, DistancesThatDoublesRoundAreBelowAndAboveTheExactOnes) {
  int rounded_up = 0, rounded_down = 0;
  for (int i = 1; i <= 64; ++i) {
    const Point3d p{0, 0, 0}, q{0.1 * i, 0.3, 0.7};
    const Box3d a{p, p}, b{q, q};
    Rational square;
    for (const double v : q) square += Rational::from_double(v) * Rational::from_double(v);
    const auto squared = [](double v) {
      return Rational::from_double(v) * Rational::from_double(v);
    };
    EXPECT_LE(squared(internal::least_distance(a, b)), square);
    EXPECT_GE(squared(internal::greatest_distance(a, b)), square);
    const double plain = std::sqrt(internal::sum_of_squares(q));
    rounded_up += squared(plain) > square;
    rounded_down += squared(plain) < square;
  }
  EXPECT_GT(rounded_up, 16);
  EXPECT_GT(rounded_down, 16);
}

TEST(BoxBounds, CloseMeansAtMostOneSixtyFourthMore) {
  for (const double lo : {1.0, 0x1.fffffffffffffp+0, 0x1.23456789abcdfp-300}) {
    const Rational most = Rational::from_double(lo) * Rational(65) / Rational(64);
    double hi = nearest_double(most);
    while (Rational::from_double(hi) > most) hi = std::nextafter(hi, 0.0);
    EXPECT_TRUE(internal::is_close_above(lo, hi));
    hi = std::nextafter(hi, 2 * hi);
    EXPECT_FALSE(internal::is_close_above(lo, hi));
    EXPECT_FALSE(internal::is_close_above(lo, 3 * lo));
  }
  EXPECT_FALSE(internal::is_close_above(0, 0x1p-600));
}

TEST(BoxBounds, TheFactorOfBoxesIsTheLargestThatItsProductAllows) {
  const Rational most = bounds::power(Rational(1) - bounds::directed_unit(), 2) / Rational(3);
  const auto squared = [](double v) { return Rational::from_double(v) * Rational::from_double(v); };
  EXPECT_LE(squared(internal::kPerRootOfThree), most);
  EXPECT_GT(squared(std::nextafter(internal::kPerRootOfThree, 1.0)), most);
  // Some d / sqrt(3) is above the double nearest to it; a product with the nearest double to 1 / sqrt(3) would be, too.
  int wrong = 0;
  for (int i = 1; i <= 64; ++i) {
    const double d = 0.1 * i;
    const Rational limit = squared(d) / Rational(3);
    EXPECT_LE(squared((SelfDistance{d, d, true}.box_bound())), limit);
    wrong += squared(d * (1 / std::sqrt(3.0))) > limit;
  }
  EXPECT_GT(wrong, 16);
}

// ---- cells

Rational largest_place() { return Rational(OctreeKey::kGrid) - Rational::power_of_two(-1); }

TEST(BoxBounds, CellMarginFollowsFromTheRoundings) {
  const RoundingCount place = internal::in_cells(kExact, kExact, kExact);
  EXPECT_EQ(place.roundings, 2);
  bounds::expect_tight_directed(Rational::from_double(internal::kCellMargin) / largest_place(),
                                place.roundings, 0);
}

TEST(BoxBounds, TakingTheMarginAwayRoundsNothing) {
  // Places below 2^20 are multiples of 2^-33, or of a smaller power.
  EXPECT_EQ(std::fmod(internal::kCellMargin, 0x1p-33), 0);
  // Otherwise a sum that rounds upward could reach a plane that the place does not.
  const ScopedUpward upward;
  for (const double place : {1.0, 512.0, 0x1.fffffffffffffp+18, 0x1.fffffffffffffp+19}) {
    const Rational exact =
        Rational::from_double(place) - Rational::from_double(internal::kCellMargin);
    EXPECT_EQ(Rational::from_double(fenced(place) - internal::kCellMargin), exact);
  }
}

// How much of the margin the rounding of x, low and size uses; 2 if a cell is missing.
double share_of_cells(const Numbers& in, Rounding mode) {
  const auto v = piece_bounds::exactly(in);
  if (!(in[2] > 0)) return 0;
  const Rational place = internal::in_cells(v[0], v[1], v[2]);
  if (place < Rational(1) || place > largest_place()) return 0;
  const Numbers found = piece_bounds::computed(mode, in, [](const Numbers& n) {
    const double q = internal::in_cells(n[0], n[1], n[2]);
    return Numbers{static_cast<double>(internal::first_cell(n[0], n[1], n[2])),
                   static_cast<double>(internal::last_cell(n[0], n[1], n[2])),
                   q - internal::kCellMargin, q + internal::kCellMargin};
  });
  if (Rational::from_double(found[0]) >= place ||
      Rational::from_double(found[1]) + Rational(1) <= place)
    return 2;
  const Rational margin = Rational::from_double(internal::kCellMargin);
  const Rational below = Rational::from_double(found[2]) + margin - place;
  const Rational above = place - (Rational::from_double(found[3]) - margin);
  return nearest_double(std::max(below, above) / margin);
}

TEST(BoxBounds, FoundPlacesUseMoreThanHalfOfTheMarginAndNoneBreaksIt) {
  const auto draw = [](Random& r) {
    Numbers in = piece_bounds::draw_numbers(r, 3);
    // Nearly the last cell: the place is just below a power of two, and the difference just above one.
    in[2] = std::ldexp(1 + 0x1p-18 * r.unit(), -20);
    in[0] = in[1] + in[2] * (OctreeKey::kGrid - 0.5 - r.unit());
    return in;
  };
  const auto change = [](Random& r, Numbers& in) {
    double& v = in[r.below(3)];
    v += v * std::ldexp(2 * r.unit() - 1, -21 - static_cast<int>(r.below(33)));
  };
  double most = 0;
  for (const Rounding mode : {Rounding::kNearest, Rounding::kUpward}) {
    const auto found = piece_bounds::climb(
        {[mode](const Numbers& in) { return share_of_cells(in, mode); }, draw, change}, 8, 1500, 1);
    EXPECT_LE(found.share, 1);
    most = std::max(most, found.share);
  }
  EXPECT_GT(most, 0.5) << "half of the margin would do";
}

TEST(BoxBounds, ACellBelowAPlaneThatAPlaceRoundsOntoIsListed) {
  // -2^-60 + 1 rounds to 1, which is the plane between cells 1023 and 1024.
  EXPECT_EQ(std::floor(internal::in_cells(-0x1p-60, -1.0, 0x1p-10)), 1024);
  EXPECT_EQ(internal::first_cell(-0x1p-60, -1, 0x1p-10), 1023u);
  // A point on the plane is inside of the two cells together only.
  EXPECT_EQ(internal::first_cell(0, -1, 0x1p-10), 1023u);
  EXPECT_EQ(internal::last_cell(0, -1, 0x1p-10), 1024u);
}

TEST(BoxBounds, ACellAboveAPlaneThatAPlaceRoundsBelowIsListed) {
  const double x = 0x1.0866666666667p+6, low = -0x1.3333333333333p-1, size = 0x1.2666666666667p+0;
  const auto exactly = [](double v) { return Rational::from_double(v); };
  EXPECT_LE(Rational(58), internal::in_cells(exactly(x), exactly(low), exactly(size)));
  EXPECT_LT(internal::in_cells(x, low, size), 58);
  EXPECT_EQ(internal::last_cell(x, low, size), 58u);
}

patch_shapes::Patches two_boxes(double near_side) {
  const auto at = [&](double x, double y) {
    return PatchPoint{Rational::from_double(x), Rational::from_double(y), Rational::from_double(y)};
  };
  return patch_shapes::joined({patch_shapes::box(at(-3.91796875, 0), at(-3, 1)),
                               patch_shapes::box(at(near_side, 0), at(1.1, 1))});
}

// PROVES SWEEP-1.COVER
TEST(BoxBounds, ASideJustBelowAPlaneOfCellsIsCovered) {
  constexpr double kSize = 0.25;
  const auto cells = [&](double side) {
    BoundaryModel model = BoundaryModel::make(make_patch_complex(two_boxes(side)).value()).value();
    return sweep_conditions(model, kSize, 0).value()[0].cells;
  };
  // The octree's lower end, in the model's units, as the sweep chooses it; then a plane of cells between the boxes.
  BoundaryModel model = BoundaryModel::make(make_patch_complex(two_boxes(0)).value()).value();
  const PieceForest& forest = model.forest();
  const double low =
      std::ldexp(hull_of_roots(forest).lo[0] - (2 + 0x1.5p-2) * std::ldexp(kSize, forest.scale()),
                 -forest.scale());
  const Rational plane = Rational::from_double(low) + Rational(18) * Rational::from_double(kSize);
  const double side = nearest_double(plane) - 0x1p-60;
  ASSERT_LT(Rational::from_double(side), plane);
  ASSERT_EQ((side - low) / kSize, 18) << "the place does not round onto the plane";
  // Below the plane and above it lie 5 x 5 cells each. A side half a cell lower does not meet the inner 3 x 3 above.
  EXPECT_EQ(cells(side), cells(side - 0.5 * kSize) + 9);
}

}  // namespace
}  // namespace veritope
