// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/patch_foot_internal.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robust/simplest.h"
#include "solids/classify/ray_net_internal.h"
#include "splines/de_casteljau_line.h"

namespace veritope::internal {
namespace {

std::int64_t bits_of(const Integer& x) { return static_cast<std::int64_t>(x.bit_length()); }

// x / 2^bits, rounded towards zero to 60 bits or fewer.
double scaled(Integer x, std::int64_t bits) {
  const std::int64_t spare = bits_of(x) - 60;
  if (spare > 0) {
    x.shift_right(static_cast<std::uint64_t>(spare));
    bits -= spare;
  }
  return std::ldexp(static_cast<double>(x.to_int64()),
                    static_cast<int>(std::clamp<std::int64_t>(-bits, -1 << 20, 1 << 20)));
}

// The nearest multiple of 2^-bits.
Dyadic rounded_to(const Dyadic& x, std::int64_t bits) {
  const std::int64_t spare = -bits - x.exponent();
  if (spare <= 0) return x;
  Integer m = x.mantissa() + power_of_two(static_cast<std::uint64_t>(spare - 1));
  m.shift_right(static_cast<std::uint64_t>(spare));
  return Dyadic(std::move(m), -bits);
}

Rational simple_near(const Dyadic& x, int bits) {
  const Rational at = x.to_rational(), reach = Rational::power_of_two(-bits);
  const Rational lo = at - reach;
  if (lo.sign() == Sign::kNegative) return Rational(0);
  return simplest_between(lo, at + reach);
}

}  // namespace

PatchFoot::PatchFoot(const TensorForm& form, const RayPoint& point,
                     const std::array<double, 2>& start)
    : form_(&form), net_(relative_coefficients(form, point)) {
  for (const auto& values : net_)
    for (const Integer& x : values) net_bits_ = std::max(net_bits_, bits_of(x));
  for (std::size_t k = 0; k < 2; ++k) at_[k] = Dyadic::from_double(start[k]);
  find_tangents();
}

// By de Casteljau's scheme in doubles: the last differences along each axis.
void PatchFoot::find_tangents() {
  const std::array<double, 2> t{nearest_double(at_[0].to_rational()),
                                nearest_double(at_[1].to_rational())};
  const auto rows = static_cast<std::size_t>(form_->degrees[0] + 1),
             columns = static_cast<std::size_t>(form_->degrees[1] + 1);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::vector<double> values;
      for (const Integer& x : net_[k]) values.push_back(scaled(x, net_bits_));
      const std::size_t other = 1 - axis;
      const auto lines = axis == 0 ? rows : columns;
      const AffineBlend<double> across{1 - t[other], t[other]}, along{1 - t[axis], t[axis]};
      for (std::size_t line = 0; line < lines; ++line)
        keep_right(values.data() + line * form_->stride(axis), form_->stride(other),
                   form_->degrees[other], across);
      const std::size_t stride = form_->stride(axis);
      for (int left = form_->degrees[axis]; left > 1; --left)
        blend_forward(values.data(), stride, left, along);
      tangents_[k][axis] = form_->degrees[axis] * (values[stride] - values[0]);
    }
}

PatchFoot::Values PatchFoot::at(const std::array<Integer, 2>& numerators,
                                const std::array<Integer, 2>& denominators) const {
  Values out;
  const AffineBlend<Integer> u{denominators[0] - numerators[0], numerators[0]},
      v{denominators[1] - numerators[1], numerators[1]};
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Integer> work = net_[k];
    for (int row = 0; row <= form_->degrees[0]; ++row)
      keep_right(work.data() + static_cast<std::size_t>(row) * form_->stride(0), 1,
                 form_->degrees[1], v);
    keep_right(work.data(), form_->stride(0), form_->degrees[0], u);
    out[k] = std::move(work.front());
  }
  return out;
}

bool PatchFoot::refine(int bits) {
  constexpr int kLeastGain = 4;  // bits a step
  const auto& j = tangents_;
  double uu = 0, uv = 0, vv = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    uu += j[k][0] * j[k][0];
    uv += j[k][0] * j[k][1];
    vv += j[k][1] * j[k][1];
  }
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return false;
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
  for (;;) {
    std::int64_t fine = 0;
    for (const Dyadic& t : at_) fine = std::max(fine, -t.exponent());
    const Integer whole = power_of_two(static_cast<std::uint64_t>(fine));
    std::array<Integer, 2> numerators;
    for (std::size_t k = 0; k < 2; ++k)
      numerators[k] = at_[k].mantissa() << static_cast<std::uint64_t>(at_[k].exponent() + fine);
    const Values r = at(numerators, {whole, whole});
    const std::int64_t unit = net_bits_ + fine * (form_->degrees[0] + form_->degrees[1]);
    std::int64_t most = 0;
    for (const Integer& x : r) most = std::max(most, bits_of(x));
    if (most == 0) return true;
    const std::int64_t residual = most - unit;  // its logarithm, approximately
    if (residual <= -bits) return true;
    if (residual > last - kLeastGain) return false;
    last = residual;
    double du = 0, dv = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = scaled(r[k], most);
      du += j[k][0] * x;
      dv += j[k][1] * x;
    }
    const std::array<double, 2> step{-(vv * du - uv * dv) / determinant,
                                     -(uu * dv - uv * du) / determinant};
    for (std::size_t k = 0; k < 2; ++k) {
      if (!std::isfinite(step[k])) return false;
      at_[k] = rounded_to(at_[k] + Dyadic::from_double(step[k]) * Dyadic(1, residual),
                          60 - std::min<std::int64_t>(residual, 0));
      const double t = nearest_double(at_[k].to_rational());
      if (!(t > -1 && t < 2)) return false;
    }
  }
}

std::optional<std::array<Rational, 2>> PatchFoot::exact_parameters(int bits) const {
  std::array<Rational, 2> out;
  std::array<Integer, 2> numerators, denominators;
  for (std::size_t k = 0; k < 2; ++k) {
    out[k] = simple_near(at_[k], bits);
    if (out[k] > Rational(1)) return std::nullopt;
    numerators[k] = out[k].numerator();
    denominators[k] = out[k].denominator();
  }
  for (const Integer& x : at(numerators, denominators))
    if (!x.is_zero()) return std::nullopt;
  return out;
}

std::optional<std::array<Rational, 2>> PatchFoot::at_collapsed_side(const TensorForm& form,
                                                                    const RayPoint& point) {
  const RayPoint::Fractions q = point.fractions();
  for (std::uint32_t s = 0; s < 4; ++s) {
    if (!form.sides[s].is_collapsed) continue;
    const std::size_t i = form.first_of_side(s);
    bool is_equal = true;
    for (std::size_t k = 0; k < 3; ++k)
      is_equal = is_equal && form.exact[k][i] * q.denominator == form.exact[3][i] * q.numerators[k];
    if (!is_equal) continue;
    std::array<Rational, 2> out;
    if (s == 1) out[0] = Rational(1);
    if (s == 2) out[1] = Rational(1);
    return out;
  }
  return std::nullopt;
}

}  // namespace veritope::internal
