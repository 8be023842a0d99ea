// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/curve_agreement_internal.h"

#include <algorithm>
#include <utility>

#include "solids/patches/patch_complex_internal.h"
#include "solids/patches/patch_sides.h"
#include "splines/bezier_domain.h"
#include "splines/de_casteljau.h"

namespace veritope::internal {
namespace {

using Curve = Patch::Curve;

Rational weight_of(const Curve& curve, std::size_t i) {
  return curve.is_rational() ? curve.component(3)[i] : Rational(1);
}

// The Bernstein coefficients of X_c - point_c W.
std::vector<Rational> distance_along(const PatchPoint& point, const Curve& curve, std::size_t c) {
  std::vector<Rational> out;
  const auto x = curve.component(static_cast<int>(c));
  for (std::size_t i = 0; i < x.size(); ++i) out.push_back(x[i] - point[c] * weight_of(curve, i));
  return out;
}

bool have_one_sign(const std::vector<Rational>& values) {
  const Sign first = values.front().sign();
  return first != Sign::kZero && std::all_of(values.begin(), values.end(),
                                             [&](const Rational& v) { return v.sign() == first; });
}

// Whether b is a after t -> q t / (1 - t + q t) for some q: its homogeneous control points are then those of a times a
// geometric sequence. REQUIRES positive weights.
bool is_projective_change(const Curve& a, const Curve& b) {
  if (a.degree(0) != b.degree(0)) return false;
  std::vector<Rational> ratio;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(a.degree(0)); ++i) {
    ratio.push_back(weight_of(b, i) / weight_of(a, i));
    for (int c = 0; c < 3; ++c)
      if (!(a.component(c)[i] * ratio[i] == b.component(c)[i])) return false;
    if (i >= 2 && !(ratio[i] * ratio[i - 2] == ratio[i - 1] * ratio[i - 1])) return false;
  }
  return true;
}

// Whether b lies on the algebraic curve of a, and many of its points on the arc. A form of degree m vanishes on all of
// b if it does so at m n + 1 parameters, n the degree of b; cones of degree m or less cut out the curve of a.
bool lies_on_curve_of(const Curve& a, const Curve& b) {
  const int needed = a.degree(0) * b.degree(0) + 1;
  for (int i = 1; i <= needed; ++i)
    if (parameters_of(point_at(b, Rational(i) / Rational(needed + 1)), a).roots.empty())
      return false;
  return true;
}

}  // namespace

PatchPoint point_at(const Curve& curve, const Rational& t) {
  const std::vector<Rational> at = evaluate<Rational, 1>(curve, {t});
  return point_of(std::span<const Rational>(at)).value();
}

CommonRoots parameters_of(const PatchPoint& point, const Curve& curve) {
  std::array<std::vector<Rational>, 3> along;
  for (std::size_t c = 0; c < 3; ++c) {
    along[c] = distance_along(point, curve, c);
    if (have_one_sign(along[c])) return {};
  }
  std::array<Polynomial, 3> polynomials;
  for (std::size_t c = 0; c < 3; ++c) polynomials[c] = polynomial_of(along[c]);
  return common_roots(polynomials);
}

Curve arc_of(const Curve& curve, const std::array<Rational, 2>& at) {
  return at[0] < at[1] ? restricted(curve, 0, at[0], at[1])
                       : reversed(restricted(curve, 0, at[1], at[0]), 0);
}

std::optional<CurveAgreement> agreement_of(const Curve& a, const Curve& b) {
  if (directed_form(a) == directed_form(b)) return CurveAgreement::kAffine;
  const Curve x = with_least_degree(a), y = with_least_degree(b);
  if (is_projective_change(x, y)) return CurveAgreement::kProjective;
  if (lies_on_curve_of(x, y)) return CurveAgreement::kOneCurve;
  return std::nullopt;
}

}  // namespace veritope::internal
