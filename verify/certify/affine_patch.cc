// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/affine_patch.h"

#include <algorithm>

#include "splines/bezier_triangle.h"

namespace veritope {
namespace {

// Where a control point of an affine patch lies: its parameters, or its last two barycentric coordinates.
template <typename Use>
void for_each_control(const Patch& patch, Use use) {
  const auto part = [](int i, int n) { return Rational(i) / Rational(n); };
  if (patch.is_triangle()) {
    const int n = patch.triangle().degree();
    for (int j = 0; j <= n; ++j)
      for (int k = 0; j + k <= n; ++k) use(triangle_index(j, k), part(j, n), part(k, n));
    return;
  }
  const int p = patch.tensor().degree(0), q = patch.tensor().degree(1);
  std::size_t at = 0;
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j) use(at++, part(i, p), part(j, q));
}

bool has_equal_weights(const Patch& patch) {
  if (!patch.is_rational()) return true;
  const auto weights = patch.component(3);
  return std::all_of(weights.begin(), weights.end(),
                     [&](const Rational& w) { return w == weights[0]; });
}

PatchPoint control_point(const Patch& patch, std::size_t i) {
  PatchPoint out;
  for (std::size_t k = 0; k < 3; ++k) {
    out[k] = patch.component(static_cast<int>(k))[i];
    if (patch.is_rational()) out[k] = out[k] / patch.component(3)[i];
  }
  return out;
}

}  // namespace

std::optional<AffinePatch> AffinePatch::make(const Patch& patch) {
  if (!has_equal_weights(patch)) return std::nullopt;
  AffinePatch out;
  out.is_triangle_ = patch.is_triangle();
  const Rational zero(0), one(1);
  for_each_control(patch, [&](std::size_t at, const Rational& u, const Rational& v) {
    const PatchPoint p = control_point(patch, at);
    if (u == zero && v == zero) out.origin_ = p;
    if (u == one && v == zero) out.axes_[0] = p;
    if (u == zero && v == one) out.axes_[1] = p;
  });
  for (PatchPoint& axis : out.axes_)
    for (std::size_t k = 0; k < 3; ++k) axis[k] -= out.origin_[k];
  bool is_affine = true;
  for_each_control(patch, [&](std::size_t at, const Rational& u, const Rational& v) {
    const PatchPoint p = control_point(patch, at);
    for (std::size_t k = 0; k < 3; ++k)
      is_affine &= p[k] == out.origin_[k] + u * out.axes_[0][k] + v * out.axes_[1][k];
  });
  if (!is_affine) return std::nullopt;
  for (out.i_ = 0; out.i_ < 3; ++out.i_) {
    out.j_ = (out.i_ + 1) % 3;
    out.determinant_ =
        out.axes_[0][out.i_] * out.axes_[1][out.j_] - out.axes_[0][out.j_] * out.axes_[1][out.i_];
    if (out.determinant_.sign() != Sign::kZero) return out;
  }
  return std::nullopt;
}

std::optional<std::array<Rational, 2>> AffinePatch::parameters_of(const PatchPoint& point) const {
  const Rational x = point[i_] - origin_[i_], y = point[j_] - origin_[j_], zero(0), one(1);
  const Rational u = (x * axes_[1][j_] - y * axes_[1][i_]) / determinant_;
  const Rational v = (y * axes_[0][i_] - x * axes_[0][j_]) / determinant_;
  std::array<Rational, 2> out{u, v};
  if (is_triangle_) {
    const Rational s = u + v;
    out = {s, s.sign() == Sign::kZero ? zero : v / s};
  }
  for (const Rational& t : out)
    if (t < zero || one < t) return std::nullopt;
  return out;
}

}  // namespace veritope
