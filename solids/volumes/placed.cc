// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/volumes/placed.h"

#include <algorithm>
#include <string>
#include <utility>

#include "splines/bspline_domain.h"

namespace veritope {

Placement translation(const CellPoint& by) {
  Placement out;
  out.shift = by;
  return out;
}

Placement after(const Placement& second, const Placement& first) {
  Placement out;
  for (std::size_t i = 0; i < 3; ++i) {
    out.shift[i] = second.shift[i];
    for (std::size_t k = 0; k < 3; ++k) {
      out.shift[i] += second.linear[i][k] * first.shift[k];
      out.linear[i][k] = Rational(0);
      for (std::size_t j = 0; j < 3; ++j)
        out.linear[i][k] += second.linear[i][j] * first.linear[j][k];
    }
  }
  return out;
}

Rational determinant(const Placement& placement) {
  const auto& m = placement.linear;
  Rational det;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    det += m[0][k] * (m[1][i] * m[2][j] - m[1][j] * m[2][i]);
  }
  return det;
}

Rational distance_from_rotation(const Placement& placement) {
  Rational most;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      Rational entry = i == j ? Rational(-1) : Rational(0);
      for (std::size_t k = 0; k < 3; ++k) entry += placement.linear[k][i] * placement.linear[k][j];
      most = std::max(most, abs(std::move(entry)));
    }
  return most;
}

Result<std::array<CellVolume, 2>> split(const CellVolume& cell, std::size_t axis,
                                        const Rational& at) {
  const Rational &begin = cell.axis(axis).domain_begin(), &end = cell.axis(axis).domain_end();
  if (!(begin < at && at < end))
    return bad_argument("at must lie inside of the domain, from " + begin.to_string() + " to " +
                        end.to_string() + ", and it is " + at.to_string());
  return std::array{internal::clamped_part(cell, axis, begin, at),
                    internal::clamped_part(cell, axis, at, end)};
}

}  // namespace veritope
