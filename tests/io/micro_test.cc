// SPDX-License-Identifier: LGPL-3.0-or-later
// Files .vmicro: what is read is written, canonical files come back byte for byte, and each refusal has its line.
#include <random>

#include "io/formats.h"
#include "io/micro/write_micro.h"
#include "solids/micro/micro_validity.h"
#include "tests/io/io_test_util.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

using namespace std::string_literals;

Result<MicroFile> parse_micro(const std::string& text, const ReadLimits& limits = {}) {
  const std::string name = "model.vmicro";
  const ByteBuffer buffer = copy_to_buffer(io_test::bytes(text));
  return read_micro(MicroFormat::kMicro, source_of(buffer, name), limits);
}

const std::string& three_cells() {
  static const std::string text =
      io_test::slurp(test::source_dir() + "/tests/models/micro/three_cells.vmicro");
  return text;
}

/// The text with the first `from` replaced.
std::string changed(const std::string& from, const std::string& to,
                    std::string text = three_cells()) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

/// "ok", or "code@line: message".
std::string said(const Result<MicroFile>& file) {
  if (file) return "ok";
  const Error& e = file.error();
  return code_name(e.code) + "@"s + (e.place.line ? std::to_string(*e.place.line) : "none") + ": " +
         e.message;
}

std::string repeated(const std::string& item, std::size_t count, const std::string& separator) {
  std::string out;
  for (std::size_t i = 0; i < count; ++i) out += (i == 0 ? "" : separator) + item;
  return out;
}

constexpr const char* kPoint = R"(["1/2", "1/2", "1/2"])";

