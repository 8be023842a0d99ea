// SPDX-License-Identifier: LGPL-3.0-or-later
// Six surfaces as the faces of a cuboid layout: a search over the faces and the 8 symmetries of a square.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "solids/volumes/boolean_sum.h"
#include "splines/bspline_domain.h"

namespace veritope {
namespace {

// A surface in one of 8 orientations: the axes change places first, then each may be reversed.
struct Oriented {
  std::size_t surface = 0;
  bool is_swapped = false;
  std::array<bool, 2> is_reversed{};
};

// Side `end` across `axis` of an oriented surface: its number among the 24 sides, and whether it runs backwards.
struct SideUse {
  std::size_t side;
  bool is_reversed;
};
SideUse side_use(const Oriented& o, std::size_t axis, std::size_t end) {
  const std::size_t old_axis = o.is_swapped ? 1 - axis : axis;
  const std::size_t old_end = o.is_reversed[axis] ? 1 - end : end;
  return {4 * o.surface + 2 * old_axis + old_end, o.is_reversed[1 - axis]};
}

bool are_same(const CellCurve& a, const CellCurve& b) {
  if (a.dimension() != b.dimension()) return false;
  const auto both = in_one_space<1>({a, b});
  return both && internal::factor_between((*both)[0], (*both)[1]);
}

class Layout {
 public:
  explicit Layout(const SixFaces& surfaces) : surfaces_(surfaces) {
    std::vector<CellCurve> sides;
    for (CellSurface& s : surfaces_) {
      s = clamped(clamped(s, 0), 1);
      for (std::size_t k = 0; k < 4; ++k) sides.push_back(side_of(s, k / 2, k % 2));
    }
    for (std::size_t i = 0; i < 24; ++i)
      for (std::size_t j = 0; j < 24; ++j) {
        if (i / 4 == j / 4) continue;
        same_[i][j][0] = are_same(sides[i], sides[j]);
        same_[i][j][1] = are_same(sides[i], reversed(sides[j], 0));
      }
  }

  std::optional<SixFaces> find() {
    roles_[4] = Oriented{};
    if (!place(0)) return std::nullopt;
    SixFaces out = surfaces_;
    for (std::size_t f = 0; f < 6; ++f) {
      const Oriented& o = *roles_[f];
      CellSurface s = surfaces_[o.surface];
      if (o.is_swapped) s = swapped(s, 0, 1);
      for (std::size_t a = 0; a < 2; ++a)
        if (o.is_reversed[a]) s = reversed(s, a);
      out[f] = std::move(s);
    }
    return out;
  }

 private:
  // The places after w0, each next to one that is filled before.
  static constexpr std::array<std::size_t, 5> kOrder = {0, 2, 1, 3, 5};

  bool place(std::size_t next) {
    if (next == kOrder.size()) return true;
    const std::size_t f = kOrder[next];
    for (std::size_t choice = 8; choice < 48; ++choice) {
      const std::size_t surface = choice / 8;
      const bool is_used = std::any_of(roles_.begin(), roles_.end(),
                                       [&](const auto& o) { return o && o->surface == surface; });
      if (is_used) continue;
      roles_[f] = Oriented{surface, (choice & 1) != 0, {(choice & 2) != 0, (choice & 4) != 0}};
      if (fits(f) && place(next + 1)) return true;
      roles_[f].reset();
    }
    return false;
  }

  bool fits(std::size_t f) const {
    const std::size_t a = f / 2;
    for (std::size_t g = 0; g < 6; ++g) {
      const std::size_t b = g / 2;
      if (a == b || !roles_[g]) continue;
      const SideUse x = side_use(*roles_[f], b < a ? b : b - 1, g % 2),
                    y = side_use(*roles_[g], a < b ? a : a - 1, f % 2);
      if (!same_[x.side][y.side][x.is_reversed == y.is_reversed ? 0 : 1]) return false;
    }
    return true;
  }

  SixFaces surfaces_;
  std::array<std::array<std::array<bool, 2>, 24>, 24> same_{};
  std::array<std::optional<Oriented>, 6> roles_;
};

}  // namespace

Result<CellVolume> boolean_sum_in_any_order(const SixFaces& surfaces) {
  for (const CellSurface& s : surfaces)
    if (const Status in = check_cell_surface(s); !in) return in.error();
  const auto faces = Layout(surfaces).find();
  if (!faces)
    return bad_argument("faces are not those of a cuboid: their sides do not agree in pairs");
  Result<CellVolume> volume = boolean_sum(*faces);
  if (volume && hand_in_the_middle(*volume) == Sign::kNegative) return swapped(*volume, 0, 1);
  return volume;
}

}  // namespace veritope
