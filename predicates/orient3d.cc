// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/orient3d.h"

#include "predicates/lattice.h"
#include "robust/base/int128.h"

namespace veritope::internal {

// Differences have at most 61 bits and minors 123. A minor is cut into high * 2^64 + low with 0 <= low < 2^64: a difference times
// `low` has 125 bits and the sum of three of them stays under 2^127; a difference times `high` is shorter.
Sign3 orient3d_lattice(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  static_assert(2 * (kLatticeBits + 1) + 1 <= 126 && 64 + kLatticeBits + 1 + 2 <= 127);
  std::array<std::int64_t, 4> x, y, z;
  if (!to_short_lattice<4>({a.x, b.x, c.x, d.x}, x) || !to_short_lattice<4>({a.y, b.y, c.y, d.y}, y) ||
      !to_short_lattice<4>({a.z, b.z, c.z, d.z}, z)) {
    return Sign3::kUncertain;
  }
  const int128 ux = x[1] - x[0], uy = y[1] - y[0], uz = z[1] - z[0];
  const std::int64_t vx = x[2] - x[0], vy = y[2] - y[0], vz = z[2] - z[0];
  const int128 nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  const auto low = [](int128 minor, std::int64_t w) {
    return static_cast<int128>(static_cast<std::uint64_t>(minor)) * w;
  };
  const auto high = [](int128 minor, std::int64_t w) {
    return static_cast<int128>(static_cast<std::int64_t>(minor >> 64)) * w;
  };
  const std::int64_t wx = x[3] - x[0], wy = y[3] - y[0], wz = z[3] - z[0];
  const int128 low_sum = low(nx, wx) + low(ny, wy) + low(nz, wz);
  const int128 high_sum = high(nx, wx) + high(ny, wy) + high(nz, wz) + (low_sum >> 64);
  if (high_sum != 0) return to_sign3(sign_of(high_sum));
  return static_cast<std::uint64_t>(low_sum) != 0 ? Sign3::kPositive : Sign3::kZero;
}

Sign3 orient3d_interval(const Vec3d&, const Vec3d&, const Vec3d&, const Vec3d&) {
  return Sign3::kUncertain;
}

Sign orient3d_exact(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const auto x = to_integers<4>({a.x, b.x, c.x, d.x});
  const auto y = to_integers<4>({a.y, b.y, c.y, d.y});
  const auto z = to_integers<4>({a.z, b.z, c.z, d.z});
  const formulas::Plane3<Integer> plane(x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]);
  return plane.det(x[3] - x[0], y[3] - y[0], z[3] - z[0]).sign();
}

Sign orient3d_after_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                           TierCounts* tally) {
  return cascade<1>(
      tally, [&] { return orient3d_lattice(a, b, c, d); },
      [&] { return orient3d_interval(a, b, c, d); }, [&] { return orient3d_exact(a, b, c, d); });
}

}  // namespace veritope::internal
