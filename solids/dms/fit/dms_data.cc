// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/dms_data.h"

#include <algorithm>
#include <numeric>

namespace veritope {

std::vector<std::size_t> find_conflicts(const DmsData& data) {
  std::vector<std::size_t> order(data.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return data.points[a] != data.points[b] ? data.points[a] < data.points[b] : a < b;
  });
  const auto agree = [&](std::size_t a, std::size_t b) {
    for (std::size_t k = 0; k < data.num_attributes; ++k)
      if (data.value(a, k) != data.value(b, k)) return false;
    return true;
  };
  std::vector<std::size_t> found;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    bool is_one = true;
    for (end = begin; end < order.size() && data.points[order[end]] == data.points[order[begin]];
         ++end)
      is_one = is_one && agree(order[begin], order[end]);
    if (!is_one) found.insert(found.end(), &order[begin], &order[begin] + (end - begin));
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace veritope
