// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/gmsh_quality.h: Gmsh's bounds of Jacobian determinants, a peer of bench_vmodel.cc only.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace veritope::bench {

/// Nodes (i / 3, j / 3, k / 3) of a cell, k fastest.
using TricubicNodes = std::array<std::array<double, 3>, 64>;

/// Nanoseconds a cell that the plugin AnalyseMeshQuality takes for the determinants of hexahedra of order 3, the least
/// of the rounds. Nothing but the determinants is computed, and no view is made.
double gmsh_quality_ns(const std::vector<TricubicNodes>& cells, int rounds);

}  // namespace veritope::bench
