// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/jacobian_tree_internal.h: halves a piece until no coefficient of N is negative.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "robust/rational.h"
#include "solids/vmodel/jacobian_net.h"

namespace veritope::internal {

/// A box in the unit cube: along axis a from index[a] 2^-level[a], of length 2^-level[a].
struct DyadicBox {
  std::array<std::uint64_t, 3> index{};
  std::array<unsigned, 3> level{};

  unsigned depth() const { return level[0] + level[1] + level[2]; }
  DyadicBox half(std::size_t axis, unsigned upper) const {
    DyadicBox out = *this;
    out.index[axis] = 2 * index[axis] + upper;
    ++out.level[axis];
    return out;
  }
  bool touches_begin(std::size_t axis) const { return index[axis] == 0; }
  bool touches_end(std::size_t axis) const {
    return index[axis] == (std::uint64_t{1} << level[axis]) - 1;
  }
  std::array<Rational, 2> along(std::size_t axis) const {
    const Rational length = Rational::power_of_two(-static_cast<std::int64_t>(level[axis]));
    return {Rational(index[axis]) * length, Rational(index[axis] + 1) * length};
  }
};

/// s0, s1, s2 of sub-face 9 s0 + 3 s1 + s2.
constexpr std::array<unsigned, 3> sub_face_places(unsigned number) {
  return {number / 9, number / 3 % 3, number % 3};
}
/// Whether sub-face `part` is a part of sub-face `whole` of the same box.
constexpr bool is_sub_face_part(unsigned part, unsigned whole) {
  const auto p = sub_face_places(part), w = sub_face_places(whole);
  for (std::size_t a = 0; a < 3; ++a)
    if (w[a] != 2 && w[a] != p[a]) return false;
  return true;
}

enum class TreeEnd {
  kProved,
  kNegative,   ///< at the point
  kZero,       ///< at the point, which no zero of the piece holds
  kUncertain,  ///< in rounded numbers: integers must decide
  kTooLarge    ///< in the box
};
struct TreeResult {
  TreeEnd end = TreeEnd::kProved;
  std::vector<std::uint8_t> tree;  ///< if proved
  std::array<Rational, 3> point;   ///< in the piece's unit cube
  DyadicBox box;
};

/// N times sign (1 or -1) on the unit cube. No zeros.
TreeResult search_tree(const RoundedJacobian& net, int sign, std::size_t max_nodes);
/// The zeros: bit n for sub-face n.
TreeResult search_tree(const ExactJacobian& net, int sign, std::uint32_t zeros,
                       std::size_t max_nodes);

/// A point inside of the unit cube, of few bits, at which rounded N times sign is as low as steps downhill from the
/// box's middle led: a guess, whose sign is not known. Nothing if numbers are out of range.
std::optional<std::array<Rational, 3>> low_point(const RoundedJacobian& net, int sign,
                                                 const DyadicBox& near);

/// The greatest sub-faces on which all coefficients are 0, bit 26 for all of it.
std::uint32_t zeros_of(const ExactJacobian& net);

}  // namespace veritope::internal
