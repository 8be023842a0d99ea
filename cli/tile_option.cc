// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/tile_option.h"

#include <array>
#include <charconv>
#include <set>
#include <string_view>
#include <utility>

#include "io/base/exact_number.h"
#include "io/itd_polygons.h"
#include "io/open_tile_file.h"
#include "io/read_model.h"
#include "io/splines/spline_text_reader.h"
#include "io/tile_file.h"
#include "solids/micro/bifurcation.h"
#include "solids/vmodel/v_parts.h"

namespace veritope::cli {
namespace {

constexpr unsigned kBranchArms = 51;         // to u0, u1, w0 and w1
constexpr unsigned kArmsOfBifurcation = 31;  // to all walls but w1

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c == separator)
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

std::string take_number(const std::string& value, Rational& to) {
  return read_exact_number(value, {}, to) == DecimalFault::kNone
             ? ""
             : "needs a number such as 1/8 or 0.125, not " + value;
}

std::string take_degree(const std::string& value, int& to) {
  const auto end = value.data() + value.size();
  const auto read = std::from_chars(value.data(), end, to);
  return read.ec == std::errc() && read.ptr == end ? "" : "needs a degree, 1 or 3, not " + value;
}

// "u0+w1".
std::string take_arms(const std::string& value, unsigned& to) {
  to = 0;
  for (const std::string& name : parts_of(value, '+')) {
    std::size_t wall = 0;
    while (wall < 6 && v_face_name(wall) != name) ++wall;
    if (wall == 6) return "needs walls such as u0+u1+w1, not " + value;
    if ((to >> wall & 1u) != 0) return "names the wall " + name + " twice";
    to |= 1u << wall;
  }
  return "";
}

std::string take_key(const std::string& key, const std::string& value, bool is_branch,
                     JackShape& shape) {
  if (key == "node") return take_number(value, shape.node);
  if (key == "cap") return take_number(value, shape.cap);
  if (key == "degree") return take_degree(value, shape.degree);
  if (is_branch && key == "arms") return take_arms(value, shape.arms);
  return "has no key " + key + "; " +
         (is_branch ? "a branch has node, cap, degree and arms"
                    : "a jack has node, cap and degree");
}
std::string take_key(const std::string& key, const std::string& value, FrameShape& shape) {
  if (key == "bar") return take_number(value, shape.bar);
  if (key == "margin") return take_number(value, shape.margin);
  return "has no key " + key + "; a frame has bar and margin";
}

std::string take_key(const std::string& key, const std::string& value, Curves3Shape& shape) {
  if (key == "radius") return take_number(value, shape.radius);
  if (key != "parts") return "has no key " + key + "; curves3 has radius and parts";
  const char* const end = value.data() + value.size();
  const auto read = std::from_chars(value.data(), end, shape.parts.emplace());
  return read.ec == std::errc() && read.ptr == end ? "" : "needs a number of parts, not " + value;
}

// Calls take(key, value) for each part after the name; no key may occur twice.
template <typename Take>
std::string take_keys(const std::vector<std::string>& parts, Take take) {
  std::set<std::string> known;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t equals = parts[i].find('=');
    const std::string key = parts[i].substr(0, equals),
                      value = equals == std::string::npos ? "" : parts[i].substr(equals + 1);
    if (std::string why = take(key, value); !why.empty()) return why;
    if (!known.insert(key).second) return "has the key " + key + " twice";
  }
  return "";
}

// Whether a proof may need quadrilaterals in the place of triangles.
bool may_need_quadrilaterals(const MicroTile& tile) {
  const auto analysed = analyse_tile(tile);
  const auto* const found = std::get_if<AnalysedTile>(&analysed);
  return found != nullptr && !found->is_star();
}

Result<MicroTile> read_tile_file(const std::string& path, const ModelReadOptions& reading,
                                 bool as_open) {
  const Result<ModelBytes> bytes = load_model(path, reading);
  if (!bytes) return bytes.error();
  const Result<ModelFile> file = read_model(*bytes, reading);
  if (!file) return file.error();
  std::optional<MeshFile> polygons;
  if (has_polygons_and_splines(*file)) {
    Result<MeshFile> mesh = read_itd_polygons(source_of(bytes->bytes, bytes->name),
                                              std::get<SplineFile>(*file), reading.limits);
    if (!mesh) return mesh.error();
    polygons.emplace(std::move(*mesh));
  }
  const std::string name = stored_name(path);
  const MeshFile* const also = polygons ? &*polygons : nullptr;
  if (as_open) return open_tile_of(*file, name, also);
  const auto with = [&](TileFacets facets) { return tile_of(*file, name, facets, also); };
  Result<MicroTile> tile = with(TileFacets::kFewest);
  if (!tile || !may_need_quadrilaterals(*tile)) return tile;
  Result<MicroTile> finer = with(TileFacets::kQuadrilaterals);
  return finer ? std::move(finer) : std::move(tile);
}

}  // namespace

