// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "solids/micro/cage/scale_floor_internal.h"
#include "solids/vmodel/jacobian_net.h"
#include "splines/de_casteljau.h"

namespace veritope::internal {
namespace {

bool is_large(const BezierVolume<double>& scale, double least, int halvings) {
  const auto values = scale.coefficients();
  if (*std::min_element(values.begin(), values.end()) >= least) return true;
  const Grid<3> grid = scale.grid();
  for (unsigned corner = 0; corner < 8; ++corner) {
    std::array<std::size_t, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = (corner >> k & 1) == 0 ? 0 : grid.size[k] - 1;
    if (values[grid.at(at)] < least) return false;
  }
  if (halvings == 0) return false;
  const auto [first, second] = split(scale, static_cast<std::size_t>(halvings % 3), 0.5);
  return is_large(first, least, halvings - 1) && is_large(second, least, halvings - 1);
}

}  // namespace

bool has_scale(const BezierVolume<double>& map, double least, int halvings) {
  std::array<int, 3> degrees;
  for (std::size_t k = 0; k < 3; ++k) degrees[k] = 3 * static_cast<int>(map.grid().size[k] - 1) - 1;
  return is_large(BezierVolume<double>(degrees, 1, false, plain_jacobian(map)), least, halvings);
}

}  // namespace veritope::internal
