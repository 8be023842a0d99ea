// SPDX-License-Identifier: LGPL-3.0-or-later
// Files .vmicro with bridges, sweeps and materials: what is read is written, and each refusal has its line.
#include "io/micro/read_micro.h"
#include "io/micro/write_micro.h"
#include "tests/io/io_test_util.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

Result<MicroFile> parse_bridges(const std::string& text) {
  const std::string name = "model.vmicro";
  const ByteBuffer buffer = copy_to_buffer(io_test::bytes(text));
  return read_micro(MicroFormat::kMicro, source_of(buffer, name), {});
}

/// Three cells in a row; the members follow the walls.
std::string with_members(const std::string& members) {
  std::string text = io_test::slurp(test::source_dir() + "/tests/models/micro/three_cells.vmicro");
  EXPECT_TRUE(text.ends_with("}\n"));
  text.resize(text.size() - 2);
  return text + members + "}\n";
}

constexpr const char* kBridge =
    R"({"grid": 0, "cell": 1, "wall": 3, "volume": 0, "degrees": [1,1], "points": [)"
    R"(["5/4", "0", "1/4"], ["5/4", "1/8", "1/4"], ["5/4", "1/4", "1/4"], )"
    R"(["5/4", "0", "3/4"], ["5/4", "1/8", "3/4"], ["5/4", "1/4", "3/4"], )"
    R"(["7/4", "0", "1/4"], ["7/4", "1/8", "1/4"], ["7/4", "1/4", "1/4"], )"
    R"(["7/4", "0", "3/4"], ["7/4", "1/8", "3/4"], ["7/4", "1/4", "3/4"]]})";
constexpr const char* kMaterial =
    R"({"name": "glass", "values": [[0,-1,1048576,3,4503599627370495,-4503599627370495,6,7,8,9,10,11,12,13,14,15]]})";

constexpr const char* kSweep =
    R"({"grid": 0, "cell": 1, "wall": 3, "axis": [["0", "1/8", "-1/16"], ["1/4", "1/3", "0"]]})";

std::string with_bridges(const std::string& bridges) {
  return with_members(",\n\"bridges\": [\n" + bridges + "]");
}
std::string with_sweeps(const std::string& sweeps) {
  return with_members(",\n\"sweeps\": [\n" + sweeps + "]");
}
std::string altered(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}
std::string answer_to(const std::string& text) {
  const auto file = parse_bridges(text);
  if (file) return "ok";
  const Error& e = file.error();
  return code_name(e.code) + ("@" + std::to_string(e.place.line.value_or(0))) + ": " + e.message;
}

TEST(MicroBridges, ComeBackByteForByte) {
  const std::string text = with_members(",\n\"bridges\": [\n" + std::string(kBridge) +
                                        "],\n\"materials\": [\n" + kMaterial + "]");
  const auto file = parse_bridges(text);
  ASSERT_TRUE(file) << answer_to(text);
  const Microstructure& m = file->micro;
  ASSERT_EQ(m.bridges.size(), 1u);
  const MicroBridge& b = m.bridges[0];
  EXPECT_EQ(b.cap, (CapPlace{0, 1, 3}));
  EXPECT_EQ(b.volume, 0u);
  EXPECT_EQ(b.degrees, (std::array<int, 2>{1, 1}));
  EXPECT_EQ(b.points[b.at(1, 0, 2)], (TilePoint{Rational(7, 4), Rational(1, 4), Rational(1, 4)}));
  ASSERT_EQ(m.materials.size(), 1u);
  EXPECT_EQ(m.materials[0].name, "glass");
  EXPECT_EQ(m.materials[0].values[0][5], -kMaxMaterialNumber);
  EXPECT_TRUE(validate(m));
  EXPECT_EQ(write_micro(m), text);
}

