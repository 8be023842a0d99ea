// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/micro_view.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "splines/fast_spline.h"

namespace veritope {
namespace {

constexpr Colour kBridgedTileColour{226, 186, 60}, kCageColour{200, 40, 40};
constexpr std::size_t kCageEdgeParts = 48;
constexpr double kCageWidth = 2;

using Net = std::vector<Point3d>;

// Values of Bernstein polynomials of degree n at i / parts.
std::vector<double> bernstein(int n, double t) {
  std::vector<double> b(static_cast<std::size_t>(n) + 1, 0.0);
  b[0] = 1;
  for (int k = 1; k <= n; ++k)
    for (int i = k; i >= 0; --i) {
      const auto at = static_cast<std::size_t>(i);
      b[at] = (i < k ? b[at] * (1 - t) : 0) + (i > 0 ? b[at - 1] * t : 0);
    }
  return b;
}

// A grid of (parts + 1)^2 points of a tensor patch, the second parameter fastest.
std::vector<Point3d> sampled(const Net& net, int p, int q, std::size_t parts) {
  std::vector<std::vector<double>> u, v;
  for (std::size_t i = 0; i <= parts; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(parts);
    u.push_back(bernstein(p, t));
    v.push_back(bernstein(q, t));
  }
  std::vector<Point3d> out;
  out.reserve((parts + 1) * (parts + 1));
  for (const std::vector<double>& a : u)
    for (const std::vector<double>& b : v) {
      Point3d sum{};
      for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
          for (std::size_t c = 0; c < 3; ++c) sum[c] += a[i] * b[j] * net[i * b.size() + j][c];
      out.push_back(sum);
    }
  return out;
}

Net rounded_points(const std::vector<TilePoint>& points) {
  Net out;
  for (const TilePoint& p : points)
    out.push_back({nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])});
  return out;
}

// The wall of the unit cube in which all points of a patch lie.
std::optional<int> wall_of(const TilePatch& patch) {
  for (int wall = 0; wall < 6; ++wall) {
    const auto axis = static_cast<std::size_t>(wall / 2);
    const Rational height(wall % 2);
    bool lies = true;
    for (std::size_t l = 0; l < patch.points.size() && lies; ++l)
      lies = std::all_of(patch.points[l].begin(), patch.points[l].end(), [&](const TilePoint& p) {
        return p[axis] == (l == 0 ? height : Rational(0));
      });
    if (lies) return wall;
  }
  return std::nullopt;
}

class MicroPainter {
 public:
  MicroPainter(const Microstructure& micro, const MicroViewOptions& options)
      : micro_(micro), options_(options) {}

  Status prepare() {
    for (const VVolume& volume : micro_.cage) {
      auto made = FastSpline<3>::prepare(volume);
      if (!made) return made.error();
      maps_.push_back(std::move(*made));
    }
    for (const MicroTile& tile : micro_.tiles) {
      std::vector<std::optional<int>>& walls = walls_.emplace_back();
      for (const TilePatch& patch : tile.patches) walls.push_back(wall_of(patch));
    }
    return choose_parts();
  }

  Result<std::vector<ViewPart>> run() {
    parts_ = {named("tiles", kTileColour), named("bridged_tiles", kBridgedTileColour),
              named("bridges", kBridgeColour)};
    auto bridge = micro_.bridges.begin();
    auto sweep = micro_.sweeps.begin();
    for (std::uint32_t g = 0; g < micro_.grids.size(); ++g) {
      const MicroGrid& grid = micro_.grids[g];
      for (std::uint64_t c = 0; c < grid.tiles.size(); ++c) {
        if (grid.tiles[c] == 0) continue;
        unsigned bridged = 0;  // a bit for each wall
        for (; bridge != micro_.bridges.end() && bridge->cap.grid == g && bridge->cap.cell == c;
             ++bridge)
          bridged |= 1U << bridge->cap.wall;
        for (; sweep != micro_.sweeps.end() && sweep->cap.grid == g && sweep->cap.cell == c;
             ++sweep)
          bridged |= 1U << sweep->cap.wall;
        draw_tile(g, c, bridged);
      }
    }
    for (const MicroBridge& b : micro_.bridges) draw_bridge(b);
    for (const MicroSweep& s : micro_.sweeps) draw_sweep(s);
    std::erase_if(parts_, [](const ViewPart& part) { return part.triangles.empty(); });
    if (options_.model != nullptr) parts_.push_back(part_around(*options_.model));
    if (options_.has_cage) add_cage();
    return std::move(parts_);
  }

