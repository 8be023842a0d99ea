// SPDX-License-Identifier: LGPL-3.0-or-later
// The same surfaces in other words meet alike: elevated, with more knots, exchanged, under exact affine maps.
#include <gtest/gtest.h>

#include "bench/random_surfaces.h"
#include "interval/intersect/surface_intersection.h"
#include "interval/numeric.h"
#include "splines/affine_map.h"
#include "splines/bspline_degree.h"
#include "splines/bspline_domain.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

Rational q(std::int64_t p, std::int64_t r = 1) { return Rational(p) / Rational(r); }

struct Counts {
  std::size_t arcs = 0, loops = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};
Counts counts_of(const BSplineSurface<Rational>& a, const BSplineSurface<Rational>& b,
                 Interval* length) {
  const auto x = intersect(a, b);
  EXPECT_TRUE(x.has_value() && x->is_complete());
  Counts out;
  double lo = 0, hi = 0;
  for (const auto& branch : x->branches) {
    ++(branch.is_closed ? out.loops : out.arcs);
    lo += branch.length.lo(), hi += branch.length.hi();
  }
  *length = Interval::from_bounds(lo * (1 - 1e-12), hi * (1 + 1e-12));
  return out;
}

TEST(IntersectionInvariance, CountsStayUnderOtherFormsOfTheSameSurfaces) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    const auto a = bench::random_graph(6, random), b = bench::random_graph(6, random);
    Interval length, other;
    const Counts plain = counts_of(a, b, &length);
    const auto expect_same = [&](const BSplineSurface<Rational>& c,
                                 const BSplineSurface<Rational>& d, const char* what) {
      EXPECT_EQ(counts_of(c, d, &other), plain) << what << ", seed " << seed;
      EXPECT_FALSE(is_disjoint(length, other)) << what << ", seed " << seed;
    };
    expect_same(b, a, "exchanged");
    expect_same(elevate(a, 0, 1), b, "elevated");
    expect_same(insert_knot(insert_knot(a, 0, q(1, 2)), 1, q(2, 7)), b, "knots inserted");
    expect_same(swapped(a, 0, 1), b, "axes exchanged");
    expect_same(mirrored(a, 0), b, "reversed");
  }
}

TEST(IntersectionInvariance, CountsStayUnderAffineMaps) {
  const AffineMap skew{3,
                       3,
                       {q(3), q(1, 3), q(0), q(-2, 7), q(1), q(5), q(1, 11), q(0), q(2)},
                       {q(100), q(-7, 3), q(1, 9)}};
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    const auto a = bench::random_graph(6, random), b = bench::random_graph(6, random);
    Interval length, other;
    const Counts plain = counts_of(a, b, &length);
    EXPECT_EQ(counts_of(transformed(a, skew), transformed(b, skew), &other), plain)
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace veritope
