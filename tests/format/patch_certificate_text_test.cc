// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/claims.h"

#include <gtest/gtest.h>

#include <random>

#include "verify/format/byte_stream.h"

namespace veritope::certificate {
namespace {

using internal::ByteWriter;

Fraction fraction(unsigned char p, unsigned char q) {
  return {false, p == 0 ? Natural{} : Natural{p}, Natural{q}};
}

// One box and one walk; the entities' patches are all leaves.
StarBoxBody body_of(const std::vector<std::array<std::size_t, 2>>& surfaces, std::size_t triangles) {
  StarBoxBody b;
  std::size_t patches = triangles;
  for (const auto& [u, v] : surfaces) {
    PatchEntity e;
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t i = 0; i <= (a == 0 ? u : v); ++i) e.breaks[a].push_back(fraction(static_cast<unsigned char>(i), 1));
    b.entities.push_back(e);
    patches += u * v;
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    PatchEntity e;
    e.is_surface = false;
    e.is_reversed = i == 0;
    b.entities.push_back(e);
  }
  b.roots.assign(patches, {0, 0});
  b.exponent = -7;
  b.boxes.push_back({false, 3, {-1, 0, 5}, {4, 4, 4}, 3, {{{0, 1, 6}, {1, 2, 7}, {}}}, 0, {}});
  b.trees.assign(patches, 0);
  b.walks.push_back({0, true, {{{0, {1, 2, 3}}}, 3, 0, false}});
  return b;
}
Bytes certificate_of(const StarBoxBody& body) {
  Subject subject;
  subject.sha256 = std::string(64, '0');
  subject.format = "vjson";
  subject.tool = "test";
  StarBoxQuantities q;
  q.patches = body.roots.size();
  return encode(subject, q, body);
}
Bytes certificate_of(const std::string& claim, std::size_t patches, Bytes body) {
  const std::string line = R"({"claim":")" + claim + R"(","patches":)" + std::to_string(patches) + "}\n";
  Bytes out(line.begin(), line.end());
  out.insert(out.end(), body.begin(), body.end());
  return out;
}
std::string text_of(const Bytes& bytes, std::size_t max_items = 9) {
  std::string why;
  const auto text = explain_certificate(bytes, max_items, why);
  return text ? *text : "NOT: " + why;
}
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void write_magic(ByteWriter& w, const char* magic) {
  for (int i = 0; i < 4; ++i) w.u8(static_cast<std::uint8_t>(magic[i]));
}
void write_interval(ByteWriter& w, unsigned k, unsigned a, unsigned b) {
  for (const unsigned v : {k, a, b}) w.varint(v);
}

// The rest of a body may not be read once for each of very many headers that fit.
TEST(PatchCertificateText, ManyHeadersThatFitCostNoMoreThanAFew) {
  constexpr std::uint32_t kEntities = 300'000;
  ByteWriter w;
  write_magic(w, "VTSB");
  w.u32(kEntities);
  for (std::uint32_t i = 0; i < kEntities; ++i) w.u8(0);
  for (std::uint32_t i = 0; i < 2 * kEntities; ++i) {
    w.u32(2);
    for (const unsigned end : {0u, 1u}) w.zigzag(end), w.varint(1);
  }
  EXPECT_TRUE(has(text_of(certificate_of("star-box-1", kEntities, w.take())), "NOT: the body is not complete"));
}

TEST(PatchCertificateText, FindsTheNumberOfSurfacesOfABodyThatDoesNotSayIt) {
  for (std::size_t surfaces = 0; surfaces < 4; ++surfaces)
    for (std::size_t triangles = surfaces == 0 ? 1 : 0; triangles < 4; ++triangles)
      for (const std::array<std::size_t, 2> cuts : {std::array<std::size_t, 2>{1, 1}, {2, 3}}) {
        const std::string text = text_of(certificate_of(body_of(std::vector(surfaces, cuts), triangles)));
        const std::string want = "body: star-box-1, " + std::to_string(surfaces + triangles) + " entities (" +
                                 std::to_string(surfaces) + " surfaces, " + std::to_string(triangles) + " triangles; " +
                                 (triangles > 0 ? "1" : "0") + " reversed), ";
        EXPECT_TRUE(has(text, want)) << want << "\n" << text;
      }
}

TEST(PatchCertificateText, SaysBoxesTreesAndWalks) {
  StarBoxBody body = body_of({{1, 2}}, 0);
  body.trees = {kSplit, 0, 0, 0, 0, 0};
  const std::string text = text_of(certificate_of(body));
  EXPECT_TRUE(has(text, "claim: star-box-1\n")) << text;
  EXPECT_TRUE(has(text, R"(1 entities (1 surfaces, 0 triangles; 0 reversed), 2 patches
unit: 2^-7
star boxes: 1
mesh boxes: 0
trees of 2 roots: 5 leaves, 6 nodes, at most 1 levels deep
walks: 1
  0: from c+ of box 0, 1 points, to infinity along -y
)")) << text;
  EXPECT_TRUE(has(text_of(certificate_of(body), 0), "walks: 1\n  ... and 1 more\n"));
}

TEST(PatchCertificateText, SaysFramesSheetsAndSeparatorsOfVersion2) {
  StarBoxBody body = body_of({{1, 2}}, 1);
  body.version = 2;
  body.frames = {{{{{3, 4, 0}, {-4, 3, 0}, {0, 0, 5}}}}};
  body.boxes.push_back(body.boxes[0]);
  StarBoxItem& b = body.boxes[1];
  b.frame = 1;
  b.sheets = {{{0, 1, 6}, {1, 2, 7}, {1, 0}}, {{0, -1, 6}, {1, 2, -7}, {2, 1}}};
  b.separators = {{1, -3, {1, -2, 3, 4}}, {1, 5, {0, 0, 0, -1}}};
  const std::string text = text_of(certificate_of(body));
  EXPECT_TRUE(
      has(text, R"(body: star-box-2, 2 entities (1 surfaces, 1 triangles; 1 reversed), 3 patches
unit: 2^-7
star boxes: 2
mesh boxes: 0
frames: 2
  0: the unit matrix
  1: (3, 4, 0), (-4, 3, 0), (0, 0, 5)
boxes in other frames than 0: 1
boxes with several sheets: 1
  0: box 1, frame 1, points in units of 2^3 of these
    c- (0, 1, 6), c+ (1, 2, 7), signs +0
    c- (0, -1, 6), c+ (1, 2, -7), signs -+
    separator of degree 1, t = -3, coefficients 1 -2 3 4
    separator of degree 1, t = 5, coefficients 0 0 0 -1
trees of 3 roots: 3 leaves, 3 nodes, at most 0 levels deep
)")) << text;
  EXPECT_TRUE(
      has(text_of(certificate_of(body), 0), "boxes with several sheets: 1\n  ... and 1 more\n"));
}

// A body of version 2 is cut into its fields without its statement and its model.
TEST(PatchCertificateText, NeedsOnlyTheBodyInVersion2) {
  StarBoxBody body = body_of({{1, 2}, {2, 2}}, 2);
  std::swap(body.entities[0], body.entities[2]);  // a triangle first
  body.version = 2;
  EXPECT_TRUE(has(text_of(certificate_of("star-box-2", 99, encode(body))),
                  "(2 surfaces, 2 triangles; 1 reversed), 8 patches"));
}

TEST(PatchCertificateText, SaysWhatACollarAdds) {
  Bytes body = encode(body_of({}, 2));
  ByteWriter w;
  w.varint(1);
  for (const int v : {-5, 0, 5}) w.zigzag(v);
  const std::uint64_t level1 = std::uint64_t{1} << 57;
  w.u32(2);
  w.varint(level1);      // the cell (0, 0, 0) of level 1
  w.varint(2 * level1);  // and its neighbour
  w.u32(1);
  w.u8(1);
  w.zigzag(4), w.zigzag(-3);
  w.u8(1);                                    // the first leaf's tree
  for (const int s : {0, 1, 1, 1, 1}) w.u8(static_cast<std::uint8_t>(s));
  w.u32(0), w.u8(6), w.varint(0), w.u8(0);    // the only shore
  const Bytes rest = w.take();
  body.insert(body.end(), rest.begin(), rest.end());
  const std::string text = text_of(certificate_of("collar-1", 2, body));
  EXPECT_TRUE(has(text, R"(root cube: least corner (-5, 0, 5) units of 2^1 of these, edge 2^20
cells: 2
  level 1: 2
components of the boundary: 1
  0: in d+
collapses: 2
trees of these 2 leaves: 5 leaves, 6 nodes, at most 1 levels deep
shores: 1
  0: 0 points, to c- of box 0
)")) << text;
}

TEST(PatchCertificateText, SaysWhereTwoPartsMeet) {
  ByteWriter w;
  write_magic(w, "VTPI");
  w.u32(2), w.u8(0), w.u8(0), w.u8(0);
  w.varint(1), write_interval(w, 2, 1, 2), write_interval(w, 3, 1, 7);
  w.varint(0), write_interval(w, 0, 0, 1), write_interval(w, 1, 1, 1);
  for (int i = 0; i < 9; ++i) w.zigzag(i - 4);
  const std::string text = text_of(certificate_of("patch-invalid-1", 2, w.take()));
  EXPECT_TRUE(has(text, R"(two parts of the surface that meet:
  A: patch 1, [1/2^2, 2/2^2] x [1/2^3, 7/2^3]
  B: patch 0, [0/2^0, 1/2^0] x [1/2^1, 1/2^1]
  Y_1: (-4, -3, -2)
  Y_2: (-1, 0, 1)
  Y_3: (2, 3, 4)
)")) << text;
}

TEST(PatchCertificateText, SaysWhichArcsAreOneCurve) {
  ByteWriter w;
  write_magic(w, "VTPI");
  w.u32(1), w.u8(0), w.u8(1), w.u32(2);
  for (const unsigned side : {0u, 2u}) w.varint(0), w.u8(static_cast<std::uint8_t>(side)), write_interval(w, 0, 0, 1);
  w.u8(1), w.varint(1), w.varint(1);
  const std::string text = text_of(certificate_of("patch-invalid-1", 1, w.take()), 1);
  EXPECT_TRUE(has(text, R"(arcs that are the same curve: 2
  0: patch 0, side 0, [0/2^0, 1/2^0]
  ... and 1 more
monotone along: y
point: 1/2^1 of the first one's side
)")) << text;
}

TEST(PatchCertificateText, SaysWhichPointsHaveOneImage) {
  ByteWriter w;
  write_magic(w, "VTI2");
  w.u32(2), w.u8(2), w.u8(0), w.u8(2), w.u8(1);
  for (const unsigned v : {0u, 2u, 3u, 1u, 2u, 1u, 4u, 6u, 0u, 1u}) w.varint(v);
  const std::string text = text_of(certificate_of("patch-invalid-2", 2, w.take()));
  EXPECT_TRUE(has(text, R"(two points of the surface with one image:
  A: patch 0, (2/3, 1/2)
  B: patch 1, (4/6, 0/1)
)")) << text;
}

TEST(PatchCertificateText, RefusesOtherClaimsOtherPatchesAndBodiesThatAreNotComplete) {
  const Bytes whole = certificate_of(body_of({{2, 2}}, 1));
  EXPECT_FALSE(has(text_of(whole), "NOT: "));
  EXPECT_TRUE(has(text_of({}), "NOT: no line feed"));
  EXPECT_TRUE(has(text_of(certificate_of("star-box-2", 1, {})), "NOT: "));
  EXPECT_TRUE(has(text_of(certificate_of("star-box-1", 4, encode(body_of({{2, 2}}, 1)))), "NOT: ")) << "5 patches";
  EXPECT_TRUE(has(text_of(certificate_of("patch-invalid-1", 5, encode(body_of({{2, 2}}, 1)))), "NOT: the body does not begin"));
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_TRUE(has(text_of(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(n))), "NOT: ")) << n;
}

// No crash and no great allocation, whatever the bytes; what is said is printable.
TEST(PatchCertificateText, SurvivesChangesOfAnyByte) {
  for (unsigned seed = 0; seed < 20000; ++seed) {
    std::mt19937 random(seed);
    StarBoxBody body = body_of({{1, 2}}, 2);
    body.version = 1 + static_cast<int>(seed % 2);
    if (body.version == 2) {
      body.frames.resize(2);
      body.boxes[0].sheets.resize(2, {{}, {}, {1}});
      body.boxes[0].sheets[0].signs = {2};
      body.boxes[0].separators = {{1, 0, {1, 2, 3, 4}}};
    }
    Bytes bytes = certificate_of(body);
    for (unsigned n = 1 + random() % 3; n > 0; --n) bytes[random() % bytes.size()] = static_cast<unsigned char>(random());
    for (const char c : text_of(bytes)) ASSERT_TRUE((c >= ' ' && c <= '~') || c == '\n') << "seed " << seed;
  }
}

}  // namespace
}  // namespace veritope::certificate
