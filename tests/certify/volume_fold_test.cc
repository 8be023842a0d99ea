// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/volume_fold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "splines/bspline_domain.h"
#include "splines/bspline_make.h"

namespace veritope {
namespace {

using Point = std::array<Rational, 3>;
using Index = std::array<std::size_t, 3>;

Rational ratio(std::int64_t n, std::int64_t d) { return Rational(Integer(n), Integer(d)); }

std::vector<Rational> clamped(int degree, std::vector<Rational> inner, const Rational& end) {
  std::vector<Rational> out(static_cast<std::size_t>(degree) + 1, Rational(0));
  out.insert(out.end(), inner.begin(), inner.end());
  out.insert(out.end(), static_cast<std::size_t>(degree) + 1, end);
  return out;
}

// The control points are where(index), the weights 1 + (i + j + k) % 3 if it is rational.
ExactVolume volume(const std::array<KnotAxis<Rational>, 3>& axes,
                   const std::function<Point(const Index&)>& where, bool is_rational = false) {
  Grid<3> grid;
  for (std::size_t a = 0; a < 3; ++a) grid.size[a] = axes[a].num_control();
  const std::size_t n = grid.count(), components = is_rational ? 4 : 3;
  std::vector<Rational> all(components * n);
  for (std::size_t i = 0; i < n; ++i) {
    const Index index = grid.index_of(i);
    const Rational w(
        is_rational ? static_cast<std::int64_t>(1 + (index[0] + index[1] + index[2]) % 3) : 1);
    const Point p = where(index);
    for (std::size_t c = 0; c < 3; ++c) all[c * n + i] = p[c] * w;
    if (is_rational) all[3 * n + i] = w;
  }
  return ExactVolume(axes, static_cast<int>(components), is_rational, std::move(all));
}

std::array<KnotAxis<Rational>, 3> bezier_axes(int p, int q, int r) {
  return {KnotAxis<Rational>{p, clamped(p, {}, Rational(1))},
          KnotAxis<Rational>{q, clamped(q, {}, Rational(1))},
          KnotAxis<Rational>{r, clamped(r, {}, Rational(1))}};
}
Point at(const Index& i) {
  return {Rational(static_cast<std::int64_t>(i[0])), Rational(static_cast<std::int64_t>(i[1])),
          Rational(static_cast<std::int64_t>(i[2]))};
}
// The unit cube, its corner (1, 1, 1) moved to (c, c, c): it folds iff c < 2/3.
ExactVolume cube(const Rational& c) {
  return volume(bezier_axes(1, 1, 1), [&](const Index& i) {
    return i == Index{1, 1, 1} ? Point{c, c, c} : at(i);
  });
}
SplineModel model(std::vector<ExactVolume> volumes) {
  SplineModel out;
  for (ExactVolume& v : volumes) out.entities.push_back({std::move(v), {}, {}, {}});
  return out;
}
// Exchanges coordinates, multiplies them and moves the point.
struct Affine {
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::array<std::int64_t, 3> factors{1, 1, 1};
  std::int64_t shift = 0;

