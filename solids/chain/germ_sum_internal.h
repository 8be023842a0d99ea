// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/germ_sum_internal.h: the function f of a chain near one point, where all walls are flat.
// Theory: docs/THEORY.md, CHAIN-2.
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "robust/integer.h"
#include "solids/chain/chain.h"
#include "solids/chain/local_faces_internal.h"

namespace veritope::internal {

/// The multiple of a normal whose first component that is not 0 is 1, and the sign of the factor.
template <std::size_t Dim>
std::pair<NormalIn<Dim>, Sign> as_hyperplane(NormalIn<Dim> normal) {
  std::size_t first = 0;
  while (first + 1 < Dim && normal[first].sign() == 0) ++first;
  const Rational unit = normal[first];
  for (Rational& x : normal) x /= unit;
  return {std::move(normal), unit.sign()};
}

template <std::size_t Dim>
class GermSum {
 public:
  /// False if a cell that matters has no germ there.
  bool add(const ChainTerm<Dim>& term, const ChainPoint<Dim>& q) {
    bool is_known = true;
    for (const CellPointer<Dim>& cell : term.cells) {
      const Germ& germ = germ_of(*cell, q);
      if (germ && germ->half_spaces.empty() && germ->inside == 0) return true;
      is_known = is_known && germ.has_value();
    }
    if (!is_known) return false;
    Product product{term.coefficient, {}};
    for (const CellPointer<Dim>& cell : term.cells) {
      const CellGerm<Dim>& germ = *germs_.at(cell.get());
      if (germ.half_spaces.empty())
        product.coefficient *= Integer(germ.inside);
      else
        product.parts.push_back(&part_of(*cell, germ));
    }
    if (product.parts.empty())
      constant_ += product.coefficient;
    else
      products_.push_back(std::move(product));
    return true;
  }

  /// Those of all cells that matter, each once.
  const std::vector<NormalIn<Dim>>& hyperplanes() const { return hyperplanes_; }
  bool is_constant() const { return hyperplanes_.empty(); }

  /// @param sides  of the hyperplanes, those of a face
  Integer at(const std::vector<Sign>& sides) const {
    Integer out = constant_;
    for (const Product& p : products_) {
      Integer value = p.coefficient;
      for (const Part* part : p.parts) value *= Integer(part->at(sides));
      out += value;
    }
    return out;
  }

 private:
  using Germ = std::optional<CellGerm<Dim>>;
  struct Part {
    std::vector<std::pair<std::size_t, Sign>> half_spaces;  // hyperplane, and its inner side
    int inside = 0, border = 0, outside = 0;
    int at(const std::vector<Sign>& sides) const {
      bool is_on = false;
      for (const auto& [h, inner] : half_spaces) {
        const Sign s = sides[h] * inner;
        if (s < 0) return outside;
        is_on = is_on || s == 0;
      }
      return is_on ? border : inside;
    }
  };
  struct Product {
    Integer coefficient;
    std::vector<const Part*> parts;
  };

  const Germ& germ_of(const Cell<Dim>& cell, const ChainPoint<Dim>& q) {
    const auto [at, is_new] = germs_.try_emplace(&cell);
    if (is_new) at->second = cell.germ(q);
    return at->second;
  }
  const Part& part_of(const Cell<Dim>& cell, const CellGerm<Dim>& germ) {
    const auto [at, is_new] = parts_.try_emplace(&cell);
    Part& out = at->second;
    if (!is_new) return out;
    out = {{}, germ.inside, germ.border, germ.outside};
    for (const NormalIn<Dim>& normal : germ.half_spaces) {
      const auto [hyperplane, sign] = as_hyperplane<Dim>(normal);
      const auto [number, is_first] = numbers_.try_emplace(hyperplane, hyperplanes_.size());
      if (is_first) hyperplanes_.push_back(hyperplane);
      out.half_spaces.emplace_back(number->second, sign);
    }
    return out;
  }

  std::map<const Cell<Dim>*, Germ> germs_;
  std::map<const Cell<Dim>*, Part> parts_;  // their addresses do not change
  std::map<NormalIn<Dim>, std::size_t> numbers_;
  std::vector<NormalIn<Dim>> hyperplanes_;
  std::vector<Product> products_;
  Integer constant_{0};
};

}  // namespace veritope::internal
