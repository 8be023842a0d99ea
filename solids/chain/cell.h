// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/cell.h: what a chain is made of: extended cells, definition 1 and 2 of seed 001 [GRF03].
// Theory: docs/THEORY.md, CHAIN-2.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/chain/chain_point.h"

namespace veritope {

/// A simplex of a flat wall: an end of a segment (Dim = 1), a segment in the plane, a triangle in space.
template <std::size_t Dim>
using FacetIn = std::array<PointIn<Dim>, Dim>;

/// A vector across a flat wall: of the half-space { x : normal . x >= 0 } from a point of its border.
template <std::size_t Dim>
using NormalIn = std::array<Rational, Dim>;

/// What a closed cell is near a point: an intersection of closed half-spaces with that point on their borders, and the
/// cell's values inside of it, on its border and off it. Without half-spaces the cell is constant near the point, with
/// the value `inside`.
template <std::size_t Dim>
struct CellGerm {
  std::vector<NormalIn<Dim>> half_spaces;
  int inside = 0, border = 0, outside = 0;

  static CellGerm constant(int value) { return {{}, value, value, value}; }
};

enum class CellKind : std::uint8_t { kSimplex, kFreeForm };

/// A closed extended cell: a simplex, or a free-form cell. Immutable: threads may share it.
/// Its value at a point is 1 in a simplex and 0 off it. A free-form cell has the winding number of its boundary chain,
/// times its sign: 1 in the paper's cells, and another integer where a patch is passed more than once. On its walls a
/// closed cell has the value of
///   max(0, the greatest value beside the point) + min(0, the least value beside the point).
template <std::size_t Dim>
class Cell {
 public:
  virtual ~Cell() = default;

  virtual CellKind kind() const = 0;
  /// Contains the cell; coordinates beyond Dim are 0.
  const Box3d& box() const { return box_; }
  /// The value at a point. Nothing on a curved wall, or where it is open whether the point is on one.
  virtual std::optional<int> value(const ChainPoint<Dim>& q) const = 0;
  /// The cell near a point. Nothing where value() has none, or where walls meet that bound no intersection of
  /// half-spaces. REQUIRES nothing of q: a point off the cell has the constant 0.
  virtual std::optional<CellGerm<Dim>> germ(const ChainPoint<Dim>& q) const = 0;
  /// Adds the facets to `out` if all walls are flat; otherwise false, and `out` is unchanged.
  virtual bool add_facets(std::vector<FacetIn<Dim>>& out) const = 0;

 protected:
  explicit Cell(const Box3d& box) : box_(box) {}

 private:
  Box3d box_;
};

template <std::size_t Dim>
using CellPointer = std::shared_ptr<const Cell<Dim>>;

}  // namespace veritope
