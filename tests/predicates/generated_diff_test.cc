// SPDX-License-Identifier: LGPL-3.0-or-later
// The generated predicates and order_on_circle against GMP's rationals by their definitions: homogeneous
// determinants, centres and powers. Shares no formula with tools/predicate_generator/.
#include <gtest/gtest.h>

#include "predicates/generated/compare_distance2d.h"
#include "predicates/generated/compare_distance3d.h"
#include "predicates/generated/compare_lengths2d.h"
#include "predicates/generated/compare_lengths3d.h"
#include "predicates/generated/order_along_line2d.h"
#include "predicates/generated/order_along_line3d.h"
#include "predicates/generated/power_circle.h"
#include "predicates/generated/power_edge2d.h"
#include "predicates/generated/power_edge3d.h"
#include "predicates/generated/power_sphere.h"
#include "predicates/order_on_circle.h"
#include "predicates/side_of_bisector.h"
#include "tests/predicates/point_generators.h"
#include "tests/predicates/rational_oracle.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using generate::Points;
using generate::xy;
using Exact = std::vector<mpq_class>;
using Weights = std::array<double, 5>;

Exact exact(const Vec2d& p) { return {p.x, p.y}; }
Exact exact(const Vec3d& p) { return {p.x, p.y, p.z}; }
Sign to_sign_of(const mpq_class& v) { return static_cast<Sign>(sgn(v)); }

mpq_class dot(const Exact& a, const Exact& b) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}
Exact minus(Exact a, const Exact& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}
mpq_class squared_distance(const Exact& a, const Exact& b) { return dot(minus(a, b), minus(a, b)); }

// The sign of the determinant of the rows (1, p, |p|^2 - w).
template <typename Point, std::size_t N>
Sign lifted(const std::array<Point, N>& points, const Weights& w) {
  oracle::Matrix m;
  for (std::size_t i = 0; i < N; ++i) {
    Exact row = exact(points[i]);
    const mpq_class lift = dot(row, row) - mpq_class(w[i]);
    row.insert(row.begin(), 1);
    row.push_back(lift);
    m.push_back(row);
  }
  return static_cast<Sign>(-oracle::determinant_sign(m));
}

// By the smallest orthogonal sphere's centre and squared radius.
template <typename Point>
Sign edge(const Point& a, const Point& b, const Point& d, const Weights& w) {
  const Exact p = exact(a), u = minus(exact(b), p);
  const mpq_class length = dot(u, u), wa = w[0];
  if (length == 0) return Sign::kZero;
  const mpq_class at = ((wa - mpq_class(w[1])) / length + 1) / 2;
  Exact centre = p;
  for (std::size_t i = 0; i < u.size(); ++i) centre[i] += at * u[i];
  const mpq_class squared_radius = squared_distance(p, centre) - wa;
  return -to_sign_of(squared_distance(exact(d), centre) - mpq_class(w[2]) - squared_radius);
}

// Turned so that p points along the first axis.
Sign around(const Vec2d& c, const Vec2d& p, const Vec2d& q, const Vec2d& r) {
  const Exact u = minus(exact(p), exact(c));
  const auto turned = [&](const Vec2d& x) -> Exact {
    const Exact v = minus(exact(x), exact(c));
    return {dot(u, v), u[0] * v[1] - u[1] * v[0]};
  };
  const auto lower = [](const Exact& v) {
    return sgn(v[1]) < 0 || (sgn(v[1]) == 0 && sgn(v[0]) < 0);
  };
  const Exact a = turned(q), b = turned(r);
  if (dot(u, u) == 0 || dot(a, a) == 0 || dot(b, b) == 0) return Sign::kZero;
  if (lower(a) != lower(b)) return lower(a) ? Sign::kNegative : Sign::kPositive;
  return to_sign_of(a[0] * b[1] - a[1] * b[0]);
}

