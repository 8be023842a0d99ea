// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "solids/dms/fast/fast_pair_internal.h"
#include "solids/dms/fast/fast_tables_internal.h"

namespace veritope::internal {
namespace {

constexpr double kUnit = 0x1p-53, kLeast = 0x1p-100, kMostCoordinate = 0x1p400;
constexpr int kMostExponent = 400;

}  // namespace

bool is_in_range(double x, double most) {
  return x == 0 || (std::abs(x) >= kLeast && std::abs(x) <= most);
}

std::optional<FastPlace> FastPlace::around(const Box3d& box) {
  FastPlace out{};
  double side = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double size = std::max(std::abs(box.lo[c]), std::abs(box.hi[c]));
    if (!(size <= kMostCoordinate)) return std::nullopt;
    const double rounding = size * (2 * kUnit) + 0x1p-1070;
    out.box.lo[c] = box.lo[c] - 2 * rounding, out.box.hi[c] = box.hi[c] + 2 * rounding;
    out.origin[c] = 0.5 * box.lo[c] + 0.5 * box.hi[c];
    out.rounding[c] = rounding;
    side = std::max(side, box.hi[c] - box.lo[c]);
  }
  std::frexp(side, &out.exponent);
  if (side == 0 || std::abs(out.exponent) > kMostExponent) return std::nullopt;
  out.scale = std::ldexp(1.0, -out.exponent);
  for (std::size_t c = 0; c < 3; ++c) {
    const double half =
        std::max(out.box.hi[c] - out.origin[c], out.origin[c] - out.box.lo[c]) * out.scale;
    out.rounding[c] *= out.scale;
    out.reach[c] = half * (1 + 0x1p-40) + out.rounding[c];
  }
  return out;
}

std::optional<FastLinear> FastPlace::round(const std::array<Rational, 4>& l, const Rational& factor,
                                           double most, FastLow* low) const {
  const auto part = [&](std::size_t i, const Rational& x) {
    const FastPair pair = pair_of(x);
    if (low != nullptr) low->c[i] = pair.lo;
    return pair.hi;
  };
  Rational at_origin = l[0];
  for (std::size_t c = 0; c < 3; ++c) at_origin += l[c + 1] * Rational::from_double(origin[c]);
  FastLinear out{};
  out.c[0] = part(0, factor * at_origin);
  // Roundings of each term: of the coefficient, the coordinate, the product, the sums, and one when the error is added.
  constexpr double kRoundings[3] = {7, 6, 5};
  double size = 5 * std::abs(out.c[0]);
  bool is_good = is_in_range(out.c[0], most);
  for (std::size_t c = 0; c < 3; ++c) {
    out.c[c + 1] = part(c + 1, factor * l[c + 1] * Rational::power_of_two(exponent));
    is_good = is_good && is_in_range(out.c[c + 1], most);
    size += kRoundings[c] * std::abs(out.c[c + 1]) * reach[c];
    out.error[1] += std::abs(out.c[c + 1]) * rounding[c];
  }
  out.error[0] = size * kUnit * (1 + 0x1p-40) + kFloor;
  out.error[1] *= 1 + 0x1p-40;
  return is_good ? std::optional(out) : std::nullopt;
}

std::optional<FastFrame> FastPlace::round(const SimplexFrame<Rational>& frame, FastLow* low) const {
  FastFrame out{};
  for (std::size_t m = 0; m < 4; ++m) {
    const auto made =
        round(frame.lambda[m], Rational(1), kMostBarycentric, low != nullptr ? low + m : nullptr);
    if (!made) return std::nullopt;
    out.lambda[m] = *made;
  }
  return out;
}

}  // namespace veritope::internal
