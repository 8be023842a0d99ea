// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/patch_net.h: one form for each patch, whatever its degrees, factor, corner 0 and normal: two patches
// are the same map of their domain, up to a symmetry of it, iff their forms are equal.
#pragma once
#include <compare>
#include <vector>

#include "solids/patches/patch.h"

namespace veritope {

struct CanonicalNet {
  std::array<int, 2> degrees{};  ///< for a triangle, its degree and -1
  std::size_t num_components = 3;
  std::vector<Rational> values;  ///< component by component
  bool is_reversed = false;  ///< the form is that of the reversed patch; no part of the comparison

  friend std::strong_ordering operator<=>(const CanonicalNet& a, const CanonicalNet& b);
};

/// The net in the least degrees, divided by the absolute value of the first weight, without weights if all are then 1;
/// among the 8 (6) symmetries of the domain, the one whose values come first. @cost O(size * degree)
CanonicalNet canonical_net(const Patch& patch);

/// Lowers the degree along each axis as far as the map allows.
Patch with_least_degrees(const Patch& patch);

}  // namespace veritope
