// SPDX-License-Identifier: LGPL-3.0-or-later
// I3: behind each void's surface a point that is not in the microstructure.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "interval/upward.h"
#include "solids/micro/inside/cage_inverse_internal.h"
#include "solids/micro/inside/inside_parts_internal.h"
#include "solids/micro/sweep_nodes.h"
#include "solids/micro/sweep_start.h"
#include "splines/bezier_domain.h"

namespace veritope::internal {

namespace {

constexpr std::size_t kMaxSources = 64;  // spots of a void near which points are tried
// The page lets a checker visit 2^22 nodes, and 64 more for each entry.
constexpr std::size_t kAllNodes = std::size_t{1} << 21, kNodesOfVoid = 32;
constexpr std::size_t kMaxNodes = 32768;  // of the descents of F2; the page has 65,536
constexpr int kMaxExitDepth = 39;         // the page has 40
constexpr std::size_t kMaxWordBits = 63;  // B2 of the page has 64

struct ParameterBox {
  TilePoint lo, hi;
};

bool are_words(const TilePoint& x) {
  return std::all_of(x.begin(), x.end(), [](const Rational& r) {
    return r.numerator().bit_length() <= kMaxWordBits &&
           r.denominator().bit_length() <= kMaxWordBits;
  });
}

class VoidSearch {
 public:
  explicit VoidSearch(const InsideParts& parts) : parts_(parts), inverse_(parts) {
    const SweepStarts starts(parts.micro, parts.tiles);
    const ScopedUpward upward;
    for (const MicroSweep& s : parts.micro.sweeps)
      sweeps_.push_back(SweepNodes(starts.wall(s.cap), starts.cap(s.cap).value(), s.axis).box({}));
  }

  std::optional<VoidPoint> find(std::uint32_t shell) {
    shell_ = shell;
    for (const Point3d& q : sources())
      for (const CageParameters& at : inverse_.all(q)) {
        if (auto found = at_or_near(at)) return found;
      }
    return std::nullopt;
  }

 private:
  bool is_in_void(const PointAnswer& answer) const {
    return answer.is_decided && !answer.is_on() && answer.shell == shell_;
  }

  // Points of the hole, those far from its surface first; then those near its surface.
  std::vector<Point3d> sources() const {
    const Box3d box = parts_.solid.box_of_shell(shell_);
    std::vector<Point3d> out;
    const auto add = [&](const Point3d& q) {
      if (std::isfinite(q[0] + q[1] + q[2]) &&
          is_in_void(parts_.solid.classify(ExactPoint{Rational::from_double(q[0]),
                                                      Rational::from_double(q[1]),
                                                      Rational::from_double(q[2])})))
        out.push_back(q);
    };
    for (const int side : {1, 3, 5})
      for (int i = 1; i <= side; ++i)
        for (int j = 1; j <= side; ++j)
          for (int k = 1; k <= side; ++k) {
            const auto along = [&](std::size_t c, int n) {
              const double t = static_cast<double>(n) / (side + 1);
              return (1 - t) * box.lo[c] + t * box.hi[c];
            };
            add({along(0, i), along(1, j), along(2, k)});
          }
    for (const SurfaceSpot& spot : parts_.solid.spots(shell_, kMaxSources))
      for (const double distance : {0.5, 0.1, 1e-2, 1e-4, 1e-7}) {
        Point3d q = spot.at;
        for (std::size_t c = 0; c < 3; ++c) q[c] += distance * spot.size * spot.normal[c];
        add(q);
      }
    return out;
  }
  // The point itself, or one that differs by little and has shorter numbers.
  std::optional<VoidPoint> at_or_near(const CageParameters& at) {
    for (const int bits : {8, 16, 30, 44}) {
      TilePoint x;
      for (std::size_t a = 0; a < 3; ++a) {
        if (!std::isfinite(at.x[a])) return std::nullopt;
        const double unit = std::ldexp(at.scale[a], -bits);
        x[a] = Rational::from_double(std::nearbyint(at.x[a] / unit) * unit);
      }
      if (auto found = test(at.volume, x)) return found;
    }
    return std::nullopt;
  }

