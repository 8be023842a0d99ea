// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/certificate_entities.h"

#include "verify/certify/natural.h"

namespace veritope {
namespace {

// Bits for the sides of piece (i, j) of m x n that lie on the domain's border, with the file's numbering of sides.
std::uint8_t border_bits(std::size_t i, std::size_t j, std::size_t m, std::size_t n) {
  const unsigned bits =
      (j == 0 ? 1u : 0u) | (i + 1 == m ? 2u : 0u) | (j + 1 == n ? 4u : 0u) | (i == 0 ? 8u : 0u);
  return static_cast<std::uint8_t>(bits);
}
// Side s of the reversed patch is side 3 - s of the patch in the file.
std::uint8_t with_reversed_sides(std::uint8_t bits) {
  unsigned out = 0;
  for (unsigned s = 0; s < 4; ++s) out |= (bits >> s & 1u) << (3 - s);
  return static_cast<std::uint8_t>(out);
}

}  // namespace

certificate::Fraction to_fraction(const Rational& v) {
  return {v.sign() == Sign::kNegative, to_natural(abs(v).numerator()), to_natural(v.denominator())};
}

bool breaks_fit_certificate(const StarBoxEntity& entity) {
  constexpr std::uint64_t kMostBits = 2048;
  for (const auto& axis : entity.breaks)
    for (const Rational& b : axis)
      if (b.numerator().bit_length() > kMostBits || b.denominator().bit_length() > kMostBits)
        return false;
  return true;
}

std::vector<certificate::PatchEntity> to_certificate(const std::vector<StarBoxEntity>& entities) {
  std::vector<certificate::PatchEntity> out;
  for (const StarBoxEntity& e : entities) {
    certificate::PatchEntity& to = out.emplace_back();
    to.is_reversed = e.is_reversed, to.is_surface = e.is_surface;
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (const Rational& b : e.breaks[axis]) to.breaks[axis].push_back(to_fraction(b));
  }
  return out;
}

std::vector<bool> reversed_patches(const std::vector<StarBoxEntity>& entities,
                                   std::size_t num_patches) {
  std::vector<bool> out(num_patches);
  for (std::size_t e = 0; e < entities.size(); ++e) {
    const std::size_t last = e + 1 < entities.size() ? entities[e + 1].first_patch : num_patches;
    for (std::size_t p = entities[e].first_patch; p < last; ++p) out[p] = entities[e].is_reversed;
  }
  return out;
}

OuterSides outer_sides(const std::vector<StarBoxEntity>& entities, std::size_t num_patches) {
  OuterSides out(num_patches, 15);
  for (const StarBoxEntity& e : entities) {
    if (!e.is_surface) continue;
    const std::size_t m = e.breaks[0].size() - 1, n = e.breaks[1].size() - 1;
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const std::uint8_t bits = border_bits(i, j, m, n);
        out[e.first_patch + i * n + j] = e.is_reversed ? with_reversed_sides(bits) : bits;
      }
  }
  return out;
}

}  // namespace veritope
