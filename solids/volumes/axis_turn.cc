// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/volumes/axis_turn.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "robust/simplest.h"
#include "solids/volumes/half_angle.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using internal::RationalRange;

Rational dot3(const CellPoint& a, const CellPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
CellPoint cross3(const CellPoint& a, const CellPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A short number near 1 / |d|, exactly that if |d| is rational.
Rational inverse_length(const RationalRange& length) {
  if (length.lo == length.hi) return Rational(1) / length.lo;
  const Rational one_part = Rational::power_of_two(-12);
  return simplest_between((Rational(1) - one_part) / length.lo,
                          (Rational(1) + one_part) / length.hi);
}

// A short b for which |b |d| - tan| < 2^-50, less than half of the tangent. `degrees` > 0.
Rational short_tangent(const Rational& degrees, const RationalRange& length) {
  const RationalRange tangent = internal::tangent_range(degrees);
  const Rational error = std::min(max_half_angle_error(), tangent.lo / Rational(2));
  return simplest_between((tangent.hi - error) / length.lo, (tangent.lo + error) / length.hi);
}

// The quaternion of the angle 2 half degrees, 0 < half < 180, and whether it is exact.
std::pair<HalfTurn, bool> end_of_turn(const Rational& half, const RationalRange& length) {
  const bool has_rational_length = length.lo == length.hi;
  const Rational beta = inverse_length(length), right = Rational(90);
  if (half == right) return {{Rational(0), beta}, true};
  if (has_rational_length && (half == Rational(45) || half == Rational(135)))
    return {{half < right ? Rational(1) : Rational(-1), beta}, true};
  if (half < Rational(45)) return {{Rational(1), short_tangent(half, length)}, false};
  if (half > Rational(135))
    return {{Rational(-1), short_tangent(Rational(180) - half, length)}, false};
  // cot half = a / (beta |d|), so that a / beta / |d| is near it; 1 / |d| lies between 1 / hi and 1 / lo.
  const RationalRange inverse{Rational(1) / length.hi, Rational(1) / length.lo};
  const Rational a = short_tangent(abs(right - half), inverse) * beta;
  return {{half < right ? a : -a, beta}, false};
}

// 115 > 360 / pi degrees a unit of the half angle: the arc tangent changes by at most what its argument does.
Rational angle_error() { return Rational(115) * max_half_angle_error(); }

Rational squared_length(const CellPoint& direction) { return dot3(direction, direction); }

// The parameters of two points on different sides of the axis, if the surface lies in a plane with the axis and such
// points are found among 9 x 9 of each of its pieces. An error if the surface lies on the axis.
class Profile {
 public:
  Profile(const CellSurface& surface, const TurnAxis& axis) : surface_(surface), axis_(axis) {}

  Status check() const {
    std::optional<CellPoint> across;  // from the axis to one of the control points
    for (std::size_t i = 0; i < surface_.grid().count(); ++i) {
      const CellPoint y = from_axis(i), turned = cross3(axis_.direction, y);
      if (turned == CellPoint{}) continue;
      if (!across) across = cross3(turned, axis_.direction);
      if (dot3(turned, *across).sign() != Sign::kZero) return ok_status();  // not in one plane
    }
    if (!across) return bad_argument("surface lies on the axis of revolution");
    std::vector<Rational> distance;
    for (std::size_t i = 0; i < surface_.grid().count(); ++i)
      distance.push_back(dot3(from_axis(i), *across));
    return check_sides({surface_.axes(), 1, false, std::move(distance)});
  }

 private:
  CellPoint from_axis(std::size_t i) const {
    CellPoint y;
    const Rational& w = surface_.component(surface_.dimension())[i];
    for (std::size_t k = 0; k < 3; ++k)
      y[k] = surface_.component(static_cast<int>(k))[i] - w * axis_.point[k];
    return y;
  }

  static Status check_sides(const CellSurface& distance) {
    std::array<std::optional<std::string>, 2> at;  // on each side
    const auto all = distance.component(0);
    const auto has = [&](Sign sign) {
      return std::any_of(all.begin(), all.end(),
                         [&](const Rational& x) { return x.sign() == sign; });
    };
    if (!has(Sign::kPositive) || !has(Sign::kNegative)) return ok_status();
    for (const Rational& u : samples(distance.axis(0)))
      for (const Rational& v : samples(distance.axis(1))) {
        const Sign sign = evaluate(distance, {u, v}).value()[0].sign();
        if (sign == Sign::kZero) continue;
        auto& side = at[sign == Sign::kPositive ? 0 : 1];
        if (!side) side = "(u, v) = (" + u.to_string() + ", " + v.to_string() + ")";
        if (at[0] && at[1])
          return bad_argument("surface crosses the axis of revolution: it is on one side at " +
                              *at[0] + " and on the other at " + *at[1]);
      }
    return ok_status();
  }

  static std::vector<Rational> samples(const KnotAxis<Rational>& axis) {
    const auto breaks = internal::breaks_of(axis);
    const std::size_t stride =
        1 + breaks.size() / 256;  // bounded work, whatever the number of pieces
    std::vector<Rational> out{breaks.front()};
    for (std::size_t i = 0; i + 1 < breaks.size(); i += stride)
      for (int k = 1; k <= 8; ++k)
        out.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * Rational(k) / Rational(8));
    return out;
  }

  const CellSurface& surface_;
  const TurnAxis& axis_;
};

}  // namespace

