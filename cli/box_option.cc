// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/box_option.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "io/base/exact_number.h"

namespace veritope::cli {
namespace {

// A decimal is rounded to the nearest binary64 number, as coordinates of meshes and points are.
std::string take_bound(const std::string& token, Rational& value) {
  const DecimalFault fault = read_exact_number(token, {}, value);
  if (fault != DecimalFault::kNone)
    return "needs six decimals, fractions or hexadecimal numbers X0,Y0,Z0,X1,Y1,Z1, and has '" +
           token + "'";
  if (token.find_first_of("xX/") != token.npos) return "";
  const double near = nearest_double(value);
  if (near - near != 0) return "has '" + token + "', which is beyond binary64";
  value = Rational::from_double(near);
  return "";
}

}  // namespace

std::string take_box(const std::string& text, std::optional<ExactBox<3>>& box) {
  std::vector<Rational> bounds;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (std::string wrong = take_bound(text.substr(begin, end - begin), bounds.emplace_back());
        !wrong.empty())
      return wrong;
    begin = end + 1;
  }
  if (bounds.size() != 6)
    return "needs six bounds X0,Y0,Z0,X1,Y1,Z1, and there are " + std::to_string(bounds.size());
  box.emplace();
  for (std::size_t k = 0; k < 3; ++k) {
    if (bounds[k + 3] <= bounds[k]) return "has no interior: " + text;
    (*box)[k] = {std::move(bounds[k]), std::move(bounds[k + 3])};
  }
  return "";
}

}  // namespace veritope::cli
