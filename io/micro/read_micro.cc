// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/micro/read_micro.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "io/splines/spline_json_lexer.h"
#include "io/splines/spline_sniff.h"
#include "solids/micro/micro_validity.h"

namespace veritope {
namespace {

constexpr std::string_view kMicroFormatName = "veritope-micro-1";

class MicroReader : SplineJsonLexer {
 public:
  using SplineJsonLexer::SplineJsonLexer;
  using SplineTextReader::take_error;

  bool read();
  MicroFile take() {
    MicroFile file;
    file.micro = std::move(micro_);
    file.bytes = source_.size();
    file.has_names_in_cage = has_names_in_cage_;
    file.beyond_default_limits = std::move(beyond_default_);
    if (!file.beyond_default_limits)
      file.beyond_default_limits = SplineTextReader::take().beyond_default_limits;
    return file;
  }

 private:
  bool read_member(std::size_t key);
  bool read_format();
  bool read_model();
  bool read_cage();
  bool read_grids();
  bool read_grid();
  bool read_tile();
  bool read_patch(TilePatch& patch);
  bool read_powers(std::vector<std::vector<TilePoint>>& powers);
  bool read_cells(std::size_t grid);
  bool read_bits(std::size_t grid, std::size_t tile);
  bool read_walls(std::size_t grid, std::size_t axis);
  bool read_all_walls();
  bool read_bridge();
  bool read_sweep();
  // The key 0, 1 or 2: grid, cell, wall.
  bool read_cap_number(std::size_t key, CapPlace& cap);
  bool read_material();
  bool read_values(std::size_t grid, std::vector<std::int64_t>& values);
  bool read_degrees(std::array<int, 2>& degrees);
  bool read_point(TilePoint& point) {
    return read_exactly(3, [&](std::size_t c) { return read_exact(point[c]); });
  }

  bool read_volume(const char* what, std::uint64_t most, std::uint32_t& volume) {
    std::uint64_t n = 0;
    if (!read_natural(what, most, n)) return false;
    volume = static_cast<std::uint32_t>(n);
    return true;
  }
  // Reads a list with so many items; item(i) reads the i-th.
  template <typename Item>
  bool read_exactly(std::size_t count, Item item);
  // Whether the items of a list, `count` with the one at the cursor, are at most so many.
  bool is_within(std::size_t count, std::size_t most, const char* what) {
    return count <= most ||
           fail(p_, Code::kOverLimit, "more than " + std::to_string(most) + " " + what);
  }
  // Passes on what a part lacks, with the line of the part.
  bool accept(const char* at, const Status& status) {
    return status.has_value() || fail_with(at, status.error());
  }