 private:
  static ViewPart named(const char* name, Colour colour) {
    ViewPart out;
    out.name = name, out.colour = colour;
    return out;
  }

  std::size_t parts_of(const std::array<int, 2>& degrees) const {
    return degrees[0] == 1 && degrees[1] == 1 ? std::max<std::size_t>(1, num_parts_ / 2)
                                              : num_parts_;
  }
  Status choose_parts() {
    std::vector<std::uint64_t> used(micro_.tiles.size());
    for (const MicroGrid& grid : micro_.grids)
      for (const std::uint8_t t : grid.tiles)
        if (t != 0) ++used[t - 1U];
    for (num_parts_ = std::max<std::size_t>(2, options_.parts);; --num_parts_) {
      std::uint64_t triangles = 10 * micro_.num_bridges() * num_parts_ * num_parts_;
      for (std::size_t k = 0; k < used.size(); ++k)
        for (const TilePatch& patch : micro_.tiles[k].patches)
          triangles += 2 * used[k] * parts_of(patch.degrees) * parts_of(patch.degrees);
      if (triangles <= options_.max_triangles) return ok_status();
      if (num_parts_ == 2)
        return Error{Code::kOverLimit,
                     {},
                     "the picture would have " + std::to_string(triangles) +
                         " triangles, more than " + std::to_string(options_.max_triangles)};
    }
  }

  bool is_hidden(const MicroGrid& grid, const std::array<std::size_t, 3>& at, int wall) const {
    const auto axis = static_cast<std::size_t>(wall / 2);
    std::array<std::size_t, 3> beside = at;
    if (wall % 2 == 0 ? at[axis] == 0 : at[axis] + 1 == grid.shape().size[axis]) return false;
    beside[axis] += wall % 2 == 0 ? std::size_t(-1) : 1;
    return grid.tiles[grid.shape().at(beside)] != 0;
  }

  void draw_tile(std::uint32_t g, std::uint64_t cell, unsigned bridged) {
    const MicroGrid& grid = micro_.grids[g];
    const std::size_t k = grid.tiles[cell] - std::size_t{1};
    const std::array<std::size_t, 3> at = grid.shape().index_of(cell);
    const WallNumbers numbers = grid.numbers_of(at);
    for (std::size_t s = 0; s < micro_.tiles[k].patches.size(); ++s) {
      const TilePatch& patch = micro_.tiles[k].patches[s];
      const std::optional<int>& wall = walls_[k][s];
      if (wall && ((bridged >> *wall & 1) != 0 || is_hidden(grid, at, *wall))) continue;
      std::vector<Point3d> points = samples_of(k, s, number_of(patch, numbers));
      bring_to_cell(grid, at, points);
      add(parts_[bridged != 0 ? 1 : 0], grid.volume, points, parts_of(patch.degrees));
    }
  }
  static void bring_to_cell(const MicroGrid& grid, const std::array<std::size_t, 3>& at,
                            std::vector<Point3d>& points) {
    for (std::size_t a = 0; a < 3; ++a) {
      const double lo = nearest_double(grid.breaks[a][at[a]]),
                   hi = nearest_double(grid.breaks[a][at[a] + 1]);
      for (Point3d& p : points) p[a] = lo * (1 - p[a]) + hi * p[a];
    }
  }
  const std::vector<Point3d>& samples_of(std::size_t tile, std::size_t patch, std::int32_t number) {
    const std::array<std::int64_t, 3> key{static_cast<std::int64_t>(tile),
                                          static_cast<std::int64_t>(patch), number};
    const auto known = samples_.find(key);
    if (known != samples_.end()) return known->second;
    constexpr std::size_t kMostKnown = 4096;
    if (samples_.size() >= kMostKnown) samples_.clear();
    const TilePatch& p = micro_.tiles[tile].patches[patch];
    return samples_[key] = sampled(rounded_points(points_at(p, number)), p.degrees[0], p.degrees[1],
                                   parts_of(p.degrees));
  }

