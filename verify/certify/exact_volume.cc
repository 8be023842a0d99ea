// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/exact_volume.h"

#include <algorithm>

#include "robust/base/check.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_product.h"

namespace veritope {

std::optional<Rational> exact_volume(std::span<const Patch> patches) {
  if (std::any_of(patches.begin(), patches.end(), [](const Patch& p) { return p.is_rational(); }))
    return std::nullopt;
  Rational sum(0);
  for (const Patch& patch : patches) {
    VT_CHECK(!patch.is_triangle(), "the boundary of volumes has four sides a patch");
    const Patch::Tensor& s = patch.tensor();
    sum = sum + integral(dot(s, cross(derivative(s, 0), derivative(s, 1)))).front();
  }
  return sum / Rational(3);
}

}  // namespace veritope
