// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/exact_point.h: points with rational coordinates, and their orientation. Where all points have binary64
// coordinates, the predicates of these decide.
#pragma once
#include <array>

#include "interval/interval.h"
#include "predicates/vec.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"
#include "robust/rational.h"

namespace veritope {

/// A rational point with what the tiers take: the nearest doubles, intervals around the coordinates, and integers over
/// one denominator. Immutable.
class ExactPoint3 {
 public:
  explicit ExactPoint3(std::array<Rational, 3> at);
  explicit ExactPoint3(const Vec3d& at)
      : ExactPoint3({Rational::from_double(at.x), Rational::from_double(at.y),
                     Rational::from_double(at.z)}) {}

  const std::array<Rational, 3>& at() const { return at_; }
  /// Every coordinate is a binary64 number; then rounded() is the point.
  bool is_binary64() const { return is_binary64_; }
  /// The nearest binary64 numbers, infinite for coordinates beyond the largest.
  const Vec3d& rounded() const { return rounded_; }
  const std::array<Interval, 3>& enclosure() const { return enclosure_; }
  /// The coordinates times scale().
  const std::array<Integer, 3>& scaled() const { return scaled_; }
  /// The least common denominator.
  const Integer& scale() const { return scale_; }

 private:
  std::array<Rational, 3> at_;
  Vec3d rounded_;
  bool is_binary64_;
  std::array<Interval, 3> enclosure_;
  std::array<Integer, 3> scaled_;
  Integer scale_;
};

/// Like orient3d of explicit points: the exact sign of det(b - a, c - a, d - a). The filter and the lattice are asked
/// only where all four points are binary64 ones.
Sign orient3d(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
              const ExactPoint3& d, TierCounts* tally = nullptr);
/// orient2d of the points without their coordinate `axis`, as drop_axis(p, axis) has them: the sign of the coordinate
/// `axis` of (b - a) x (c - a).
Sign orient2d_projected(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c, int axis,
                        TierCounts* tally = nullptr);

namespace internal {
Sign3 orient3d_interval(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                        const ExactPoint3& d);
Sign orient3d_exact(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                    const ExactPoint3& d);
Sign3 orient2d_projected_interval(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                                  int axis);
Sign orient2d_projected_exact(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                              int axis);
}  // namespace internal

}  // namespace veritope