  // The four sides and the end, whose normals point out of the bridge where determinants are positive.
  void draw_bridge(const MicroBridge& b) {
    const int p = b.degrees[0], q = b.degrees[1];
    const Net net = rounded_points(b.points);
    const auto face = [&](int m, int n, auto index) {
      Net out;
      for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= n; ++j) out.push_back(net[index(i, j)]);
      add(parts_[2], b.volume, sampled(out, m, n, num_parts_), num_parts_);
    };
    face(kBridgeAxisDegree, q, [&](int k, int j) { return b.at(0, j, k); });
    face(q, kBridgeAxisDegree, [&](int j, int k) { return b.at(p, j, k); });
    face(p, kBridgeAxisDegree, [&](int i, int k) { return b.at(i, 0, k); });
    face(kBridgeAxisDegree, p, [&](int k, int i) { return b.at(i, q, k); });
    face(p, q, [&](int i, int j) { return b.at(i, j, kBridgeAxisDegree); });
  }

  // Each patch in the wall, moved along the curve: four sides and the end, with normals as those of bridges.
  void draw_sweep(const MicroSweep& s) {
    const MicroGrid& grid = micro_.grids[s.cap.grid];
    const auto at = grid.shape().index_of(s.cap.cell);
    const std::size_t k = grid.tiles[s.cap.cell] - std::size_t{1};
    const Net axis = rounded_points({s.axis.begin(), s.axis.end()});
    for (std::size_t n = 0; n < micro_.tiles[k].patches.size(); ++n) {
      if (walls_[k][n] != s.cap.wall) continue;
      const TilePatch& patch = micro_.tiles[k].patches[n];
      Net points = sampled(rounded_points(points_at(patch, number_of(patch, grid.numbers_of(at)))),
                           patch.degrees[0], patch.degrees[1], num_parts_);
      bring_to_cell(grid, at, points);
      draw_moved(mapped(grid.volume, points), axis);
    }
  }
  void draw_moved(const Net& cap, const Net& axis) {
    const std::size_t last = num_parts_, m = last + 1;
    const auto point = [&](std::size_t i, std::size_t j, std::size_t step) {
      const double w = static_cast<double>(step) / static_cast<double>(last);
      Point3d p = cap[i * m + j];
      for (std::size_t c = 0; c < 3; ++c) p[c] += 2 * w * (1 - w) * axis[0][c] + w * w * axis[1][c];
      return p;
    };
    const auto face = [&](auto at) {
      Net image;
      for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < m; ++j) image.push_back(at(i, j));
      add_image(parts_[2], image, last);
    };
    face([&](std::size_t l, std::size_t j) { return point(0, j, l); });
    face([&](std::size_t j, std::size_t l) { return point(last, j, l); });
    face([&](std::size_t i, std::size_t l) { return point(i, 0, l); });
    face([&](std::size_t l, std::size_t i) { return point(i, last, l); });
    face([&](std::size_t i, std::size_t j) { return point(i, j, last); });
  }

  // Maps points to space. A parameter that was rounded out of the domain is moved back.
  std::vector<Point3d> mapped(std::uint32_t volume, const std::vector<Point3d>& points) const {
    const FastSpline<3>& map = maps_[volume];
    std::array<std::vector<double>, 3> at;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto [first, last] = map.domain(a);
      for (const Point3d& p : points) at[a].push_back(std::clamp(p[a], first, last));
    }
    const std::size_t d = map.dimension();
    std::vector<double> values(points.size() * d);
    FastSplineOutput out;
    out.value = values.data();
    map.evaluate({at[0].data(), at[1].data(), at[2].data()}, points.size(), out);
    std::vector<Point3d> image(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) image[i][c] = values[i * d + c];
    return image;
  }
  void add(ViewPart& part, std::uint32_t volume, const std::vector<Point3d>& points,
           std::size_t parts) const {
    add_image(part, mapped(volume, points), parts);
  }
  static void add_image(ViewPart& part, const std::vector<Point3d>& image, std::size_t parts) {
    const auto first = static_cast<std::uint32_t>(part.points.size());
    const auto n = static_cast<std::uint32_t>(parts) + 1;
    part.points.insert(part.points.end(), image.begin(), image.end());
    for (std::uint32_t i = 0; i + 1 < n; ++i)
      for (std::uint32_t j = 0; j + 1 < n; ++j) {
        const std::uint32_t a = first + i * n + j, b = a + n;
        part.triangles.push_back({a, b, b + 1});
        part.triangles.push_back({a, b + 1, a + 1});
      }
  }

  void add_cage() {
    ViewPart& out = parts_.emplace_back(named("cage", kCageColour));
    for (std::uint32_t v = 0; v < maps_.size(); ++v)
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t ends = 0; ends < 4; ++ends) {
          std::vector<Point3d> points(kCageEdgeParts + 1);
          for (std::size_t i = 0; i <= kCageEdgeParts; ++i)
            for (std::size_t a = 0, bit = 0; a < 3; ++a) {
              const auto [first, last] = maps_[v].domain(a);
              const double t = a == axis ? static_cast<double>(i) / kCageEdgeParts
                                         : static_cast<double>(ends >> bit++ & 1);
              points[i][a] = first * (1 - t) + last * t;
            }
          const auto begin = static_cast<std::uint32_t>(out.net_points.size());
          const std::vector<Point3d> image = mapped(v, points);
          out.net_points.insert(out.net_points.end(), image.begin(), image.end());
          for (std::uint32_t i = 0; i < kCageEdgeParts; ++i)
            out.net_lines.push_back({begin + i, begin + i + 1});
        }
  }

  const Microstructure& micro_;
  const MicroViewOptions& options_;
  std::size_t num_parts_ = 2;
  std::vector<FastSpline<3>> maps_;
  std::vector<std::vector<std::optional<int>>> walls_;  // by tiles and patches
  std::map<std::array<std::int64_t, 3>, std::vector<Point3d>> samples_;
  std::vector<ViewPart> parts_;
};

}  // namespace

