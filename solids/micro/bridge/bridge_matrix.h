// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/bridge_matrix.h: a matrix that shows that a bridge is one to one: the condition R1 of
// docs/certificates/microstructure.md. Theory: docs/THEORY.md, MICRO-1.
#pragma once
#include <array>
#include <optional>

#include "solids/micro/micro_bridge.h"

namespace veritope {

/// Row by row.
using BridgeMatrix = std::array<Rational, 9>;

/// Whether det K > 0, and K J + (K J)^T is positive definite for each Bernstein coefficient J of the derivative in the
/// degrees (p, q, 2): then (x - y) . K (b(x) - b(y)) > 0 for all different x and y. Exact.
/// REQUIRES the net of a bridge.  @cost (p + 1)(q + 1) 3 matrices; rationals where intervals do not decide
bool shows_one_to_one(const BridgeMatrix& matrix, const MicroBridge& bridge);

/// A matrix of integers below 2^40 for which shows_one_to_one holds, if one is found. It starts from the inverse of the
/// mean of all J, scaled along the axes, and turns it where a J is against it.
std::optional<BridgeMatrix> find_bridge_matrix(const MicroBridge& bridge);

/// Whether the determinant is positive at 125 points of the bridge: approximate, for statistics.
bool has_positive_determinants(const MicroBridge& bridge);

}  // namespace veritope