  bool is_mirror() const {
    bool out = factors[0] * factors[1] * factors[2] < 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i + 1; j < 3; ++j) out = out != (axes[i] > axes[j]);
    return out;
  }
  Point operator()(const Point& p) const {
    Point out;
    for (std::size_t c = 0; c < 3; ++c)
      out[c] = p[axes[c]] * Rational(factors[c]) + Rational(shift);
    return out;
  }
};

void expect_proof(const SplineModel& m, const VolumeFold& fold) {
  const auto& v = std::get<ExactVolume>(m.entities[fold.entity].shape);
  EXPECT_EQ(jacobian_sign(v, fold.places[0]), Sign::kPositive);
  EXPECT_EQ(jacobian_sign(v, fold.places[1]), Sign::kNegative);
}

// PROVES INVALID-4
TEST(VolumeFold, ACornerPulledPastTheDiagonalIsFoundAndOneBeforeItIsNot) {
  const SplineModel folded = model({cube(Rational(1)), cube(ratio(3, 5))});
  const auto fold = find_fold(folded);
  ASSERT_TRUE(fold);
  EXPECT_EQ(fold->entity, 1u);
  expect_proof(folded, *fold);
  const auto& v = std::get<ExactVolume>(folded.entities[1].shape);
  EXPECT_EQ(parameters_at(v, fold->places[0]), (Point{Rational(0), Rational(0), Rational(0)}));
  EXPECT_EQ(parameters_at(v, fold->places[1]), (Point{Rational(1), Rational(1), Rational(1)}));
  EXPECT_EQ(point_at(v, fold->places[1]), (Point{ratio(3, 5), ratio(3, 5), ratio(3, 5)}));
  EXPECT_FALSE(find_fold(model({cube(Rational(1)), cube(ratio(7, 10))})));
  EXPECT_FALSE(find_fold(model({cube(ratio(2, 3))}))) << "the determinant is 0 at the corner";
  const Rational hair = ratio(1, std::int64_t{1} << 60);
  EXPECT_TRUE(find_fold(model({cube(ratio(2, 3) - hair)}))) << "corners are decided exactly";
}

// PROVES INVALID-4.J1
// PROVES INVALID-4.J2
TEST(VolumeFold, MirrorsExchangeThePlacesAndAffineMapsKeepTheVerdict) {
  std::array<std::size_t, 3> axes{0, 1, 2};
  do
    for (unsigned signs = 0; signs < 8; ++signs)
      for (const bool is_rational : {false, true}) {
        const Affine map{
            axes,
            {(signs & 1) != 0 ? -3 : 3, (signs & 2) != 0 ? -1 : 1, (signs & 4) != 0 ? -2 : 2},
            7};
        for (const Rational& c : {ratio(1, 10), Rational(1)}) {
          const SplineModel m = model({volume(
              bezier_axes(1, 1, 1),
              [&](const Index& i) {
                return map(i == Index{1, 1, 1} ? Point{c, c, c} : at(i));
              },
              is_rational)});
          const auto fold = find_fold(m);
          ASSERT_EQ(fold.has_value(), c != Rational(1));
          if (!fold) continue;
          expect_proof(m, *fold);
          EXPECT_EQ(fold->places[map.is_mirror() ? 1 : 0].at,
                    (Point{Rational(0), Rational(0), Rational(0)}));
        }
      }
  while (std::next_permutation(axes.begin(), axes.end()));
}

// Only the middle, or only a place beside an inner knot, is inside out.
TEST(VolumeFold, FoldsInsideAreFoundInTheMiddleAndOnTheGridOfEachPiece) {
  const auto along_u = [](const KnotAxis<Rational>& axis, std::vector<std::int64_t> x) {
    auto axes = bezier_axes(1, 1, 1);
    axes[0] = axis;
    return volume(axes, [x](const Index& i) {
      Point p = at(i);
      p[0] = Rational(x[i[0]]);
      return p;
    });
  };
  const SplineModel middle = model({along_u({3, clamped(3, {}, Rational(1))}, {0, 4, -3, 1})});
  const auto in_middle = find_fold(middle);
  ASSERT_TRUE(in_middle);
  EXPECT_EQ(in_middle->places[1].at, (Point{ratio(1, 2), ratio(1, 2), ratio(1, 2)}));
  expect_proof(middle, *in_middle);

  const SplineModel knots = model({along_u(
      {2, clamped(2, {Rational(1), Rational(3), Rational(3)}, Rational(7))}, {0, 2, 5, 4, 6, 9})});
  const auto in_piece = find_fold(knots);
  ASSERT_TRUE(in_piece);
  expect_proof(knots, *in_piece);
  EXPECT_EQ(in_piece->places[1].piece[0], 1u);
}

// Points at inner knots of multiplicity over the degree may belong to two separate parts of which one is mirrored.
TEST(VolumeFold, VolumesThatMayBeTornAreNotExamined) {
  auto axes = bezier_axes(1, 1, 1);
  axes[0] = {1, clamped(1, {Rational(1), Rational(1)}, Rational(2))};
  const std::array<std::int64_t, 4> x{0, 1, 3, 2};
  const ExactVolume torn = volume(axes, [&](const Index& i) {
    Point p = at(i);
    p[0] = Rational(x[i[0]]);
    return p;
  });
  EXPECT_FALSE(find_fold(model({torn})));
  EXPECT_TRUE(find_fold(model({torn, cube(Rational(0))})));
}

// The intervals of the search never contradict the exact sign: what is found is a proof.
TEST(VolumeFold, WhatIsFoundInRandomVolumesIsAProof) {
  std::mt19937_64 random(54);
  int found = 0;
  for (int trial = 0; trial < 120; ++trial) {
    std::array<KnotAxis<Rational>, 3> axes;
    for (auto& axis : axes) {
      axis.degree = static_cast<int>(1 + random() % 3);
      std::vector<Rational> inner;
      for (std::uint64_t n = random() % 3; n > 0; --n)
        inner.push_back(ratio(static_cast<std::int64_t>(3 - n) * 7, 3));
      axis.knots = clamped(axis.degree, inner, Rational(9));
    }
    const std::int64_t noise = trial % 3;
    const SplineModel m = model({volume(
        axes,
        [&](const Index& i) {
          Point p = at(i);
          for (Rational& c : p)
            c += ratio(noise * (static_cast<std::int64_t>(random() % 17) - 8), 16);
          return p;
        },
        trial % 2 == 0)});
    const auto fold = find_fold(m);
    if (noise == 0 && trial % 2 != 0) {
      EXPECT_FALSE(fold) << trial;
    }
    if (!fold) continue;
    ++found;
    expect_proof(m, *fold);
  }
  EXPECT_GT(found, 20);
}

TEST(VolumeFold, LimitsOfCertificatesAreThoseOfThePage) {
  const FoldPlace first{{0, 0, 0}, {Rational(0), Rational(0), Rational(0)}};
  const auto with = [](const Rational& x, const Rational& end) {
    auto axes = bezier_axes(1, 1, 1);
    axes[1].knots = clamped(1, {}, end);
    return volume(axes, [&](const Index& i) {
      Point p = at(i);
      if (i == Index{1, 0, 0}) p[0] = x;
      return p;
    });
  };
  const auto power = [](unsigned bits) {
    Integer out(1);
    for (unsigned i = 0; i < bits; ++i) out *= Integer(2);
    return out;
  };
  EXPECT_TRUE(fits_certificate(with(Rational(power(8191)), Rational(1)), first));
  EXPECT_FALSE(fits_certificate(with(Rational(power(8192)), Rational(1)), first));
  EXPECT_FALSE(fits_certificate(with(Rational(Integer(1), power(8192)), Rational(1)), first));
  EXPECT_TRUE(fits_certificate(with(Rational(1), Rational(power(255))), first));
  EXPECT_FALSE(fits_certificate(with(Rational(1), Rational(power(256))), first));
  EXPECT_FALSE(fits_certificate(with(Rational(1), Rational(Integer(1), power(256))), first));
  const auto of_degree = [](int p) {
    return volume(bezier_axes(p, 1, 1), [](const Index& i) { return at(i); });
  };
  EXPECT_TRUE(fits_certificate(of_degree(15), first));
  EXPECT_FALSE(fits_certificate(of_degree(16), first));
}

}  // namespace
}  // namespace veritope