ViewPart part_around(const TriangleMesh& mesh) {
  ViewPart out;
  out.name = "model", out.colour = kAroundColour;
  for (const Vec3d& p : mesh.positions) out.points.push_back({p.x, p.y, p.z});
  out.triangles = mesh.faces;
  return out;
}

Result<std::vector<ViewPart>> micro_parts(const Microstructure& micro,
                                          const MicroViewOptions& options) {
  MicroPainter painter(micro, options);
  if (const Status status = painter.prepare(); !status) return status.error();
  return painter.run();
}

Scene micro_scene(std::vector<ViewPart> parts) {
  Scene out;
  for (ViewPart& part : parts) {
    for (std::size_t i = 0; i < part.net_lines.size();) {  // lines that follow each other are one
      SceneLine line;
      line.colour = part.colour, line.width = kCageWidth;
      line.points.push_back(part.net_points[part.net_lines[i][0]]);
      std::uint32_t end = part.net_lines[i][0];
      for (; i < part.net_lines.size() && part.net_lines[i][0] == end; ++i) {
        end = part.net_lines[i][1];
        line.points.push_back(part.net_points[end]);
      }
      out.lines.push_back(std::move(line));
    }
    if (part.triangles.empty()) continue;
    SceneSurface surface;
    surface.paints = {
        Paint{part.colour, part.name == "model" ? kAroundOpacity : std::uint8_t{255}}};
    surface.points = std::move(part.points);
    surface.triangles = std::move(part.triangles);
    surface.name = part.name;
    out.surfaces.push_back(std::move(surface));
  }
  return out;
}

}  // namespace veritope
