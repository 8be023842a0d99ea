// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/unit_space_internal.h"

namespace veritope::internal {

UnitSpace unit_space(const KnotAxis<Rational>& axis) {
  const auto p = static_cast<std::size_t>(axis.degree);
  UnitSpace out{axis.degree, {}};
  const Rational begin = axis.domain_begin(), length = axis.domain_end() - begin;
  for (std::size_t i = p + 1; i < axis.num_control(); ++i)
    out.inner.push_back((axis.knots[i] - begin) / length);
  return out;
}

UnitSpace reversed_space(UnitSpace space) {
  for (Rational& t : space.inner) t = Rational(1) - t;
  std::reverse(space.inner.begin(), space.inner.end());
  return space;
}

UnitSpace common_space(const UnitSpace& a, const UnitSpace& b) {
  if (a == b) return a;
  UnitSpace out{std::max(a.degree, b.degree), {}};
  // How often t, which stands at i, occurs in the space after elevation; moves i past it.
  const auto copies = [&](const UnitSpace& space, std::size_t& i, const Rational& t) {
    std::size_t n = 0;
    for (; i < space.inner.size() && space.inner[i] == t; ++i) ++n;
    return n == 0 ? 0 : n + static_cast<std::size_t>(out.degree - space.degree);
  };
  for (std::size_t i = 0, j = 0; i < a.inner.size() || j < b.inner.size();) {
    const bool is_from_a = j == b.inner.size() || (i < a.inner.size() && a.inner[i] <= b.inner[j]);
    const Rational t = is_from_a ? a.inner[i] : b.inner[j];
    const std::size_t in_a = copies(a, i, t), in_b = copies(b, j, t);
    out.inner.insert(out.inner.end(), std::max(in_a, in_b), t);
  }
  return out;
}

}  // namespace veritope::internal
