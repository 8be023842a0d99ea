// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/literal_chain.h"

#include "solids/chain/literal_hypotheses_internal.h"

namespace veritope {

class LiteralChain::Body {
 public:
  explicit Body(const PatchComplex& complex) : complex_(complex), facets_(complex) {}

  LiteralHypotheses hypotheses() const {
    return {internal::planes_share_lines(complex_, facets_),
            internal::curves_in_planes(complex_, facets_), internal::graphs(complex_, facets_)};
  }

 private:
  const PatchComplex& complex_;
  const internal::LiteralFacets facets_;
};

LiteralChain::LiteralChain(const PatchComplex& complex)
    : body_(std::make_unique<const Body>(complex)) {}
LiteralChain::LiteralChain(LiteralChain&&) noexcept = default;
LiteralChain::~LiteralChain() = default;

LiteralHypotheses LiteralChain::hypotheses() const { return body_->hypotheses(); }

}  // namespace veritope
