// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/tile_analysis.h"

#include <algorithm>
#include <string>
#include <utility>

#include "robust/base/disjoint_sets.h"
#include "solids/micro/tile_caps_internal.h"
#include "solids/vmodel/v_model.h"
#include "splines/bezier_domain.h"

namespace veritope {
namespace {

constexpr std::size_t kMaxCentres = 100;    // that are tried
constexpr std::size_t kMaxCentreBits = 64;  // of numerators and denominators: B2 of the page

using Family = BezierVolume<Rational>;
using Member = BezierSurface<Rational>;  // a patch for the least number of the range

// F1 for one patch.
bool turns_around(const Family& family, const TileSurface& surface, std::size_t patch,
                  const TilePoint& a) {
  const Family g = star_product(family, a);
  const auto rows = static_cast<std::size_t>(g.degree(0)),
             columns = static_cast<std::size_t>(g.degree(1)),
             indices = static_cast<std::size_t>(g.degree(2)) + 1;
  const std::array<bool, kTileSides> is_left_out = {
      surface.is_collapsed(patch, 0), surface.is_collapsed(patch, 1),
      surface.is_collapsed(patch, 2), surface.is_collapsed(patch, 3)};
  for (std::size_t s = 0; s < kTileSides; ++s)
    if (is_left_out[s] && is_left_out[(s + 1) % kTileSides]) return false;
  for (std::size_t i = 0; i <= rows; ++i)
    for (std::size_t j = 0; j <= columns; ++j) {
      if ((j == 0 && is_left_out[0]) || (i == rows && is_left_out[1]) ||
          (j == columns && is_left_out[2]) || (i == 0 && is_left_out[3]))
        continue;
      for (std::size_t k = 0; k < indices; ++k)
        if (g.component(0)[(i * (columns + 1) + j) * indices + k].sign() != Sign::kPositive)
          return false;
    }
  return true;
}

// The middle of a parallelogram; nothing for another patch.
std::optional<TilePoint> middle_of_parallelogram(const Member& s) {
  if (s.degrees() != std::array<int, 2>{1, 1}) return std::nullopt;
  TilePoint m;
  for (int c = 0; c < 3; ++c) {
    const auto p = s.component(c);
    if (p[0] + p[3] != p[1] + p[2]) return std::nullopt;
    m[static_cast<std::size_t>(c)] = (p[0] + p[3]) / Rational(2);
  }
  return m;
}
// Where the ray from a through m leaves the unit cube, if that is straight along an axis.
std::optional<TilePoint> end_of_ray(const TilePoint& a, const TilePoint& m) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto others = v_face_axes(axis);
    if (m[axis] == a[axis] || m[others[0]] != a[others[0]] || m[others[1]] != a[others[1]])
      continue;
    TilePoint end = a;
    end[axis] = Rational(m[axis] < a[axis] ? 0 : 1);
    return end;
  }
  return std::nullopt;
}

bool box_misses(const Member& s, const TilePoint& a, const TilePoint& m) {
  for (int c = 0; c < 3; ++c) {
    const auto x = s.component(c);
    const auto [lo, hi] = std::minmax_element(x.begin(), x.end());
    const auto k = static_cast<std::size_t>(c);
    if (*lo > std::max(a[k], m[k]) || *hi < std::min(a[k], m[k])) return true;
  }
  return false;
}
// The descent of F2.
bool misses_segment(const Member& s, const TilePoint& a, const TilePoint& m, std::size_t& visited) {
  std::vector<std::pair<Member, int>> stack = {{s, 0}};
  while (!stack.empty()) {
    if (++visited > kMaxExitNodes) return false;
    const auto [node, level] = std::move(stack.back());
    stack.pop_back();
    if (box_misses(node, a, m)) continue;
    if (level == kMaxExitLevel) return false;
    const std::size_t axis = static_cast<std::size_t>(level % 2);
    const Rational half = Rational(1) / Rational(2);
    stack.push_back({restricted(node, axis, Rational(0), half), level + 1});
    stack.push_back({restricted(node, axis, half, Rational(1)), level + 1});
  }
  return true;
}

bool may_be_centre(const TilePoint& a) {
  return std::all_of(a.begin(), a.end(), [](const Rational& x) {
    return Rational(0) < x && x < Rational(1) && x.denominator().bit_length() <= kMaxCentreBits;
  });
}

