// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/side_overlaps.h: open sides that run along one curve and are no edge: T-junctions, where a corner lies
// inside a side of a neighbour, and sides of equal curves with other parametrizations. Everything is decided exactly.
// Design: docs/design/0037-named-gaps-and-joints.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/patches/patch_complex.h"

namespace veritope {

/// How two arcs with common ends agree.
enum class CurveAgreement {
  kAffine,  ///< equal maps after an affine change of parameter, up to degree and factor of weights
  kProjective,  ///< equal maps after t -> a t / (1 - t + a t), a > 0 and not 1: equal sets
  /// Both arcs lie on one irreducible algebraic curve, in other parametrizations. The arcs may differ: a circle has two
  /// arcs between two points.
  kOneCurve,
};

/// An arc of one side that runs along an arc of another.
struct SideOverlap {
  std::array<PatchSide, 2> sides;  ///< the lesser first
  /// The arcs, in each side's direction of travel: from at[0][0] to at[0][1], ascending, on the first side, and from
  /// at[1][0] to at[1][1] on the second, where they descend if the sides run in opposite directions. Each end is 0 or 1
  /// on one of the sides.
  std::array<std::array<Rational, 2>, 2> at;
  CurveAgreement agreement = CurveAgreement::kAffine;
};

struct SideOverlaps {
  std::vector<SideOverlap> found;  ///< ascending by sides
  /// Pairs that were not decided: a corner's parameter on a side is irrational or has a denominator of over 20 bits.
  std::vector<std::array<PatchSide, 2>> undecided;
  bool is_complete = true;  ///< false: there are more pairs than were compared
};

/// Those of the complex's open sides; none of a patch with a weight that is not positive.
/// @cost O(n log n) comparisons of boxes for n open sides whose boxes overlap few others; exact work for at most
///       max_pairs pairs
SideOverlaps find_side_overlaps(const PatchComplex& complex, std::size_t max_pairs = 100'000);

/// A corner of `neighbour`'s side that lies inside `side`, where the two run along each other with affine parameters.
struct TJunction {
  PatchSide side;
  Rational at;  ///< 0 < at < 1, in the side's direction of travel
  PatchCorner corner;
  PatchSide neighbour;
};
/// Each place of a side once, ascending by side and parameter.
std::vector<TJunction> t_junctions_of(const PatchComplex& complex,
                                      const std::vector<SideOverlap>& overlaps);

}  // namespace veritope
