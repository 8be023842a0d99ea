// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/measure/bridge_primitive_internal.h: a primitive of the cage's determinant around a bridge. Internal to
// solids/micro/measure.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <tuple>
#include <vector>

#include "interval/box.h"
#include "solids/micro/measure/span_determinant_internal.h"
#include "solids/micro/microstructure.h"

namespace veritope::internal {

/// Determinants of volumes between knots, and the errors of their expansions, made when they are first asked for. May
/// be used by several threads. All functions REQUIRE a live ScopedUpward.
class SpanDeterminants {
 public:
  explicit SpanDeterminants(const Microstructure& micro) : micro_(micro) {}

  using Knots = std::array<std::size_t, 3>;  // as in CellSpan
  /// @param exponents  half of the widths of the cells, in units of the span, are at most 2 to these powers
  struct Expandable {
    const SpanDeterminant& determinant;
    const std::vector<double>& errors;  ///< by orders
  };
  Expandable of(std::uint32_t volume, const Knots& knots, const std::array<int, 3>& exponents);

 private:
  const Microstructure& micro_;
  std::mutex mutex_;
  std::map<std::pair<std::uint32_t, Knots>, SpanDeterminant> determinants_;
  std::map<std::tuple<std::uint32_t, Knots, std::array<int, 3>>, std::vector<double>> errors_;
};

/// Let X be a box of parameters of a volume, brought to [0,1]^3 as y, and J(y) the determinant of the map from y to
/// space. G has the derivative J along one axis, and is 0 at its begin. Knots cut X into cells, on each of which a
/// polynomial is near G. All functions REQUIRE a live ScopedUpward.
class BridgePrimitive {
 public:
  /// REQUIRES lo < hi in the domain of the volume.
  BridgePrimitive(const VVolume& volume, std::uint32_t number, const TilePoint& lo,
                  const TilePoint& hi, SpanDeterminants& determinants);

  /// The axis of the derivative: one that knots cut, if there is one.
  std::size_t axis() const { return axis_; }
  /// The greatest degree of the polynomials near J.
  std::size_t order() const { return order_; }

  /// Numbers of cells along each axis, the first and the last, that contain all of a box in X.
  using CellRange = std::array<std::array<std::size_t, 2>, 3>;
  CellRange cells_of(const Box3& y) const;
  /// Where cell k of an axis begins, k > 0.
  const Interval& cut(std::size_t axis, std::size_t k) const { return cuts_[axis][k - 1]; }

  using CellNumber = std::array<std::size_t, 3>;
  /// Encloses the polynomial near G for points of the cell; what the box has beyond the cell is cut off.
  Interval near(const CellNumber& cell, const Box3& y) const;
  /// How far G is from it.
  double error(const CellNumber& cell) const { return cell_at(cell).error; }
  /// The polynomial near G at the cell's begin along the axis, which depends on the other two coordinates.
  Interval near_begin(const CellNumber& cell, const Box3& y) const;
  /// Encloses J.
  Interval determinant(const CellNumber& cell, const Box3& y) const;

 private:
  struct Cell {
    std::array<Interval, 3> begin, width;
    std::size_t order = 0;
    std::vector<Interval> expansion;  // in the order of moment_indices
    double rest = 0;                  // of J
    std::size_t begin_order = 0;
    std::vector<Interval> at_begin;  // of G, the numbers along the axis 0
    double error = 0;
  };
  const Cell& cell_at(const CellNumber& cell) const { return cells_[shape_.at(cell)]; }
  void expand(const VVolume& volume, std::uint32_t number, const TilePoint& lo, const TilePoint& hi,
              const CellNumber& at, SpanDeterminants& determinants);
  void go_on(const Cell& before, Cell& cell) const;
  std::array<std::vector<Interval>, 3> legendre(const Cell& cell, const Box3& y) const;

  std::size_t axis_ = 0, order_ = 0;
  std::array<std::vector<Rational>, 3> breaks_;  // of the cells, in the parameters of the volume
  std::array<std::vector<Interval>, 3> cuts_;    // the inner ones, brought to [0, 1]
  Grid<3> shape_;
  std::vector<Cell> cells_;
};

}  // namespace veritope::internal