std::string tile_of(const std::string& patches) {
  return R"({"name": "t", "range": null, "patches": [)" + patches + "]}";
}
std::string patch_of(int p, int q, std::size_t num_points) {
  return R"({"wall": null, "degrees": [)" + std::to_string(p) + "," + std::to_string(q) +
         R"(], "points": [[)" + repeated(kPoint, num_points, ", ") + "]]}";
}
std::string volume_of(const std::string& end = "1") {
  std::string points;
  for (const char* p :
       {R"(["0", "0", "0"])", R"(["0", "0", "1"])", R"(["0", "1", "0"])", R"(["0", "1", "1"])",
        R"(["1", "0", "0"])", R"(["1", "0", "1"])", R"(["1", "1", "0"])", R"(["1", "1", "1"])"})
    points += (points.empty() ? "" : ", ") + std::string(p);
  const std::string knots = R"(["0", "0", ")" + end + R"(", ")" + end + R"("])";
  return R"({"kind": "volume", "group": null, "attributes": [], "shape": {"degrees": [1, 1, 1],
 "periodic": [false, false, false], "knots": [)" +
         repeated(knots, 3, ", ") + R"(], "rational": false, "components": 3, "points": [)" +
         points + "]}}";
}
std::string breaks_of(std::size_t intervals) {
  std::string out = "[";
  for (std::size_t i = 0; i <= intervals; ++i)
    out += (i == 0 ? "\"" : ", \"") + std::to_string(i) + '"';
  return out + "]";
}
/// A file whose tiles do not depend on walls.
std::string micro_of(const std::string& volumes, const std::string& grids, const std::string& tiles,
                     const std::string& cells) {
  return R"({"format": "veritope-micro-1", "model": null, "cage":
{"format": "veritope-spline-1", "groups": [], "entities": [)" +
         volumes + "]},\n\"grids\": [" + grids + "],\n\"tiles\": [" + tiles + "],\n\"cells\": [" +
         cells + "],\n\"walls\": []}\n";
}
constexpr const char* kUnitGrid =
    R"({"volume": 0, "breaks": [["0", "1"], ["0", "1"], ["0", "1"]]})";

void expect_same(const Microstructure& a, const Microstructure& b) {
  EXPECT_EQ(a.model, b.model);
  EXPECT_EQ(a.cage, b.cage);
  EXPECT_EQ(a.tiles, b.tiles);
  ASSERT_EQ(a.grids.size(), b.grids.size());
  for (std::size_t g = 0; g < a.grids.size(); ++g) {
    EXPECT_EQ(a.grids[g].volume, b.grids[g].volume);
    EXPECT_EQ(a.grids[g].breaks, b.grids[g].breaks);
    EXPECT_EQ(a.grids[g].tiles, b.grids[g].tiles);
    EXPECT_EQ(a.grids[g].walls, b.grids[g].walls);
  }
}

TEST(Micro, ReadsWhatTheFileHolds) {
  const auto file = parse_micro(three_cells());
  ASSERT_TRUE(file) << said(file);
  const Microstructure& m = file->micro;
  EXPECT_EQ(file->bytes, three_cells().size());
  EXPECT_FALSE(file->has_names_in_cage);
  EXPECT_EQ(m.model, (MicroModelName{"a bar", std::string(64, '0')}));
  ASSERT_EQ(m.cage.size(), 1u);
  EXPECT_EQ(m.cage[0].axis(0).knots, (std::vector<Rational>{0, 0, 1, 3, 3}));
  ASSERT_EQ(m.grids.size(), 1u);
  EXPECT_EQ(m.grids[0].breaks[0], (std::vector<Rational>{0, 1, 2, 3}));
  EXPECT_EQ(m.grids[0].tiles, (std::vector<std::uint8_t>{1, 1, 2}));
  EXPECT_EQ(m.grids[0].numbers_of({1, 0, 0}), (WallNumbers{1 << 18, 1 << 20, 0, 0, 0, 0}));
  ASSERT_EQ(m.tiles.size(), 2u);
  EXPECT_EQ(m.tiles[0].name, "post");
  EXPECT_EQ(m.tiles[0].range, (std::array<std::int32_t, 2>{0, 1 << 20}));
  EXPECT_EQ(m.tiles[0].patches[0].wall, 0);
  EXPECT_EQ(m.tiles[0].patches.size(), 10u);
  EXPECT_EQ(m.tiles[1].patches[0].wall, std::nullopt);
  EXPECT_EQ(points_at(m.tiles[0].patches[0], 1 << 19)[0],
            (TilePoint{0, Rational(5, 16), Rational(5, 16)}));
  EXPECT_TRUE(validate(m));
}

TEST(Micro, CanonicalFilesComeBackByteForByte) {
  const auto file = parse_micro(three_cells());
  ASSERT_TRUE(file) << said(file);
  EXPECT_EQ(write_micro(file->micro), three_cells());
}

TEST(Micro, OtherSpellingsHaveTheSameCanonicalForm) {
  std::string text = changed(R"("3/8")", R"("0.375")");
  text = changed(R"([524288,262144,1048576,0])", "[ 524288 ,\r\n\t262144 , 1048576,0 ]", text);
  text = changed(R"({"volume": 0, "breaks": [["0", "1", "2", "3"], ["0", "1"], ["0", "1"]]})",
                 R"({"breaks": [["0","1","0x1p1","6/2"],["0","1"],["0","1"]],"volume":0})", text);
  text = changed(R"("a bar")", R"("\u0061 bar")", text);
  const auto file = parse_micro("\xEF\xBB\xBF  " + text);
  ASSERT_TRUE(file) << said(file);
  EXPECT_EQ(write_micro(file->micro), three_cells());
}

TEST(Micro, NamesInTheCageAreNotKept) {
  const auto file =
      parse_micro(changed(R"("attributes": [])", R"("attributes": ["[material oak]"])"));
  ASSERT_TRUE(file) << said(file);
  EXPECT_TRUE(file->has_names_in_cage);
  EXPECT_EQ(write_micro(file->micro), three_cells());
}

TEST(Micro, EmptyListsAreWrittenWithoutLines) {
  const std::string text = micro_of(volume_of(), "", tile_of(patch_of(1, 1, 4)), "");
  const auto file = parse_micro(text);
  ASSERT_TRUE(file) << said(file);
  const std::string written = write_micro(file->micro);
  EXPECT_NE(written.find("\"grids\": [],\n"), written.npos);
  EXPECT_TRUE(written.ends_with("\"cells\": [],\n\"walls\": []}\n")) << written;
  EXPECT_EQ(write_micro(parse_micro(written).value().micro), written);
}

TEST(Micro, EachRefusalHasItsLineAndItsValue) {
  const std::string digits(64, '0');
  const struct {
    std::string from, to, expected;
  } cases[] = {
      {"veritope-micro-1", "veritope-micro-2",
       "unknown-format@1: the format must be 'veritope-micro-1', not 'veritope-micro-2'"},
      {"\"model\"", "\"modell\"", "syntax@2: unknown key 'modell'"},
      {digits, digits.substr(1) + "A", "syntax@2: 64 lower-case hexadecimal digits expected"},
      {digits, digits.substr(1), "syntax@2: 64 lower-case hexadecimal digits expected"},
      {"\"kind\": \"volume\"", "\"kind\": \"ball\"", "syntax@5: unknown kind of entity 'ball'"},
      {"veritope-spline-1", "veritope-spline-2", "unknown-format@3: "},
      {"[\"0\", \"0\", \"1\", \"3\", \"3\"]", "[\"-1\", \"0\", \"1\", \"3\", \"3\"]",
       "bad-argument@5: volume 0 of the cage: axis 0 is not clamped"},
      {"{\"volume\": 0", "{\"volume\": 1",
       "over-limit@24: the volume of a grid must be an integer from 0 to 0, not '1'"},
      {"{\"volume\": 0", "{\"volume\": -1",
       "syntax@24: the volume of a grid must be an integer from 0 to 0, not '-1'"},
      {"{\"volume\": 0", "{\"volume\": 0.0", "syntax@24: "},
      {"{\"volume\": 0", "{\"volume\": 00", "syntax@24: "},
      {"[\"0\", \"1\", \"2\", \"3\"]", "[\"0\"]",
       "bad-argument@24: grid 0: axis 0: at least 2 breaks are needed, and there are 1"},
      {"[\"0\", \"1\", \"2\", \"3\"]", "[\"0\", \"1\", \"1\", \"3\"]",
       "bad-argument@24: grid 0: axis 0: break 2, 1, is not above the one before it, 1"},
      {"[\"0\", \"1\", \"2\", \"3\"]", "[\"0\", \"1\", \"2\", \"4\"]",
       "bad-argument@24: grid 0: axis 0: the break 4 is not in the domain from 0 to 3"},
      {"[\"0\", \"1\", \"2\", \"3\"]", "[\"-1\", \"1\", \"2\", \"3\"]",
       "bad-argument@24: grid 0: axis 0: the break -1 is not in the domain from 0 to 3"},
      {"[\"0\", \"1\", \"2\", \"3\"]", "[\"0\", \"3/2\", \"2\", \"3\"]",
       "bad-argument@24: grid 0: axis 0: the knot 1 is no break"},
      {"[\"0\", \"1\"], [\"0\", \"1\"]]}],", "[\"0\", \"1\"]]}],", "syntax@24: "},
      {"\"range\": [0,1048576]", "\"range\": [2,1]",
       "bad-argument@26: tile 0: the range from 2 to 1 is no range between 0 and 1048576"},
      {"\"range\": [0,1048576]", "\"range\": [0,1048577]",
       "over-limit@26: an end of a range must be an integer from 0 to 1048576, not '1048577'"},
      {"\"range\": [0,1048576]", "\"range\": null",
       "bad-argument@26: tile 0: a patch names a wall, and there is no range"},
      {"\"range\": null", "\"range\": [0,0]",
       "bad-argument@27: tile 1: it has a range, and no patch names a wall"},
      {"\"wall\": 0", "\"wall\": 6",
       "over-limit@26: the wall of a patch must be an integer from 0 to 5, not '6'"},
      {"\"wall\": 0", "\"wall\": null",
       "bad-argument@26: tile 0: patch 0: it names no wall and has 2 lists of points, not 1"},
      {"\"degrees\": [1,1]", "\"degrees\": [1,2]",
       "bad-argument@26: tile 0: patch 0: list 0 has 4 points, and the degrees (1, 2) need 6"},
      {"\"degrees\": [1,1]", "\"degrees\": [1,0]",
       "bad-argument@26: tile 0: patch 0: a degree must be from 1 to 7, not 0"},
      {"\"degrees\": [1,1]", "\"degrees\": [1]", "syntax@26: ',' expected, but there is ']'"},
      {"\"3/8\"", "\"3/0\"", "not-finite@26: the number '3/0' is not finite"},
      {"\"3/8\"", "0.5", "syntax@26: a string expected, but there is '0.5'"},
      {"[\"c\", \"2\"]", "[\"c\", \"6\"]", "syntax@29: grid 0: cell 1 holds the tiles 0 and 1"},
      {"[\"c\", \"2\"]", "[\"c\", \"3\"]",
       "syntax@29: grid 0: the bit of cell 3 is set, and there are 3 cells"},
      {"[\"c\", \"2\"]", "[\"c\", \"\"]",
       "syntax@29: grid 0: digit 0 of 1 of the cells that hold tile 1 must be a lower-case "
       "hexadecimal digit, not '\"'"},
      {"[\"c\", \"2\"]", "[\"C\", \"2\"]", "syntax@29: grid 0: digit 0 of 1 "},
      {"[\"c\", \"2\"]", "[\"c0\", \"2\"]",
       "syntax@29: grid 0: the end of a string expected after 1 digits, but there is '0'"},
      {"[\"c\", \"2\"]", "[\"c\"]", "syntax@29: ',' expected, but there is ']'"},
      {"[\"c\", \"2\"]", "[\"c\", \"2\", \"0\"]", "syntax@29: ']' expected, but there is ','"},
      {"[\"c\", \"2\"]],", "],", "syntax@29: '[' expected, but there is ']'"},
      {"524288,", "1048577,",
       "over-limit@31: the number of a wall must be an integer from 0 to 1048576, not '1048577'"},
      {"524288,", "99999999999999999999,", "over-limit@31: the number of a wall must be "},
      {"524288,", "-1,", "syntax@31: the number of a wall must be "},
      {"524288,", "01,", "syntax@31: the number of a wall must be "},
      {"524288,", "1.0,", "syntax@31: the number of a wall must be "},
      {"524288,", "1e3,", "syntax@31: the number of a wall must be "},
      {"524288,", "", "syntax@31: ',' expected, but there is ']'"},
      {"524288,", "524288,0,", "syntax@31: ']' expected, but there is ','"},
      {"524288,", ",", "syntax@31: the number of a wall must be an integer from 0 to 1048576, not"},
      {"[[524288,262144,1048576,0], [0,0,0,0,0,0], [0,0,0,0,0,0]]", "",
       "syntax@31: '[' expected, but there is ']'"},
      {"\"model\": {\"name\": \"a bar\"", "\"model\": {\"name\": \"\xFF\"",
       "syntax@2: a string is not UTF-8"},
      {"]]]}\n", "]]]}\n}", "syntax@32: the end of the file expected, but there is '}'"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.from + " -> " + c.to);
    const std::string answer = said(parse_micro(changed(c.from, c.to)));
    EXPECT_TRUE(answer.starts_with(c.expected)) << answer;
  }
}

TEST(Micro, WallsWithoutATileHaveTheNumber0) {
  std::string text = changed("[\"c\", \"2\"]", "[\"8\", \"2\"]");
  EXPECT_EQ(said(parse_micro(text)), "ok");  // each wall of the empty cell has a neighbour
  text = changed("[\"8\", \"2\"]", "[\"8\", \"0\"]", text);
  EXPECT_EQ(said(parse_micro(text)),
            "bad-argument@31: grid 0: axis 0: wall 2 has the number 1048576, and no neighbour "
            "holds a tile");
  text = changed("1048576,0], [0", "0,0], [0", text);
  EXPECT_EQ(said(parse_micro(text)), "ok");
  text = changed("], [0,0,0,0,0,0]", "], [1,1,0,0,0,7]", text);
  EXPECT_EQ(said(parse_micro(text)),
            "bad-argument@31: grid 0: axis 1: wall 5 has the number 7, and no neighbour holds a "
            "tile");
}

TEST(Micro, WallsAreEmptyWithoutRanges) {
  const std::string text = micro_of(volume_of(), kUnitGrid, tile_of(patch_of(1, 1, 4)), "[\"8\"]");
  EXPECT_EQ(said(parse_micro(text)), "ok");
  EXPECT_EQ(said(parse_micro(changed("\"walls\": []", "\"walls\": [[[0,0], [0,0], [0,0]]]", text))),
            "syntax@7: ']' expected, but there is '['");
}

TEST(Micro, TheKeysComeInTheirOrder) {
  const std::string text = micro_of(volume_of(), "", tile_of(patch_of(1, 1, 4)), "");
  EXPECT_EQ(said(parse_micro(
                changed("\"cells\": [],\n\"walls\": []", "\"walls\": [],\n\"cells\": []", text))),
            "syntax@6: the key 'cells' must come before the key 'walls'");
  EXPECT_EQ(said(parse_micro(changed(",\n\"walls\": []", "", text))),
            "syntax@1: the key 'walls' is missing");
  EXPECT_EQ(said(parse_micro(changed("\"cells\"", "\"grids\"", text))),
            "syntax@6: the key 'grids' occurs twice");
}

TEST(Micro, GridsComeByVolumesAndDoNotOverlap) {
  const auto with_grids = [](const std::string& second, const std::string& first = kUnitGrid) {
    return said(parse_micro(micro_of(volume_of("2") + ", " + volume_of("2"), first + ",\n" + second,
                                     tile_of(patch_of(1, 1, 4)), "[\"8\"], [\"0\"]")));
  };
  const auto grid = [](int volume, const std::string& x) {
    return "{\"volume\": " + std::to_string(volume) + ", \"breaks\": [" + x +
           R"(, ["0", "1"], ["0", "1"]]})";
  };
  EXPECT_EQ(with_grids(grid(1, R"(["0", "1"])")), "ok");
  EXPECT_EQ(with_grids(grid(0, R"(["1", "2"])")), "ok");
  EXPECT_EQ(with_grids(kUnitGrid, grid(0, R"(["1", "2"])")), "ok");
  EXPECT_TRUE(with_grids(kUnitGrid, grid(1, R"(["0", "1"])"))
                  .starts_with("bad-argument@6: grid 1: its volume, 0, is below that of the grid "
                               "before it, 1"));
  for (const char* x : {R"(["0", "1"])", R"(["1/2", "2"])", R"(["1/3", "1/2"])", R"(["0", "2"])"})
    EXPECT_EQ(with_grids(grid(0, x)),
              "bad-argument@6: the boxes of the grids 0 and 1 of volume 0 have inner points in "
              "common")
        << x;
}

TEST(Micro, LimitsHoldAtTheirNumbers) {
  const auto with = [](const std::string& tiles, std::size_t num_tiles = 1) {
    return said(parse_micro(
        micro_of(volume_of(), kUnitGrid, tiles, "[" + repeated("\"0\"", num_tiles, ", ") + "]")));
  };
  const std::string patch = patch_of(1, 1, 4);
  EXPECT_EQ(with(repeated(tile_of(patch), 15, ", "), 15), "ok");
  EXPECT_EQ(with(repeated(tile_of(patch), 16, ", "), 16), "over-limit@5: more than 15 tiles");
  EXPECT_EQ(with("", 0), "syntax@5: there are 0 tiles");
  EXPECT_EQ(with(tile_of(repeated(patch, 1024, ", "))), "ok");
  EXPECT_EQ(with(tile_of(repeated(patch, 1025, ", "))),
            "over-limit@5: more than 1024 patches of a tile");
  EXPECT_EQ(with(tile_of("")), "bad-argument@5: tile 0: it has 0 patches");
  EXPECT_EQ(with(tile_of(patch_of(7, 7, 64))), "ok");
  EXPECT_EQ(with(tile_of(patch_of(7, 7, 65))),
            "over-limit@5: more than 64 points in a list of a patch");
  EXPECT_EQ(with(tile_of(patch_of(8, 1, 18))),
            "over-limit@5: a degree must be an integer from 0 to 7, not '8'");
  const std::string most = "340282366920938463463374607431768211455",
                    more = "340282366920938463463374607431768211456";
  for (const std::string& coordinate : {"-" + most, "1/" + most, most + "/2"})
    EXPECT_EQ(with(tile_of(changed("1/2", coordinate, patch))), "ok") << coordinate;
  for (const std::string& coordinate : {"-" + more, "1/" + more})
    EXPECT_TRUE(with(tile_of(changed("1/2", coordinate, patch)))
                    .starts_with("over-limit@5: tile 0: patch 0: coordinate 0 of point 0 of list 0 "
                                 "has a numerator or denominator of more than 128 bits: "))
        << coordinate;
  const auto with_powers = [&](std::size_t powers) {
    const std::string list = "[" + repeated(kPoint, 4, ", ") + "]";
    std::string text = changed("[" + list + "]", "[" + repeated(list, powers, ", ") + "]", patch);
    text = changed("null", "3", text);
    std::string file =
        micro_of(volume_of(), kUnitGrid, changed("null", "[5,5]", tile_of(text)), "[\"8\"]");
    return said(parse_micro(changed("\"walls\": []", "\"walls\": [[[0,0], [0,9], [0,0]]]", file)));
  };
  EXPECT_EQ(with_powers(1), "ok");
  EXPECT_EQ(with_powers(4), "ok");
  EXPECT_EQ(with_powers(5), "over-limit@5: more than 4 lists of points of a patch");
  EXPECT_EQ(with_powers(0), "bad-argument@5: tile 0: patch 0: it has 0 lists of points");
}

TEST(Micro, LimitsOfVolumesGridsAndCellsHoldAtTheirNumbers) {
  const auto with_grids = [](std::size_t count, std::size_t per_volume) {
    std::string grids, cells;
    for (std::size_t i = 0; i < count; ++i) {
      grids += (i == 0 ? "" : ",\n") + R"({"volume": )"s + std::to_string(i / per_volume) +
               R"(, "breaks": [[")" + std::to_string(i) + "\", \"" + std::to_string(i + 1) +
               R"("], ["0", "1"], ["0", "1"]]})";
      cells += i == 0 ? "[\"8\"]" : ", [\"8\"]";
    }
    const std::string volumes = repeated(volume_of("70000"), 257, ", ");
    return said(parse_micro(micro_of(volumes, grids, tile_of(patch_of(1, 1, 4)), cells)));
  };
  EXPECT_EQ(with_grids(4096, 4096), "ok");
  EXPECT_EQ(with_grids(4097, 5000), "over-limit@4356: volume 0 has more than 4096 grids");
  EXPECT_EQ(with_grids(65536, 256), "ok");
  EXPECT_EQ(with_grids(65537, 256), "over-limit@65796: more than 65536 grids");
  const auto with_volumes = [](std::size_t count) {
    return said(parse_micro(micro_of(repeated(volume_of(), count, ",\n"), kUnitGrid,
                                     tile_of(patch_of(1, 1, 4)), "[\"8\"]")));
  };
  EXPECT_EQ(with_volumes(65536), "ok");
  EXPECT_EQ(with_volumes(65537), "over-limit@2: the cage has 65537 volumes, more than 65536");
  EXPECT_EQ(with_volumes(0), "syntax@2: the cage has 0 volumes");
  // 2^27 cells and one more; their strings are missing.
  const std::string many = breaks_of(512), one = R"(["600", "601"])";
  const std::string grid = R"({"volume": 0, "breaks": [)" + repeated(many, 3, ", ") + "]}";
  const auto with_cells = [&](const std::string& grids) {
    return said(
        parse_micro(micro_of(volume_of("5000"), grids, tile_of(patch_of(1, 1, 4)), "[\"8\"]")));
  };
  EXPECT_TRUE(
      with_cells(grid).starts_with("truncated@6: grid 0: 33554432 digits are needed, and only "));
  EXPECT_EQ(
      with_cells(grid + ",\n" + R"({"volume": 0, "breaks": [)" + repeated(one, 3, ", ") + "]}"),
      "over-limit@5: grid 1: the grids have more than 134217728 cells");
}