  std::optional<VoidPoint> test(std::uint32_t volume, const TilePoint& x) {
    if (!are_words(x)) return std::nullopt;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& knots = parts_.volumes[volume].knots(a);
      if (!(knots.front() < x[a] && x[a] < knots.back())) return std::nullopt;
    }
    if (is_near_bridge(volume, x)) return std::nullopt;
    const auto place = place_of(volume, x);
    if (!place) return std::nullopt;
    const ExactPoint image = parts_.volumes[volume].image(x);
    if (is_near_sweep(image) || !is_in_void(parts_.solid.classify(image))) return std::nullopt;
    VoidPoint out{volume, x, 8};
    if (place->cell == kEmpty) return out;
    const auto corner = free_corner(*place, x);
    if (!corner) return std::nullopt;
    out.corner = *corner;
    return out;
  }

  bool is_near_sweep(const ExactPoint& image) const {
    return std::any_of(sweeps_.begin(), sweeps_.end(), [&](const Box3d& box) {
      for (std::size_t c = 0; c < 3; ++c)
        if (image[c] < Rational::from_double(box.lo[c]) ||
            Rational::from_double(box.hi[c]) < image[c])
          return false;
      return true;
    });
  }
  bool is_near_bridge(std::uint32_t volume, const TilePoint& x) const {
    for (const MicroBridge& b : parts_.micro.bridges) {
      if (b.volume != volume) continue;
      bool is_in = true;
      for (std::size_t c = 0; c < 3 && is_in; ++c) {
        const auto less = [c](const TilePoint& p, const TilePoint& q) { return p[c] < q[c]; };
        const auto [lo, hi] = std::minmax_element(b.points.begin(), b.points.end(), less);
        is_in = (*lo)[c] <= x[c] && x[c] <= (*hi)[c];
      }
      if (is_in) return true;
    }
    return false;
  }

  static constexpr std::uint64_t kEmpty = 0xffffffffffffffff;
  struct CellPlace {
    std::uint32_t grid = 0;
    std::uint64_t cell = kEmpty;  // or the cell with a tile
  };
  // The open cell with a tile that holds x, or that no closed cell with a tile does; nothing if x is on a wall of one.
  std::optional<CellPlace> place_of(std::uint32_t volume, const TilePoint& x) const {
    for (std::uint32_t g = 0; g < parts_.micro.grids.size(); ++g) {
      const MicroGrid& grid = parts_.micro.grids[g];
      if (grid.volume != volume) continue;
      std::array<std::size_t, 3> first{}, past{};
      bool is_in = true, is_open = true;
      for (std::size_t a = 0; a < 3; ++a) {
        const auto& breaks = grid.breaks[a];
        if (x[a] < breaks.front() || breaks.back() < x[a]) is_in = false;
        // The closed intervals that hold x[a].
        const auto [lo, hi] = std::equal_range(breaks.begin(), breaks.end(), x[a]);
        const auto index = static_cast<std::size_t>(lo - breaks.begin());
        first[a] = index == 0 ? 0 : index - 1;
        past[a] = std::min(static_cast<std::size_t>(hi - breaks.begin()), breaks.size() - 1);
        is_open = is_open && lo == hi;
      }
      if (!is_in) continue;
      for (std::size_t i = first[0]; i < past[0]; ++i)
        for (std::size_t j = first[1]; j < past[1]; ++j)
          for (std::size_t k = first[2]; k < past[2]; ++k) {
            const std::uint64_t cell = grid.shape().at({i, j, k});
            if (grid.tiles[cell] == 0) continue;
            if (!is_open) return std::nullopt;
            return CellPlace{g, cell};
          }
    }
    return CellPlace{};
  }

