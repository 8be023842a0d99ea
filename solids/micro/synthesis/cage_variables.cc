// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "solids/micro/synthesis/cage_variables_internal.h"
#include "splines/de_boor.h"

namespace veritope::internal {

std::vector<Rational> cage_values(const RealFormula& formula, const VVolume& volume,
                                  const std::array<Rational, 3>& at) {
  std::vector<Rational> out(3);
  if (formula.depends_on(0) || formula.depends_on(1) || formula.depends_on(2)) {
    const std::vector<Rational> p = point(volume, at).value();
    std::copy_n(p.begin(), 3, out.begin());
  }
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = volume.axis(a);
    out.push_back((at[a] - axis.domain_begin()) / (axis.domain_end() - axis.domain_begin()));
  }
  return out;
}

}  // namespace veritope::internal