TEST(Micro, AnnouncedWallsAreNotAllocated) {
  std::string text =
      changed(R"(["0", "1"], ["0", "1"]]})", breaks_of(512) + ", " + breaks_of(512) + "]}");
  text = changed(R"(["0", "0", "1", "1"],
   ["0", "0", "1", "1"])",
                 R"(["0", "0", "512", "512"],
   ["0", "0", "512", "512"])",
                 text);
  const std::string digits(3 * 512 * 512 / 4, '0');
  text = changed("[\"c\", \"2\"]", "[\"" + digits + "\", \"" + digits + "\"]", text);
  const std::string answer = said(parse_micro(text));
  EXPECT_TRUE(answer.starts_with("truncated@31: 1048576 numbers of walls are announced, but only "))
      << answer;
}

TEST(Micro, EveryTruncatedFileIsRefused) {
  const std::string& text = three_cells();
  for (std::size_t size = 0; size + 1 < text.size(); ++size) {
    const auto file = parse_micro(text.substr(0, size));
    ASSERT_FALSE(file) << size;
    EXPECT_TRUE(file.error().code == Code::kTruncated || file.error().code == Code::kSyntax)
        << size << " " << said(file);
    EXPECT_TRUE(file.error().place.line) << size;
  }
  EXPECT_TRUE(parse_micro(text.substr(0, text.size() - 1)));  // only the last line feed is missing
}

