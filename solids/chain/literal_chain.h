// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/literal_chain.h: the chain of definitions 8 and 9 of seed 001 [GRF03] as they stand, for study: its
// cells are parts of wedges between exact planes. It decides nothing: for most models its f is not the winding number.
// Theory: docs/THEORY.md, CHAIN-6.
#pragma once
#include <cstdint>
#include <memory>

#include "solids/chain/literal_hypotheses.h"
#include "solids/classify/point_answer.h"
#include "solids/patches/patch_complex.h"

namespace veritope {

class LiteralChain {
 public:
  /// REQUIRES a closed oriented surface, which outlives the chain.
  explicit LiteralChain(const PatchComplex& complex);
  LiteralChain(LiteralChain&&) noexcept;
  ~LiteralChain();

  /// Whether what the paper assumes is true of the model.
  LiteralHypotheses hypotheses() const;

 private:
  class Body;
  std::unique_ptr<const Body> body_;
};

}  // namespace veritope
