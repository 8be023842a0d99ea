// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/exact_in_sphere.h"

#include <array>
#include <cstddef>

#include "interval/interval.h"
#include "interval/upward.h"
#include "predicates/exact_point_internal.h"
#include "predicates/formulas.h"
#include "predicates/in_sphere.h"

namespace veritope {
namespace internal {

Sign3 in_sphere_interval(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                         const ExactPoint3& d, const ExactPoint3& e) {
  const ScopedUpward upward;
  const auto &p = a.enclosure(), &q = b.enclosure(), &r = c.enclosure(), &s = d.enclosure(),
             &t = e.enclosure();
  return formulas::InSphere<Interval>(p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2], s[0],
                                      s[1], s[2], t[0], t[1], t[2])
      .det()
      .sign();
}

// The determinant of the rows (x, y, z, x^2 + y^2 + z^2) of a - e, b - e, c - e, d - e. Differences are scaled by the
// scales of their points, up to that of e, which all have: a row (x, y, z, l) then stands for (x / s, y / s, z / s,
// l / s^2), and s times it has the last entry l / s.
Sign in_sphere_exact(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                     const ExactPoint3& d, const ExactPoint3& e) {
  const std::array<const ExactPoint3*, 4> points{&a, &b, &c, &d};
  std::array<std::array<Integer, 3>, 4> rows;
  for (std::size_t i = 0; i < 4; ++i) rows[i] = scaled_difference(*points[i], e);
  Integer sum;
  for (std::size_t i = 0; i < 4; ++i) {
    Integer term;
    for (const Integer& x : rows[i]) term.add_product(x, x);
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i) term = term * points[j]->scale();
    const Integer minor = exact_triple(rows[(i + 1) % 4], rows[(i + 2) % 4], rows[(i + 3) % 4]);
    if (i % 2 == 0)
      sum.add_product(term, minor);
    else
      sum.subtract_product(term, minor);
  }
  return sum.sign();
}

}  // namespace internal

Sign in_sphere(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
               const ExactPoint3& d, const ExactPoint3& e, TierCounts* tally) {
  if (a.is_binary64() && b.is_binary64() && c.is_binary64() && d.is_binary64() && e.is_binary64())
    return in_sphere(a.rounded(), b.rounded(), c.rounded(), d.rounded(), e.rounded(), tally);
  return cascade<2>(
      tally, [&] { return internal::in_sphere_interval(a, b, c, d, e); },
      [&] { return internal::in_sphere_exact(a, b, c, d, e); });
}

}  // namespace veritope
