// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "interval/intersect/intersection_contact.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

constexpr std::int64_t kMostDenominator = 1 << 20;

/// The simplest fraction within 2^-36 (1 + |x|) of x, by continued fractions; nothing if its denominator is large.
std::optional<Rational> simple_fraction(double x) {
  if (!(std::abs(x) < 0x1p40)) return std::nullopt;
  const Rational target = Rational::from_double(x);
  const Rational near = Rational::from_double(0x1p-36 * (1 + std::abs(x)));
  std::int64_t p0 = 1, q0 = 0;
  double rest = x;
  std::int64_t p1 = static_cast<std::int64_t>(std::floor(rest)), q1 = 1;
  for (int step = 0; step < 40; ++step) {
    const Rational value = Rational(p1) / Rational(q1);
    if (abs(value - target) <= near) return value;
    const double fraction = rest - std::floor(rest);
    if (!(fraction > 1e-12)) return std::nullopt;
    rest = 1 / fraction;
    const double a = std::floor(rest);
    if (!(a < 0x1p40)) return std::nullopt;
    const auto whole = static_cast<std::int64_t>(a);
    const std::int64_t p2 = whole * p1 + p0, q2 = whole * q1 + q0;
    if (q2 > kMostDenominator || q2 <= 0) return std::nullopt;
    p0 = p1, q0 = q1, p1 = p2, q1 = q2;
  }
  return std::nullopt;
}

/// A surface in pieces, for exact points.
class ExactSurface {
 public:
  explicit ExactSurface(const BSpline<Rational, 2>& surface) : pieces_(bezier_pieces(surface)) {}
  const std::vector<Rational>& knots(std::size_t axis) const { return pieces_.breaks[axis]; }
  int degree(std::size_t axis) const { return pieces_.pieces.front().degree(axis); }
  bool is_rational() const { return pieces_.pieces.front().is_rational(); }

  /// Homogeneous, with weight 1 if the surface is polynomial. `inside` chooses the piece.
  std::array<Rational, 4> at(const std::array<Rational, 2>& x,
                             const std::array<Rational, 2>& inside) const {
    std::array<std::size_t, 2> cell{};
    std::array<Rational, 2> t;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& k = pieces_.breaks[i];
      const auto above = std::upper_bound(k.begin() + 1, k.end() - 1, inside[i]);
      cell[i] = static_cast<std::size_t>(above - k.begin()) - 1;
      t[i] = (x[i] - k[cell[i]]) / (k[cell[i] + 1] - k[cell[i]]);
    }
    auto values = evaluate(pieces_.at(cell), t);
    if (values.size() == 3) values.push_back(Rational(1));
    return {values[0], values[1], values[2], values[3]};
  }

 private:
  BezierPieces<Rational, 2> pieces_;
};

/// True if S1 at (u, v) is S2 at the affine image, on the cell [a0, b0] x [a1, b1] that holds no knot of either inside.
/// Both sides, multiplied by both weights, are polynomials; they agree if they do on a grid of degree + 1 points per
/// axis.
bool agree_on_cell(const ExactSurface& s1, const ExactSurface& s2, const ExactOverlap& map,
                   const std::array<Rational, 2>& begin, const std::array<Rational, 2>& end) {
  const Rational half = Rational(1) / Rational(2);
  const auto image = [&](const std::array<Rational, 2>& x) {
    const Rational& first = x[map.is_swapped ? 1 : 0];
    const Rational& second = x[map.is_swapped ? 0 : 1];
    return std::array<Rational, 2>{map.factor[0] * first + map.offset[0],
                                   map.factor[1] * second + map.offset[1]};
  };
  const std::array<Rational, 2> inside{(begin[0] + end[0]) * half, (begin[1] + end[1]) * half};
  const auto inside_image = image(inside);
  std::array<int, 2> degree{};
  for (std::size_t i = 0; i < 2; ++i) {
    const int d1 = s1.degree(i), d2 = s2.degree(map.is_swapped ? 1 - i : i);
    degree[i] = s1.is_rational() || s2.is_rational() ? d1 + d2 : std::max(d1, d2);
  }
  for (int i = 0; i <= degree[0]; ++i)
    for (int j = 0; j <= degree[1]; ++j) {
      const std::array<Rational, 2> x{
          begin[0] + (end[0] - begin[0]) * Rational(i) / Rational(degree[0]),
          begin[1] + (end[1] - begin[1]) * Rational(j) / Rational(degree[1])};
      const auto p = s1.at(x, inside), q = s2.at(image(x), inside_image);
      for (std::size_t c = 0; c < 3; ++c)
        if (p[c] * q[3] != q[c] * p[3]) return false;
    }
  return true;
}