class StarSearch {
 public:
  StarSearch(const std::vector<Family>& families, const TileSurface& surface)
      : families_(families), surface_(surface) {
    for (const Family& f : families) members_.push_back(boundary(f, 2, 0));
  }
  // The star, or what is against the first candidate for its centre.
  std::variant<TileStar, TileDefect> run() const {
    std::optional<TileDefect> first;
    for (const TilePoint& a : candidates()) {
      std::variant<TileStar, TileDefect> star = star_about(a);
      if (std::holds_alternative<TileStar>(star)) return star;
      if (!first.has_value()) first = std::get<TileDefect>(std::move(star));
    }
    return *first;
  }

 private:
  // The middle of the cube, then points straight behind the middles of parallelograms.
  std::vector<TilePoint> candidates() const {
    const Rational half = Rational(1) / Rational(2);
    std::vector<TilePoint> out = {{half, half, half}};
    for (const Member& s : members_) {
      const auto m = middle_of_parallelogram(s);
      if (!m.has_value()) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (out.size() > kMaxCentres) return out;
        for (const int sixteenth : {8, 4, 12, 2, 6, 10, 14}) {
          TilePoint a = *m;
          a[axis] = Rational(sixteenth) / Rational(16);
          if (may_be_centre(a) && std::find(out.begin(), out.end(), a) == out.end())
            out.push_back(std::move(a));
        }
      }
    }
    return out;
  }
  std::variant<TileStar, TileDefect> star_about(const TilePoint& a) const {
    for (std::uint32_t p = 0; p < families_.size(); ++p)
      if (!turns_around(families_[p], surface_, p, a))
        return TileDefect{"F1", p, std::nullopt,
                          "the tile is not proved to be star-shaped about (" + a[0].to_string() +
                              ", " + a[1].to_string() + ", " + a[2].to_string() + "): patch " +
                              std::to_string(p)};
    for (std::uint32_t p = 0; p < members_.size(); ++p)
      if (is_exit(p, a)) return TileStar{a, p};
    return TileDefect{"F2", std::nullopt, std::nullopt,
                      "no parallelogram has its middle straight ahead of the centre (" +
                          a[0].to_string() + ", " + a[1].to_string() + ", " + a[2].to_string() +
                          ") with nothing else before the wall"};
  }
  bool is_exit(std::uint32_t patch, const TilePoint& a) const {
    const auto m = middle_of_parallelogram(members_[patch]);
    if (!m.has_value()) return false;
    const auto end = end_of_ray(a, *m);
    if (!end.has_value()) return false;
    std::size_t visited = 0;
    for (std::uint32_t p = 0; p < members_.size(); ++p)
      if (p != patch && !misses_segment(members_[p], a, *end, visited)) return false;
    return true;
  }

  const std::vector<Family>& families_;
  const TileSurface& surface_;
  std::vector<Member> members_;
};

}  // namespace

std::variant<AnalysedTile, TileDefect> analyse_tile(const MicroTile& tile) {
  AnalysedTile out;
  out.tile = tile;
  std::variant<TileSurface, TileDefect> surface = surface_of(tile);
  if (auto* defect = std::get_if<TileDefect>(&surface)) return std::move(*defect);
  out.surface = std::get<TileSurface>(std::move(surface));
  std::vector<Family> families;
  for (const TilePatch& patch : tile.patches) families.push_back(family_of(patch, tile.range));
  out.star = StarSearch(families, out.surface).run();
  if (!out.is_star() && tile.range.has_value()) return std::get<TileDefect>(std::move(out.star));
  internal::find_caps(families, out);
  if (auto defect = internal::wall_defect(families, out)) return std::move(*defect);
  return out;
}

TileShells shells_without(const AnalysedTile& tile, std::uint64_t without) {
  const auto n = static_cast<std::uint32_t>(tile.surface.num_patches());
  const auto is_left_out = [&](std::uint32_t p) {
    const std::uint32_t cap = tile.cap_of_patch[p];
    return cap != AnalysedTile::kNoCap && (without >> cap & 1) != 0;
  };
  DisjointSets<> classes(n);
  for (std::uint32_t p = 0; p < n; ++p)
    for (std::size_t s = 0; s < kTileSides; ++s) {
      if (is_left_out(p) || tile.surface.is_collapsed(p, s)) continue;
      const auto mate =
          static_cast<std::uint32_t>(tile.surface.mates[kTileSides * p + s] / kTileSides);
      if (!is_left_out(mate)) classes.join(p, mate);
    }
  TileShells out;
  out.shell_of_patch.assign(n, AnalysedTile::kNoCap);
  for (std::uint32_t p = 0; p < n; ++p) {
    if (is_left_out(p)) continue;
    const std::uint32_t least = classes.find(p);
    out.shell_of_patch[p] = least == p ? out.count++ : out.shell_of_patch[least];
  }
  return out;
}

}  // namespace veritope
