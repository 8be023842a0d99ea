// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/normal_chain.h: the normal chain of a closed complex of patches (seed 001 [GRF03], theorem 1): simplices
// from an origin over the bases of all patches, and the free-form cells between bases and patches. Its function f is
// the winding number off all walls, for every origin.  Theory: docs/THEORY.md, CHAIN-1.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "robust/base/sign.h"
#include "solids/chain/chain.h"
#include "solids/chain/free_form_cell.h"
#include "solids/classify/point_answer.h"
#include "solids/patches/patch_complex.h"

namespace veritope {

/// Numbers of cells, by their coefficients; of simplices as seen from one origin.
struct CellCounts {
  std::uint64_t plus = 0, minus = 0, zero = 0, mixed = 0;
};

/// The coefficient of the simplex from the origin over a base triangle: the sign of its volume.
Sign simplex_sign(const BaseTriangle& base, const ExactPoint& origin);
/// The simplices of the normal chain, without making the chain.
CellCounts count_simplices(const PatchComplex& complex, const ExactPoint& origin);

class NormalChain {
 public:
  /// REQUIRES a closed oriented surface. The complex need not outlive the chain.
  explicit NormalChain(const PatchComplex& complex);
  NormalChain(NormalChain&&) noexcept;
  ~NormalChain();

  /// f(Q), definition 3: the sum of the coefficients of all cells that hold the point. On bases and on sides of
  /// simplices it is the sum at one point beside Q for all cells, which no patch separates from Q. Nothing on a patch
  /// or a strip, or if 256 halvings of the patches do not tell that Q is on none.
  std::optional<int> value(const ExactPoint& point, const ExactPoint& origin) const;

  /// The chain itself, formula (1) of theorem 1: the original simplices from the origin with the signs of their
  /// volumes, and the free-form cells with theirs. Its f is definition 3's: on flat walls it counts closed cells.
  /// Simplices without an interior and patches in their bases have the coefficient 0 and are left out. It shares the
  /// patches of the cells with this object, and may outlive it.
  Chain<3> chain(const ExactPoint& origin) const;

  CellCounts simplices(const ExactPoint& origin) const;
  CellCounts free_form_cells() const;

 private:
  class Body;
  std::unique_ptr<const Body> body_;
};

}  // namespace veritope
