// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/exact_point.h"

#include <cmath>
#include <utility>

#include "interval/upward.h"
#include "predicates/exact_point_internal.h"
#include "predicates/formulas.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/projection.h"

namespace veritope {

ExactPoint3::ExactPoint3(std::array<Rational, 3> at) : at_(std::move(at)), is_binary64_(true) {
  scale_ = Integer(1);
  for (const Rational& c : at_) scale_ = lcm(scale_, c.denominator());
  std::array<double, 3> rounded{};
  for (std::size_t c = 0; c < 3; ++c) {
    rounded[c] = nearest_double(at_[c]);
    is_binary64_ =
        is_binary64_ && std::isfinite(rounded[c]) && Rational::from_double(rounded[c]) == at_[c];
    enclosure_[c] = enclose(at_[c]);
    scaled_[c] = at_[c].numerator() * divide_exactly(scale_, at_[c].denominator());
  }
  rounded_ = {rounded[0], rounded[1], rounded[2]};
}

namespace internal {

Sign3 orient3d_interval(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                        const ExactPoint3& d) {
  const ScopedUpward upward;
  const auto &p = a.enclosure(), &q = b.enclosure(), &r = c.enclosure(), &s = d.enclosure();
  const formulas::Plane3<Interval> plane(p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]);
  return plane.det(s[0] - p[0], s[1] - p[1], s[2] - p[2]).sign();
}

Sign orient3d_exact(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                    const ExactPoint3& d) {
  return exact_triple(scaled_difference(b, a), scaled_difference(c, a), scaled_difference(d, a))
      .sign();
}

Sign3 orient2d_projected_interval(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                                  int axis) {
  const ScopedUpward upward;
  const auto i = static_cast<std::size_t>((axis + 1) % 3),
             j = static_cast<std::size_t>((axis + 2) % 3);
  const auto &p = a.enclosure(), &q = b.enclosure(), &r = c.enclosure();
  return ((q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i])).sign();
}

Sign orient2d_projected_exact(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                              int axis) {
  return exact_minor(scaled_difference(b, a), scaled_difference(c, a), axis).sign();
}

}  // namespace internal

Sign orient3d(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
              const ExactPoint3& d, TierCounts* tally) {
  if (a.is_binary64() && b.is_binary64() && c.is_binary64() && d.is_binary64())
    return orient3d(a.rounded(), b.rounded(), c.rounded(), d.rounded(), tally);
  return cascade<2>(
      tally, [&] { return internal::orient3d_interval(a, b, c, d); },
      [&] { return internal::orient3d_exact(a, b, c, d); });
}

Sign orient2d_projected(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c, int axis,
                        TierCounts* tally) {
  if (a.is_binary64() && b.is_binary64() && c.is_binary64())
    return orient2d(drop_axis(a.rounded(), axis), drop_axis(b.rounded(), axis),
                    drop_axis(c.rounded(), axis), tally);
  return cascade<2>(
      tally, [&] { return internal::orient2d_projected_interval(a, b, c, axis); },
      [&] { return internal::orient2d_projected_exact(a, b, c, axis); });
}

}  // namespace veritope
