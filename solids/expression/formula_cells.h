// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/formula_cells.h: a formula of solids, folded in cells of space by the values of the solids there.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "solids/expression/formula.h"
#include "solids/expression/operand.h"

namespace veritope {

/// Cuts a box around the solids in halves as long as a cell has many literals and there is room. A short formula has
/// one cell. Immutable: threads may share it.
class FormulaCells {
 public:
  /// @param operands  those that the variables name
  /// @cost  at most kMostCells cells, each with the values of the solids that its half of a cell has left
  FormulaCells(const Formula& formula, const std::vector<std::shared_ptr<const Operand>>& operands);

  static constexpr std::size_t kMostCells = 4096;

  /// A formula with the value of the whole one at the point and near it, wherever walls are.
  const Formula& at(const Vec3d& point) const;
  const Formula& at(const ExactPoint& point) const;
  std::size_t num_cells() const { return formulas_.size(); }

 private:
  class Builder;
  /// The lower half is the node after this one.
  struct Node {
    std::size_t axis = 0;
    double middle = 0;          ///< a point there belongs to both halves
    std::uint32_t upper = 0;    ///< the node of the upper half; 0: a cell
    std::uint32_t formula = 0;  ///< of a cell
  };
  template <typename Point>
  const Formula& find(const Point& point) const;

  Box3d box_;
  Formula outside_ = Formula::constant(false);
  std::vector<Node> nodes_;
  std::vector<Formula> formulas_;
};

}  // namespace veritope
