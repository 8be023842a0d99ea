// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "interval/upward.h"
#include "solids/micro/synthesis/formula_point_internal.h"
#include "splines/de_boor.h"

namespace veritope::internal {
namespace {

// On x, y or z.
bool depends_on_point(const RealFormula& formula) {
  return formula.depends_on(0) || formula.depends_on(1) || formula.depends_on(2);
}
// The parameter where the domain is brought to [0, 1].
Rational in_unit_domain(const KnotAxis<Rational>& axis, const Rational& t) {
  return (t - axis.domain_begin()) / (axis.domain_end() - axis.domain_begin());
}

}  // namespace

std::vector<Rational> formula_values(const RealFormula& formula, const VVolume& volume,
                                     const std::array<Rational, 3>& at) {
  std::vector<Rational> out(3);
  if (depends_on_point(formula)) {
    const std::vector<Rational> p = point(volume, at).value();
    std::copy_n(p.begin(), 3, out.begin());
  }
  for (std::size_t a = 0; a < 3; ++a) out.push_back(in_unit_domain(volume.axis(a), at[a]));
  return out;
}

FormulaBoundsOfCage::FormulaBoundsOfCage(const std::vector<VVolume>& cage) : cage_(cage) {
  const ScopedUpward upward;
  for (const VVolume& volume : cage) {
    std::vector<Interval> net;
    for (int c = 0; c < volume.num_components(); ++c)
      for (const Rational& x : volume.component(c)) net.push_back(enclose(x));
    std::array<KnotAxis<Rational>, 3> axes = {volume.axis(0), volume.axis(1), volume.axis(2)};
    maps_.emplace_back(std::move(axes), volume.num_components(), volume.is_rational(),
                       std::move(net));
  }
}

std::optional<std::vector<Interval>> FormulaBoundsOfCage::operator()(
    const RealFormula& formula, std::size_t volume, const std::array<Rational, 3>& at) const {
  const ScopedUpward upward;
  std::vector<Interval> out(3);
  if (depends_on_point(formula)) {
    const auto p = evaluate(maps_[volume], at);
    if (!p) return std::nullopt;
    const bool is_rational = maps_[volume].is_rational();
    if (is_rational && (*p)[3].sign() != Sign3::kPositive) return std::nullopt;
    for (std::size_t c = 0; c < 3; ++c) out[c] = is_rational ? (*p)[c] / (*p)[3] : (*p)[c];
  }
  for (std::size_t a = 0; a < 3; ++a)
    out.push_back(enclose(in_unit_domain(cage_[volume].axis(a), at[a])));
  for (const Interval& x : out)
    if (!(mag(x) < HUGE_VAL)) return std::nullopt;
  return out;
}

}  // namespace veritope::internal
