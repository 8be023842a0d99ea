// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/splines/simplex_spline_test.cc: simplex splines against their definition as volumes, and their laws at points on
// faces, edges, knots and planes of knots too.
#include "splines/simplex_spline.h"

#include <gtest/gtest.h>

#include "splines/dms_spline.h"
#include "tests/splines/draw.h"
#include "tests/support/simplex_oracle.h"

namespace veritope {
namespace {

using simplex_oracle::Answers;
using simplex_oracle::Path;
using simplex_oracle::Point;
using ExactSplines = SimplexSplines<Rational, Answers>;

Point draw_lattice_point(Random& random, long size) {
  Point p;
  for (Rational& c : p) c = Rational(random.between(-size, size));
  return p;
}

// Degree + 4 knots, in a third of the cases with repeated ones, in a third many of them coplanar.
std::vector<Point> draw_knots(Random& random, int degree) {
  const auto kind = random.below(3);
  std::vector<Point> knots;
  for (int i = 0; i < degree + 4; ++i) {
    if (kind == 1 && i > 0 && random.below(2) == 0) {
      knots.push_back(knots[random.below(knots.size())]);
    } else {
      knots.push_back(draw_lattice_point(random, 6));
      if (kind == 2 && random.below(2) == 0) knots.back()[2] = Rational(0);
    }
  }
  return knots;
}

// A combination of up to `count` knots: a knot, or a point of an edge, a triangle or inside.
Point draw_combination(Random& random, const std::vector<Point>& knots, std::size_t count) {
  Point sum{};
  Rational total;
  for (std::size_t i = 0; i < count; ++i) {
    const Rational weight(random.between(1, 5));
    sum =
        simplex_oracle::plus(sum, simplex_oracle::times(weight, knots[random.below(knots.size())]));
    total += weight;
  }
  return simplex_oracle::times(Rational(1) / total, sum);
}

Point draw_place(Random& random, const std::vector<Point>& knots) {
  if (random.below(3) != 0) return draw_combination(random, knots, 4 + random.below(3));
  return draw_combination(random, knots, 1 + random.below(3));
}

KnotSet all_of(const std::vector<Point>& knots) {
  KnotSet set;
  for (std::size_t i = 0; i < knots.size(); ++i) set.insert(static_cast<KnotNumber>(i));
  return set;
}

std::string text_of(const std::vector<Point>& knots) {
  std::string out;
  for (const Point& p : knots) out += simplex_oracle::text(p) + " ";
  return out;
}

Random& picks() {
  static Random random(7);
  return random;
}
std::size_t any_of(std::size_t n) { return static_cast<std::size_t>(picks().below(n)); }

bool is_on_a_plane_of_knots(const std::vector<Point>& knots, const Point& u) {
  for (std::size_t i = 0; i < knots.size(); ++i)
    for (std::size_t j = i + 1; j < knots.size(); ++j)
      for (std::size_t k = j + 1; k < knots.size(); ++k)
        if (simplex_oracle::volume6(knots[i], knots[j], knots[k], u).sign() == Sign::kZero)
          return true;
  return false;
}

TEST(KnotSet, KeepsRepeatedKnotsAndLeavesOutOne) {
  const KnotSet set{3, 1, 3, 0};
  EXPECT_EQ(set, (KnotSet{0, 1, 3, 3}));
  EXPECT_EQ(set.without(3), (KnotSet{0, 1, 3}));
  EXPECT_EQ(set.without(3).hash(), (KnotSet{3, 1, 0}).hash());
  EXPECT_FALSE(set == (KnotSet{0, 1, 3, 3, 0}));
  EXPECT_THROW((void)set.without(2), InternalError);
  EXPECT_THROW((void)set.without(4), InternalError);
  KnotSet full;
  for (int i = 0; i < 15; ++i) full.insert(0);
  EXPECT_THROW(full.insert(0), InternalError);
}

TEST(SimplexFrame, HasTheBarycentricCoordinatesOfPointsAndDirections) {
  for_loops(1, 300, [](Random& random) {
    const std::array<Point, 4> p{draw_lattice_point(random, 9), draw_lattice_point(random, 9),
                                 draw_lattice_point(random, 9), draw_lattice_point(random, 9)};
    const Rational d = simplex_oracle::volume6(p[0], p[1], p[2], p[3]);
    if (d.sign() == Sign::kZero) return;
    const auto frame = simplex_frame<Rational>({0, 1, 2, 3}, p, d.sign());
    EXPECT_EQ(frame.volume, d);
    EXPECT_EQ(frame.height, Rational(1) / abs(d));
    const Point u{draw_rational(random), draw_rational(random), draw_rational(random)};
    const auto at = frame.barycentric(u), along = frame.barycentric_direction(u);
    EXPECT_EQ(at[0] + at[1] + at[2] + at[3], Rational(1));
    EXPECT_EQ(along[0] + along[1] + along[2] + along[3], Rational(0));
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(at[0] * p[0][c] + at[1] * p[1][c] + at[2] * p[2][c] + at[3] * p[3][c], u[c]);
      EXPECT_EQ(along[0] * p[0][c] + along[1] * p[1][c] + along[2] * p[2][c] + along[3] * p[3][c],
                u[c]);
    }
    const auto rounded = frame_in_ring<double>(frame);
    EXPECT_EQ(rounded.volume, nearest_double(d));
  });
  const std::array<Point, 4> unit{Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
  EXPECT_EQ(simplex_frame<Rational>({0, 1, 2, 3}, unit, Sign::kPositive).volume, Rational(1));
  EXPECT_THROW((void)simplex_frame<Rational>({0, 1, 2, 3}, unit, Sign::kZero), InternalError);
}

// The independent definition: off all planes of knots M is the volume of a fibre of a lifted simplex.
TEST(SimplexSpline, IsTheVolumeOfTheFibreOfALiftedSimplex) {
  int positive = 0;
  for_loops(2, 400, [&](Random& random) {
    const int degree = draw_int(random, 0, 3);
    const std::vector<Point> knots = draw_knots(random, degree);
    if (simplex_oracle::volume6(knots[0], knots[1], knots[2], knots[3]).sign() == Sign::kZero)
      return;
    const Point u = draw_combination(random, knots, 5 + random.below(3));
    if (is_on_a_plane_of_knots(knots, u)) return;
    Answers answers(knots, simplex_oracle::axes_path(u));
    const Rational value = ExactSplines(answers, u).value(all_of(knots));
    EXPECT_EQ(value, simplex_oracle::fibre_volume(knots, u))
        << text_of(knots) << "at " << simplex_oracle::text(u);
    positive += value.sign() == Sign::kPositive ? 1 : 0;
  });
  EXPECT_GE(positive, 60);
}

TEST(SimplexSpline, DoesNotDependOnTheChoiceOfFrames) {
  for_loops(3, 400, [](Random& random) {
    const int degree = draw_int(random, 1, 4);
    const std::vector<Point> knots = draw_knots(random, degree);
    const Point u = draw_place(random, knots);
    Answers first(knots, simplex_oracle::axes_path(u)), other = first;
    other.set_pick(any_of);
    ExactSplines a(first, u), b(other, u);
    const KnotSet all = all_of(knots);
    EXPECT_EQ(a.value(all), b.value(all)) << text_of(knots) << "at " << simplex_oracle::text(u);
    EXPECT_EQ(a.gradient(all), b.gradient(all))
        << text_of(knots) << "at " << simplex_oracle::text(u);
    EXPECT_GE(a.value(all).sign(), Sign::kZero);
    EXPECT_TRUE(!a.is_off_support(all) || a.value(all) == Rational(0));
  });
}

// The derivative at 0 of the polynomial of degree k through (i, values[i - 1]), i = 1, ..., k + 1.
Rational slope_at_zero(const std::vector<Rational>& values) {
  const long count = static_cast<long>(values.size());
  Rational sum;
  for (long i = 1; i <= count; ++i) {
    // Lagrange's basis polynomial of node i has this derivative at 0.
    Rational slope;
    for (long j = 1; j <= count; ++j) {
      if (j == i) continue;
      Rational term = Rational(1) / Rational(i - j);
      for (long k = 1; k <= count; ++k)
        if (k != i && k != j) term *= Rational(-k) / Rational(i - k);
      slope += term;
    }
    sum += values[static_cast<std::size_t>(i - 1)] * slope;
  }
  return sum;
}

bool is_in_the_cell_of(const Path& path, const std::vector<Point>& knots, const Point& x) {
  for (std::size_t i = 0; i < knots.size(); ++i)
    for (std::size_t j = i + 1; j < knots.size(); ++j)
      for (std::size_t k = j + 1; k < knots.size(); ++k)
        if (simplex_oracle::volume6(knots[i], knots[j], knots[k], x).sign() !=
            simplex_oracle::side(knots[i], knots[j], knots[k], path))
          return false;
  return true;
}

// A point of the cell of the knots' planes that the path enters.
Point point_on(const Path& path, const std::vector<Point>& knots) {
  Rational eps(1);
  while (!is_in_the_cell_of(path, knots, simplex_oracle::at(path, eps))) eps /= Rational(2);
  return simplex_oracle::at(path, eps);
}

// Eq. 2: on the segment from u into the cell that rule H enters, M is a polynomial of degree k.
TEST(SimplexSpline, HasTheGradientOfThePolynomialThatThePathEnters) {
  int sloped = 0;
  for_loops(4, 250, [&](Random& random) {
    const int degree = draw_int(random, 1, 4);
    const std::vector<Point> knots = draw_knots(random, degree);
    const Point u = draw_place(random, knots);
    const Path path = random.below(2) == 0
                          ? simplex_oracle::axes_path(u)
                          : simplex_oracle::inward_path(u, draw_lattice_point(random, 5));
    Answers answers(knots, path);
    ExactSplines splines(answers, u);
    const KnotSet all = all_of(knots);
    const Point inner = point_on(path, knots);
    std::vector<Rational> values;
    for (int i = 1; i <= degree + 1; ++i) {
      const Point x = simplex_oracle::plus(
          u, simplex_oracle::times(fraction(i, degree + 1), simplex_oracle::minus(inner, u)));
      Answers there(knots, simplex_oracle::axes_path(x));
      values.push_back(ExactSplines(there, x).value(all));
    }
    const Point v = simplex_oracle::minus(inner, u);
    const Rational slope = slope_at_zero(values) * Rational(degree + 1);
    EXPECT_EQ(splines.derivative(all, v), slope)
        << text_of(knots) << "at " << simplex_oracle::text(u);
    sloped += slope.sign() != Sign::kZero ? 1 : 0;
    if (degree > 0) {  // and the value is that polynomial's at u
      Rational at_zero;
      for (long i = 1; i <= degree + 1; ++i) {
        Rational term = values[static_cast<std::size_t>(i - 1)];
        for (long k = 1; k <= degree + 1; ++k)
          if (k != i) term *= Rational(-k) / Rational(i - k);
        at_zero += term;
      }
      EXPECT_EQ(splines.value(all), at_zero) << text_of(knots) << "at " << simplex_oracle::text(u);
    }
  });
  EXPECT_GE(sloped, 60);
}

TEST(SimplexSpline, IsZeroOutsideOfItsKnotsHullAndForCoplanarKnots) {
  const std::vector<Point> knots{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  const Point off{2, 2, 2};
  Answers answers(knots, simplex_oracle::axes_path(off));
  ExactSplines splines(answers, off);
  EXPECT_EQ(splines.value(all_of(knots)), Rational(0));
  EXPECT_TRUE(splines.is_off_support(all_of(knots)));
  EXPECT_EQ(splines.gradient(all_of(knots)), Point{});
  const std::vector<Point> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  const Point inside = {fraction(1, 3), fraction(1, 4), Rational(0)};
  Answers flat_answers(flat, simplex_oracle::axes_path(inside));
  ExactSplines flat_splines(flat_answers, inside);
  EXPECT_EQ(flat_splines.value(all_of(flat)), Rational(0));
  EXPECT_EQ(flat_splines.gradient(all_of(flat)), Point{});
  EXPECT_EQ(flat_splines.value(KnotSet{0, 1, 2, 3}), Rational(0));
}

TEST(SimplexSpline, ChecksItsArgument) {
  const std::vector<Point> knots{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Answers answers(knots, simplex_oracle::axes_path({0, 0, 0}));
  ExactSplines splines(answers, {0, 0, 0});
  EXPECT_THROW((void)splines.value(KnotSet{0, 1, 2}), InternalError);
  EXPECT_THROW((void)splines.gradient(KnotSet{0, 1, 2}), InternalError);
  EXPECT_EQ(splines.value(KnotSet{0, 1, 2, 3}), Rational(1));
  EXPECT_EQ(splines.num_evaluated(), 1u);
}

TEST(SimplexSpline, IsCloseInDoublesToTheExactValue) {
  struct Rounded {
    Answers& exact;
    std::map<const SimplexFrame<Rational>*, SimplexFrame<double>> frames = {};
    std::map<const SimplexFrame<double>*, const SimplexFrame<Rational>*> back = {};
    const SimplexFrame<double>* frame(const KnotSet& set) {
      const auto* f = exact.frame(set);
      if (f == nullptr) return nullptr;
      auto [place, is_new] = frames.try_emplace(f);
      if (is_new) place->second = frame_in_ring<double>(*f), back[&place->second] = f;
      return &place->second;
    }
    bool contains(const SimplexFrame<double>& f) { return exact.contains(*back.at(&f)); }
  };
  for_loops(5, 100, [](Random& random) {
    const std::vector<Point> knots = draw_knots(random, 3);
    const Point u = draw_place(random, knots);
    Answers exact(knots, simplex_oracle::axes_path(u));
    Rounded rounded{exact};
    SimplexSplines<double, Rounded> splines(
        rounded, {nearest_double(u[0]), nearest_double(u[1]), nearest_double(u[2])});
    const double value = nearest_double(ExactSplines(exact, u).value(all_of(knots)));
    EXPECT_NEAR(splines.value(all_of(knots)), value, 1e-9 * (1 + value)) << text_of(knots);
  });
}

TEST(TetrahedralIndex, IsItsPlaceInDescendingOrder) {
  for (int sum = 0; sum <= 10; ++sum) {
    std::vector<TetrahedralIndex> all;
    for_each_tetrahedral_index(sum, [&](const TetrahedralIndex& index) {
      EXPECT_EQ(index[0] + index[1] + index[2] + index[3], sum);
      EXPECT_EQ(tetrahedral_index(index), all.size());
      EXPECT_TRUE(all.empty() || index < all.back());
      all.push_back(index);
    });
    EXPECT_EQ(all.size(), num_tetrahedral_indices(sum));
  }
  EXPECT_EQ(raised({0, 1, 2, 3}, 2), (TetrahedralIndex{0, 1, 3, 3}));
}

DmsKnots collapsed_knots() {
  DmsKnots knots;
  for (std::size_t m = 0; m < 4; ++m) knots.number[m].fill(static_cast<KnotNumber>(m));
  return knots;
}

// With collapsed clouds the basis functions are Bernstein's polynomials.
TEST(DmsSpline, IsABezierTetrahedronWhereAllCloudsAreCollapsed) {
  for_loops(6, 60, [](Random& random) {
    const std::vector<Point> corners{draw_lattice_point(random, 5), draw_lattice_point(random, 5),
                                     draw_lattice_point(random, 5), draw_lattice_point(random, 5)};
    const Rational d = simplex_oracle::volume6(corners[0], corners[1], corners[2], corners[3]);
    if (d.sign() != Sign::kPositive) return;
    const int n = draw_int(random, 1, 9);
    const Point u = draw_combination(random, corners, 1 + random.below(5));
    const Point g = draw_combination(random, corners, 40);
    Answers answers(corners, simplex_oracle::inward_path(u, g));
    ExactSplines splines(answers, u);
    std::vector<std::array<Rational, 2>> control;
    for (std::size_t i = 0; i < num_tetrahedral_indices(n); ++i)
      control.push_back({draw_rational(random), draw_rational(random)});
    const auto of = [&](const TetrahedralIndex& beta) {
      return std::span<const Rational>(control[tetrahedral_index(beta)]);
    };
    if (!answers.contains(*answers.frame(KnotSet{0, 1, 2, 3}))) return;  // g is on a face
    DmsSums<Rational> low(2), high(2);
    add_dms_terms(splines, collapsed_knots(), n, of, low);
    add_dms_terms_of_degree_n(splines, collapsed_knots(), n, of, high);
    // Bernstein's form by its definition.
    const auto frame = simplex_frame<Rational>(
        {0, 1, 2, 3}, {corners[0], corners[1], corners[2], corners[3]}, Sign::kPositive);
    const auto lambda = frame.barycentric(u);
    for (std::size_t c = 0; c < 2; ++c) {
      Rational sum;
      for_each_tetrahedral_index(n, [&](const TetrahedralIndex& beta) {
        Rational term = control[tetrahedral_index(beta)][c];
        int left = n;
        for (std::size_t m = 0; m < 4; ++m)
          for (int i = 1; i <= beta[m]; ++i, --left)
            term *= lambda[m] * Rational(left) / Rational(i);
        sum += term;
      });
      EXPECT_EQ(low.value[c], sum) << "degree " << n << " " << text_of(corners);
      EXPECT_EQ(high.value[c], sum) << "degree " << n << " " << text_of(corners);
      EXPECT_EQ(low.gradient[c], high.gradient[c]) << "degree " << n << " " << text_of(corners);
    }
  });
}

TEST(DmsSpline, RefusesFourDependentKnots) {
  const std::vector<Point> knots{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}};
  DmsKnots numbers = collapsed_knots();
  numbers.number[3] = {3, 4, 4, 4, 4, 4, 4, 4, 4, 4};  // W_(0,0,0,1) is flat
  const Point u = {fraction(1, 8), fraction(1, 8), fraction(1, 8)};
  Answers answers(knots, simplex_oracle::axes_path(u));
  ExactSplines splines(answers, u);
  EXPECT_THROW(for_each_dms_basis(splines, numbers, 1, [](auto&&...) {}), InternalError);
}

}  // namespace
}  // namespace veritope
