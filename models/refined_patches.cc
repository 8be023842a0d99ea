// SPDX-License-Identifier: LGPL-3.0-or-later
#include "models/refined_patches.h"

#include <utility>

#include "splines/bezier_degree.h"
#include "splines/bezier_triangle_algebra.h"
#include "splines/de_casteljau.h"

namespace veritope::patch_shapes {

Patches quartered(const Patches& patches) {
  const Rational half = Rational(1) / Rational(2);
  Patches out;
  for (const Patch& p : patches) {
    if (p.is_triangle()) {
      for (auto& part : split_in_four(p.triangle()))
        out.push_back(make_patch(std::move(part)).value());
      continue;
    }
    auto [left, right] = split(p.tensor(), 0, half);
    for (const Patch::Tensor& part : {std::move(left), std::move(right)}) {
      auto [lower, upper] = split(part, 1, half);
      out.push_back(make_patch(std::move(lower)).value());
      out.push_back(make_patch(std::move(upper)).value());
    }
  }
  return out;
}

Patches elevated(const Patches& patches) {
  Patches out;
  for (const Patch& p : patches) {
    if (p.is_triangle()) {
      out.push_back(make_patch(veritope::elevated(p.triangle())).value());
      continue;
    }
    const auto [m, n] = p.tensor().degrees();
    out.push_back(make_patch(elevate_to(p.tensor(), {m + 1, n + 1})).value());
  }
  return out;
}

Patches turned(const Patches& patches) {
  Patches out;
  for (const Patch& p : patches)
    out.push_back(
        veritope::turned(p, 1 + static_cast<std::uint32_t>(out.size()) % (p.num_sides() - 1)));
  return out;
}

}  // namespace veritope::patch_shapes