  Microstructure micro_;
  std::uint64_t num_cells_ = 0;
  std::vector<const char*> grids_at_;
  bool has_names_in_cage_ = false;
  std::optional<Error> beyond_default_;  // in the cage
};

bool MicroReader::read() {
  const std::initializer_list<std::string_view> keys = {"format", "model",    "cage",  "grids",
                                                        "tiles",  "cells",    "walls", "bridges",
                                                        "sweeps", "materials"};
  constexpr std::size_t kNumOptional = 3;  // at the end
  std::size_t next = 0;
  const bool ok = read_object(
      keys,
      [&](std::size_t key) {
        if (key == next || (key > next && next + kNumOptional >= keys.size())) {
          next = key + 1;
          return read_member(key);
        }
        const std::size_t first = std::min(next, key), second = key < next ? next - 1 : key;
        return fail(p_, Code::kSyntax,
                    "the key " + quoted(keys.begin()[first]) + " must come before the key " +
                        quoted(keys.begin()[second]));
      },
      kNumOptional);
  return ok && (is_at_end() || fail_expected("the end of the file"));
}

bool MicroReader::read_member(std::size_t key) {
  const auto each_grid = [this](auto item) { return read_exactly(micro_.grids.size(), item); };
  switch (key) {
    case 0: return read_format();
    case 1: return take_null() || read_model();
    case 2: return read_cage();
    case 3: return read_grids();
    case 4: {
      skip();
      const char* const at = p_;
      return read_list([this] { return read_tile(); }) &&
             (!micro_.tiles.empty() || fail(at, Code::kSyntax, "there are 0 tiles"));
    }
    case 5: return each_grid([this](std::size_t grid) { return read_cells(grid); });
    case 6: return read_all_walls();
    case 7: return read_list([this] { return read_bridge(); });
    case 8: return read_list([this] { return read_sweep(); });
    default: return read_list([this] { return read_material(); });
  }
}

bool MicroReader::read_all_walls() {
  skip();
  if (!micro_.has_walls()) return read_exactly(0, [](std::size_t) { return true; });
  return read_exactly(micro_.grids.size(), [this](std::size_t grid) {
    return read_exactly(3, [this, grid](std::size_t axis) { return read_walls(grid, axis); });
  });
}

bool MicroReader::read_format() {
  skip();
  const char* const at = p_;
  std::string format;
  if (!read_string(format)) return false;
  return format == kMicroFormatName ||
         fail(at, Code::kUnknownFormat,
              "the format must be 'veritope-micro-1', not " + quoted(format));
}

bool MicroReader::read_model() {
  MicroModelName model;
  const bool ok = read_object({"name", "sha256"}, [&](std::size_t key) {
    skip();
    const char* const at = p_;
    if (!read_string(key == 0 ? model.name : model.sha256)) return false;
    return key == 0 || is_sha256_text(model.sha256) ||
           fail(at, Code::kSyntax,
                "64 lower-case hexadecimal digits expected, but there is " + quoted(model.sha256));
  });
  micro_.model = std::move(model);
  return ok;
}

bool MicroReader::read_cage() {
  skip();
  const char* const start = p_;
  Result<SplineFile> file = read_spline_json_part(source_, limits_, p_);
  if (!file) return fail_as(file.error());
  beyond_default_ = std::move(file->beyond_default_limits);
  has_names_in_cage_ = !file->model.groups.empty();
  const std::vector<SplineEntity>& entities = file->model.entities;
  if (entities.empty()) return fail(start, Code::kSyntax, "the cage has 0 volumes");
  if (entities.size() > kMaxMicroGrids)
    return fail(start, Code::kOverLimit,
                "the cage has " + std::to_string(entities.size()) + " volumes, more than " +
                    std::to_string(kMaxMicroGrids));
  for (std::size_t v = 0; v < entities.size(); ++v) {
    const auto* const volume = std::get_if<ExactVolume>(&entities[v].shape);
    const Status status = volume != nullptr ? check_cage_volume(*volume, v)
                                            : bad_argument("entity " + std::to_string(v) +
                                                           " of the cage must be a volume, not a " +
                                                           spline_kind_name(entities[v]));
    if (!status) return fail_as({status.error().code, entities[v].place, status.error().message});
    has_names_in_cage_ = has_names_in_cage_ || !entities[v].attributes.empty();
    micro_.cage.push_back(*volume);
  }
  return true;
}

template <typename Item>
bool MicroReader::read_exactly(std::size_t count, Item item) {
  if (!take_char('[')) return false;
  for (std::size_t i = 0; i < count; ++i)
    if ((i > 0 && !take_char(',')) || !item(i)) return false;
  return take_char(']');
}

bool MicroReader::read_grids() {
  if (!read_list([this] { return read_grid(); })) return false;
  if (const auto crowded = crowding_grid(micro_))
    return accept(grids_at_[*crowded], crowding_error(micro_, *crowded));
  const auto grids = overlapping_grids(micro_);
  return !grids || accept(grids_at_[(*grids)[1]], overlap_error(micro_, *grids));
}

bool MicroReader::read_grid() {
  skip();
  const char* const start = p_;
  if (!is_within(micro_.grids.size() + 1, kMaxMicroGrids, "grids")) return false;
  MicroGrid& grid = micro_.grids.emplace_back();
  grids_at_.push_back(start);
  const bool ok = read_object({"volume", "breaks"}, [&](std::size_t key) {
    if (key == 1)
      return read_exactly(3, [&](std::size_t axis) {
        return read_list([&] { return read_exact(grid.breaks[axis].emplace_back()); });
      });
    return read_volume("the volume of a grid", micro_.cage.size() - 1, grid.volume);
  });
  return ok && accept(start, check_breaks(micro_, micro_.grids.size() - 1, num_cells_));
}

bool MicroReader::read_tile() {
  skip();
  const char* const start = p_;
  if (!is_within(micro_.tiles.size() + 1, kMaxMicroTiles, "tiles")) return false;
  MicroTile& tile = micro_.tiles.emplace_back();
  const bool ok = read_object({"name", "range", "patches"}, [&](std::size_t key) {
    if (key == 0) return read_string(tile.name);
    if (key == 2)
      return read_list([&] {
        return is_within(tile.patches.size() + 1, kMaxTilePatches, "patches of a tile") &&
               read_patch(tile.patches.emplace_back());
      });
    if (take_null()) return true;
    std::array<std::int32_t, 2> range{};
    const bool is_range = read_exactly(2, [&](std::size_t i) {
      std::uint64_t end = 0;
      if (!read_natural("an end of a range", kMaxWallNumber, end)) return false;
      range[i] = static_cast<std::int32_t>(end);
      return true;
    });
    tile.range = range;
    return is_range;
  });
  return ok && accept(start, check_tile(tile, micro_.tiles.size() - 1));
}

bool MicroReader::read_patch(TilePatch& patch) {
  return read_object({"wall", "degrees", "points"}, [&](std::size_t key) {
    std::uint64_t n = 0;
    if (key == 2) return read_powers(patch.points);
    if (key == 1) return read_degrees(patch.degrees);
    if (take_null()) return true;
    if (!read_natural("the wall of a patch", 5, n)) return false;
    patch.wall = static_cast<int>(n);
    return true;
  });
}

bool MicroReader::read_degrees(std::array<int, 2>& degrees) {
  return read_exactly(2, [&](std::size_t i) {
    std::uint64_t n = 0;
    if (!read_natural("a degree", kMaxTileDegree, n)) return false;
    degrees[i] = static_cast<int>(n);
    return true;
  });
}

bool MicroReader::read_powers(std::vector<std::vector<TilePoint>>& powers) {
  constexpr std::size_t kMostPoints = (kMaxTileDegree + 1) * (kMaxTileDegree + 1);
  return read_list([&] {
    if (!is_within(powers.size() + 1, kMaxTilePowers, "lists of points of a patch")) return false;
    std::vector<TilePoint>& points = powers.emplace_back();
    return read_list([&] {
      if (!is_within(points.size() + 1, kMostPoints, "points in a list of a patch")) return false;
      return read_point(points.emplace_back());
    });
  });
}

bool MicroReader::read_cells(std::size_t grid) {
  return read_exactly(micro_.tiles.size(),
                      [this, grid](std::size_t tile) { return read_bits(grid, tile); });
}

// Four cells a digit; the digit's first cell counts 8.
bool MicroReader::read_bits(std::size_t grid, std::size_t tile) {
  skip();
  const char* const start = p_;
  std::vector<std::uint8_t>& tiles = micro_.grids[grid].tiles;
  const std::size_t count = micro_.grids[grid].shape().count(), num_digits = (count + 3) / 4;
  const std::string where = "grid " + std::to_string(grid) + ": ";
  if (!is_next('"')) return fail_expected("a string");
  ++p_;
  if (num_digits > bytes_left())
    return fail(start, Code::kTruncated,
                where + std::to_string(num_digits) + " digits are needed, and only " +
                    std::to_string(bytes_left()) + " bytes follow");
  if (tile == 0) tiles.assign(count, 0);
  for (std::size_t d = 0; d < num_digits; ++d, ++p_) {
    const char* const at = p_;
    char c = *p_;
    if (c == '0') continue;
    if (c == '\\') {
      std::string escaped;
      if (++p_; !read_escape(escaped)) return false;
      --p_, c = escaped.size() == 1 ? escaped[0] : '\\';
    }
    const bool is_hex = is_digit(c) || (c >= 'a' && c <= 'f');
    if (!is_hex)
      return fail(at, Code::kSyntax,
                  where + "digit " + std::to_string(d) + " of " + std::to_string(num_digits) +
                      " of the cells that hold tile " + std::to_string(tile) +
                      " must be a lower-case hexadecimal digit, not " +
                      quoted(std::string_view(at, 1)));
    const auto digit = static_cast<unsigned>(is_digit(c) ? c - '0' : c - 'a' + 10);
    for (std::size_t k = 0; k < 4; ++k) {
      if ((digit & (8u >> k)) == 0) continue;
      const std::size_t cell = 4 * d + k;
      if (cell >= count)
        return fail(p_, Code::kSyntax,
                    where + "the bit of cell " + std::to_string(cell) + " is set, and there are " +
                        std::to_string(count) + " cells");
      if (tiles[cell] != 0)
        return fail(p_, Code::kSyntax,
                    where + "cell " + std::to_string(cell) + " holds the tiles " +
                        std::to_string(tiles[cell] - 1) + " and " + std::to_string(tile));
      tiles[cell] = static_cast<std::uint8_t>(tile + 1);
    }
  }
  if (p_ >= source_.end) return fail(start, Code::kTruncated, "a string does not end");
  if (*p_ != '"')
    return fail(p_, Code::kSyntax,
                where + "the end of a string expected after " + std::to_string(num_digits) +
                    " digits, but there is " + quoted(std::string_view(p_, 1)));
  return ++p_, true;
}

// The lists are nearly all of the file: digits, commas and blanks are read here, and all else by read_natural.
bool MicroReader::read_walls(std::size_t grid, std::size_t axis) {
  constexpr std::ptrdiff_t kMostDigits = 7;
  skip();
  const char* const start = p_;
  std::vector<std::int32_t>& walls = micro_.grids[grid].walls[axis];
  const std::size_t count = micro_.grids[grid].wall_shape(axis).count();
  if (!take_char('[') || !check_announced(count, "numbers of walls")) return false;
  walls.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && *p_ == ',' && p_ < source_.end) {
      ++p_;
    } else if (i > 0 && !take_char(',')) {
      return false;
    }
    std::int32_t value = 0;
    const char* p = p_;
    while (is_digit(*p) && p - p_ < kMostDigits) value = 10 * value + (*p++ - '0');
    const bool is_plain = p > p_ && (*p == ',' || *p == ']') && (*p_ != '0' || p == p_ + 1);
    if (!is_plain || value > kMaxWallNumber) {
      std::uint64_t slow = 0;
      if (!read_natural("the number of a wall", kMaxWallNumber, slow)) return false;
      value = static_cast<std::int32_t>(slow), p = p_;
    }
    walls[i] = value, p_ = p;
  }
  return take_char(']') && accept(start, check_walls(micro_, grid, axis));
}

