// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/format/claims.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/support/paths.h"

namespace veritope::certificate {
namespace {

std::string output_of(const std::string& command) {
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string out;
  char part[4096];
  for (std::size_t n; (n = std::fread(part, 1, sizeof part, pipe)) > 0;) out.append(part, n);
  EXPECT_EQ(::pclose(pipe), 0) << command;
  return out;
}
std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream all;
  all << file.rdbuf();
  return all.str();
}

// "key" -> text, number or flag, of a flat object.
std::map<std::string, std::string> kinds_of(const std::string& statement) {
  std::map<std::string, std::string> kinds;
  for (std::size_t at = 0; (at = statement.find("\":", at)) != statement.npos; at += 2) {
    const std::size_t open = statement.rfind('"', at - 1);
    const char first = statement[at + 2];
    kinds[statement.substr(open + 1, at - open - 1)] = first == '"'                   ? "text"
                                                       : first == 't' || first == 'f' ? "flag"
                                                                                      : "number";
  }
  return kinds;
}
std::string line_of(const Claim& claim) {
  std::istringstream all(claims_as_text());
  for (std::string line; std::getline(all, line);)
    if (line.starts_with(std::string(claim.name) + " ")) return line;
  return {};
}

PatchEntity square() {
  PatchEntity e;
  for (auto& axis : e.breaks)
    axis = {{false, {}, {1}}, {true, {3}, {7}}, {false, {5, 1}, Natural(9, 200)}};
  return e;
}
PatchEntity triangle() {
  PatchEntity e;
  e.is_surface = false;
  e.is_reversed = true;
  return e;
}
StarBoxBody star() {
  StarBoxBody b;
  b.entities = {triangle(), square(), triangle()};
  b.roots = {{0, 0}, {1, 2}, {0, 0}, {0, 0}, {0, 0}, {0, 0}};
  b.exponent = -7;
  b.boxes.push_back({false, 3, {-1, 0, 5}, {4, 4, 4}, 3, {{{0, 1, 6}, {1, 2, 7}, {}}}, 0, {}});
  b.boxes.push_back({true, 0, {-1, 0, 5}, {4, 4, 4}, 0, {}, 0, {}});
  for (const auto& [u, v] : b.roots) b.trees.insert(b.trees.end(), std::size_t{1} << (u + v), 1);
  b.trees.insert(b.trees.begin() + 3, {kSplit, 0, 1, kSplit, 0, 0, 0, 0});
  b.walks.push_back({0, true, {{{0, {1, 2, 3}}}, 3, 0, false}});
  b.walks.push_back({1, false, {{}, 6, 1, true}});
  return b;
}
StarBoxBody star_2() {
  StarBoxBody b = star();
  b.version = 2;
  b.entities.push_back(triangle());
  b.entities.back().is_surface = false;
  b.entities.back().is_other = true;
  b.frames = {{{{{3, 4, 0}, {-4, 3, 0}, {0, 0, 5}}}},
              {{{{1, 0, 0}, {0, 1, 0}, {0, -1, -2147483647}}}}};
  b.boxes[0].frame = 2;
  b.boxes[0].point_shift = 1;
  b.boxes[0].sheets = {{{0, 1, 6}, {1, 2, 7}, {1, 0}}, {{0, -1, 6}, {1, 2, -7}, {2, 1}}};
  b.boxes[0].separators = {{1, -4096, {1, -2, 3, std::int64_t{1} << 62}},
                           {2, 7, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}};
  b.boxes.push_back({true, 0, {-1, 0, 5}, {4, 4, 4}, 0, {}, 1, {}});
  b.boxes.push_back({false, 0, {-1, 0, 5}, {4, 4, 4}, 9, {{{0, 1, 6}, {1, 2, 7}, {}}}, 0, {}});
  return b;
}
CollarBody collar() {
  CollarBody b;
  b.star = star();
  b.shift = 1;
  b.corner = {-5, 0, 5};
  b.cells = {std::uint64_t{1} << 57, std::uint64_t{3} << 57};
  b.sides = {1};
  b.collapses = {4, 1};
  for (const std::int64_t symbol : b.star.trees)
    if (symbol != kSplit) b.leaves.push_back(1);
  b.leaves.insert(b.leaves.begin(), {0, 1, 1, 1});
  b.shores = {{{}, 6, 0, false}};
  return b;
}
PatchInvalidBody invalid(bool is_side) {
  PatchInvalidBody b;
  b.entities = {square(), triangle()};
  if (is_side) {
    b.finding = SideFinding{{{1, 2, {3, 1, 2}}, {0, 0, {0, 0, 1}}}, 1, 4, 7, 1, 2};
  } else {
    CrossingFinding crossing;
    crossing.sheets[0] = {3, {UnitInterval{2, 1, 2}, UnitInterval{3, 1, 7}}};
    crossing.rows[1] = {-4, 0, std::int64_t{1} << 60};
    b.finding = crossing;
  }
  return b;
}

PatchMeetingBody meeting() {
  PatchMeetingBody b;
  b.entities = {square(), triangle(), triangle()};
  b.entities.back().is_other = true;
  b.places = {{{3, {UnitFraction{1, 2}, UnitFraction{7, std::uint64_t{1} << 62}}},
               {0, {UnitFraction{0, 1}, UnitFraction{5, 5}}}}};
  return b;
}

VolumeFoldedBody folded() {
  VolumeFoldedBody b;
  b.volumes = 7;
  b.entity = 300;
  b.points = {{{{{0, {0, 1}}, {300, {1, 2}}, {1, {3, 7}}}},
               {{{2, {1, 1}}, {0, {7, std::uint64_t{1} << 62}}, {0, {0, 5}}}}}};
  return b;
}

VModelBody vmodel() {
  VModelBody b;
  b.cells.resize(2);
  b.cells[1].is_reversed = true;
  b.cells[1].added_breaks[2] = {{true, {3}, {7}}, {false, {5, 1}, Natural(9, 200)}};
  b.faces.resize(12);
  b.faces[0].kind = VModelFace::Kind::kCollapsed;
  b.faces[3] = {VModelFace::Kind::kGlued, 11, 6};
  b.faces[5] = {VModelFace::Kind::kGlued, 6, 0};
  b.faces[6].kind = b.faces[11].kind = VModelFace::Kind::kNamed;
  b.determinants = {{0, 1U << 25, {0}}, {3, 0, {2, 0, 1, 0, 0}}, {(1U << 24) - 1, 5, {0}}};
  b.boundary = star_2();
  return b;
}

MicroBody micro() {
  MicroBody b;
  const Fraction half{false, {1}, {2}}, odd{true, {3, 1}, {7, 9}};
  b.tiles.push_back(StarTileProof{{half, odd, half}, 300});
  b.tiles.push_back(star_2());
  b.tiles.push_back(StarTileProof{{half, half, half}, 0});
  b.bridges =
      std::vector<BridgeProof>{{{half, odd, half, odd, half, odd, odd, odd, half}, {}},
                               {{half, half, half, odd, half, odd, odd, odd, half}, {odd, half}}};
  b.cage = vmodel();
  return b;
}

MicroBody micro_with_sweeps() {
  MicroBody b = micro();
  const Fraction half{false, {1}, {2}}, odd{true, {3, 1}, {7, 9}};
  b.bridges =
      std::vector<SweepProof>{{{half, odd, half, odd, half, odd, odd, odd, half}, half, half},
                              {{half, half, half, odd, half, odd, odd, odd, half}, odd, half}};
  return b;
}

MicroInsideBody micro_inside(std::variant<ValidBody, StarBoxBody> solid) {
  const Fraction half{false, {1}, {2}}, odd{true, {3, 1}, {7, 9}};
  return {micro(), std::move(solid), {{7, {half, odd, half}, 8}, {0, {odd, odd, half}, 3}}};
}

DmsBody dms() {
  const Fraction half{false, {1}, {2}}, odd{true, {3, 1}, {7, 9}};
  const DmsPlaneProof plane{{half, odd, half}, odd}, other{{odd, odd, half}, half};
  const std::array<Fraction, 9> matrix{half, odd, half, odd, half, odd, odd, odd, half};
  DmsBody b;
  b.points = {{half, odd, half}, {odd, odd, odd}};
  b.trees = {{DmsLeafProof{false, matrix, {}}},
             {DmsCutProof{5, {}}, DmsCutProof{0, half}, DmsLeafProof{true, matrix, {plane}},
              DmsLeafProof{false, matrix, {plane, other}}, DmsLeafProof{true, matrix, {}}}};
  b.planes = {{}, {plane, other}, {other}};
  b.tiles = {{}, {{{0, 1, 300}, {}}, {{2, 1, 4}, {plane, other}}}, {}};
  b.domain = star_2();
  b.surface = star_2();
  b.surface.entities.pop_back();
  return b;
}

DmsPairsBody dms_pairs() {
  DmsBody of_tiles = dms();
  const Fraction half{false, {1}, {2}}, odd{true, {3, 1}, {7, 9}};
  DmsPairsBody b;
  b.trees = of_tiles.trees;
  b.planes = of_tiles.planes;
  b.blocks = {{{0}, {half, odd, half, odd, half, odd, odd, odd, half}, {}},
              {{1, 300}, {half, odd, half, odd, half, odd, odd, odd, odd}, of_tiles.planes[1]}};
  const std::array<Fraction, 3> direction{half, odd, half}, other{odd, odd, half};
  using Kind = DmsPairProof::Kind;
  b.pairs = {{0, 1, Kind::kApart, {}, {}, {}, {direction}},
             {0, 300, Kind::kChain, {7}, {}, {}, {other}},
             {1, 2, Kind::kChain, {4, 500, 6}, {0, 1}, {}, {direction}},
             {2, 3, Kind::kAtEdge, {}, {}, {half, odd}, {direction, other}}};
  b.domain = star_2();
  return b;
}

// A body of each kind of finding.
std::vector<VModelInvalidBody> invalid_vmodels() {
  const CellPoint a{3, {{{0, {0, 1}}, {300, {1, 2}}, {1, {3, 7}}}}};
  const CellPoint b{0, {{{2, {1, 1}}, {0, {7, std::uint64_t{1} << 62}}, {0, {0, 5}}}}};
  const SpanInterval t{1, {62, 0, std::uint64_t{1} << 62}}, u{0, {3, 2, 5}};
  const CellOverlap::Somewhere somewhere{{300, {t, u, u}}, {{{1, -2, 3}, {0, -64, 64}, {7, 8, 9}}}};
  const FaceArc first{0, 5, 3, t}, second{300, 0, 0, u};
  return {{400, FlatCell{300, {0, 1, 129}}}, {400, LeftHandedCell{a}},
          {400, SingularPoint{b}},           {400, CellOverlap{a, b}},
          {400, CellOverlap{b, somewhere}},  {400, CrowdedCurve{{first, second, first}}},
          {400, PinchedPoint{300, 7}}};
}

// A body of each kind of finding.
std::vector<DmsInvalidBody> invalid_dms() {
  const Fraction half{false, {1}, {2}}, odd{true, {3, 1}, {7, 9}};
  const DmsPointProof p{half, odd, half}, q{odd, odd, odd};
  const DmsPlaneProof plane{{half, odd, half}, odd};
  const DmsFaceName f{300, 3}, g{0, 0};
  const UnitInterval whole{0, 0, 1}, part{62, 0, std::uint64_t{1} << 62};
  const std::vector<std::vector<DmsPlaneProof>> planes{{}, {plane, plane}, {plane}};
  return {{400, DmsReversedTetrahedron{300}, {}},
          {400, DmsOverusedFace{{f, g}}, {}},
          {400, DmsDegenerateCloud{300, {0, 9, 1, 0}}, {}},
          {400, DmsCloudWithoutCore{300, {{{0, 1, 0, 0}, 3, half}, {{9, 0, 0, 0}, 0, odd}}}, {}},
          {400, DmsCloudInside{f, {1, 0, 1}, 128, {half, odd, half, odd, odd}}, {}},
          {400, DmsNegativePoint{p}, planes},
          {400, DmsFlatLeaf{{300, {p, q, q, p}, {plane}}}, planes},
          {400, DmsCrowdedEdgeName{{7, 300}}, {}},
          {400, DmsPinchedVertexName{300}, {}},
          {400, DmsImproperPoint{{f, g}, {p, q}}, {}},
          {400, DmsOverlapPoint{{300, 0}, q}, {}},
          {400, DmsMeetingPoints{{p, q}}, planes},
          {400,
           DmsCrossingPieces{{{{f, {p, q, p}, {plane}}, {g, {q, q, p}, {}}}},
                             {{{whole, part}, {part, whole}}},
                             {{{1, -2, 3}, {0, -64, 64}, {7, 8, 9}}}},
           planes},
          {400, DmsCoveringLeaf{{300, {p, q, q, p}, {plane}}, q}, planes}};
}

// A certificate of each claim, and bodies that fit it. All claims of the table must be here.
struct Example {
  Bytes certificate;
  std::vector<AnyBody> bodies;
  ModelKinds kinds;
};
std::map<std::string, Example, std::less<>> examples() {
  Subject subject;
  subject.sha256 = std::string(64, '0');
  subject.format = "vjson";
  subject.tool = "test";
  ValidBody valid;
  valid.num_vertex_ids = 4;
  valid.order = {2, 0, 1, 3};
  valid.stars = {0, 14, 3, 1};
  valid.star_vectors = {{1, -2, 3}};
  valid.separators = {{5, {1, 0, -7}}, {900, {-1, 1, 1}}};
  valid.codes = {3, 70, 2};
  valid.nesting = {0, 5};
  InvalidBody broken{4,
                     5,
                     {{1, 2, 0, 0, {}},
                      {5, 1, 3, 0, {}},
                      {7, 1, 2, 0, {Natural{1}, {}, {2, 9}, {}, {4}, {}}},
                      {8, 3, 0, 2, {}}}};
  StarBoxQuantities q;
  q.patches = 6;
  const ModelKinds mixed{{false, true, false}};
  std::map<std::string, Example, std::less<>> all;
  const MicroInsideBody inside = micro_inside(valid);
  all["micro-inside-1"] = {encode(subject, MicroQuantities{}, InsideStatement{}, inside),
                           {inside, micro_inside(star_2())},
                           {}};
  all["mesh-valid-1"] = {encode(subject, Quantities{}, valid), {valid}, {}};
  all["mesh-invalid-1"] = {encode(subject, broken), {broken}, {}};
  valid.num_vertex_ids = 2;  // fewer, so that the bits of ten triangles fill two bytes
  valid.stars = {0, 14};
  valid.order = {2, 0, 1, 3, 9, 8, 7, 6, 5, 4};
  const ReversedBody reversed{{0x81, 0x02}, valid};
  all["mesh-reversed-1"] = {encode(subject, Quantities{}, reversed, 1), {reversed}, {}};
  const PointsBody points{12, 8, std::uint64_t{3} << 33, {0, 5, 128, 1}};
  all["points-1"] = {encode(subject, AnswersSubject{}, points), {points}, {}};
  all["star-box-1"] = {encode(subject, q, star()), {star()}, mixed};
  all["star-box-turned-1"] = {encode(subject, q, star(), -3), {star()}, mixed};
  all["star-box-2"] = {encode(subject, q, star_2()), {star_2()}, {}};
  all["star-box-turned-2"] = {encode(subject, q, star_2(), -3), {star_2()}, {}};
  all["collar-1"] = {encode(subject, q, collar()), {collar()}, mixed};
  CollarBody collar_2 = collar();
  collar_2.star = star_2();
  collar_2.leaves.assign(internal::leaf_levels(collar_2.star).size(), 1);
  all["collar-2"] = {encode(subject, q, collar_2), {collar_2}, {}};
  all["patch-invalid-1"] = {
      encode(subject, 5, invalid(true)), {invalid(true), invalid(false)}, {{true, false}}};
  all["volume-folded-1"] = {encode(subject, folded()), {folded()}, {}};
  all["patch-invalid-2"] = {encode(subject, 5, meeting()), {meeting()}, {}};
  VModelQuantities of_cells;
  of_cells.euler = -3;
  all["vmodel-1"] = {encode(subject, of_cells, vmodel()), {vmodel()}, {}};
  all["microstructure-1"] = {
      encode(subject, MicroQuantities{}, micro()), {micro(), micro_with_sweeps()}, {}};
  all["dms-solid-1"] = {encode(subject, DmsQuantities{}, dms()), {dms()}, {}};
  all["dms-solid-2"] = {encode(subject, DmsQuantities{}, dms_pairs()), {dms_pairs()}, {}};
  std::vector<AnyBody> findings;
  for (const VModelInvalidBody& body : invalid_vmodels()) findings.emplace_back(body);
  all["vmodel-invalid-1"] = {encode(subject, invalid_vmodels()[0]), std::move(findings), {}};
  std::vector<AnyBody> of_dms;
  for (const DmsInvalidBody& body : invalid_dms()) of_dms.emplace_back(body);
  all["dms-invalid-1"] = {encode(subject, invalid_dms()[0]), std::move(of_dms), {}};
  return all;
}

TEST(Claims, BothCheckersHaveTheSameTable) {
  EXPECT_EQ(claims_as_text(), output_of("'" + test::program_dir() + "/veritope-check' --claims"));
  EXPECT_EQ(claims_as_text(), output_of("'" + test::python() + "' -B '" + test::source_dir() +
                                        "/verify/checker/veritope_check.py' --claims"));
}

TEST(Claims, EveryRowHasAPageThatNamesTheClaimAndItsMagic) {
  for (const Claim& c : all_claims()) {
    const std::string page =
        file_text(std::filesystem::path(test::source_dir()) / "docs/certificates" / c.page);
    EXPECT_NE(page.find("`" + std::string(c.name) + "`"), page.npos) << c.name;
    EXPECT_NE(page.find("`" + std::string(c.magic) + "`"), page.npos) << c.name;
    EXPECT_EQ(find_claim(c.name), &c);
  }
  EXPECT_EQ(find_claim("star-box-9"), nullptr);
}

TEST(Claims, StatementsHaveTheKeysOfTheirRow) {
  const auto all = examples();
  for (const Claim& c : all_claims()) {
    ASSERT_TRUE(all.contains(c.name)) << c.name;
    const Bytes& bytes = all.find(c.name)->second.certificate;
    const std::string statement(bytes.begin(), std::find(bytes.begin(), bytes.end(), '\n'));
    std::string keys;
    for (const auto& [key, kind] : kinds_of(statement))
      keys += (keys.empty() ? " " : ",") + key + "=" + kind;
    const std::string line = line_of(c);
    EXPECT_EQ(keys, line.substr(line.rfind(' '))) << c.name;
  }
}

TEST(Claims, WhatIsEncodedIsDecodedWithItsModelAndExplained) {
  const auto all = examples();
  for (const Claim& c : all_claims())
    for (const AnyBody& body : all.at(std::string(c.name)).bodies) {
      const Bytes bytes = c.encode(body);
      ASSERT_EQ(std::string(bytes.begin(), bytes.begin() + 4), c.magic);
      std::string why;
      const ModelKinds& kinds = all.at(std::string(c.name)).kinds;
      const auto decoded = c.decode(bytes, "{\"patches\":0}", &kinds, why);
      ASSERT_TRUE(decoded) << c.name << ": " << why;
      EXPECT_EQ(decoded->index(), body.index()) << c.name;
      EXPECT_EQ(c.encode(*decoded), bytes) << c.name;
      EXPECT_EQ(c.explain(*decoded, c.name, 3), c.explain(body, c.name, 3)) << c.name;
      for (std::size_t n = 4; n < bytes.size(); ++n)
        if (c.decode(std::span(bytes).first(n), "{}", &kinds, why)) {
          // The last fields of these have no count: the nesting of the shells, the codes of the points.
          EXPECT_TRUE(c.name == "mesh-valid-1" || c.name == "mesh-reversed-1" ||
                      c.name == "points-1")
              << c.name << " " << n;
        }
    }
}

TEST(Claims, TheStatementAloneNamesTheFile) {
  const std::string text =
      "{\"certificate\":\"veritope-certificate-1\",\"claim\":\"of-tomorrow\",\"subject_sha256\":"
      "\"12ab\","
      "\"subject_bytes\":382}\n";
  const auto subject_in = [](const std::string& bytes) {
    return stated_subject({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
  };
  const auto subject = subject_in(text + "a body that is cut");
  ASSERT_TRUE(subject);
  EXPECT_EQ(subject->sha256, "12ab");
  EXPECT_EQ(subject->bytes, 382U);
  EXPECT_FALSE(subject_in(text.substr(0, text.size() - 1))) << "the statement has no end";
  EXPECT_FALSE(subject_in("OFF\n3 1 0\n"));
  EXPECT_FALSE(subject_in(""));
}

TEST(Claims, WithoutTheModelVersion1GuessesTheNumberOfSurfaces) {
  const auto all = examples();
  for (const Claim& c : all_claims()) {
    const Example& example = all.at(std::string(c.name));
    std::string why, ignored;
    const auto decoded = decode_certificate(example.certificate, why);
    ASSERT_TRUE(decoded) << c.name << ": " << why;
    EXPECT_EQ(decoded->claim, &c);
    EXPECT_EQ(c.encode(decoded->body), c.encode(example.bodies[0])) << c.name;
    EXPECT_EQ(explain_certificate(example.certificate, 3, why),
              explain_certificate(example.certificate, 3, ignored, &example.kinds))
        << c.name;
  }
}

TEST(Claims, AModelOfOtherKindsIsRefused) {
  const Example example = examples().at("star-box-1");
  std::string why;
  for (const ModelKinds& kinds : {ModelKinds{{false, true}}, ModelKinds{{true, true, false}},
                                  ModelKinds{{false, false, false}}})
    EXPECT_FALSE(decode_certificate(example.certificate, why, &kinds));
  EXPECT_EQ(why, "the body is not complete");
}

TEST(Claims, AnUnknownClaimIsReadByItsMagic) {
  Bytes bytes = examples().at("mesh-valid-1").certificate;
  const std::string name = "mesh-valid-1", other = "mesh-valid-9";
  std::copy(other.begin(), other.end(),
            std::search(bytes.begin(), bytes.end(), name.begin(), name.end()));
  std::string why;
  const auto decoded = decode_certificate(bytes, why);
  ASSERT_TRUE(decoded) << why;
  EXPECT_EQ(decoded->claim->name, "mesh-valid-1");
  *std::search(bytes.begin(), bytes.end(), decoded->claim->magic.begin(),
               decoded->claim->magic.end()) = 'X';
  EXPECT_FALSE(decode_certificate(bytes, why));
}

}  // namespace
}  // namespace veritope::certificate
