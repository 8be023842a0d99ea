// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/implicit_kinds.h"

#include <cmath>

#include "predicates/implicit_exact.h"
#include "predicates/orient2d.h"

namespace veritope {
namespace {

// Makes the last weight, the denominator, positive.
template <std::size_t N>
std::array<double, N> normalised(std::array<double, N> weights) {
  // Compares bits: fast-math reads signbit as < 0, which flushing to zero makes false.
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  const std::uint64_t flip = std::bit_cast<std::uint64_t>(weights[N - 1]) & kSign;
  for (double& w : weights) w = std::bit_cast<double>(std::bit_cast<std::uint64_t>(w) ^ flip);
  return weights;
}

// The sign of (b - a) x (d - c). The filter needs no rounding mode: docs/bounds/implicit_point.md.
Sign turn(const std::array<Vec2d, 4>& p) {
  const double ux = p[1].x - p[0].x, uy = p[1].y - p[0].y, wx = p[3].x - p[2].x,
               wy = p[3].y - p[2].y;
  const double left = ux * wy, right = uy * wx;
  const double most =
      larger(larger(std::abs(ux), std::abs(uy)), larger(std::abs(wx), std::abs(wy)));
  const Sign3 s = most <= internal::kImplicitReach
                      ? sign_beyond(left - right, 4 * internal::kOrient2dRel *
                                                          (std::abs(left) + std::abs(right)) +
                                                      internal::kImplicitAbs)
                      : Sign3::kUncertain;
  if (is_certain(s)) return to_sign(s);
  return internal::exact_sign<false>([&]<typename T>(std::type_identity<T>) {
    std::array<T, 8> v;
    internal::to_numbers(internal::coordinates(p), v);
    return (v[2] - v[0]) * (v[7] - v[5]) - (v[3] - v[1]) * (v[6] - v[4]);
  });
}

}  // namespace

SegmentPoint::SegmentPoint(const Vec3d& a, const Vec3d& b, double numerator,
                           double denominator) noexcept
    : points_{a, b}, weights_(normalised<2>({numerator, denominator})) {}

TrianglePoint::TrianglePoint(const Vec3d& a, const Vec3d& b, const Vec3d& c, double v, double w,
                             double denominator) noexcept
    : points_{a, b, c}, weights_(normalised<3>({v, w, denominator})) {}

SegmentPoint2d::SegmentPoint2d(const Vec2d& a, const Vec2d& b, double numerator,
                               double denominator) noexcept
    : points_{a, b}, weights_(normalised<2>({numerator, denominator})) {}

SegmentSegmentPoint2d::SegmentSegmentPoint2d(const Vec2d& a, const Vec2d& b, const Vec2d& c,
                                             const Vec2d& d) noexcept
    : points_{a, b, c, d}, denominator_(turn(points_)) {}

}  // namespace veritope