TEST(Micro, MutatedFilesAreRefusedOrComeBack) {
  constexpr unsigned kSeed = 20261127;
  std::mt19937 random(kSeed);
  const std::string& text = three_cells();
  const std::string letters = "0123456789abcdef,:[]{}\"\\- /.enul\n";
  int num_read = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string mutated = text;
    for (unsigned k = random() % 3 + 1; k > 0; --k) {
      const std::size_t at = random() % mutated.size();
      const char letter = letters[random() % letters.size()];
      switch (random() % 4) {
        case 0: mutated.erase(at, random() % 8 + 1); break;
        case 1: mutated.insert(at, 1, letter); break;
        case 2: mutated.insert(at, mutated.substr(random() % mutated.size(), random() % 40)); break;
        default: mutated[at] = letter;
      }
    }
    const auto file = parse_micro(mutated);
    if (!file) {
      EXPECT_TRUE(file.error().place.line) << "seed " << kSeed << ", case " << i << "\n" << mutated;
      continue;
    }
    ++num_read;
    EXPECT_TRUE(validate(file->micro)) << "seed " << kSeed << ", case " << i << "\n" << mutated;
    const std::string written = write_micro(file->micro);
    const auto again = parse_micro(written);
    ASSERT_TRUE(again) << said(again) << "\nseed " << kSeed << ", case " << i << "\n" << mutated;
    expect_same(again->micro, file->micro);
    EXPECT_EQ(write_micro(again->micro), written);
  }
  EXPECT_GT(num_read, 100);
}

