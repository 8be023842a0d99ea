// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "robust/common_bits.h"
#include "robust/integer.h"
#include "verify/certify/vmodel_cut_internal.h"

namespace veritope::internal {
namespace {

constexpr std::uint64_t kMostBitsOfKnots = 2048, kMostBitsOfPoints = 8192;

// The numbers times their least common denominator, without a common factor; nothing if one of these, or it, has more
// bits.
std::optional<std::vector<Integer>> integers_of(const std::vector<Rational>& numbers,
                                                std::uint64_t most) {
  Integer denominator(1), factor;
  for (const Rational& x : numbers) {
    denominator = lcm(denominator, x.denominator());
    if (denominator.bit_length() > most) return std::nullopt;
  }
  std::vector<Integer> out;
  for (const Rational& x : numbers) {
    out.push_back(x.numerator() * divide_exactly(denominator, x.denominator()));
    if (out.back().bit_length() > most) return std::nullopt;
    factor = gcd(factor, out.back());
  }
  if (factor.sign() == Sign::kPositive && factor != Integer(1))
    for (Integer& x : out) x = divide_exactly(x, factor);
  return out;
}
std::uint64_t longest_of(const std::vector<Integer>& numbers) {
  std::uint64_t out = 1;
  for (const Integer& x : numbers) out = std::max(out, x.bit_length());
  return out;
}

}  // namespace

std::uint64_t KnotPiece::units(int degree) const {
  const auto p = static_cast<std::uint64_t>(degree), cube = p * p * p;
  return 1 + cube * (64 + cube * bits * bits / 8192) / 32;
}

std::optional<KnotPiece> interval_of(const KnotAxis<Rational>& axis, const Rational& a,
                                     const Rational& b, bool is_bound) {
  const auto p = static_cast<std::size_t>(axis.degree);
  std::size_t k = p;
  while (axis.knots[k + 1] <= a) ++k;
  KnotPiece out;
  out.first = k - p;
  std::vector<Rational> from_a;
  out.is_whole = true;
  for (std::size_t i = k - p + 1; i <= k + p; ++i) {
    from_a.push_back(axis.knots[i] - a);
    out.is_whole = out.is_whole && axis.knots[i] == (i <= k ? a : b);
  }
  from_a.push_back(b - a);
  if (is_bound) {
    CommonBits bits(kMostBitsOfKnots);
    for (const Rational& x : from_a) bits.add(x);
    if (bits.is_beyond()) return std::nullopt;
    if (!out.is_whole) out.bits = bits.bits();
    return out;
  }
  const auto integers = integers_of(from_a, kMostBitsOfKnots);
  if (!integers) return std::nullopt;
  out.bits = longest_of(*integers);
  return out;
}

std::optional<std::uint64_t> bits_of_points(const std::vector<Rational>& numbers, bool is_bound) {
  if (!is_bound) {
    const auto integers = integers_of(numbers, kMostBitsOfPoints);
    return integers ? std::optional(longest_of(*integers)) : std::nullopt;
  }
  CommonBits bits(kMostBitsOfPoints);
  for (const Rational& x : numbers) bits.add(x);
  return bits.is_beyond() ? std::nullopt : std::optional(bits.bits());
}

CutProducts products_of(std::span<const std::uint64_t> sizes, std::span<const KnotPiece> axes,
                        std::uint64_t bits) {
  CutProducts out;
  out.bits = bits;
  std::uint64_t m = 1;
  for (const std::uint64_t n : sizes) m *= n;
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    const std::uint64_t longer = sizes[a] * (sizes[a] - 1) * axes[a].bits;
    out.units += m * sizes[a] * (32 + (1 + longer / 128) * (1 + bits / 64)) / 32;
    bits += longer / 2;
    if (!axes[a].is_whole) out.bits += longer / 2;
  }
  return out;
}

}  // namespace veritope::internal
