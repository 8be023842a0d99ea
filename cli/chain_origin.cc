// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/chain_origin.h"

#include "io/base/exact_number.h"
#include "solids/chain/origin_cost.h"

namespace veritope::cli {

std::string take_origin(const std::string& text, ChainOrigin& origin) {
  origin.is_auto = text == "auto";
  if (origin.is_auto) return "";
  std::size_t begin = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t end = k < 2 ? text.find(',', begin) : text.size();
    if (end == text.npos) return "needs three numbers X,Y,Z or auto, not " + text;
    const std::string token = text.substr(begin, end - begin);
    if (read_exact_number(token, {}, origin.point[k]) != DecimalFault::kNone)
      return "needs three decimals, fractions or hexadecimal numbers X,Y,Z, and has '" + token +
             "'";
    begin = end + 1;
  }
  return "";
}

ExactPoint origin_for(const PatchComplex& complex, const ChainOrigin& origin) {
  return origin.is_auto ? OriginCosts(complex).best().origin : origin.point;
}

}  // namespace veritope::cli
