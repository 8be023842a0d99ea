// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/literal_chain.h: the chain of definitions 8 and 9 of seed 001 [GRF03] as they stand, for study: its
// cells are parts of wedges between exact planes. It decides nothing: for most models its f is not the winding number.
// Theory: docs/THEORY.md, CHAIN-6.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "solids/chain/literal_conditions.h"
#include "solids/chain/literal_hypotheses.h"
#include "solids/classify/point_answer.h"
#include "solids/patches/patch_complex.h"

namespace veritope {

struct LiteralValue {
  std::optional<int>
      f;  ///< nothing: on a curved wall, but for rational parameters of its patch, or so near one that
          ///< 48 halvings do not tell
  std::optional<int>
      regular;  ///< f*; nothing on a curved wall, or if more than 48 planes meet at the point
};

class LiteralChain {
 public:
  /// REQUIRES a closed oriented surface, which outlives the chain.
  explicit LiteralChain(const PatchComplex& complex);
  LiteralChain(LiteralChain&&) noexcept;
  ~LiteralChain();

  /// Whether what the paper assumes is true of the model. The answer does not depend on the number of threads.
  LiteralHypotheses hypotheses(unsigned jobs = 1) const;

  /// The free-form cells, and whether definition 1 accepts them. @cost milliseconds for each curved patch of a low
  /// degree, up to a second for rational patches of four sides
  LiteralCells cells(unsigned jobs = 1) const;

  /// f, definition 3: the sum of the coefficients of the closed cells that hold the point, simplices from the origin
  /// and parts of wedges. And f*, definition 6, if all cells are cones with flat sides near the point. Curved walls are
  /// the patches, and what lies between their boundaries and the planes of their bases, along the base's normal.
  /// @cost one search in each cell whose box and wedge hold the point, about a millisecond
  LiteralValue value(const ExactPoint& point, const ExactPoint& origin) const;

 private:
  class Body;
  std::unique_ptr<const Body> body_;
};

}  // namespace veritope