TEST(MicroBridges, EmptyListsMayBeLeftOutAndAreNotWritten) {
  for (const char* members :
       {"", ",\n\"bridges\": []", ",\n\"sweeps\": []", ",\n\"materials\": []",
        ",\n\"bridges\": [],\"materials\": []", ",\n\"bridges\": [],\"sweeps\": []"}) {
    const auto file = parse_bridges(with_members(members));
    ASSERT_TRUE(file) << members;
    EXPECT_EQ(write_micro(file->micro), with_members(""));
  }
  EXPECT_EQ(answer_to(with_members(",\n\"materials\": [], \"bridges\": []")),
            "syntax@32: the key 'bridges' must come before the key 'materials'");
  EXPECT_EQ(answer_to(with_members(",\n\"sweeps\": [], \"bridges\": []")),
            "syntax@32: the key 'bridges' must come before the key 'sweeps'");
}

TEST(MicroBridges, EachRefusalHasItsLineAndItsValue) {
  const struct {
    const char *from, *to, *expected;
  } cases[] = {
      {"\"grid\": 0", "\"grid\": 1",
       "bad-argument@33: bridge 0: the grid must be from 0 to 0, not 1"},
      {"\"grid\": 0", "\"grid\": -1", "syntax@33: the grid of a bridge must be an integer"},
      {"\"cell\": 1", "\"cell\": 3",
       "bad-argument@33: bridge 0: the cell must be from 0 to 2, not 3"},
      {"\"cell\": 1", "\"cell\": 134217728", "over-limit@33: the cell of a bridge must be"},
      {"\"wall\": 3", "\"wall\": 6", "over-limit@33: the wall of a bridge must be an integer"},
      {"\"volume\": 0", "\"volume\": 1",
       "bad-argument@33: bridge 0: the volume must be from 0 to 0, not 1"},
      {"[1,1]", "[1,0]", "bad-argument@33: bridge 0: a degree must be from 1 to 7, not 0"},
      {"[1,1]", "[1,2]",
       "bad-argument@33: bridge 0: it has 12 points, and the degrees (1, 2, 2) need 18"},
      {"[1,1]", "[1,8]", "over-limit@33: a degree must be"},
      {"\"wall\": 3, ", "", "syntax@33: the key 'wall' is missing"},
      {"\"5/4\", \"0\"", "\"5/4\"", "syntax@33: "},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.to);
    const std::string answer = answer_to(with_bridges(altered(kBridge, c.from, c.to)));
    EXPECT_TRUE(answer.starts_with(c.expected)) << answer;
  }
  const std::string empty_cell = altered(with_bridges(kBridge), "[\"c\", \"2\"]", "[\"8\", \"2\"]");
  EXPECT_EQ(answer_to(empty_cell), "bad-argument@33: bridge 0: cell 1 of grid 0 holds no tile");
}

TEST(MicroBridges, CapsAscend) {
  const std::string next = altered(kBridge, "\"wall\": 3", "\"wall\": 4");
  EXPECT_EQ(answer_to(with_bridges(kBridge + (",\n" + next))), "ok");
  for (const std::string& second :
       {std::string(kBridge), altered(kBridge, "\"wall\": 3", "\"wall\": 2"),
        altered(kBridge, "\"cell\": 1", "\"cell\": 0")})
    EXPECT_EQ(answer_to(with_bridges(kBridge + (",\n" + second))),
              "bad-argument@34: bridge 1: its grid, cell and wall do not come after those of the "
              "bridge before it");
}

TEST(MicroBridges, LongNumbersAreRefused) {
  const std::string most = (Rational::power_of_two(kMaxBridgeBits) - Rational(1)).to_string(),
                    more = Rational::power_of_two(kMaxBridgeBits).to_string();
  ASSERT_LT(more.size(), 1000u);
  EXPECT_EQ(answer_to(with_bridges(altered(kBridge, "7/4", "1/" + most))), "ok");
  for (const std::string& bad : {more, "1/" + more})
    EXPECT_TRUE(answer_to(with_bridges(altered(kBridge, "7/4", bad)))
                    .starts_with("over-limit@33: bridge 0: coordinate 0 of point 6 has a numerator "
                                 "or denominator of more than 2304 bits"));
}