// Squares of lengths, all equal, or any coordinates; two points coincide every fourth time.
void vary(Points& p, Weights& w, Random& random) {
  const std::uint64_t turn = random.below(4);
  for (std::size_t i = 0; i < 5; ++i) {
    const double v = p[turn == 0 ? 0 : i][i % 3];
    w[i] = turn == 1 || !std::isfinite(v * v) ? v : v * v;
  }
  if (random.below(4) == 0) p[random.below(3)] = p[random.below(3)];
}

std::string text(const Weights& w) {
  std::string out;
  for (const double v : w) {
    char number[40];
    std::snprintf(number, sizeof number, " %a", v);
    out += number;
  }
  return out;
}

template <typename Check>
void on_all_kinds(long loops, Check check) {
  std::array<long, 3> signs{};
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    const unsigned seed = 3000u + static_cast<unsigned>(kind);
    Random random(seed);
    for (long i = 0; i < scaled(loops); ++i) {
      Points p = generate::points(static_cast<generate::Kind>(kind), random);
      Weights w;
      vary(p, w, random);
      const auto count = [&](Sign found, Sign expected) {
        EXPECT_EQ(found, expected);
        ++signs[static_cast<std::size_t>(to_int(expected) + 1)];
      };
      check(p, w, count);
      ASSERT_FALSE(testing::Test::HasFailure())
          << generate::kKindNames[kind] << ", seed " << seed << ", case " << i << ": "
          << generate::text(p) << "; weights" << text(w);
    }
  }
  for (const long n : signs) EXPECT_GT(n, (signs[0] + signs[1] + signs[2]) / 10);
}

TEST(GeneratedDifferential, PowerTestsAreThoseOfTheirDefinitions) {
  on_all_kinds(1500, [](const Points& p, const Weights& w, const auto& count) {
    const std::array<Vec2d, 4> q = {xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3])};
    count(power_circle(q[0], w[0], q[1], w[1], q[2], w[2], q[3], w[3]), lifted(q, w));
    count(power_sphere(p[0], w[0], p[1], w[1], p[2], w[2], p[3], w[3], p[4], w[4]), lifted(p, w));
    count(power_edge2d(q[0], w[0], q[1], w[1], q[2], w[2]), edge(q[0], q[1], q[2], w));
    count(power_edge3d(p[0], w[0], p[1], w[1], p[2], w[2]), edge(p[0], p[1], p[2], w));
  });
}

template <typename Point, typename Count, typename Distance, typename Bisector, typename Lengths,
          typename Along>
void check_metric(const Point& a, const Point& b, const Point& c, const Point& d,
                  const Count& count, Distance compare_distance, Bisector side_of_bisector,
                  Lengths compare_lengths, Along order_along_line) {
  const Exact ea = exact(a), eb = exact(b), ec = exact(c), ed = exact(d);
  count(compare_distance(a, b, c, nullptr),
        to_sign_of(squared_distance(ea, eb) - squared_distance(ea, ec)));
  count(side_of_bisector(b, c, a, nullptr),
        to_sign_of(squared_distance(ea, ec) - squared_distance(ea, eb)));
  count(compare_lengths(a, b, c, d, nullptr),
        to_sign_of(squared_distance(ea, eb) - squared_distance(ec, ed)));
  count(order_along_line(a, b, c, d, nullptr), to_sign_of(dot(minus(eb, ea), minus(ec, ed))));
}

TEST(GeneratedDifferential, DistancesAndOrdersAreThoseOfTheirDefinitions) {
  on_all_kinds(2000, [](const Points& p, const Weights&, const auto& count) {
    const Vec2d a = xy(p[0]), b = xy(p[1]), c = xy(p[2]), d = xy(p[3]);
    check_metric(a, b, c, d, count, compare_distance2d, side_of_bisector2d, compare_lengths2d,
                 order_along_line2d);
    check_metric(p[0], p[1], p[2], p[3], count, compare_distance3d, side_of_bisector3d,
                 compare_lengths3d, order_along_line3d);
    count(order_on_circle(a, b, c, d), around(a, b, c, d));
  });
}

}  // namespace
}  // namespace veritope
