// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/side_witness.h: a proof that the outer sides of patches pass an arc other than once in each direction,
// the exact test of it (conditions D1 to D4 of docs/certificates/patch-invalid.md, section 4), and the search.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/patches/patch_complex.h"
#include "verify/certify/crossing_witness.h"

namespace veritope {

/// A part of a side, in the side's direction of travel.
struct SideArc {
  PatchSide side;
  DyadicInterval at;
  friend bool operator==(const SideArc&, const SideArc&) = default;
};

struct SideWitness {
  std::vector<SideArc> arcs;
  std::uint8_t axis = 0;    ///< the coordinate that is monotone along the first arc
  unsigned point_bits = 0;  ///< the point lies at the parameter point / 2^point_bits of the first arc's side
  std::uint64_t point = 0;
  std::uint32_t same = 0, opposite = 0;  ///< numbers of arcs that run with the first one, and against it
  friend bool operator==(const SideWitness&, const SideWitness&) = default;
};

/// For each patch, bit s is set iff side s lies on the border of the domain of the entity to which the patch belongs.
/// Empty: all sides do.
using OuterSides = std::vector<std::uint8_t>;
inline bool is_outer(const OuterSides& outer, PatchSide side) {
  return outer.empty() || (outer[side.patch] >> side.side & 1) != 0;
}

enum class SideCondition { kD1, kD2, kD3, kD4 };
/// The first condition that does not hold; nothing: the witness is a proof. Exact. @cost for D4, a few comparisons for
/// each side of the complex
std::optional<SideCondition> broken_condition(const PatchComplex& complex, const OuterSides& outer,
                                              const SideWitness& witness);

/// The point of the witness, exactly. REQUIRES D1.
PatchPoint point_of(const PatchComplex& complex, const SideWitness& witness);

/// A proof for the first of the complex's findings for which one is found: open sides, sides of three or more patches,
/// equal directions. Nothing if other sides pass all the points that are tried: they may be the same point set in
/// another parametrisation.
/// @cost at most 16 findings times 15 points, each as broken_condition
std::optional<SideWitness> find_side_witness(const PatchComplex& complex, const OuterSides& outer);

/// The witness for the patches of entities that are reversed: their sides change numbers and directions.
SideWitness with_reversed(const PatchComplex& complex, const std::vector<bool>& is_reversed,
                          SideWitness witness);

}  // namespace veritope
