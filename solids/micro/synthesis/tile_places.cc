// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/synthesis/tile_places.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "interval/upward.h"
#include "solids/micro/synthesis/formula_point_internal.h"
#include "splines/de_boor.h"

namespace veritope {

std::vector<Rational> internal::formula_values(const RealFormula& formula, const VVolume& volume,
                                               const std::array<Rational, 3>& at) {
  std::vector<Rational> out(3);
  if (formula.depends_on(0) || formula.depends_on(1) || formula.depends_on(2)) {
    const std::vector<Rational> p = point(volume, at).value();
    std::copy_n(p.begin(), 3, out.begin());
  }
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = volume.axis(a);
    out.push_back((at[a] - axis.domain_begin()) / (axis.domain_end() - axis.domain_begin()));
  }
  return out;
}

internal::FormulaBoundsOfCage::FormulaBoundsOfCage(const std::vector<VVolume>& cage) : cage_(cage) {
  const ScopedUpward upward;
  for (const VVolume& volume : cage) {
    std::vector<Interval> net;
    for (int c = 0; c < volume.num_components(); ++c)
      for (const Rational& x : volume.component(c)) net.push_back(enclose(x));
    std::array<KnotAxis<Rational>, 3> axes = {volume.axis(0), volume.axis(1), volume.axis(2)};
    maps_.emplace_back(std::move(axes), volume.num_components(), volume.is_rational(),
                       std::move(net));
  }
}

std::optional<std::vector<Interval>> internal::FormulaBoundsOfCage::operator()(
    const RealFormula& formula, std::size_t volume, const std::array<Rational, 3>& at) const {
  const ScopedUpward upward;
  std::vector<Interval> out(3);
  if (formula.depends_on(0) || formula.depends_on(1) || formula.depends_on(2)) {
    const auto p = evaluate(maps_[volume], at);
    if (!p) return std::nullopt;
    const bool is_rational = maps_[volume].is_rational();
    if (is_rational && (*p)[3].sign() != Sign3::kPositive) return std::nullopt;
    for (std::size_t c = 0; c < 3; ++c) out[c] = is_rational ? (*p)[c] / (*p)[3] : (*p)[c];
  }
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = cage_[volume].axis(a);
    out.push_back(
        enclose((at[a] - axis.domain_begin()) / (axis.domain_end() - axis.domain_begin())));
  }
  for (const Interval& x : out)
    if (!(mag(x) < HUGE_VAL)) return std::nullopt;
  return out;
}

Result<std::size_t> TilePlaces::operator()(const VVolume& volume, const MicroGrid& grid,
                                           std::uint64_t cell) {
  const auto place = grid.shape().index_of(cell);
  const auto about = [&](const std::string& what) {
    return bad_argument("cell (" + std::to_string(place[0]) + ", " + std::to_string(place[1]) +
                        ", " + std::to_string(place[2]) + ") of volume " +
                        std::to_string(grid.volume) + ": " + what);
  };
  std::array<Rational, 3> middle;
  for (std::size_t a = 0; a < 3; ++a)
    middle[a] = (grid.breaks[a][place[a]] + grid.breaks[a][place[a] + 1]) / Rational(2);
  const Result<RoundedValue> value =
      evaluator_.round_to_multiple(internal::formula_values(formula_, volume, middle),
                                   (std::uint64_t{grid.volume} << 40) + cell);
  if (!value) return about(value.error().message);
  if (value->open.has_value()) return about(value->open->message);
  const std::int64_t number = value->multiple >> kWallBits;  // rounds down
  if (number < 0 || number >= static_cast<std::int64_t>(num_tiles_))
    return about("the value " + std::to_string(value->multiple) + "/2^20 is the number " +
                 std::to_string(number) + " of a tile, and there are " +
                 std::to_string(num_tiles_) + ", from 0");
  return static_cast<std::size_t>(number);
}

}  // namespace veritope