/// s as a function of the two parameters along which `pairs` lie, from three of them: (by u, by v, constant).
std::optional<std::array<double, 3>> affine_fit(const std::array<Point4, 3>& p,
                                                std::size_t target) {
  const double u1 = p[1][0] - p[0][0], v1 = p[1][1] - p[0][1], d1 = p[1][target] - p[0][target];
  const double u2 = p[2][0] - p[0][0], v2 = p[2][1] - p[0][1], d2 = p[2][target] - p[0][target];
  const double det = u1 * v2 - u2 * v1;
  if (!(std::abs(det) > 0)) return std::nullopt;
  const double a = (d1 * v2 - d2 * v1) / det, b = (u1 * d2 - u2 * d1) / det;
  return std::array<double, 3>{a, b, p[0][target] - a * p[0][0] - b * p[0][1]};
}

/// Three pairs that span a triangle of large area in (u, v).
std::array<Point4, 3> spread_out(const std::vector<Point4>& pairs) {
  const auto far = [&](auto measure) {
    return *std::max_element(pairs.begin(), pairs.end(), [&](const Point4& a, const Point4& b) {
      return measure(a) < measure(b);
    });
  };
  std::array<Point4, 3> out;
  out[0] = far([](const Point4& p) { return -p[0] - p[1]; });
  out[1] = far([&](const Point4& p) { return std::hypot(p[0] - out[0][0], p[1] - out[0][1]); });
  const double du = out[1][0] - out[0][0], dv = out[1][1] - out[0][1];
  out[2] = far(
      [&](const Point4& p) { return std::abs(du * (p[1] - out[0][1]) - dv * (p[0] - out[0][0])); });
  return out;
}

// Guesses in binary64, with tolerances; find_overlap proves the guess in rationals or drops it.
std::optional<ExactOverlap> guess_map(const std::array<Point4, 3>& corners) {
  const auto s = affine_fit(corners, 2), t = affine_fit(corners, 3);
  if (!s || !t) return std::nullopt;
  ExactOverlap out;
  out.is_swapped = std::abs((*s)[1]) > std::abs((*s)[0]);
  const auto depends = [&](const std::array<double, 3>& f, std::size_t axis, std::size_t i) {
    if (std::abs(f[1 - axis]) > 1e-6 * std::abs(f[axis])) return false;
    const auto factor = simple_fraction(f[axis]), offset = simple_fraction(f[2]);
    if (!factor || !offset || factor->sign() == Sign::kZero) return false;
    out.factor[i] = *factor, out.offset[i] = *offset;
    return true;
  };
  const std::size_t first = out.is_swapped ? 1 : 0;
  if (!depends(*s, first, 0) || !depends(*t, 1 - first, 1)) return std::nullopt;
  return out;
}

