// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/micro_grid.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace veritope {
namespace {

std::vector<Rational> different_knots(const KnotAxis<Rational>& axis) {
  std::vector<Rational> out;
  for (const Rational& t : axis.knots)
    if (axis.domain_begin() <= t && t <= axis.domain_end() && (out.empty() || out.back() < t))
      out.push_back(t);
  return out;
}

// How many of `count` intervals each span has.
std::vector<std::uint64_t> shares_of(const std::vector<Rational>& knots, std::uint64_t count) {
  const std::size_t spans = knots.size() - 1;
  const Rational length = knots.back() - knots.front(), more = Rational(Integer(count - spans));
  std::vector<std::uint64_t> shares;
  std::vector<Rational> remainders;
  for (std::size_t s = 0; s < spans; ++s) {
    const Rational share = more * (knots[s + 1] - knots[s]) / length;
    const Integer whole = floor_divide(share.numerator(), share.denominator());
    shares.push_back(1 + static_cast<std::uint64_t>(whole.to_int64()));
    remainders.push_back(share - Rational(whole));
  }
  std::vector<std::size_t> order(spans);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return remainders[a] > remainders[b]; });
  std::uint64_t left = count - std::accumulate(shares.begin(), shares.end(), std::uint64_t{0});
  for (std::size_t k = 0; left > 0; ++k, --left) ++shares[order[k]];
  return shares;
}

}  // namespace

Result<MicroGrid> make_micro_grid(const VVolume& volume, std::uint32_t number,
                                  const std::array<std::uint64_t, 3>& counts) {
  MicroGrid out;
  out.volume = number;
  std::uint64_t cells = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::vector<Rational> knots = different_knots(volume.axis(a));
    const std::uint64_t spans = knots.size() - 1;
    if (counts[a] < spans)
      return bad_argument(std::to_string(counts[a]) + " cells along axis " + "uvw"[a] +
                          " of volume " + std::to_string(number) + " are fewer than its " +
                          std::to_string(spans) + " spans between knots");
    if (counts[a] > kMaxMicroCells / cells)
      return Error{Code::kOverLimit,
                   {},
                   "more than " + std::to_string(kMaxMicroCells) + " cells in volume " +
                       std::to_string(number)};
    cells *= counts[a];
    const std::vector<std::uint64_t> shares = shares_of(knots, counts[a]);
    for (std::size_t s = 0; s < spans; ++s)
      for (std::uint64_t i = 0; i < shares[s]; ++i)
        out.breaks[a].push_back(knots[s] + (knots[s + 1] - knots[s]) * Rational(Integer(i)) /
                                               Rational(Integer(shares[s])));
    out.breaks[a].push_back(knots.back());
  }
  out.tiles.assign(cells, 0);
  return out;
}

Result<std::vector<MicroGrid>> make_micro_grids(
    const std::vector<VVolume>& cage, const std::vector<std::array<std::uint64_t, 3>>& counts,
    std::uint64_t max_cells) {
  std::vector<MicroGrid> grids;
  std::uint64_t left = max_cells;
  for (std::uint32_t v = 0; v < cage.size(); ++v) {
    const std::array<std::uint64_t, 3>& own = counts[counts.size() == 1 ? 0 : v];
    std::uint64_t cells = 1;
    for (const std::uint64_t n : own) {
      if (n != 0 && cells > left / n)
        return Error{Code::kOverLimit, {}, "more than " + std::to_string(max_cells) + " cells"};
      cells *= n;
    }
    left -= cells;
    Result<MicroGrid> grid = make_micro_grid(cage[v], v, own);
    if (!grid) return grid.error();
    grids.push_back(std::move(*grid));
  }
  return grids;
}

}  // namespace veritope
