// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/radial_cage.h"

#include <algorithm>
#include <string>
#include <utility>

#include "robust/simplest.h"
#include "solids/volumes/half_angle.h"
#include "splines/bspline_domain.h"

namespace veritope {
namespace {

using internal::RationalRange;

Rational dot_of(const CellPoint& a, const CellPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
CellPoint at_multiple(const CellPoint& p, const Rational& t, const CellPoint& d) {
  return {p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]};
}

const Rational& rounding_part() {
  static const Rational part = Rational::power_of_two(-42);
  return part;
}

// length / of, exactly if `of` is known, else more by at most 2^-41 of it. REQUIRES length >= 0.
Rational ratio_above(const Rational& length, const RationalRange& of) {
  if (of.lo == of.hi) return length / of.lo;
  if (length.sign() == Sign::kZero) return length;
  const Rational least = length / of.lo;
  return simplest_between(least, least + least * rounding_part());
}
Rational ratio_below(const Rational& length, const RationalRange& of) {
  if (of.lo == of.hi) return length / of.lo;
  if (length.sign() == Sign::kZero) return length;
  const Rational most = length / of.hi;
  return simplest_between(most - most * rounding_part(), most);
}
Rational signed_above(const Rational& length, const RationalRange& of) {
  return length.sign() == Sign::kNegative ? -ratio_below(-length, of) : ratio_above(length, of);
}

CellPoint start_of(const RadialShape& shape) {
  if (shape.start) return *shape.start;
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (abs(shape.axis.direction[k]) < abs(shape.axis.direction[axis])) axis = k;
  CellPoint out{};
  out[axis] = Rational(1);
  return out;
}

Status check_shape(const RadialShape& s) {
  if (s.axis.direction == CellPoint{}) return bad_argument("axis must not be 0");
  if (s.inner.sign() == Sign::kNegative)
    return bad_argument("inner must not be negative, and it is " + s.inner.to_string());
  if (!(s.inner < s.outer))
    return bad_argument("inner must be less than outer, and they are " + s.inner.to_string() +
                        " and " + s.outer.to_string());
  if (!(s.low < s.high))
    return bad_argument("low must be less than high, and they are " + s.low.to_string() + " and " +
                        s.high.to_string());
  if (s.degrees && (s.degrees->sign() != Sign::kPositive || *s.degrees >= Rational(360)))
    return bad_argument("degrees must be more than 0 and less than 360, not " +
                        s.degrees->to_string());
  return ok_status();
}

}  // namespace

Result<RadialCage> radial_cage(const RadialShape& shape) {
  if (const Status fits = check_shape(shape); !fits) return fits.error();
  const CellPoint& d = shape.axis.direction;
  const CellPoint start = start_of(shape);
  const CellPoint across = at_multiple(start, -dot_of(start, d) / dot_of(d, d), d);
  if (across == CellPoint{}) return bad_argument("start lies along the axis");
  const RationalRange along_length = internal::square_root_range(dot_of(d, d)),
                      across_length = internal::square_root_range(dot_of(across, across));
  const std::array<Rational, 2> heights{-signed_above(-shape.low, along_length),
                                        signed_above(shape.high, along_length)};
  const std::array<Rational, 2> radii{ratio_below(shape.inner, across_length),
                                      ratio_above(shape.outer, across_length)};
  // The rectangle of (along, outwards) beside the axis: with the turn it is right-handed.
  std::array<std::vector<Rational>, 3> points;
  for (const Rational& height : heights)
    for (const Rational& radius : radii) {
      const CellPoint p = at_multiple(at_multiple(shape.axis.point, height, d), radius, across);
      for (std::size_t k = 0; k < 3; ++k) points[k].push_back(p[k]);
    }
  std::vector<Rational> all;
  for (const auto& component : points) all.insert(all.end(), component.begin(), component.end());
  const CellSurface section({unit_axis(1), unit_axis(1)}, 3, false, std::move(all));
  const Result<Turn> turn = make_turn(d, shape.degrees ? *shape.degrees : Rational(360));
  if (!turn) return turn.error();
  Result<CellVolume> turned = revolved(section, shape.axis, *turn);
  if (!turned) return turned.error();
  return RadialCage{permuted(*turned, {1, 2, 0}), turn->error};
}

Result<RadialShape> radial_shape_around(const CageContent& content, RadialShape shape,
                                        const Rational& margin) {
  const CellPoint& d = shape.axis.direction;
  if (d == CellPoint{}) return bad_argument("axis must not be 0");
  const Rational square = dot_of(d, d);
  Rational farthest, least, most;  // square of the distance from the axis; places in terms of d
  bool is_first = true;
  for (const CellPoint& p : content.points) {
    const CellPoint from = at_multiple(p, Rational(-1), shape.axis.point);
    const Rational place = dot_of(from, d) / square;
    farthest = std::max(farthest, dot_of(from, from) - place * place * square);
    least = is_first ? place : std::min(least, place);
    most = is_first ? place : std::max(most, place);
    is_first = false;
  }
  const Rational one(1);
  const RationalRange length = internal::square_root_range(square);
  const RationalRange unit{one / length.hi, one / length.lo};
  if (farthest.sign() == Sign::kPositive) {
    const RationalRange radius = internal::square_root_range(farthest);
    shape.outer = ratio_above(one, {one / radius.hi, one / radius.lo}) + margin;
  } else {
    shape.outer = margin;
  }
  shape.low = -signed_above(-least, unit) - margin;
  shape.high = signed_above(most, unit) + margin;
  return shape;
}

std::optional<std::size_t> first_in_hole(const CageContent& content, const RadialShape& shape) {
  const CellPoint& d = shape.axis.direction;
  for (std::size_t i = 0; i < content.points.size(); ++i) {
    const CellPoint from = at_multiple(content.points[i], Rational(-1), shape.axis.point);
    const Rational along = dot_of(from, d);
    if (dot_of(from, from) - along * along / dot_of(d, d) < shape.inner * shape.inner) return i;
  }
  return std::nullopt;
}

}  // namespace veritope
