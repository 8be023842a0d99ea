// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "robust/base/disjoint_sets.h"
#include "solids/micro/tile_caps_internal.h"
#include "solids/vmodel/v_parts.h"

namespace veritope {
namespace {

using Family = BezierVolume<Rational>;

bool is_zero_everywhere(const Family& h) {
  const auto c = h.component(0);
  return std::all_of(c.begin(), c.end(), [](const Rational& x) { return x.sign() == Sign::kZero; });
}
bool is_positive_everywhere(const Family& h) {
  const auto c = h.component(0);
  return std::all_of(c.begin(), c.end(),
                     [](const Rational& x) { return x.sign() == Sign::kPositive; });
}

// Signs of the Bernstein coefficients of a height over a wall.
class Heights {
 public:
  Heights(const Family& family, int wall)
      : h_(height_over(family, wall)),
        degrees_{family.degree(0), family.degree(1)},
        num_indices_(static_cast<std::size_t>(family.degree(2)) + 1) {}

  bool has_negative() const {
    const auto c = h_.component(0);
    return std::any_of(c.begin(), c.end(),
                       [](const Rational& x) { return x.sign() == Sign::kNegative; });
  }
  bool is_zero() const { return is_zero_everywhere(h_); }
  // Whether for each index in t one of these control points is higher than the wall.
  template <typename Points>
  bool rises_on(const Points& points) const {
    for (std::size_t k = 0; k < num_indices_; ++k)
      if (std::none_of(points.begin(), points.end(), [&](std::size_t point) {
            return h_.component(0)[point * num_indices_ + k].sign() == Sign::kPositive;
          }))
        return false;
    return true;
  }
  std::vector<std::size_t> all_points() const {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < h_.component(0).size() / num_indices_; ++i) out.push_back(i);
    return out;
  }
  std::vector<std::size_t> side_points(std::size_t side) const {
    std::vector<std::size_t> out;
    for (int i = 0; i <= tile_side_degree(degrees_, side); ++i)
      out.push_back(tile_side_index(degrees_, side, static_cast<std::size_t>(i)));
    return out;
  }
  std::array<std::size_t, 1> corner_point(std::size_t corner) const {
    return {tile_side_index(degrees_, corner, 0)};
  }

 private:
  Family h_;
  std::array<int, 2> degrees_;
  std::size_t num_indices_;
};

std::string name_of_wall(int wall) { return v_face_name(static_cast<std::size_t>(wall)); }
TileDefect against(const char* condition, std::uint32_t patch, int wall, const std::string& what) {
  return {condition, patch, wall,
          "patch " + std::to_string(patch) + " " + what + " wall " + name_of_wall(wall)};
}

std::int64_t euler_of(const TileSurface& surface, const std::vector<std::uint32_t>& patches) {
  std::set<std::uint32_t> vertices, edges;
  for (const std::uint32_t p : patches)
    for (std::uint32_t s = 0; s < kTileSides; ++s) {
      vertices.insert(surface.vertex(p, s));
      const auto side = static_cast<std::uint32_t>(kTileSides * p + s);
      if (!surface.is_collapsed(p, s)) edges.insert(std::min(side, surface.mates[side]));
    }
  return static_cast<std::int64_t>(vertices.size()) - static_cast<std::int64_t>(edges.size()) +
         static_cast<std::int64_t>(patches.size());
}

// T2 and T3 for one wall.
class WallTest {
 public:
  WallTest(const std::vector<Family>& families, const AnalysedTile& tile, int wall)
      : families_(families), tile_(tile), wall_(wall), is_in_wall_(tile.surface.num_patches()) {
    for (const std::uint32_t cap : tile.caps_of_wall[static_cast<std::size_t>(wall)])
      for (const std::uint32_t p : tile.caps[cap].patches) {
        is_in_wall_[p] = true;
        for (std::size_t c = 0; c < kTileSides; ++c) rim_.insert(tile.surface.vertex(p, c));
      }
  }
  std::optional<TileDefect> run() const {
    for (std::uint32_t p = 0; p < is_in_wall_.size(); ++p)
      if (auto defect = is_in_wall_[p] ? inner_patch(p) : other_patch(p)) return defect;
    return crowded_vertex();
  }

