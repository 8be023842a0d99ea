// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/flat_place_internal.h"

#include <algorithm>
#include <utility>

#include "solids/classify/curve_passes.h"
#include "solids/classify/ray_net_internal.h"
#include "splines/de_casteljau_line.h"

namespace veritope::internal {
namespace {

std::vector<Integer> as_integers(const Polynomial& p) {
  Integer unit(1);
  for (const Rational& c : p) unit = lcm(unit, c.denominator());
  std::vector<Integer> out;
  for (const Rational& c : p) out.push_back(c.numerator() * divide_exactly(unit, c.denominator()));
  return out;
}

AlgebraicNumber number_of(const Rational& t) { return {{-t.numerator(), t.denominator()}, t, t}; }

AlgebraicNumber first_of(const CommonRoots& roots) {
  if (roots.is_everywhere) return number_of(Rational(0));  // a collapsed side
  const auto& [lo, hi] = roots.roots.front();
  if (lo == hi) return number_of(lo);
  return {as_integers(roots.polynomial), lo, hi};
}

// Times a positive number, the same for all lines of one length: the value at a parameter of [0,1].
Integer value_at(std::vector<Integer> line, const Dyadic& at) {
  const auto bits = static_cast<std::uint64_t>(std::max<std::int64_t>(-at.exponent(), 0));
  const Integer whole = power_of_two(bits);
  const Integer part =
      at.mantissa() << static_cast<std::uint64_t>(at.exponent() + static_cast<std::int64_t>(bits));
  const AffineBlend<Integer> blend{whole - part, part};
  for (int left = static_cast<int>(line.size()) - 1; left > 0; --left)
    blend_forward(line.data(), 1, left, blend);
  return std::move(line.front());
}

// The parameter of a side of the square that does not change along it.
Rational fixed_parameter(std::uint32_t side) { return Rational(side == 1 || side == 2 ? 1 : 0); }

}  // namespace

Sign side_of(const FormPlane& plane, const RayPoint::Fractions& q) {
  Integer height = -(plane.offset * q.denominator);
  for (std::size_t k = 0; k < 3; ++k) height.add_product(plane.normal[k], q.numerators[k]);
  return height.sign();
}

RayPlace place_beside(const FormPlane& plane, Sign side, const AxisRay& ray) {
  const Sign ahead = ray.is_upward ? plane.normal[ray.axis].sign() : -plane.normal[ray.axis].sign();
  return ahead * side < 0 ? RayPlace::kMissesBackward : RayPlace::kMissesRay;
}

bool passes_through(const FormPlane& plane, const AxisRay& ray) {
  return !plane.normal[ray.axis].is_zero();
}

FlatPlace::FlatPlace(const TensorForm& form, const RayPoint& point) : form_(form) {
  std::array<std::vector<Integer>, 3> net = relative_coefficients(form, point);
  std::size_t seen_along = 0;
  while (form.plane->normal[seen_along].is_zero()) ++seen_along;
  for (std::size_t k = 0; k < 2; ++k) net_[k] = std::move(net[(seen_along + 1 + k) % 3]);
}

FlatPlace::OfBorder FlatPlace::border() const {
  OfBorder out;
  for (std::uint32_t s = 0; s < 4; ++s) {
    const std::size_t along = axis_of_side(s);
    RelativeCurve curve;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(form_.degrees[along]); ++i) {
      const std::size_t at = form_.first_of_side(s) + i * form_.stride(along);
      curve.along.push_back(net_[0][at]);
      curve.across.push_back(net_[1][at]);
    }
    const std::optional<int> passes = passes_of(curve);
    if (!passes) {
      out.parameters.emplace();
      out.parameters->numbers[along] = first_of(roots_of(curve));
      out.parameters->numbers[1 - along] = number_of(fixed_parameter(s));
      return out;
    }
    out.winding += runs_upward(s) ? *passes : -*passes;
  }
  return out;
}

std::array<std::vector<Integer>, 2> FlatPlace::line_at(std::size_t across, const Dyadic& at,
                                                       const Dyadic& from, const Dyadic& to) const {
  const Dyadic zero(0), one(1);
  const std::size_t along = 1 - across;
  std::array<std::vector<Integer>, 2> out;
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t i = 0; i <= static_cast<std::size_t>(form_.degrees[along]); ++i) {
      std::vector<Integer> line;
      for (std::size_t j = 0; j <= static_cast<std::size_t>(form_.degrees[across]); ++j)
        line.push_back(net_[k][i * form_.stride(along) + j * form_.stride(across)]);
      out[k].push_back(value_at(std::move(line), at));
    }
    restrict_to(out[k], zero, one, from, to);
  }
  return out;
}

bool FlatPlace::is_inside(const std::array<Dyadic, 2>& lo, const std::array<Dyadic, 2>& hi) const {
  int winding = 0;
  for (std::uint32_t s = 0; s < 4; ++s) {
    const std::size_t along = axis_of_side(s), across = 1 - along;
    const Dyadic& at = fixed_parameter(s).sign() == 0 ? lo[across] : hi[across];
    auto line = line_at(across, at, lo[along], hi[along]);
    const std::optional<int> passes = passes_of({std::move(line[0]), std::move(line[1])});
    if (!passes) return false;
    winding += runs_upward(s) ? *passes : -*passes;
  }
  return winding != 0;
}

}  // namespace veritope::internal