/// The places of the second surface's knots on an axis of the first, with its own knots between; empty if the domains'
/// images do not overlap.
std::vector<Rational> common_breaks(const std::vector<Rational>& own,
                                    const std::vector<Rational>& other, const Rational& factor,
                                    const Rational& offset) {
  std::vector<Rational> images;
  for (const Rational& k : other) images.push_back((k - offset) / factor);
  std::sort(images.begin(), images.end());
  const Rational begin = std::max(own.front(), images.front()),
                 end = std::min(own.back(), images.back());
  std::vector<Rational> out;
  if (!(begin < end)) return out;
  for (const auto* list : {&own, &std::as_const(images)})
    for (const Rational& k : *list)
      if (begin <= k && k <= end) out.push_back(k);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Proved by the mean value theorem: two coordinates have derivatives, each taken somewhere in the rectangle, that are
/// never dependent.
bool is_one_to_one(const EnclosedSurface& s, const Interval& u, const Interval& v) {
  const auto r = s.range(u, v);
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const Sign3 sign = (r.du[a] * r.dv[b] - r.du[b] * r.dv[a]).sign();
    if (sign == Sign3::kPositive || sign == Sign3::kNegative) return true;
  }
  return false;
}

Interval around(const Rational& a, const Rational& b) { return hull(enclose(a), enclose(b)); }

}  // namespace

std::optional<ExactOverlap> find_overlap(const BSpline<Rational, 2>& first,
                                         const BSpline<Rational, 2>& second,
                                         const std::vector<Point4>& pairs) {
  if (pairs.size() < 3) return std::nullopt;
  auto map = guess_map(spread_out(pairs));
  if (!map) return std::nullopt;
  const ExactSurface s1(first), s2(second);
  std::array<std::vector<Rational>, 2> breaks;
  for (std::size_t i = 0; i < 2; ++i) {  // parameter i of the second surface
    const std::size_t axis = map->is_swapped ? 1 - i : i;
    breaks[axis] = common_breaks(s1.knots(axis), s2.knots(i), map->factor[i], map->offset[i]);
    if (breaks[axis].size() < 2) return std::nullopt;
    const Rational &a = breaks[axis].front(), &b = breaks[axis].back();
    const Rational c = map->factor[i] * a + map->offset[i], d = map->factor[i] * b + map->offset[i];
    map->exact[axis] = {a, b};
    map->exact[2 + i] = {std::min(c, d), std::max(c, d)};
    map->parameters[axis] = around(a, b);
    map->parameters[2 + i] = around(c, d);
  }
  for (std::size_t i = 0; i + 1 < breaks[0].size(); ++i)
    for (std::size_t j = 0; j + 1 < breaks[1].size(); ++j)
      if (!agree_on_cell(s1, s2, *map, {breaks[0][i], breaks[1][j]},
                         {breaks[0][i + 1], breaks[1][j + 1]}))
        return std::nullopt;
  return map;
}

bool holds_all_of(const EnclosedSurface& s1, const EnclosedSurface& s2, const ExactOverlap& overlap,
                  const Box4& x) {
  // S1(u, v) = S2(s, t) = S2(image of (u, v)), and S2 takes no value twice; or the same with the surfaces exchanged.
  const std::size_t of_s = overlap.is_swapped ? 1 : 0, of_t = 1 - of_s;
  const Interval fs = enclose(overlap.factor[0]), os = enclose(overlap.offset[0]);
  const Interval ft = enclose(overlap.factor[1]), ot = enclose(overlap.offset[1]);
  const Box4& all = overlap.parameters;
  const auto lies_in = [&](std::size_t i) {
    return overlap.exact[i][0] <= Rational::from_double(x[i].lo()) &&
           Rational::from_double(x[i].hi()) <= overlap.exact[i][1];
  };
  if (lies_in(0) && lies_in(1))
    return is_one_to_one(s2, hull(x[2], intersection(all[2], fs * x[of_s] + os)),
                         hull(x[3], intersection(all[3], ft * x[of_t] + ot)));
  if (!lies_in(2) || !lies_in(3)) return false;
  std::array<Interval, 2> preimage;
  preimage[of_s] = (x[2] - os) / fs, preimage[of_t] = (x[3] - ot) / ft;
  return is_one_to_one(s1, hull(x[0], intersection(all[0], preimage[0])),
                       hull(x[1], intersection(all[1], preimage[1])));
}

}  // namespace veritope
