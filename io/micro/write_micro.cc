// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/micro/write_micro.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "io/base/json_string.h"
#include "io/splines/write_splines.h"

namespace veritope {
namespace {

class MicroWriter {
 public:
  std::string write(const Microstructure& micro) {
    out_ = "{\"format\": \"veritope-micro-1\",\n\"model\": ";
    model(micro.model);
    out_ += ",\n\"cage\": ";
    cage(micro.cage);
    out_ += ",\n\"grids\": ";
    lines(micro.grids, [this](const MicroGrid& grid) { breaks(grid); });
    out_ += ",\n\"tiles\": ";
    lines(micro.tiles, [this](const MicroTile& t) { tile(t); });
    out_ += ",\n\"cells\": ";
    lines(micro.grids, [&](const MicroGrid& grid) { cells(grid, micro.tiles.size()); });
    out_ += ",\n\"walls\": ";
    if (micro.has_walls()) {
      lines(micro.grids, [this](const MicroGrid& grid) { walls(grid); });
    } else {
      out_ += "[]";
    }
    if (!micro.bridges.empty()) {
      out_ += ",\n\"bridges\": ";
      lines(micro.bridges, [this](const MicroBridge& b) { bridge(b); });
    }
    if (!micro.sweeps.empty()) {
      out_ += ",\n\"sweeps\": ";
      lines(micro.sweeps, [this](const MicroSweep& s) { sweep(s); });
    }
    if (!micro.materials.empty()) {
      out_ += ",\n\"materials\": ";
      lines(micro.materials, [this](const MicroMaterial& m) { material(m); });
    }
    return std::move(out_ += "}\n");
  }

 private:
  template <typename List, typename Item>
  void list(const List& items, Item item, std::string_view separator, const char* begin = "[") {
    out_ += begin;
    bool is_first = true;
    for (const auto& i : items) {
      if (!is_first) out_ += separator;
      is_first = false;
      item(i);
    }
    out_ += ']';
  }
  // One element a line.
  template <typename List, typename Item>
  void lines(const List& items, Item item) {
    list(items, item, ",\n", items.empty() ? "[" : "[\n");
  }
  void text(std::string_view s) { append_json_string(s, out_); }
  void number(const Rational& r) { out_ += '"' + r.to_string() + '"'; }
  template <typename List>
  void numbers(const List& items) {
    list(
        items, [this](const Rational& r) { number(r); }, ", ");
  }
  template <typename List>
  void integers(const List& items) {
    list(
        items,
        [this](std::int64_t n) {
          char digits[24];
          out_.append(digits, std::to_chars(digits, digits + sizeof digits, n).ptr);
        },
        ",");
  }

  void model(const std::optional<MicroModelName>& name) {
    if (!name) {
      out_ += "null";
      return;
    }
    out_ += "{\"name\": ";
    text(name->name);
    out_ += ", \"sha256\": ";
    text(name->sha256);
    out_ += '}';
  }
  void cage(const std::vector<VVolume>& volumes) {
    SplineModel model;
    for (const VVolume& volume : volumes) model.entities.push_back({volume, {}, {}, {}});
    out_ += spline_json_bytes(model);
    out_.pop_back();  // the line feed
  }
  void breaks(const MicroGrid& grid) {
    out_ += "{\"volume\": " + std::to_string(grid.volume) + ", \"breaks\": ";
    list(
        grid.breaks, [this](const std::vector<Rational>& axis) { numbers(axis); }, ", ");
    out_ += '}';
  }
  void tile(const MicroTile& t) {
    out_ += "{\"name\": ";
    text(t.name);
    out_ += ", \"range\": ";
    if (t.range) {
      integers(*t.range);
    } else {
      out_ += "null";
    }
    out_ += ", \"patches\": ";
    list(
        t.patches, [this](const TilePatch& p) { patch(p); }, ", ");
    out_ += '}';
  }
  void patch(const TilePatch& p) {
    out_ += "{\"wall\": " + (p.wall ? std::to_string(*p.wall) : "null") + ", \"degrees\": ";
    integers(p.degrees);
    out_ += ", \"points\": ";
    list(
        p.points,
        [this](const std::vector<TilePoint>& points) {
          list(
              points, [this](const TilePoint& point) { numbers(point); }, ", ");
        },
        ", ");
    out_ += '}';
  }
  void cells(const MicroGrid& grid, std::size_t num_tiles) {
    out_ += '[';
    for (std::size_t t = 0; t < num_tiles; ++t) {
      out_ += t == 0 ? "\"" : ", \"";
      bits(grid.tiles, static_cast<std::uint8_t>(t + 1));
      out_ += '"';
    }
    out_ += ']';
  }
  // Which cells hold a tile: four a digit, the first one counts 8.
  void bits(const std::vector<std::uint8_t>& tiles, std::uint8_t tile) {
    constexpr char kHex[] = "0123456789abcdef";
    for (std::size_t i = 0; i < tiles.size(); i += 4) {
      unsigned digit = 0;
      for (std::size_t k = i; k < i + 4 && k < tiles.size(); ++k)
        if (tiles[k] == tile) digit |= 8u >> (k - i);
      out_ += kHex[digit];
    }
  }
  void walls(const MicroGrid& grid) {
    list(
        grid.walls, [this](const std::vector<std::int32_t>& axis) { integers(axis); }, ", ");
  }
  void cap(const CapPlace& c) {
    out_ += "{\"grid\": " + std::to_string(c.grid) + ", \"cell\": " + std::to_string(c.cell) +
            ", \"wall\": " + std::to_string(c.wall);
  }
  void bridge(const MicroBridge& b) {
    cap(b.cap);
    out_ += ", \"volume\": " + std::to_string(b.volume) + ", \"degrees\": ";
    integers(b.degrees);
    out_ += ", \"points\": ";
    list(
        b.points, [this](const TilePoint& point) { numbers(point); }, ", ");
    out_ += '}';
  }
  void sweep(const MicroSweep& s) {
    cap(s.cap);
    out_ += ", \"axis\": ";
    list(
        s.axis, [this](const TilePoint& vector) { numbers(vector); }, ", ");
    out_ += '}';
  }
  void material(const MicroMaterial& m) {
    out_ += "{\"name\": ";
    text(m.name);
    out_ += ", \"values\": ";
    list(
        m.values, [this](const std::vector<std::int64_t>& grid) { integers(grid); }, ", ");
    out_ += '}';
  }

  std::string out_;
};

}  // namespace

std::string write_micro(const Microstructure& micro) { return MicroWriter().write(micro); }

}  // namespace veritope