std::string take_tile(const std::string& text, std::vector<TileChoice>& tiles) {
  const std::vector<std::string> parts = parts_of(text, ',');
  const bool is_branch = parts[0] == "branch";
  std::string why;
  const bool is_sheets = parts[0] == "jack-surfaces";
  if (parts[0] == "jack" || is_branch || is_sheets) {
    JackShape shape;
    if (is_branch) shape.arms = kBranchArms;
    why = take_keys(parts, [&](const std::string& key, const std::string& value) {
      return take_key(key, value, is_branch, shape);
    });
    if (is_sheets)
      tiles.emplace_back(JackSheets{std::move(shape)});
    else
      tiles.emplace_back(std::move(shape));
  } else if (parts[0] == "curves3") {
    Curves3Shape shape;
    why = take_keys(parts, [&](const std::string& key, const std::string& value) {
      return take_key(key, value, shape);
    });
    tiles.emplace_back(std::move(shape));
  } else if (parts[0] == "frame") {
    FrameShape shape;
    why = take_keys(parts, [&](const std::string& key, const std::string& value) {
      return take_key(key, value, shape);
    });
    tiles.emplace_back(std::move(shape));
  } else if (text.find_first_of("./") != std::string::npos) {
    tiles.emplace_back(TileFile{text, {}});
    return "";
  } else {
    return "needs jack, frame, branch, curves3 or jack-surfaces, such as jack,node=1/5, or a file, "
           "not " +
           text;
  }
  if (!why.empty()) return why;
  const Result<MicroTile> tile = make_tile(tiles.back(), 63, std::nullopt);
  return tile ? "" : "is not a tile: " + tile.error().message;
}

namespace {
// Reads K,M,N; `at` moves behind it. False if there are no such numbers from 1.
bool read_counts(const char*& at, const char* end, std::array<std::uint64_t, 3>& out) {
  for (std::size_t a = 0; a < 3; ++a) {
    const auto read = std::from_chars(at, end, out[a]);
    const bool goes_on = a == 2 || (read.ptr != end && *read.ptr == ',');
    if (read.ec != std::errc() || !goes_on || out[a] == 0) return false;
    at = read.ptr + (a < 2 ? 1 : 0);
  }
  return true;
}
}  // namespace

std::string take_counts(const std::string& text,
                        std::optional<std::array<std::uint64_t, 3>>& counts) {
  const char *at = text.data(), *const end = text.data() + text.size();
  std::array<std::uint64_t, 3> out{};
  if (!read_counts(at, end, out) || at != end)
    return "needs three numbers K,M,N from 1, not " + text;
  counts = out;
  return "";
}

std::string take_counts_of_volumes(const std::string& text,
                                   std::vector<std::array<std::uint64_t, 3>>& counts) {
  const char *at = text.data(), *const end = text.data() + text.size();
  std::vector<std::array<std::uint64_t, 3>> out;
  for (;;) {
    if (!read_counts(at, end, out.emplace_back()) || (at != end && *at != '/'))
      return "needs three numbers K,M,N from 1, or such numbers for each volume, as in "
             "2,3,4/2,3,1, not " +
             text;
    if (at == end) break;
    ++at;
  }
  counts = std::move(out);
  return "";
}

std::string stored_name(const std::string& path) {
  return to_utf8(path.substr(path.find_last_of('/') + 1));
}

Status read_tile_files(const ModelReadOptions& reading, bool as_open,
                       std::vector<TileChoice>& tiles) {
  for (TileChoice& choice : tiles) {
    auto* const file = std::get_if<TileFile>(&choice);
    if (file == nullptr) continue;
    Result<MicroTile> tile = read_tile_file(file->path, reading, as_open);
    if (!tile) {
      Error error = tile.error();
      error.place.file = file->path;
      return error;
    }
    file->tile = std::move(*tile);
  }
  return ok_status();
}

Result<MicroTile> make_tile(const TileChoice& tile, unsigned arms,
                            const std::optional<std::array<std::int32_t, 2>>& range) {
  if (const auto* const file = std::get_if<TileFile>(&tile)) return file->tile;
  if (const auto* const frame = std::get_if<FrameShape>(&tile)) {
    FrameShape shape = *frame;
    shape.arms &= arms;
    return frame_tile(shape);
  }
  if (const auto* const curves = std::get_if<Curves3Shape>(&tile)) return curves3_tile(*curves);
  const auto* const sheets = std::get_if<JackSheets>(&tile);
  JackShape shape = sheets != nullptr ? sheets->jack : std::get<JackShape>(tile);
  shape.arms &= arms;
  shape.range = range;
  Result<MicroTile> jack = jack_tile(shape);
  if (!jack || sheets == nullptr) return jack;
  jack->name = jack->name.replace(0, 4, "jack-surfaces");
  return sheets_of(std::move(*jack));
}

Result<MicroTile> make_bifurcation(const TileChoice& tile, unsigned arms,
                                   const std::optional<std::array<std::int32_t, 2>>& range) {
  JackShape shape = std::get<JackShape>(tile);
  shape.arms &= arms & kArmsOfBifurcation;
  shape.range = range;
  return bifurcation_tile(shape);
}

std::string take_doubling(const std::string& text, std::optional<std::uint64_t>& layer) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  if (text.starts_with("w=")) {
    const auto read = std::from_chars(text.data() + 2, end, number);
    if (read.ec == std::errc() && read.ptr == end && number > 0) {
      layer = number;
      return "";
    }
  }
  return "needs w=L, L the number of a layer from 1, not " + text;
}

const char* defect_in_words(const TileDefect& defect) {
  constexpr std::array<std::pair<std::string_view, const char*>, 6> kWords{
      {{"S0", "the surface is not closed"},
       {"F1", "the tile is not star-shaped"},
       {"F2", "the tile is not star-shaped"},
       {"F3", "the patches do not bound one solid"},
       {"T2", "the tile leaves the cube, or touches a wall off its caps"},
       {"T3", "caps of one wall touch each other"}}};
  for (const auto& [condition, words] : kWords)
    if (condition == defect.condition) return words;
  return "";
}

}  // namespace veritope::cli
