// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "robust/base/check.h"
#include "solids/classify/tensor_form.h"
#include "splines/bezier_triangle_algebra.h"

namespace veritope {
namespace {

// floor(log2 |x|) or one more.
std::int64_t log2_above(const Rational& x) {
  return static_cast<std::int64_t>(x.numerator().bit_length()) -
         static_cast<std::int64_t>(x.denominator().bit_length()) + 1;
}

Patch::Tensor tensor_of(const Patch& patch) {
  return patch.is_triangle() ? as_tensor_product(patch.triangle()) : patch.tensor();
}

using IntegerVector = std::array<Integer, 3>;

IntegerVector product(const IntegerVector& a, const IntegerVector& b) {
  IntegerVector out;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
    out[k] = a[p] * b[q];
    out[k].subtract_product(a[q], b[p]);
  }
  return out;
}
bool is_zero(const IntegerVector& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }

// Through the first control points that are not on one line, if all others are on it.
std::optional<FormPlane> plane_of(const TensorForm& form) {
  const auto& [x, y, z, w] = form.exact;
  // Times a positive number, from control point 0.
  const auto from_first = [&](std::size_t i) {
    IntegerVector out;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::vector<Integer>& c = form.exact[k];
      if (form.exact[3][i] == form.exact[3][0])
        out[k] = c[i] - c[0];
      else
        out[k] = c[i] * form.exact[3][0] - c[0] * form.exact[3][i];
    }
    return out;
  };
  IntegerVector along, normal;
  bool has_normal = false;
  for (std::size_t i = 1; i < form.count(); ++i) {
    IntegerVector d = from_first(i);
    if (has_normal) {
      Integer height = normal[0] * d[0];
      height.add_product(normal[1], d[1]);
      height.add_product(normal[2], d[2]);
      if (!height.is_zero()) return std::nullopt;
    } else if (is_zero(along)) {
      along = std::move(d);
    } else {
      normal = product(along, d);
      has_normal = !is_zero(normal);
    }
  }
  if (!has_normal) return std::nullopt;
  FormPlane out;
  out.offset = normal[0] * x[0] + normal[1] * y[0] + normal[2] * z[0];
  for (std::size_t k = 0; k < 3; ++k) out.normal[k] = normal[k] * w[0];
  return out;
}

Rational divided(const Rational& x, std::int64_t power) {
  return x * Rational::power_of_two(-power);
}

}  // namespace

int scale_of(const PatchComplex& complex) {
  std::int64_t most = std::numeric_limits<std::int64_t>::min();
  for (const Patch& patch : complex.patches()) {
    const std::size_t n = patch.num_control();
    for (int k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < n; ++i) {
        Rational x = patch.component(k)[i];
        if (x.sign() == Sign::kZero) continue;
        if (patch.is_rational()) x /= patch.component(3)[i];
        most = std::max(most, log2_above(x));
      }
  }
  constexpr std::int64_t kLimit = 1 << 20;
  return most == std::numeric_limits<std::int64_t>::min()
             ? 0
             : static_cast<int>(std::clamp(most, -kLimit, kLimit));
}

TensorForm::TensorForm(const Patch::Tensor& map, int scale) : degrees(map.degrees()) {
  const std::size_t n = count();
  Integer unit(1);
  for (const Rational& x : map.coefficients()) unit = lcm(unit, x.denominator());
  std::int64_t weight = 0;  // its greatest logarithm
  if (map.is_rational()) {
    weight = std::numeric_limits<std::int64_t>::min();
    for (const Rational& w : map.component(3)) weight = std::max(weight, log2_above(w));
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const bool is_weight = k == 3;
    for (std::size_t i = 0; i < n; ++i) {
      const Rational x =
          is_weight && !map.is_rational() ? Rational(1) : map.component(static_cast<int>(k))[i];
      exact[k].push_back(x.numerator() * divide_exactly(unit, x.denominator()));
      rounded[k].push_back(nearest_double(divided(x, is_weight ? weight : weight + scale)));
    }
  }
  plane = plane_of(*this);
}

TensorForm::TensorForm(const PatchComplex& complex, std::uint32_t patch, int scale)
    : TensorForm(tensor_of(complex.patch(patch)), scale) {
  shell = complex.shell(patch);
  for (std::uint32_t s = 0; s < 4; ++s) {
    const PatchSide side{patch, s};
    sides[s].is_collapsed = s == complex.patch(patch).num_sides() || complex.is_collapsed(side);
    if (sides[s].is_collapsed) continue;
    const auto mate = complex.mate(side);
    VT_CHECK(mate.has_value(), "an open side in a closed complex");
    sides[s].edge = complex.edge(side);
    sides[s].is_forward = side < *mate;
  }
}

}  // namespace veritope