  // A corner of the cell to which a box leads from x that misses the tile.
  std::optional<std::uint8_t> free_corner(const CellPlace& place, const TilePoint& x) {
    const MicroGrid& grid = parts_.micro.grids[place.grid];
    const auto at = grid.shape().index_of(place.cell);
    TilePoint u;  // in the unit cube
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& breaks = grid.breaks[a];
      u[a] = (x[a] - breaks[at[a]]) / (breaks[at[a] + 1] - breaks[at[a]]);
    }
    const auto& patches = parts_.micro.tiles[grid.tiles[place.cell] - 1u].patches;
    std::vector<BezierSurface<Rational>> maps;
    for (std::uint32_t p = 0; p < patches.size(); ++p) {
      std::vector<Rational> c;
      const auto points = parts_.exact_points({place.grid, place.cell, p});
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const TilePoint& q : points) c.push_back(q[axis]);
      maps.emplace_back(patches[p].degrees, 3, false, std::move(c));
    }
    const std::size_t most = std::min(kMaxNodes, left_ + kNodesOfVoid);
    for (const std::uint8_t corner : corners_near(u)) {
      std::size_t visited = 0;
      if (!misses(maps, box_to(u, corner), most, &visited)) continue;
      left_ -= visited > kNodesOfVoid ? visited - kNodesOfVoid : 0;
      return corner;
    }
    return std::nullopt;
  }
  // The corners of the cube, those on the nearer sides first.
  static std::array<std::uint8_t, 8> corners_near(const TilePoint& u) {
    unsigned nearest = 0;
    for (std::size_t a = 0; a < 3; ++a)
      if (Rational(1) < u[a] + u[a]) nearest |= 1u << a;
    std::array<std::uint8_t, 8> out{};
    for (unsigned i = 0; i < 8; ++i) {
      constexpr std::array<unsigned, 8> kFew = {0, 1, 2, 4, 3, 5, 6, 7};
      out[i] = static_cast<std::uint8_t>(nearest ^ kFew[i]);
    }
    return out;
  }
  static ParameterBox box_to(const TilePoint& u, unsigned corner) {
    ParameterBox box{u, u};
    for (std::size_t a = 0; a < 3; ++a)
      if ((corner >> a & 1) != 0)
        box.hi[a] = Rational(1);
      else
        box.lo[a] = Rational(0);
    return box;
  }
  static bool is_apart(const BezierSurface<Rational>& s, const ParameterBox& box) {
    for (int c = 0; c < 3; ++c) {
      const auto k = static_cast<std::size_t>(c);
      const auto [lo, hi] = std::minmax_element(s.component(c).begin(), s.component(c).end());
      if (box.hi[k] < *lo || *hi < box.lo[k]) return true;
    }
    return false;
  }
  // The descents of F2, with a box in the place of the segment.
  static bool misses(const std::vector<BezierSurface<Rational>>& maps, const ParameterBox& box,
                     std::size_t most, std::size_t* visited) {
    const Rational half = Rational(1) / Rational(2);
    for (const auto& map : maps) {
      std::vector<std::pair<BezierSurface<Rational>, int>> stack = {{map, 0}};
      while (!stack.empty()) {
        if (++*visited > most) return false;
        const auto [node, level] = std::move(stack.back());
        stack.pop_back();
        if (is_apart(node, box)) continue;
        // A corner of the node in the box ends the search early.
        if (level >= kMaxExitDepth || has_corner_in(node, box)) return false;
        const auto axis = static_cast<std::size_t>(level % 2);
        stack.emplace_back(restricted(node, axis, Rational(0), half), level + 1);
        stack.emplace_back(restricted(node, axis, half, Rational(1)), level + 1);
      }
    }
    return true;
  }
  static bool has_corner_in(const BezierSurface<Rational>& s, const ParameterBox& box) {
    const std::size_t n = s.grid().count(), columns = s.grid().size[1];
    for (const std::size_t i : {std::size_t{0}, columns - 1, n - columns, n - 1}) {
      bool is_in = true;
      for (std::size_t c = 0; c < 3 && is_in; ++c) {
        const Rational& x = s.component(static_cast<int>(c))[i];
        is_in = box.lo[c] <= x && x <= box.hi[c];
      }
      if (is_in) return true;
    }
    return false;
  }

  const InsideParts& parts_;
  CageInverse inverse_;
  std::vector<Box3d> sweeps_;  // around them
  std::uint32_t shell_ = 0;
  std::size_t left_ = kAllNodes;
};

}  // namespace

std::optional<InsideDefect> void_defect(const InsideParts& parts, std::vector<VoidPoint>* out) {
  const auto& depth = parts.solid.depths();
  std::optional<VoidSearch> search;
  for (std::uint32_t s = 0; s < depth.size(); ++s) {
    if (depth[s] % 2 == 0) continue;
    if (!search) search.emplace(parts);
    if (auto found = search->find(s)) {
      out->push_back(std::move(*found));
      continue;
    }
    const std::uint32_t first = parts.solid.first_source(s);
    return InsideDefect{"I3",
                        {},
                        {},
                        first,
                        "no point was found in the void of the solid behind " +
                            parts.solid.name(first) +
                            " that is proved not to be in the microstructure"};
  }
  return std::nullopt;
}

}  // namespace veritope::internal