bool MicroReader::read_bridge() {
  constexpr std::size_t kMostPoints =
      (kMaxTileDegree + 1) * (kMaxTileDegree + 1) * (kBridgeAxisDegree + 1);
  skip();
  const char* const start = p_;
  if (!is_within(micro_.bridges.size() + 1, kMaxMicroBridges, "bridges")) return false;
  MicroBridge& bridge = micro_.bridges.emplace_back();
  const bool ok =
      read_object({"grid", "cell", "wall", "volume", "degrees", "points"}, [&](std::size_t key) {
        if (key < 3) return read_cap_number(key, bridge.cap);
        if (key == 3)
          return read_volume("the volume of a bridge", kMaxMicroGrids - 1, bridge.volume);
        if (key == 4) return read_degrees(bridge.degrees);
        return read_list([&] {
          return is_within(bridge.points.size() + 1, kMostPoints, "points of a bridge") &&
                 read_point(bridge.points.emplace_back());
        });
      });
  return ok && accept(start, check_bridge(micro_, micro_.bridges.size() - 1));
}

bool MicroReader::read_sweep() {
  skip();
  const char* const start = p_;
  if (!is_within(micro_.sweeps.size() + 1, kMaxMicroBridges, "sweeps")) return false;
  MicroSweep& sweep = micro_.sweeps.emplace_back();
  const bool ok = read_object({"grid", "cell", "wall", "axis"}, [&](std::size_t key) {
    if (key < 3) return read_cap_number(key, sweep.cap);
    return read_exactly(2, [&](std::size_t i) { return read_point(sweep.axis[i]); });
  });
  return ok && accept(start, check_sweep(micro_, micro_.sweeps.size() - 1));
}