 private:
  // A patch in the wall is strictly between the walls across the other two axes.
  std::optional<TileDefect> inner_patch(std::uint32_t p) const {
    for (const std::size_t axis : v_face_axes(static_cast<std::size_t>(wall_ / 2)))
      for (const int end : {0, 1}) {
        const int other = 2 * static_cast<int>(axis) + end;
        if (!is_positive_everywhere(height_over(families_[p], other)))
          return against("T2", p, wall_, "reaches wall " + name_of_wall(other) + " in");
      }
    return std::nullopt;
  }
  std::optional<TileDefect> other_patch(std::uint32_t p) const {
    const Heights h(families_[p], wall_);
    if (h.has_negative()) return against("T2", p, wall_, "is not proved to stay inside of");
    if (!h.rises_on(h.all_points())) return against("T2", p, wall_, "does not rise from");
    for (std::size_t s = 0; s < kTileSides; ++s) {
      if (tile_.surface.is_collapsed(p, s)) continue;
      const std::uint32_t mate = tile_.surface.mates[kTileSides * p + s];
      if (!is_in_wall_[mate / kTileSides] && !h.rises_on(h.side_points(s)))
        return against("T2", p, wall_, "has side " + std::to_string(s) + ", of no cap, in");
    }
    for (std::size_t c = 0; c < kTileSides; ++c)
      if (rim_.count(tile_.surface.vertex(p, c)) == 0 && !h.rises_on(h.corner_point(c)))
        return against("T2", p, wall_, "has corner " + std::to_string(c) + ", of no cap, in");
    return std::nullopt;
  }
  // T3. An edge between a patch in the wall and one outside has two ends.
  std::optional<TileDefect> crowded_vertex() const {
    std::vector<int> ends(tile_.surface.num_vertices);
    for (std::uint32_t p = 0; p < is_in_wall_.size(); ++p) {
      if (!is_in_wall_[p]) continue;
      for (std::size_t s = 0; s < kTileSides; ++s) {
        if (tile_.surface.is_collapsed(p, s)) continue;
        if (is_in_wall_[tile_.surface.mates[kTileSides * p + s] / kTileSides]) continue;
        for (const std::size_t c : {s, s + 1})
          if (++ends[tile_.surface.vertex(p, c)] > 2)
            return against("T3", p, wall_, "meets another part of its cap at a corner, in");
      }
    }
    return std::nullopt;
  }

  const std::vector<Family>& families_;
  const AnalysedTile& tile_;
  int wall_;
  std::vector<bool> is_in_wall_;
  std::set<std::uint32_t> rim_;  // vertices of the caps
};

}  // namespace

void internal::find_caps(const std::vector<BezierVolume<Rational>>& families, AnalysedTile& tile) {
  const auto n = static_cast<std::uint32_t>(families.size());
  std::vector<int> wall_of(n, -1);
  for (std::uint32_t p = 0; p < n; ++p)
    for (int wall = 0; wall < 6 && wall_of[p] < 0; ++wall)
      if (is_zero_everywhere(height_over(families[p], wall))) wall_of[p] = wall;
  DisjointSets<> classes(n);
  for (std::uint32_t p = 0; p < n; ++p)
    for (std::size_t s = 0; s < kTileSides; ++s) {
      if (tile.surface.is_collapsed(p, s)) continue;
      const auto mate =
          static_cast<std::uint32_t>(tile.surface.mates[kTileSides * p + s] / kTileSides);
      if (wall_of[p] >= 0 && wall_of[p] == wall_of[mate]) classes.join(p, mate);
    }
  tile.caps.clear();
  tile.cap_of_patch.assign(n, AnalysedTile::kNoCap);
  for (int wall = 0; wall < 6; ++wall) {
    auto& of_wall = tile.caps_of_wall[static_cast<std::size_t>(wall)];
    of_wall.clear();
    for (std::uint32_t p = 0; p < n; ++p) {
      if (wall_of[p] != wall) continue;
      const std::uint32_t least = classes.find(p);
      if (least == p) {
        tile.cap_of_patch[p] = static_cast<std::uint32_t>(tile.caps.size());
        of_wall.push_back(tile.cap_of_patch[p]);
        tile.caps.push_back({wall, {}, 0});
      }
      tile.cap_of_patch[p] = tile.cap_of_patch[least];
      tile.caps[tile.cap_of_patch[p]].patches.push_back(p);
    }
  }
  for (TileCap& cap : tile.caps) cap.euler = euler_of(tile.surface, cap.patches);
}

std::optional<TileDefect> internal::wall_defect(const std::vector<BezierVolume<Rational>>& families,
                                                const AnalysedTile& tile) {
  for (int wall = 0; wall < 6; ++wall)
    if (auto defect = WallTest(families, tile, wall).run()) return defect;
  return std::nullopt;
}

}  // namespace veritope
