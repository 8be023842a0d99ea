// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_moves.h"

#include <algorithm>
#include <string>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_knots.h"
#include "solids/dms/dms_validity.h"
#include "splines/bspline.h"
#include "splines/de_boor.h"

namespace veritope {
namespace {

Status check_point(std::span<const Rational> numbers) {
  for (const Rational& c : numbers)
    if (const Status status = check_dms_number(c); !status) return status;
  return ok_status();
}

Status shift(std::span<Rational> point, const DmsShift& by) {
  for (std::size_t c = 0; c < 3; ++c)
    point[c] = by.is_place ? by.amount[c] : point[c] + by.amount[c];
  return check_point(point.first(3));
}

std::span<Rational> value_of(DmsModel& model, std::size_t control) {
  const std::size_t size = model.num_components();
  return std::span(model.control.values).subspan(control * size, size);
}
DmsPoint place_of(const DmsModel& model, std::size_t control) {
  const auto value = model.value(control);
  return {value[0], value[1], value[2]};
}

Status apply(DmsModel& model, const DmsControlMove& move) {
  return shift(value_of(model, move.control), move.shift);
}

Status apply(DmsModel& model, const DmsCoefficientMove& move) {
  Rational& value = value_of(model, move.control)[3 + move.attribute];
  value = move.is_value ? move.amount : value + move.amount;
  return check_dms_number(value);
}

Status apply(DmsModel& model, const DmsKnotMove& move) {
  return shift(model.clouds[move.vertex].at(move.knot), move.shift);
}

// Knots 0, ..., 0, 1, 2, ..., k, ..., k.
KnotAxis<Rational> uniform_axis(int degree, std::size_t count) {
  const auto p = static_cast<std::size_t>(degree);
  KnotAxis<Rational> axis;
  axis.degree = degree;
  for (std::size_t i = 0; i < count + p + 1; ++i)
    axis.knots.emplace_back(std::min(std::max(i, p), count) - p);
  return axis;
}

BSplineVolume<Rational> displacements(const DmsLattice& lattice) {
  std::array<KnotAxis<Rational>, 3> axes;
  std::size_t count = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    axes[a] = uniform_axis(lattice.degree[a], lattice.counts[a]);
    count *= lattice.counts[a];
  }
  BSplineVolume<Rational> out(std::move(axes), 3, false, std::vector<Rational>(3 * count));
  for (const DmsLattice::Node& node : lattice.nodes)
    for (int c = 0; c < 3; ++c)
      out.component(c)[out.grid().at(node.at)] += node.by[static_cast<std::size_t>(c)];
  return out;
}

Status apply(DmsModel& model, const DmsLattice& lattice) {
  const BSplineVolume<Rational> by = displacements(lattice);
  for (std::size_t i = 0; i < model.num_control(); ++i) {
    const DmsPoint at = place_of(model, i);
    std::array<Rational, 3> parameter;
    bool is_inside = true;
    for (std::size_t a = 0; a < 3; ++a) {
      is_inside = is_inside && lattice.low[a] <= at[a] && at[a] <= lattice.high[a];
      parameter[a] =
          (at[a] - lattice.low[a]) / (lattice.high[a] - lattice.low[a]) * by.axis(a).domain_end();
    }
    if (!is_inside) continue;
    const Result<std::vector<Rational>> moved = evaluate(by, parameter);
    VT_CHECK(moved.has_value(), "points of the box have parameters in the domain");
    const DmsShift shift_of{{(*moved)[0], (*moved)[1], (*moved)[2]}, false};
    if (const Status status = shift(value_of(model, i), shift_of); !status) return status;
  }
  return ok_status();
}

Rational squared_distance(const DmsPoint& x, const DmsPoint& a, const DmsPoint& b) {
  const DmsPoint along = difference(b, a), from = difference(x, a);
  const Rational length = dot_product(along, along);
  Rational t = length.sign() == Sign::kZero ? Rational() : dot_product(from, along) / length;
  t = std::min(std::max(t, Rational()), Rational(1));
  DmsPoint rest = from;
  for (std::size_t c = 0; c < 3; ++c) rest[c] -= t * along[c];
  return dot_product(rest, rest);
}

Rational distance_from(const std::vector<DmsPoint>& corners, const DmsPoint& x) {
  Rational least = squared_distance(x, corners[0], corners[0]);
  for (std::size_t i = 1; i < corners.size(); ++i)
    least = std::min(least, squared_distance(x, corners[i - 1], corners[i]));
  return least;
}

Rational distance_from(const DmsEllipsoid& shape, const DmsPoint& x) {
  const auto& a = shape.axes;
  const DmsPoint from = difference(x, shape.centre);
  const Rational volume = dot_product(a[0], cross_product(a[1], a[2]));
  Rational sum(-1);
  for (std::size_t m = 0; m < 3; ++m) {
    const Rational t = dot_product(from, cross_product(a[(m + 1) % 3], a[(m + 2) % 3])) / volume;
    sum += t * t;
  }
  return std::max(sum, Rational());
}

Rational polynomial_at(const std::vector<Rational>& coefficients, const Rational& s) {
  Rational sum;
  for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * s + coefficients[i];
  return sum;
}

// The nearest multiple of 2^-bits, of two the greater one.
Rational rounded(const Rational& x, std::uint64_t bits) {
  Integer steps = floor_divide(x.numerator() << (bits + 1), x.denominator()) + Integer(1);
  steps.shift_right(1);
  return Rational(std::move(steps), Integer(1) << bits);
}

Status apply(DmsModel& model, const DmsSkeletonMove& move) {
  for (std::size_t i = 0; i < model.num_control(); ++i) {
    const DmsPoint at = place_of(model, i);
    Rational sum;
    for (const DmsSkeleton& skeleton : move.skeletons) {
      const Rational s =
          std::visit([&](const auto& shape) { return distance_from(shape, at); }, skeleton.shape);
      const Rational under = polynomial_at(skeleton.under, s);
      if (under.sign() == Sign::kZero)
        return bad_argument("a field's denominator is 0 at the control point (" +
                            at[0].to_string() + ", " + at[1].to_string() + ", " +
                            at[2].to_string() + ")");
      sum += skeleton.weight * polynomial_at(skeleton.over, s) / under;
    }
    if (move.round_bits) sum = rounded(sum, *move.round_bits);
    if (const Status status = check_dms_number(sum); !status) {
      Error error = status.error();
      if (!move.round_bits)
        error.message += "; the key 'round' of a skeleton move makes them short";
      return error;
    }
    value_of(model, i)[3 + move.attribute] = std::move(sum);
  }
  return ok_status();
}

}  // namespace

Status apply_move(DmsModel& model, const DmsMove& move) {
  return std::visit([&](const auto& kind) { return apply(model, kind); }, move);
}

}  // namespace veritope