bool MicroReader::read_cap_number(std::size_t key, CapPlace& cap) {
  constexpr std::array<const char*, 3> kWhat = {"the grid of a bridge", "the cell of a bridge",
                                                "the wall of a bridge"};
  const std::array<std::uint64_t, 3> most = {kMaxMicroGrids - 1, kMaxMicroCells - 1, 5};
  std::uint64_t n = 0;
  if (!read_natural(kWhat[key], most[key], n)) return false;
  if (key == 0) cap.grid = static_cast<std::uint32_t>(n);
  if (key == 1) cap.cell = n;
  if (key == 2) cap.wall = static_cast<int>(n);
  return true;
}

bool MicroReader::read_material() {
  skip();
  if (!is_within(micro_.materials.size() + 1, kMaxMicroMaterials, "materials")) return false;
  MicroMaterial& material = micro_.materials.emplace_back();
  return read_object({"name", "values"}, [&](std::size_t key) {
    if (key == 0) return read_string(material.name);
    return read_exactly(micro_.grids.size(), [&](std::size_t grid) {
      return read_values(grid, material.values.emplace_back());
    });
  });
}

bool MicroReader::read_values(std::size_t grid, std::vector<std::int64_t>& values) {
  const std::size_t count = micro_.grids[grid].corner_shape().count();
  if (!check_announced(count, "values of a material")) return false;
  values.reserve(count);
  return read_exactly(count, [&](std::size_t) {
    skip();
    const char* const at = p_;
    const bool is_negative = p_ < source_.end && *p_ == '-';
    if (is_negative) ++p_;
    std::uint64_t n = 0;
    if (!read_natural("a value of a material", kMaxMaterialNumber, n)) return false;
    if (is_negative && n == 0) return fail(at, Code::kSyntax, "0 has no minus sign");
    const auto value = static_cast<std::int64_t>(n);
    values.push_back(is_negative ? -value : value);
    return true;
  });
}

}  // namespace

bool looks_like_micro(const Source& source) { return starts_with_format(source, kMicroFormatName); }

Result<MicroFile> read_micro(MicroFormat format, const Source& source, const ReadLimits& limits) {
  MicroReader reader(source, limits);
  if (!reader.read()) return reader.take_error();
  MicroFile file = reader.take();
  file.format = format;
  return file;
}

}  // namespace veritope