TEST(MicroSweeps, ComeBackByteForByte) {
  const std::string text = with_members(",\n\"sweeps\": [\n" + std::string(kSweep) +
                                        "],\n\"materials\": [\n" + kMaterial + "]");
  const auto file = parse_bridges(text);
  ASSERT_TRUE(file) << answer_to(text);
  const Microstructure& m = file->micro;
  ASSERT_EQ(m.sweeps.size(), 1u);
  EXPECT_EQ(m.sweeps[0].cap, (CapPlace{0, 1, 3}));
  EXPECT_EQ(m.sweeps[0].axis[0], (TilePoint{Rational(0), Rational(1, 8), Rational(-1, 16)}));
  EXPECT_EQ(m.sweeps[0].axis[1], (TilePoint{Rational(1, 4), Rational(1, 3), Rational(0)}));
  EXPECT_EQ(m.materials.size(), 1u);
  EXPECT_TRUE(validate(m));
  EXPECT_EQ(write_micro(m), text);
}

TEST(MicroSweeps, EachRefusalHasItsLineAndItsValue) {
  const struct {
    const char *from, *to, *expected;
  } cases[] = {
      {"\"grid\": 0", "\"grid\": 1",
       "bad-argument@33: sweep 0: the grid must be from 0 to 0, not 1"},
      {"\"cell\": 1", "\"cell\": 3",
       "bad-argument@33: sweep 0: the cell must be from 0 to 2, not 3"},
      {"\"wall\": 3", "\"wall\": 6", "over-limit@33: the wall of a bridge must be an integer"},
      {"\"wall\": 3, ", "", "syntax@33: the key 'wall' is missing"},
      {"\"wall\": 3, ", "\"wall\": 3, \"volume\": 0, ", "syntax@33: "},
      {"\"axis\": [", "\"axis\": [[\"0\", \"0\", \"0\"], ",
       "syntax@33: ']' expected, but there is ','"},
      {"[\"0\", \"1/8\", \"-1/16\"], ", "", "syntax@33: ',' expected, but there is ']'"},
      {"\"-1/16\"]", "\"-1/16\", \"0\"]", "syntax@33: ']' expected, but there is ','"},
      {"\"-1/16\"", "\"1/0\"", "not-finite@33: the number '1/0' is not finite"},
      {"\"-1/16\"", "1", "syntax@33: "},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.to);
    const std::string answer = answer_to(with_sweeps(altered(kSweep, c.from, c.to)));
    EXPECT_TRUE(answer.starts_with(c.expected)) << answer;
  }
  const std::string empty_cell = altered(with_sweeps(kSweep), "[\"c\", \"2\"]", "[\"8\", \"2\"]");
  EXPECT_EQ(answer_to(empty_cell), "bad-argument@33: sweep 0: cell 1 of grid 0 holds no tile");
  const std::string most = (Rational::power_of_two(kMaxBridgeBits) - Rational(1)).to_string(),
                    more = Rational::power_of_two(kMaxBridgeBits).to_string();
  EXPECT_EQ(answer_to(with_sweeps(altered(kSweep, "1/3", "1/" + most))), "ok");
  for (const std::string& bad : {more, "1/" + more})
    EXPECT_EQ(answer_to(with_sweeps(altered(kSweep, "1/3", bad))),
              "over-limit@33: sweep 0: coordinate 1 of vector f has a numerator or denominator of "
              "more than 2304 bits");
}

TEST(MicroSweeps, CapsAscendAndThereAreNoBridges) {
  const std::string next = altered(kSweep, "\"wall\": 3", "\"wall\": 4");
  EXPECT_EQ(answer_to(with_sweeps(kSweep + (",\n" + next))), "ok");
  for (const std::string& second :
       {std::string(kSweep), altered(kSweep, "\"wall\": 3", "\"wall\": 2"),
        altered(kSweep, "\"cell\": 1", "\"cell\": 0")})
    EXPECT_EQ(answer_to(with_sweeps(kSweep + (",\n" + second))),
              "bad-argument@34: sweep 1: its grid, cell and wall do not come after those of the "
              "sweep before it");
  EXPECT_EQ(answer_to(with_members(",\n\"bridges\": [\n" + std::string(kBridge) +
                                   "],\n\"sweeps\": [\n" + next + "]")),
            "bad-argument@35: sweep 0: a microstructure with bridges has no sweeps");
}

