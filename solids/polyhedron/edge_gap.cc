// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/edge_gap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "predicates/lattice.h"
#include "predicates/projection.h"
#include "robust/integer.h"

namespace veritope {

// In integers: the four ends of two edges on a lattice of their own.

namespace {

using IntegerPoint = std::array<Integer, 3>;

struct IntegerEdge {
  IntegerPoint a, b;
};

struct IntegerEdges {
  IntegerEdge e, f;
  int exponent;  // a coordinate is an integer times 2^exponent
};

IntegerEdges integer_edges(const EdgeEnds& e, const EdgeEnds& f) {
  const std::array<double, 12> from{e.a.x, e.a.y, e.a.z, e.b.x, e.b.y, e.b.z,
                                    f.a.x, f.a.y, f.a.z, f.b.x, f.b.y, f.b.z};
  std::array<Integer, 12> c;
  IntegerEdges out;
  out.exponent = internal::to_integers(from, c);
  const auto point = [&](std::size_t i) {
    return IntegerPoint{std::move(c[i]), std::move(c[i + 1]), std::move(c[i + 2])};
  };
  out.e = {point(0), point(3)};
  out.f = {point(6), point(9)};
  return out;
}

IntegerPoint difference_of(const IntegerPoint& a, const IntegerPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Integer product_of(const IntegerPoint& a, const IntegerPoint& b) {
  Integer out = a[0] * b[0];
  return std::move(out.add_product(a[1], b[1]).add_product(a[2], b[2]));
}

// A number >= 0. REQUIRES den > 0.
struct Fraction {
  Integer num, den;
};

bool is_less(const Fraction& x, const Fraction& y) { return x.num * y.den < y.num * x.den; }

// The square of the distance of p from an edge.
Fraction squared_distance(const IntegerPoint& p, const IntegerEdge& from) {
  const IntegerPoint d = difference_of(from.b, from.a), w = difference_of(p, from.a);
  const Integer along = product_of(w, d);
  if (along.sign() != Sign::kPositive) return {product_of(w, w), 1};
  const Integer length = product_of(d, d);
  if (along >= length) {
    const IntegerPoint v = difference_of(p, from.b);
    return {product_of(v, v), 1};
  }
  Integer num = product_of(w, w) * length;
  num.subtract_product(along, along);
  return {std::move(num), length};
}

// The square of the greatest distance of a point of e from f.
Fraction squared_reach(const IntegerEdge& e, const IntegerEdge& f) {
  Fraction a = squared_distance(e.a, f), b = squared_distance(e.b, f);
  return is_less(a, b) ? b : a;
}

// Whether the middle of e is projected into f, whose direction and squared length are given.
bool has_middle_along(const IntegerEdge& e, const IntegerEdge& f, const IntegerPoint& d,
                      const Integer& length) {
  const Integer twice =
      product_of(difference_of(e.a, f.a), d) + product_of(difference_of(e.b, f.a), d);
  return twice.sign() != Sign::kNegative && twice <= length + length;
}

// Whether p lies on the edge.
bool lies_on(const Vec3d& p, const EdgeEnds& on) {
  if (p == on.a || p == on.b) return true;
  for (int k = 0; k < 3; ++k)
    if (p[k] < std::min(on.a[k], on.b[k]) || std::max(on.a[k], on.b[k]) < p[k]) return false;
  return collinear(on.a, on.b, p);
}

}  // namespace

bool run_along(const EdgeEnds& e, const EdgeEnds& f) {
  const IntegerEdges edges = integer_edges(e, f);
  const IntegerPoint d = difference_of(edges.e.b, edges.e.a);
  const IntegerPoint g = difference_of(edges.f.b, edges.f.a);
  const Integer dd = product_of(d, d), gg = product_of(g, g), dg = product_of(d, g);
  // cos^2 > 3/4
  if (Integer(4) * dg * dg <= Integer(3) * dd * gg) return false;
  return has_middle_along(edges.e, edges.f, g, gg) || has_middle_along(edges.f, edges.e, d, dd);
}

Rational squared_gap(const EdgeEnds& e, const EdgeEnds& f) {
  const IntegerEdges edges = integer_edges(e, f);
  Fraction to_f = squared_reach(edges.e, edges.f), to_e = squared_reach(edges.f, edges.e);
  Fraction& least = is_less(to_f, to_e) ? to_f : to_e;
  return Rational(std::move(least.num), std::move(least.den)) *
         Rational::power_of_two(2 * std::int64_t{edges.exponent});
}

bool has_no_gap(const EdgeEnds& e, const EdgeEnds& f) {
  return (lies_on(e.a, f) && lies_on(e.b, f)) || (lies_on(f.a, e) && lies_on(f.b, e));
}

Rational squared_length(const EdgeEnds& e) {
  Rational out;
  for (int k = 0; k < 3; ++k) {
    const Rational d = Rational::from_double(e.b[k]) - Rational::from_double(e.a[k]);
    out += d * d;
  }
  return out;
}

double nearest_root(const Rational& a) {
  if (a.sign() == Sign::kZero) return 0;
  // The root of a 4^shift exceeds 2^64. It is `low`, or it lies between `low` and `low` + 1. Neither a number of 53
  // bits nor the middle of two of them lies strictly between these integers: `low` + 1/2 rounds as the root does.
  const auto bits = [](const Integer& n) { return static_cast<std::int64_t>(n.bit_length()); };
  const std::int64_t shift = (130 + bits(a.denominator()) - bits(a.numerator())) / 2 + 1;
  const Rational large = a * Rational::power_of_two(2 * shift);
  const Integer whole = floor_divide(large.numerator(), large.denominator());
  const Integer low = floor_sqrt(whole);
  const bool is_exact = low * low == whole && large.denominator() == Integer(1);
  return nearest_double(Rational(low + low + (is_exact ? 0 : 1)) *
                        Rational::power_of_two(-shift - 1));
}

// In doubles.
// Claim    The computed distance of a point p from an edge differs from the exact one by at most kEdgeGapRel * |w| +
//          kEdgeGapFloor, where w = p - a, and the foot is computed as a + t d, d = b - a.
// Bound    u = 2^-53; O(u^2) is left out and paid for by the difference of 17.5 and 32. Let s = w.d, the exact t* =
//          s / d.d clamped to [0, 1]; then t* |d| <= |w|. The computed s differs by 5 u |w| |d| (2 u for the rounded
//          differences, 3 u for the sum), d.d by 5 u d.d, the quotient by u: t differs from t* by at most
//          11 u |w| / |d|, and so does it after clamping. That moves the point a + t d by 11 u |w|. The difference r =
//          w - t d is computed with an error of at most 4 u |w| (u |w|, 2 u t |d|, u |r|), and its length with
//          2.5 u |r|. The sum is 17.5 u |w|; |w|, which is computed itself, is too small by at most 2.5 u |w|.
// Underflow  Products lose less than 2^-1074 each. Where |d| >= 2^-500, t loses less than 2^-1071 / d.d, so that the
//          foot moves by less than 2^-570; where |d| < 2^-500 every t in [0, 1] is near enough. The root of a sum
//          that lost 3 * 2^-1074 loses less than 2^-535. Coordinates that the scale rounded lose 2^-1075 each.
// Overflow cannot occur: differences are below 2^502, squares of lengths below 2^1006.

namespace internal {

namespace {

Point3d edge_difference(const Point3d& a, const Point3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double edge_product(const Point3d& a, const Point3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The square of |w - t d| where it is least for t in [0, 1], for w.d = s and d.d = length.
double squared_rest(const Point3d& w, const Point3d& d, double s, double length) {
  if (!(s > 0) || !(length > 0)) return edge_product(w, w);
  const double t = std::min(s / length, 1.0);
  const Point3d r{w[0] - t * d[0], w[1] - t * d[1], w[2] - t * d[2]};
  return edge_product(r, r);
}

double approx_squared_distance(const Point3d& p, const ScaledEdge& from, const Point3d& d) {
  const Point3d w = edge_difference(p, from.a);
  return squared_rest(w, d, edge_product(w, d), from.squared_length);
}

// Whether the gap exceeds the limit because the middle of neither edge is within the limit of the other edge. Sums of
// coordinates below 2^501 are rounded by less than 2^450.
bool have_far_middles(const ScaledEdge& e, const ScaledEdge& f, double limit) {
  const Point3d s{(e.a[0] + e.b[0]) - (f.a[0] + f.b[0]), (e.a[1] + e.b[1]) - (f.a[1] + f.b[1]),
                  (e.a[2] + e.b[2]) - (f.a[2] + f.b[2])};
  const double most = 2 * limit + std::max(e.length, f.length) + 0x1p453;
  return edge_product(s, s) > (1 + 0x1p-40) * (most * most);
}

struct PointDistance {
  double squared;
  double squared_base;  // |w|^2
};

// From the nearer end: where the foot is near an end, that makes the error as small as the distance.
PointDistance distance_from_nearer_end(const Point3d& p, const ScaledEdge& from, const Point3d& d) {
  const Point3d w = edge_difference(p, from.a), v = edge_difference(p, from.b);
  const double ww = edge_product(w, w), vv = edge_product(v, v);
  if (ww <= vv) return {squared_rest(w, d, edge_product(w, d), from.squared_length), ww};
  const Point3d back{-d[0], -d[1], -d[2]};
  return {squared_rest(v, back, edge_product(v, back), from.squared_length), vv};
}

GapBounds reach_bounds(const ScaledEdge& e, const ScaledEdge& f, const Point3d& d) {
  const PointDistance a = distance_from_nearer_end(e.a, f, d),
                      b = distance_from_nearer_end(e.b, f, d);
  const double most = std::sqrt(std::max(a.squared, b.squared));
  const double error =
      kEdgeGapRel * std::sqrt(std::max(a.squared_base, b.squared_base)) + kEdgeGapFloor;
  return {std::max(0.0, most - error), most + error};
}

// Rounded coordinates move a product by 2^-1075 * 2^503 at most.
constexpr double kProductFloor = 0x1p-560;

// Whether the middle of e is projected into f, whose direction is d. The error of w.d is bounded as above.
Sign3 middle_along_filter(const ScaledEdge& e, const ScaledEdge& f, const Point3d& d) {
  const Point3d w = edge_difference(e.a, f.a), v = edge_difference(e.b, f.a);
  const double twice = edge_product(w, d) + edge_product(v, d), most = 2 * f.squared_length;
  const double size = std::sqrt(std::max(edge_product(w, w), edge_product(v, v)));
  const double error = kEdgeGapRel * (size * std::sqrt(f.squared_length) + most) + kProductFloor;
  if (twice < -error || twice - most > error) return Sign3::kNegative;
  return twice > error && most - twice > error ? Sign3::kPositive : Sign3::kUncertain;
}

}  // namespace

ScaledEdge scaled_edge(const Point3d& a, const Point3d& b) {
  const Point3d d = edge_difference(b, a);
  const double squared = edge_product(d, d);
  return {a, b, squared, std::sqrt(squared)};
}

GapBounds gap_bounds(const ScaledEdge& e, const ScaledEdge& f) {
  const Point3d d = edge_difference(e.b, e.a), g = edge_difference(f.b, f.a);
  const GapBounds to_f = reach_bounds(e, f, g), to_e = reach_bounds(f, e, d);
  return {std::min(to_f.lo, to_e.lo), std::min(to_f.hi, to_e.hi)};
}

double approx_squared_gap(const ScaledEdge& e, const ScaledEdge& f, double limit) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  if (have_far_middles(e, f, limit)) return kFar;
  const double most = limit * limit;
  const Point3d d = edge_difference(e.b, e.a), g = edge_difference(f.b, f.a);
  const auto squared_reach = [most](const ScaledEdge& from, const ScaledEdge& to,
                                    const Point3d& direction) {
    const double a = approx_squared_distance(from.a, to, direction);
    if (a > most) return kFar;
    const double b = approx_squared_distance(from.b, to, direction);
    return b > most ? kFar : std::max(a, b);
  };
  return std::min(squared_reach(e, f, g), squared_reach(f, e, d));
}

// cos^2 is compared with 3/4. |d.g| differs by at most 5 u |d| |g|, as above, so that the square of the cosine, at most
// 1, differs by less than 40 u; edges shorter than 2^-200 are left to the integers.
Sign3 run_along_filter(const ScaledEdge& e, const ScaledEdge& f) {
  if (!(e.squared_length > 0x1p-400) || !(f.squared_length > 0x1p-400)) return Sign3::kUncertain;
  const Point3d d = edge_difference(e.b, e.a), g = edge_difference(f.b, f.a);
  const double dg = edge_product(d, g);
  const double excess = (dg / e.squared_length) * (dg / f.squared_length) - 0.75;
  if (excess < -0x1p-46) return Sign3::kNegative;
  const Sign3 first = middle_along_filter(e, f, g);
  const bool is_steep = excess > 0x1p-46;
  if (first == Sign3::kPositive && is_steep) return Sign3::kPositive;
  const Sign3 second = middle_along_filter(f, e, d);
  if (first == Sign3::kNegative && second == Sign3::kNegative) return Sign3::kNegative;
  return second == Sign3::kPositive && is_steep ? Sign3::kPositive : Sign3::kUncertain;
}

}  // namespace internal

}  // namespace veritope
