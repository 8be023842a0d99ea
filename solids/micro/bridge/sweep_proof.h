// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/sweep_proof.h: proves that the sweeps of a microstructure are solids that meet the rest in their
// caps alone. The conditions Q1 to Q4 of docs/certificates/microstructure.md. Theory: docs/THEORY.md, MICRO-1.
#pragma once
#include <cstdint>
#include <variant>
#include <vector>

#include "solids/micro/bridge/bridge_proof.h"
#include "solids/micro/bridge/sweep_matrix.h"

namespace veritope {

/// One for each sweep, in their order; or the first one that is not proved, with the condition "Q1", "Q2", "Q3" or
/// "Q4". The result does not depend on the number of jobs.
/// REQUIRES as prove_bridges.
/// @error kOverLimit: FastSpline::prepare
/// @cost  milliseconds for each sweep, if few of them and of the tiles are near each other
Result<std::variant<std::vector<SweepWitness>, BridgeDefect>> prove_sweeps(
    const Microstructure& micro, const VModel& cage, const std::vector<AnalysedTile>& tiles,
    unsigned jobs);

}  // namespace veritope