Rational max_half_angle_error() { return Rational::power_of_two(-50); }

Result<Turn> make_turn(const CellPoint& direction, const Rational& degrees) {
  if (direction == CellPoint{}) return bad_argument("axis must not be 0");
  if (degrees.sign() != Sign::kPositive || degrees > Rational(360))
    return bad_argument("degrees must be more than 0 and at most 360, not " + degrees.to_string());
  const RationalRange length = internal::square_root_range(squared_length(direction));
  const Rational beta = inverse_length(length);
  const std::array<HalfTurn, 5> quarters = {{{Rational(1), Rational(0)},
                                             {Rational(1), beta},
                                             {Rational(0), beta},
                                             {Rational(-1), beta},
                                             {Rational(-1), Rational(0)}}};
  Turn turn{{quarters[0]}, degrees, Rational(0)};
  for (int k = 1; k <= 3;
       ++k)  // 10 degrees: far more than a quarter may be off where |d| is irrational
    if (Rational(90 * k + 10) <= degrees)
      turn.stops.push_back(quarters[static_cast<std::size_t>(k)]);
  if (degrees == Rational(360)) {
    turn.stops.push_back(quarters[4]);
    return turn;
  }
  const auto [end, is_exact] = end_of_turn(degrees / Rational(2), length);
  turn.stops.push_back(end);
  if (!is_exact) turn.error = angle_error();
  return turn;
}

Result<Rotation> make_rotation(const TurnAxis& axis, const Rational& degrees) {
  const Integer turns = floor_divide(degrees.numerator(), degrees.denominator() * Integer(360));
  const Rational rest = degrees - Rational(turns) * Rational(360);
  if (axis.direction == CellPoint{}) return bad_argument("axis must not be 0");
  if (rest.sign() == Sign::kZero) return Rotation{};
  const Result<Turn> turn = make_turn(axis.direction, rest);
  if (!turn) return turn.error();
  const HalfTurn& q = turn->stops.back();
  const CellPoint& d = axis.direction;
  const Rational bb = q.b * q.b, plain = q.a * q.a - bb * squared_length(d),
                 weight = q.a * q.a + bb * squared_length(d), two = Rational(2);
  Rotation out{{}, turn->error};
  for (std::size_t j = 0; j < 3; ++j) {
    CellPoint e{};
    e[j] = Rational(1);
    const CellPoint turned = cross3(d, e);
    for (std::size_t i = 0; i < 3; ++i)
      out.placement.linear[i][j] =
          (plain * e[i] + two * bb * d[j] * d[i] + two * q.a * q.b * turned[i]) / weight;
  }
  for (std::size_t i = 0; i < 3; ++i)
    out.placement.shift[i] = axis.point[i] - dot3(out.placement.linear[i], axis.point);
  return out;
}

CellSurface turned_row(const CellSurface& surface, const TurnAxis& axis, const HalfTurn& p,
                       const HalfTurn& q) {
  const CellPoint& d = axis.direction;
  const Rational bb = p.b * q.b, aa = p.a * q.a, length = squared_length(d);
  const Rational plain = aa - bb * length, along = Rational(2) * bb, across = p.a * q.b + p.b * q.a,
                 weight = aa + bb * length;
  CellSurface out = surface;
  for (int c = 3; c < surface.num_components(); ++c)
    for (Rational& x : out.component(c)) x *= weight;
  const auto weights = std::as_const(out).component(out.dimension());
  for (std::size_t i = 0; i < surface.grid().count(); ++i) {
    CellPoint y;
    for (std::size_t k = 0; k < 3; ++k)
      y[k] = surface.component(static_cast<int>(k))[i] -
             surface.component(surface.dimension())[i] * axis.point[k];
    const CellPoint turned = cross3(d, y);
    const Rational part = along * dot3(d, y);
    for (std::size_t k = 0; k < 3; ++k)
      out.component(static_cast<int>(k))[i] =
          plain * y[k] + part * d[k] + across * turned[k] + weights[i] * axis.point[k];
  }
  return out;
}

Result<CellVolume> revolved(const CellSurface& surface, const TurnAxis& axis, const Turn& turn) {
  if (axis.direction == CellPoint{}) return bad_argument("axis must not be 0");
  if (const Status in = check_cell_surface(surface); !in) return in.error();
  const std::size_t steps = turn.stops.size() - 1, num_rows = 2 * steps + 1;
  const auto one = in_one_space<2>({homogeneous(surface)}, kMaxCellNumbers / num_rows);
  if (!one) return one.error();
  const CellSurface& section = (*one)[0];
  if (const Status beside = Profile(section, axis).check(); !beside) return beside.error();
  std::vector<CellSurface> rows;
  KnotAxis<Rational> around{2, {Rational(0)}, false};
  for (std::size_t i = 0; i <= steps; ++i) {
    const HalfTurn& q = turn.stops[i];
    if (i > 0) rows.push_back(turned_row(section, axis, turn.stops[i - 1], q));
    rows.push_back(turned_row(section, axis, q, q));
    around.knots.insert(around.knots.end(), 2, Rational(static_cast<std::int64_t>(i)));
  }
  around.knots.push_back(around.knots.back());
  return with_positive_weights(stacked(rows, std::move(around)));
}

}  // namespace veritope