TEST(Micro, RandomCellsAndWallsComeBack) {
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  for (int i = 0; i < 50; ++i) {
    Microstructure micro = parse_micro(three_cells()).value().micro;
    MicroGrid& grid = micro.grids[0];
    for (std::size_t a = 1; a < 3; ++a) {
      grid.breaks[a].clear();
      const auto n = static_cast<int>(random() % 6 + 1);
      for (int k = 0; k <= n; ++k) grid.breaks[a].emplace_back(Integer(k), Integer(n));
    }
    grid.tiles.assign(grid.shape().count(), 0);
    for (std::uint8_t& t : grid.tiles) t = static_cast<std::uint8_t>(random() % 3);
    for (std::size_t a = 0; a < 3; ++a) {
      const Grid<3> shape = grid.wall_shape(a);
      grid.walls[a].assign(shape.count(), 0);
      for (std::size_t w = 0; w < shape.count(); ++w) {
        // The two neighbours, found by their indices.
        auto cell = shape.index_of(w);
        const bool has_after = cell[a] < grid.shape().size[a] && grid.tiles[grid.shape().at(cell)];
        bool has_before = false;
        if (cell[a] > 0) --cell[a], has_before = grid.tiles[grid.shape().at(cell)] != 0;
        if (has_before || has_after)
          grid.walls[a][w] = static_cast<std::int32_t>(random() % (kMaxWallNumber + 1));
        else if (random() % 500 == 0) {
          grid.walls[a][w] = 1;
          EXPECT_FALSE(validate(micro)) << "seed " << kSeed << ", case " << i;
          grid.walls[a][w] = 0;
        }
      }
    }
    ASSERT_TRUE(validate(micro)) << to_string(validate(micro).error()) << " seed " << kSeed;
    const auto back = parse_micro(write_micro(micro));
    ASSERT_TRUE(back) << said(back);
    expect_same(back->micro, micro);
  }
}

