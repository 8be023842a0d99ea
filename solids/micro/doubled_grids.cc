// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/doubled_grids.h"

#include <string>
#include <utility>

#include "solids/micro/micro_grid.h"

namespace veritope {
namespace {

std::vector<Rational> halved_breaks(const std::vector<Rational>& breaks) {
  std::vector<Rational> out = {breaks.front()};
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    out.push_back((breaks[i - 1] + breaks[i]) / Rational(2));
    out.push_back(breaks[i]);
  }
  return out;
}

}  // namespace

Result<std::vector<MicroGrid>> make_doubled_grids(const std::vector<VVolume>& cage,
                                                  const std::array<std::uint64_t, 3>& counts,
                                                  std::uint64_t layer, std::uint64_t max_cells) {
  if (layer < 1 || layer >= counts[2])
    return bad_argument("the layer " + std::to_string(layer) +
                        " from which cells are doubled is not from 1 to " +
                        std::to_string(counts[2] - 1));
  if (2 * cage.size() > kMaxMicroGrids)
    return Error{Code::kOverLimit,
                 {},
                 "more than " + std::to_string(kMaxMicroGrids / 2) + " volumes with two grids"};
  std::vector<MicroGrid> out;
  std::uint64_t cells = 0;
  for (std::uint32_t v = 0; v < cage.size(); ++v) {
    Result<MicroGrid> whole = make_micro_grid(cage[v], v, counts);
    if (!whole) return whole.error();
    MicroGrid fine = *whole;
    const auto cut = whole->breaks[2].begin() + static_cast<std::ptrdiff_t>(layer);
    fine.breaks = {halved_breaks(whole->breaks[0]), halved_breaks(whole->breaks[1]),
                   std::vector<Rational>(cut, whole->breaks[2].end())};
    whole->breaks[2].erase(cut + 1, whole->breaks[2].end());
    for (MicroGrid* const grid : {&*whole, &fine}) {
      const auto count = grid->shape().count_up_to(max_cells - cells);
      if (!count || *count > max_cells - cells)
        return Error{Code::kOverLimit, {}, "more than " + std::to_string(max_cells) + " cells"};
      cells += *count;
      grid->tiles.assign(*count, 0);
      out.push_back(std::move(*grid));
    }
  }
  return out;
}

bool is_before_doubling(const VVolume& volume, const MicroGrid& grid, std::uint64_t cell) {
  return grid.breaks[2].back() != volume.axis(2).domain_end() &&
         grid.shape().index_of(cell)[2] + 2 == grid.breaks[2].size();
}

}  // namespace veritope
