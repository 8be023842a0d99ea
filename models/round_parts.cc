// SPDX-License-Identifier: LGPL-3.0-or-later
#include "models/round_parts.h"

#include <algorithm>
#include <utility>

#include "models/patch_shapes_internal.h"
#include "solids/patches/patch_complex.h"

namespace veritope::patch_shapes {
namespace {

// The segments from a curve, travelled the other way, to a point: side 0 is a mate of the curve.
Patch::Tensor fan(const Patch::Curve& curve, const Point& apex) {
  const int n = curve.degree(0);
  Patch::Tensor out({n, 1}, curve.num_components(), curve.is_rational());
  const auto last = static_cast<std::size_t>(n);
  for (std::size_t i = 0; i <= last; ++i) {
    const Rational weight = curve.is_rational() ? curve.component(3)[last - i] : Rational(1);
    for (int c = 0; c < curve.num_components(); ++c) {
      out.component(c)[2 * i] = curve.component(c)[last - i];
      out.component(c)[2 * i + 1] = c == 3 ? weight : weight * apex[static_cast<std::size_t>(c)];
    }
  }
  return out;
}

}  // namespace

Patches disc_cylinder(const Rational& height) {
  Patches out;
  internal::add_revolved(out, {{{0, 1}, {0, 0}, {1, 1}},
                               {{1, 1}, {0, height}, {1, 1}},
                               {{1, 0}, {height, height}, {1, 1}}});
  return out;
}

Patches disc_cone(const Rational& height) {
  Patches out;
  internal::add_revolved(out, {{{0, 1}, {0, 0}, {1, 1}}, {{1, 0}, {0, height}, {1, 1}}});
  return out;
}

Patches ball_with_neck() {
  const Rational five(5), quarter = Rational(1) / 4;
  internal::PlaneCurve south = internal::quarter_circle(3);
  for (std::size_t i = 0; i < 3; ++i) {
    south.x[i] *= five;
    south.y[i] *= five;
  }
  // (1 - t^2, 2 t) / (1 + t^2) for 0 <= t <= 1/2, five times as large: from (5, 0) to (3, 4).
  const internal::PlaneCurve north{{5, 5, 15 * quarter}, {0, 10 * quarter, 5}, {1, 1, 5 * quarter}};
  Patches out;
  internal::add_revolved(out, {south, north, {{3, 3}, {4, 8}, {1, 1}}});
  internal::add_end(out, {3, 8, {0, 0, 8}, true});
  return out;
}

Patches patches_with_signs(const Patches& patches, const std::array<int, 3>& signs) {
  Patches out;
  for (const Patch& p : patches) {
    bool fits = true;
    for (int k = 0; k < 3; ++k)
      for (const Rational& x : p.component(k))
        fits &= to_int(x.sign()) * signs[static_cast<std::size_t>(k)] >= 0;
    if (fits) out.push_back(p);
  }
  return out;
}

Patches coned(const Patches& part, const Point& apex) {
  const PatchComplex complex = make_patch_complex(part).value();
  Patches out = part;
  for (std::uint32_t p = 0; p < part.size(); ++p)
    for (std::uint32_t s = 0; s < part[p].num_sides(); ++s)
      if (!complex.is_collapsed({p, s}) && !complex.mate({p, s}))
        internal::add(out, fan(part[p].side(s), apex));
  return out;
}

}  // namespace veritope::patch_shapes