TEST(Micro, NumbersBeyondTheDefaultLimitsAreRemembered) {
  ReadLimits wide;
  wide.max_digits = 5000;
  const std::string longer = "0." + std::string(2000, '0') + "1";
  EXPECT_FALSE(parse_micro(three_cells(), wide).value().beyond_default_limits);
  const std::string in_cage =
      changed("[\"3\", \"3/4\", \"0\"]", "[\"3\", \"3/4\", \"" + longer + "\"]");
  EXPECT_TRUE(parse_micro(in_cage, wide).value().beyond_default_limits);
  EXPECT_EQ(said(parse_micro(in_cage)).substr(0, 10), "over-limit");
  const std::string in_breaks = changed("\"2\", \"3\"]", "\"2." + longer.substr(2) + "\", \"3\"]");
  EXPECT_EQ(said(parse_micro(in_breaks, wide)).substr(0, 10), "over-limit");  // 2048 bits
}

TEST(Micro, ContentIsRecognisedByItsFirstMember) {
  const auto looks = [](const std::string& text) {
    const std::string name = "-";
    const ByteBuffer buffer = copy_to_buffer(io_test::bytes(text));
    const ModelFormat* const row = format_from_content(source_of(buffer, name));
    return row == nullptr ? "none" : row->name;
  };
  EXPECT_STREQ(looks(three_cells()), "vmicro");
  EXPECT_STREQ(looks("{\"format\":\"veritope-micro-1\"}"), "vmicro");
  EXPECT_STREQ(looks(" {\n \"format\" :\t\"veritope-micro-1\", \"veritope-spline-1\"}"), "vmicro");
  EXPECT_STREQ(looks("{\"format\": \"veritope-spline-1\", \"veritope-micro-1\": 0}"), "vjson");
  EXPECT_STREQ(looks("{\"groups\": [], \"format\": \"veritope-spline-1\"}"), "vjson");
  EXPECT_STREQ(looks("{\"format\": \"veritope-micro-12\"}"), "none");
  EXPECT_STREQ(looks("{\"format\": \"other\", \"veritope-spline-1\": 0}"), "none");
  EXPECT_STREQ(looks("{\"format\""), "none");
}

}  // namespace
}  // namespace veritope
