// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/chain_origin.h: --origin X,Y,Z or auto: the origin of a chain.
#pragma once
#include <string>

#include "solids/classify/point_answer.h"
#include "solids/patches/patch_complex.h"

namespace veritope::cli {

struct ChainOrigin {
  bool is_auto = false;
  ExactPoint point;  ///< unless is_auto
};

/// Reads "auto", or three decimals, fractions or hexadecimal numbers "X,Y,Z", exactly. @return what is wrong; empty:
/// nothing
std::string take_origin(const std::string& text, ChainOrigin& origin);

/// The point; of `auto` the candidate with the fewest expected cell tests (OriginCosts::best).
ExactPoint origin_for(const PatchComplex& complex, const ChainOrigin& origin);

}  // namespace veritope::cli
