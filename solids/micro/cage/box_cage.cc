// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/box_cage.h"

#include <string>
#include <utility>
#include <vector>

namespace veritope {

KnotAxis<Rational> cage_axis(const CageGrid& grid, std::size_t axis) {
  const auto ends = static_cast<std::size_t>(grid.degrees[axis]) + 1;
  KnotAxis<Rational> out{grid.degrees[axis], {}, false};
  out.knots.assign(ends, Rational(0));
  for (std::uint64_t i = 1; i < grid.spans[axis]; ++i) out.knots.emplace_back(i);
  out.knots.insert(out.knots.end(), ends, Rational(grid.spans[axis]));
  return out;
}

Status check_cage_grid(const CageGrid& grid) {
  std::uint64_t numbers = 3;
  for (const int degree : grid.degrees)
    if (degree < 1 || degree > kMaxCellDegree)
      return bad_argument("degrees must be from 1 to " + std::to_string(kMaxCellDegree) +
                          ", and one is " + std::to_string(degree));
  for (std::size_t k = 0; k < 3; ++k) {
    if (grid.spans[k] < 1 || grid.spans[k] > kMaxCageSpans)
      return bad_argument("spans must be from 1 to " + std::to_string(kMaxCageSpans) +
                          ", and one is " + std::to_string(grid.spans[k]));
    numbers *= grid.spans[k] + static_cast<std::uint64_t>(grid.degrees[k]);
  }
  if (numbers <= kMaxCellNumbers) return ok_status();
  return Error{Code::kOverLimit,
               {},
               "spans and degrees give " + std::to_string(numbers) +
                   " coefficients, and the limit is " + std::to_string(kMaxCellNumbers)};
}

Result<CellVolume> box_cage(const CageBox& box, const CageGrid& grid) {
  if (const Status fits = check_cage_grid(grid); !fits) return fits.error();
  for (std::size_t k = 0; k < 3; ++k)
    if (!(box.min[k] < box.max[k]))
      return bad_argument(std::string("min must be less than max, and in ") + "xyz"[k] +
                          " they are " + box.min[k].to_string() + " and " + box.max[k].to_string());
  std::array<KnotAxis<Rational>, 3> axes;
  std::array<std::vector<Rational>, 3> places;
  Grid<3> net;
  for (std::size_t k = 0; k < 3; ++k) {
    axes[k] = cage_axis(grid, k);
    net.size[k] = axes[k].num_control();
    for (const Rational& part : internal::rising(axes[k]))
      places[k].push_back(box.min[k] + (box.max[k] - box.min[k]) * part);
  }
  std::vector<Rational> all;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t n = 0; n < net.count(); ++n) all.push_back(places[k][net.index_of(n)[k]]);
  return CellVolume(std::move(axes), 3, false, std::move(all));
}

}  // namespace veritope
