// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/volumes/swept.h: volumes through surfaces in order, and the inside of a closed tube.
// Source: seed paper 000, sections 3.2.2 and 5.4, figure 13; [PT97] 9.2.1 for the knots.
#pragma once
#include <span>
#include <vector>

#include "solids/volumes/cell_maps.h"

namespace veritope {

enum class SweepMode {
  kInterpolate,  ///< through every section: the volume at w_i is section i, exactly
  kApproximate,  ///< the sections are the control rows
};

/// The most sections that an interpolation takes: its numbers grow with their number.
inline constexpr std::size_t kMaxInterpolatedSections = 256;
/// The most bits that the numbers of an interpolation may have, as estimated from those of its sections and parameters.
inline constexpr std::uint64_t kMaxInterpolatedBits = std::uint64_t{1} << 20;

/// (u, v, w), w from the first parameter to the last; the inner knots are means of `degree` parameters in a row. The
/// linear equations of an interpolation are solved in rationals.
/// @error  kBadArgument for fewer than degree + 1 sections, a degree < 1, parameters that do not increase or are not as
///         many as the sections, and where a weight would not be positive; kOverLimit
Result<CellVolume> swept(std::vector<CellSurface> sections, std::span<const Rational> parameters,
                         int degree, SweepMode mode);

/// The inside of a surface that is closed along one of its axes: it is cut there into four strips, two Boolean sums of
/// four curves close its ends, and the volumetric Boolean sum of the six is right-handed in the middle. The cuts are
/// the begin of the closed axis and the three knots nearest to its quarters, where they are within an eighth of its
/// length, else the quarters. Where the surface is smooth at a cut, the volume has N = 0 on the edge there.
/// @error  kBadArgument if neither axis is closed as a homogeneous curve; as boolean_sum
Result<CellVolume> tube(const CellSurface& surface);

}  // namespace veritope
