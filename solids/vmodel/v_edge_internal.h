// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_edge_internal.h: points and edges of cells, and when they are equal.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "solids/vmodel/v_model.h"

namespace veritope::internal {

/// What is equal for equal points.
std::uint64_t point_hash(const std::array<Rational, 3>& point);

/// Edge 4 axis + e + 2 f as a curve on its axis; with weights if `is_rational`, which a rational cell needs.
BSplineCurve<Rational> curve_of_edge(const VVolume& cell, std::size_t edge, bool is_rational);

/// A place of an edge.
struct VEdge {
  const VVolume* cell = nullptr;
  std::size_t edge = 0;
};
/// What is equal for edges that are equal in either direction: from exact points inside.
std::uint64_t edge_hash(const VEdge& edge);
/// Whether b runs against a (true) or as a does (false; also if both hold); nothing if they are not equal. Equal means
/// equal as maps up to degrees, knots, affine changes of the domain and one positive factor of homogeneous coordinates.
std::optional<bool> is_equal_reversed(const VEdge& a, const VEdge& b);

}  // namespace veritope::internal
