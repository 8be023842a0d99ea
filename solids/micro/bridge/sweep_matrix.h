// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/sweep_matrix.h: a matrix that shows that a sweep is one to one and leaves its tile in the cap
// alone: the condition Q2 of docs/certificates/microstructure.md. Theory: docs/THEORY.md, MICRO-1.
#pragma once
#include <array>
#include <optional>

#include "solids/micro/bridge/bridge_matrix.h"
#include "solids/micro/sweep_start.h"

namespace veritope {

/// What shows Q2 to Q4 of a sweep.
struct SweepWitness {
  BridgeMatrix matrix;
  Rational depth{1};  ///< of the slab, in units of the cell's width; over 0, at most 1
  Rational speed{1};  ///< over 0
};

/// True only if Q2 holds. Decided by intervals.
/// @cost a product of nine numbers for each coefficient of the derivative on the slab, and two for each on the wall
bool shows_one_to_one(const SweepWitness& witness, const SweepStarts& starts,
                      const MicroSweep& sweep);

/// A witness for which shows_one_to_one holds, with integers below 2^40 and powers of two, if one is found.
std::optional<SweepWitness> find_sweep_witness(const SweepStarts& starts, const MicroSweep& sweep);

}  // namespace veritope
