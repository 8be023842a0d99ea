// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/tile_option.h: tiles as options of veritope micro: "jack,node=1/5,cap=1/8,degree=3", "frame", or a file.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/model_file.h"
#include "solids/micro/frame.h"
#include "solids/micro/jack.h"
#include "solids/micro/open_tile.h"
#include "solids/micro/tile_analysis.h"

namespace veritope::cli {

/// A file with a tile, and the tile once it was read.
struct TileFile {
  std::string path;
  MicroTile tile;
};
/// The sides of a jack, without caps: "jack-surfaces".
struct JackSheets {
  JackShape jack;
};
/// What --tile says: a jack or a branch, a frame, curves, sheets, or a file.
using TileChoice = std::variant<JackShape, FrameShape, TileFile, Curves3Shape, JackSheets>;

/// Whether it is a tile of curves or sheets, whatever files hold.
inline bool is_open_choice(const TileChoice& tile) {
  return std::holds_alternative<Curves3Shape>(tile) || std::holds_alternative<JackSheets>(tile);
}
/// "curves3", for such a tile.
inline const char* open_choice_name(const TileChoice& tile) {
  return std::holds_alternative<Curves3Shape>(tile) ? "curves3" : "jack-surfaces";
}

/// Appends the tile. Returns nothing, or what is wrong with the text, in words that follow the name of the option. A
/// text without a name of a tile is the path of a file, which is not read here.
std::string take_tile(const std::string& text, std::vector<TileChoice>& tiles);

/// "10,10,10": the numbers of cells along three axes, from 1. Returns nothing, or what is wrong with the text.
std::string take_counts(const std::string& text,
                        std::optional<std::array<std::uint64_t, 3>>& counts);
/// Such numbers, or some for each of several volumes, with / between them.
std::string take_counts_of_volumes(const std::string& text,
                                   std::vector<std::array<std::uint64_t, 3>>& counts);

/// The name by which a microstructure keeps a file: without its folders, and with Latin-1 characters for its bytes if
/// it is not UTF-8.
std::string stored_name(const std::string& path);

/// Reads the tiles that are files, as closed surfaces, or as curves and sheets. Triangles of closed ones are cut
/// into quadrilaterals where that may help a proof: TileFacets.
/// @error  as read_model_file and tile_of or open_tile_of, with the file
Status read_tile_files(const ModelReadOptions& reading, bool as_open,
                       std::vector<TileChoice>& tiles);

/// The tile with arms to these walls at most; a file's tile has all its caps.
/// @param range  of the numbers of walls; tiles without a thickness do not use it
/// @error  as jack_tile and frame_tile
Result<MicroTile> make_tile(const TileChoice& tile, unsigned arms,
                            const std::optional<std::array<std::int32_t, 2>>& range);

/// The tile below 2 x 2 jacks like this one. REQUIRES a jack.
/// @error  as bifurcation_tile
Result<MicroTile> make_bifurcation(const TileChoice& tile, unsigned arms,
                                   const std::optional<std::array<std::int32_t, 2>>& range);

/// "w=3": the layer. Returns nothing, or what is wrong with the text.
std::string take_doubling(const std::string& text, std::optional<std::uint64_t>& layer);

/// "the surface is not closed", for the condition S0.
const char* defect_in_words(const TileDefect& defect);

}  // namespace veritope::cli
