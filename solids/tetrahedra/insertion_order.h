// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/tetrahedra/insertion_order.h: an order in which points are inserted fast into a triangulation: rounds of
// random points, each four times as large as the one before, and in each round along a Hilbert curve.
// Source: biased randomized insertion order, [ACR03]; the curve as in [Ski04].
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/vec.h"

namespace veritope {

/// A permutation of the points' numbers, the same for the same points on every machine.
/// REQUIRES finite coordinates. @cost a sort
std::vector<std::uint32_t> insertion_order(std::span<const Vec3d> points);

/// The number, below 2^60, of the cell (x, y, z) of a grid of 2^20 cells along each axis on a Hilbert curve:
/// cells with neighbouring numbers have a common face. REQUIRES x, y, z < 2^20.
std::uint64_t hilbert_number(std::uint32_t x, std::uint32_t y, std::uint32_t z);

}  // namespace veritope
