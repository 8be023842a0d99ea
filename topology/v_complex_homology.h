// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/v_complex_homology.h: signed boundary maps of a V-complex, its Euler characteristic and Betti numbers.
#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "robust/base/result.h"
#include "topology/v_complex.h"

namespace veritope {

/// A matrix of small integers by its columns; each column lists (row, entry != 0), rows ascending.
struct IntegerMatrix {
  std::uint32_t num_rows = 0;
  std::vector<std::vector<std::pair<std::uint32_t, std::int32_t>>> columns;
  bool is_zero() const;
};
IntegerMatrix product(const IntegerMatrix& a, const IntegerMatrix& b);

/// d3 maps V-cells to V-surfaces, d2 V-surfaces to V-curves, d1 V-curves to V-points. Rows and columns are the elements
/// by ascending ids. A V-surface is oriented as its first half, a V-cell as space, so that its boundary has each of its
/// half-V-surfaces once: an entry of d3 is the number of first halves minus that of second ones, 0 for a cell on both
/// sides. A V-curve that the loops of a half-V-surface pass k times along and l times against has the entry k - l.
struct BoundaryMaps {
  IntegerMatrix d3, d2, d1;
};
BoundaryMaps boundary_maps(const VComplex& complex);

/// The Euler characteristic of the space, for V-surfaces with k loops (2 - k) and V-cells whose boundary surfaces have
/// the Euler characteristic e in all (-e / 2, as for all open sets of space with a boundary of closed surfaces).
std::int64_t euler_characteristic(const VComplex& complex);

/// Largest prime below 2^61, and the field of the Betti numbers: those over the rationals are the same unless it
/// divides a torsion coefficient of the homology over the integers.
inline constexpr std::uint64_t kBettiPrime = (std::uint64_t{1} << 61) - 1;
std::uint64_t rank_modulo(const IntegerMatrix& matrix, std::uint64_t prime);

/// b0, b1, b2, b3 over the field with kBettiPrime elements: exact, by elimination. A V-complex is no CW complex where a
/// V-surface has several loops or a V-cell several boundary surfaces. Loops and boundary surfaces of one element are
/// then connected by bridges, curves through it that nothing else meets; what is left of the element is an open disk or
/// ball, and has the same boundary: a connected open set of space with spheres as boundary is a ball without closed
/// balls.
/// @error kBadArgument with place.entity = a cell that has a boundary surface of genus > 0: its boundary does not tell
///   which cycles bound in it. Cut it by split_cell (v_complex_edit.h) first.
Result<std::array<std::uint64_t, 4>> betti_numbers(const VComplex& complex);

}  // namespace veritope