TEST(MicroMaterials, EachRefusalHasItsLineAndItsValue) {
  const struct {
    const char *from, *to, *expected;
  } cases[] = {
      {"[0,-1", "[-0,-1", "syntax@33: 0 has no minus sign"},
      {"[0,-1", "[0.5,-1", "syntax@33: a value of a material must be an integer"},
      {"[0,-1", "[01,-1", "syntax@33: a value of a material must be an integer"},
      {"4503599627370495", "4503599627370496", "over-limit@33: a value of a material must be"},
      {",15]]", "]]", "syntax@33: ',' expected, but there is ']'"},
      {",15]]", ",15,16]]", "syntax@33: ']' expected, but there is ','"},
      {",15]]", ",15], []]", "syntax@33: ']' expected, but there is ','"},
      {"\"name\": \"glass\", ", "", "syntax@33: the key 'name' is missing"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.to);
    const std::string answer =
        answer_to(with_members(",\n\"materials\": [\n" + altered(kMaterial, c.from, c.to) + "]"));
    EXPECT_TRUE(answer.starts_with(c.expected)) << answer;
  }
  std::string many = kMaterial;
  for (int k = 1; k < 16; ++k) many += std::string(",\n") + kMaterial;
  EXPECT_EQ(answer_to(with_members(",\n\"materials\": [\n" + many + "]")), "ok");
  EXPECT_EQ(answer_to(with_members(",\n\"materials\": [\n" + many + ",\n" + kMaterial + "]")),
            "over-limit@49: more than 16 materials");
}

TEST(MicroBridges, EveryTruncatedFileIsRefused) {
  const std::string text = with_members(",\n\"bridges\": [\n" + std::string(kBridge) +
                                        "],\n\"materials\": [\n" + kMaterial + "]");
  for (std::size_t n = text.find("\"bridges\""); n + 2 < text.size(); ++n)
    EXPECT_FALSE(parse_bridges(text.substr(0, n))) << n;
  const std::string sweeps = with_sweeps(kSweep);
  for (std::size_t n = sweeps.find("\"sweeps\""); n + 2 < sweeps.size(); ++n)
    EXPECT_FALSE(parse_bridges(sweeps.substr(0, n))) << n;
}

// validate() finds what a program may have done wrong, too.
TEST(MicroBridges, ValidateRefusesWhatTheReaderRefuses) {
  const auto file = parse_bridges(with_members(",\n\"bridges\": [\n" + std::string(kBridge) +
                                               "],\n\"materials\": [\n" + kMaterial + "]"));
  ASSERT_TRUE(file);
  const auto refuses = [&](auto change) {
    Microstructure m = file->micro;
    change(m);
    return !validate(m).has_value();
  };
  EXPECT_TRUE(refuses([](Microstructure& m) { m.bridges[0].cap.wall = -1; }));
  EXPECT_TRUE(refuses([](Microstructure& m) { m.bridges[0].cap.cell = 3; }));
  EXPECT_TRUE(refuses([](Microstructure& m) { m.bridges[0].points.pop_back(); }));
  EXPECT_TRUE(refuses([](Microstructure& m) { m.bridges.push_back(m.bridges[0]); }));
  EXPECT_TRUE(refuses([](Microstructure& m) { m.materials[0].values.clear(); }));
  EXPECT_TRUE(refuses([](Microstructure& m) { m.materials[0].values[0].pop_back(); }));
  EXPECT_TRUE(
      refuses([](Microstructure& m) { m.materials[0].values[0][3] = kMaxMaterialNumber + 1; }));
  EXPECT_TRUE(refuses([](Microstructure& m) { m.materials.resize(17, m.materials[0]); }));
  EXPECT_TRUE(refuses([](Microstructure& m) { m.sweeps.push_back({m.bridges[0].cap, {}}); }));
  const auto refuses_sweeps = [&](std::vector<MicroSweep> sweeps) {
    return refuses([&](Microstructure& m) {
      m.bridges.clear();
      m.sweeps = std::move(sweeps);
    });
  };
  const CapPlace cap = file->micro.bridges[0].cap;
  EXPECT_TRUE(refuses_sweeps({{cap, {}}, {cap, {}}}));
  EXPECT_TRUE(refuses_sweeps({{{0, 1, 6}, {}}}));
  EXPECT_FALSE(refuses_sweeps({{cap, {}}}));
  EXPECT_FALSE(refuses([](Microstructure&) {}));
}

}  // namespace
}  // namespace veritope
