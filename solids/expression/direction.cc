// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/direction.h"

#include <algorithm>

#include "robust/base/int128.h"

namespace veritope {
namespace {

constexpr int128 kMost = Direction::kMostApprox;

// floor(x 2^shift). REQUIRES |x| 2^shift < 2^62.
std::int64_t scaled_floor(const Dyadic& x, std::int64_t shift) {
  const std::int64_t left = x.exponent() + shift;
  const Integer& m = x.mantissa();
  if (left >= 0) return m.to_int64() << left;
  if (m.fits_int64()) return m.to_int64() >> std::min<std::int64_t>(-left, 63);
  Integer out = m;
  out.shift_right(static_cast<std::uint64_t>(-left));
  return out.to_int64();
}

// The sign of an exact value that differs from `approx` by less than `error`; uncertain if that does not tell.
Sign3 sign_within(int128 approx, int128 error) {
  if (approx >= error) return Sign3::kPositive;
  if (-approx >= error) return Sign3::kNegative;
  return Sign3::kUncertain;
}

// Component k of a x b of the integers beside them.
int128 approx_cross(const Direction& a, const Direction& b, std::size_t k) {
  const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
  return static_cast<int128>(a.approx()[p]) * b.approx()[q] -
         static_cast<int128>(a.approx()[q]) * b.approx()[p];
}

}  // namespace

Direction::Direction(std::array<Dyadic, 3> vector) : vector_(std::move(vector)) {
  bool has_top = false;
  std::int64_t top = 0;  // components are below 2^top
  for (const Dyadic& x : vector_) {
    if (x.sign() == 0) continue;
    const std::int64_t end = x.exponent() + static_cast<std::int64_t>(x.mantissa().bit_length());
    top = has_top ? std::max(top, end) : end;
    has_top = true;
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (vector_[k].sign() != 0) approx_[k] = scaled_floor(vector_[k], kApproxBits - top);
}

Direction difference(const Vec3d& a, const Vec3d& b) {
  std::array<Dyadic, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const int i = static_cast<int>(k);
    out[k] = Dyadic::from_double(a[i]) - Dyadic::from_double(b[i]);
  }
  return Direction(std::move(out));
}

Direction axis_direction(std::size_t axis, int sign) {
  std::array<Dyadic, 3> out;
  out[axis] = Dyadic(sign);
  return Direction(std::move(out));
}

Direction operator+(const Direction& a, const Direction& b) {
  return Direction({a[0] + b[0], a[1] + b[1], a[2] + b[2]});
}
Direction operator-(const Direction& a) { return Direction({-a[0], -a[1], -a[2]}); }
Direction operator*(const Dyadic& s, const Direction& a) {
  return Direction({s * a[0], s * a[1], s * a[2]});
}
Direction cross(const Direction& a, const Direction& b) {
  return Direction(
      {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
}
Dyadic dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// With M = kMostApprox: for |x|, |y| <= M, each off by less than 1, the product is off by less than 2 M + 1 < 3 M.
Sign side(const Direction& a, const Direction& b) {
  int128 sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += static_cast<int128>(a.approx()[k]) * b.approx()[k];
  const Sign3 s = sign_within(sum, 9 * kMost);
  return is_certain(s) ? to_sign(s) : dot(a, b).sign();
}

// Each of six products of three such numbers is off by less than (M + 1)^3 - M^3 < 4 M^2, and is at most M^3 < 2^115.
Sign turn(const Direction& n, const Direction& a, const Direction& b) {
  int128 sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += approx_cross(a, b, k) * n.approx()[k];
  const Sign3 s = sign_within(sum, 24 * kMost * kMost);
  return is_certain(s) ? to_sign(s) : dot(n, cross(a, b)).sign();
}

// A component of a x b is off by less than 6 M.
bool is_parallel(const Direction& a, const Direction& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (is_certain(sign_within(approx_cross(a, b, k), 6 * kMost))) return false;
  return cross(a, b).is_zero();
}

}  // namespace veritope
