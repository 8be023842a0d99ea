// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/mesh_certificate.h"

#include <gtest/gtest.h>

#include <random>

#include "verify/format/sha256.h"

namespace veritope::certificate {
namespace {

using Random = std::mt19937_64;

std::uint32_t below(Random& r, std::uint32_t n) { return static_cast<std::uint32_t>(r() % n); }

ValidBody random_valid(Random& r) {
  ValidBody b;
  b.num_vertex_ids = below(r, 9);
  for (std::uint32_t i = 0, n = 1 + below(r, 9); i < n; ++i) b.order.push_back(below(r, 1000));
  for (std::uint32_t i = 0; i < b.num_vertex_ids; ++i) b.stars.push_back(static_cast<std::uint8_t>(below(r, 15)));
  const auto component = [&] { return static_cast<std::int32_t>(below(r, 4) == 0 ? static_cast<std::int64_t>(below(r, 0xffffffffu)) - 0x7fffffff : static_cast<std::int64_t>(below(r, 9)) - 4); };
  for (std::uint32_t i = 0, n = below(r, 4); i < n; ++i) {
    const std::int32_t x = component(), y = component(), z = component();
    b.star_vectors.push_back({x, y, z});
  }
  std::uint64_t index = 0;
  for (std::uint32_t i = 0, n = below(r, 5); i < n; ++i) {
    index += below(r, 3) == 0 ? r() >> 10 : below(r, 200);
    const std::int32_t x = component(), y = component(), z = component();
    b.separators.push_back({index++, {x, y, z}});
  }
  for (std::uint32_t i = 0, n = below(r, 9); i < n; ++i) b.codes.push_back(static_cast<std::uint8_t>(below(r, 256)));
  for (std::uint32_t i = 0, n = below(r, 4); i < n; ++i) b.nesting.push_back(static_cast<std::uint8_t>(below(r, 6)));
  return b;
}

Natural random_natural(Random& r) {
  Natural n;
  for (std::uint32_t i = 0, size = below(r, 40); i < size; ++i) n.push_back(static_cast<unsigned char>(r()));
  if (!n.empty() && n.back() == 0) n.back() = 1;
  return n;
}

InvalidBody random_invalid(Random& r) {
  InvalidBody b;
  b.num_faces = below(r, 100);
  b.num_vertex_ids = below(r, 100);
  for (std::uint8_t rule = 1; rule <= 9; ++rule)
    for (std::uint32_t n = below(r, 3); n > 0; --n) {
      Witness w;
      w.rule = rule;
      w.first = static_cast<std::uint32_t>(r());
      if ((rule >= 2 && rule <= 5) || rule == 7) w.second = static_cast<std::uint32_t>(r());
      if (rule == 7)
        for (Natural& weight : w.weights) weight = random_natural(r);
      if (rule >= 8) w.axis = static_cast<std::uint8_t>(below(r, 3));
      b.witnesses.push_back(w);
    }
  return b;
}

Subject subject() { return {std::string(64, 'a'), 1234, "off", false, "rule", "tool 1"}; }
Quantities quantities() { return {4, 6, 4, 1, 1, 0, "1/6"}; }

bool same(const ValidBody& a, const ValidBody& b) {
  if (a.separators.size() != b.separators.size()) return false;
  for (std::size_t i = 0; i < a.separators.size(); ++i)
    if (a.separators[i].index != b.separators[i].index || a.separators[i].direction != b.separators[i].direction) return false;
  return a.num_vertex_ids == b.num_vertex_ids && a.order == b.order && a.stars == b.stars && a.star_vectors == b.star_vectors && a.codes == b.codes && a.nesting == b.nesting;
}
bool same(const InvalidBody& a, const InvalidBody& b) {
  if (a.num_faces != b.num_faces || a.num_vertex_ids != b.num_vertex_ids || a.witnesses.size() != b.witnesses.size()) return false;
  for (std::size_t i = 0; i < a.witnesses.size(); ++i) {
    const Witness &x = a.witnesses[i], &y = b.witnesses[i];
    if (x.rule != y.rule || x.first != y.first || x.second != y.second || x.axis != y.axis || x.weights != y.weights) return false;
  }
  return true;
}

Bytes with_statement(const std::string& statement, const Bytes& body) {
  Bytes out(statement.begin(), statement.end());
  out.push_back('\n');
  out.insert(out.end(), body.begin(), body.end());
  return out;
}

TEST(MeshCertificateFormat, BodyOfAValidMeshIsLaidOutAsOnThePage) {
  ValidBody b;
  b.num_vertex_ids = 4;
  b.order = {2, 0};
  b.stars = {0, 14, 3, 0};
  b.star_vectors = {{1, -1, 256}};
  b.separators = {{5, {1, -1, 64}}, {8, {0, 0, -2147483647}}};
  b.codes = {65, 3};
  b.nesting = {0, 5};
  EXPECT_EQ(encode(b), (Bytes{'V', 'T', 'M', 'V', 2, 0, 0, 0, 4, 0, 0, 0,                           // F, V
                              2, 0, 0, 0, 0, 0, 0, 0,                                               // order
                              0, 14, 3, 0,                                                          // stars
                              1, 0, 0, 0, 1, 0, 0, 0, 255, 255, 255, 255, 0, 1, 0, 0,               // star vectors
                              2, 0, 0, 0, 5, 2, 1, 128, 1, 2, 0, 0, 253, 255, 255, 255, 15,         // separators: gaps 5 and 8 - 5 - 1
                              2, 0, 0, 0, 65, 3,                                                    // codes
                              0, 5}));                                                              // nesting
}

ReversedBody random_reversed(Random& r) {
  ReversedBody b{{}, random_valid(r)};
  const std::size_t faces = b.solid.order.size();
  b.reversed.resize((faces + 7) / 8);
  for (std::size_t f = 0; f < faces; ++f)
    b.reversed[f / 8] = static_cast<unsigned char>(b.reversed[f / 8] | below(r, 2) << (f % 8));
  return b;
}

TEST(MeshCertificateFormat, BodyOfAReversedMeshIsThatOfAValidOneWithItsBits) {
  ReversedBody b;
  b.solid.num_vertex_ids = 1;
  b.solid.order = {8, 7, 6, 5, 4, 3, 2, 1, 0};
  b.solid.stars = {0};
  b.reversed = {0x84, 0x01};
  Bytes want = encode(b.solid);
  want[3] = 'R';
  want.insert(want.begin() + 12, {0x84, 0x01});
  EXPECT_EQ(encode(b), want);

  const Bytes whole = encode(subject(), quantities(), b, 0);
  const std::string statement(whole.begin(), std::find(whole.begin(), whole.end(), '\n'));
  EXPECT_NE(statement.find("\"claim\":\"mesh-reversed-1\""), std::string::npos) << statement;
  EXPECT_NE(statement.find("\"volume\":\"1/6\",\"reversed\":3,\"reversed_shells\":0}"),
            std::string::npos)
      << statement;
  std::string why;
  EXPECT_NE(explain(decode(whole, why).value(), 9).find("2"), std::string::npos);
  EXPECT_NE(explain(b, "", 9).find("reversed triangles"), std::string::npos) << explain(b, "", 9);
}

TEST(MeshCertificateFormat, ABitOfNoTriangleIsRefused) {
  ReversedBody b;
  b.solid.order = {2, 1, 0};
  b.reversed = {7};
  std::string why;
  EXPECT_TRUE(decode(with_statement("{}", encode(b)), why)) << why;
  b.reversed = {8};
  EXPECT_FALSE(decode(with_statement("{}", encode(b)), why));
}

TEST(MeshCertificateFormat, BodyOfAnInvalidMeshIsLaidOutAsOnThePage) {
  InvalidBody b;
  b.num_faces = 9;
  b.num_vertex_ids = 8;
  b.witnesses.resize(4);
  b.witnesses[0] = {1, 3, 0, 0, {}};
  b.witnesses[1] = {5, 1, 2, 0, {}};
  b.witnesses[2] = {7, 4, 5, 0, {Natural{1}, Natural{}, Natural{0, 1}, Natural{2}, Natural{}, Natural{}}};
  b.witnesses[3] = {9, 6, 0, 2, {}};
  EXPECT_EQ(encode(b), (Bytes{'V', 'T', 'M', 'I', 9, 0, 0, 0, 8, 0, 0, 0, 4, 0, 0, 0,                          //
                              1, 3, 0, 0, 0,                                                                   //
                              5, 1, 0, 0, 0, 2, 0, 0, 0,                                                       //
                              7, 4, 0, 0, 0, 5, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1,          //
                              1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0,                                           //
                              9, 6, 0, 0, 0, 2}));
}

TEST(MeshCertificateFormat, StatementsAreOneFlatObject) {
  ValidBody b;
  b.order = {0};
  const Bytes body = encode(b), whole = encode(subject(), quantities(), b);
  const std::string text(whole.begin(), whole.end());
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "{\"certificate\":\"veritope-certificate-1\",\"tool\":\"tool 1\",\"claim\":\"mesh-valid-1\",\"subject_sha256\":\"" + std::string(64, 'a') +
                "\",\"subject_bytes\":1234,\"subject_format\":\"off\",\"reading_rule\":\"rule\",\"as_indexed\":false,\"body_sha256\":\"" + to_hex(sha256(body)) +
                "\",\"vertices\":4,\"edges\":6,\"faces\":4,\"shells\":1,\"bodies\":1,\"genus\":0,\"volume\":\"1/6\"}");
  EXPECT_EQ(text.substr(text.find('\n') + 1), std::string(body.begin(), body.end()));
  InvalidBody invalid;
  invalid.witnesses.resize(3);
  invalid.witnesses[0].rule = invalid.witnesses[1].rule = 3;
  invalid.witnesses[2].rule = 8;
  const Bytes other = encode(subject(), invalid);
  const std::string statement(other.begin(), std::find(other.begin(), other.end(), '\n'));
  EXPECT_NE(statement.find("\"rules\":\"M3 M8\"}"), std::string::npos) << statement;
}

TEST(MeshCertificateFormatLaw, EveryBodySurvivesEncodingAndDecoding) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    Random r(seed);
    std::string why;
    const ValidBody valid = random_valid(r);
    const auto v = decode(encode(subject(), quantities(), valid), why);
    ASSERT_TRUE(v && v->valid && !v->invalid) << "seed " << seed << ": " << why;
    ASSERT_TRUE(same(*v->valid, valid)) << "seed " << seed;
    const InvalidBody invalid = random_invalid(r);
    const auto i = decode(encode(subject(), invalid), why);
    ASSERT_TRUE(i && i->invalid && !i->valid) << "seed " << seed << ": " << why;
    ASSERT_TRUE(same(*i->invalid, invalid)) << "seed " << seed;
    const ReversedBody reversed = random_reversed(r);
    const auto w = decode(encode(subject(), quantities(), reversed, 1), why);
    ASSERT_TRUE(w && w->reversed && !w->valid && !w->invalid) << "seed " << seed << ": " << why;
    ASSERT_TRUE(same(w->reversed->solid, reversed.solid)) << "seed " << seed;
    ASSERT_EQ(w->reversed->reversed, reversed.reversed) << "seed " << seed;
    EXPECT_EQ(encode(*w->reversed), encode(reversed));
    EXPECT_EQ(encode(*v->valid), encode(valid));
    EXPECT_EQ(encode(*i->invalid), encode(invalid));
  }
}

TEST(MeshCertificateFormat, RefusesWhatIsNoCertificate) {
  const auto why = [](const Bytes& bytes) {
    std::string text;
    EXPECT_FALSE(decode(bytes, text));
    return text;
  };
  EXPECT_NE(why({}).find("no line feed"), std::string::npos);
  EXPECT_NE(why(Bytes(70000, 'x')).find("no line feed"), std::string::npos);
  EXPECT_NE(why(with_statement(std::string(65537, 'x'), encode(ValidBody{}))).find("no line feed"), std::string::npos);
  EXPECT_NE(why(with_statement("{}", {'V', 'T', 'M'})).find("with none of"), std::string::npos);
  EXPECT_NE(why(with_statement("{}", {'V', 'T', 'M', 'V'})).find("too early"), std::string::npos);
  Bytes trailing = encode(InvalidBody{});
  trailing.push_back(0);
  EXPECT_NE(why(with_statement("{}", trailing)).find("too long"), std::string::npos);
  std::string none;
  EXPECT_TRUE(decode(with_statement(std::string(65535, 'x'), encode(InvalidBody{})), none)) << none;
}

TEST(MeshCertificateFormat, RefusesMalformedNumbers) {
  std::string why;
  ValidBody b;
  b.separators = {{0, {2147483647, 0, -2147483647}}};
  Bytes body = encode(b);
  ASSERT_TRUE(decode(with_statement("{}", body), why));
  // The zigzag of 2147483647 is fe ff ff ff 0f; of 2147483648 it is 80 80 80 80 10.
  const Bytes most{0xfe, 0xff, 0xff, 0xff, 0x0f}, more{0x80, 0x80, 0x80, 0x80, 0x10};
  std::copy(more.begin(), more.end(), std::search(body.begin(), body.end(), most.begin(), most.end()));
  EXPECT_FALSE(decode(with_statement("{}", body), why)) << "a component of 2^31";

  InvalidBody i;
  i.witnesses.resize(1);
  i.witnesses[0].rule = 7;
  i.witnesses[0].weights[0] = {1, 0};
  EXPECT_FALSE(decode(with_statement("{}", encode(i)), why)) << "a natural number whose last byte is 0";
  for (std::uint8_t rule : {0, 10, 255}) {
    i.witnesses[0].rule = rule;
    Bytes bytes = encode(i);
    EXPECT_FALSE(decode(with_statement("{}", bytes), why)) << int{rule};
  }
}

// No crash and no great allocation, whatever the bytes; what is decoded can be explained.
TEST(MeshCertificateFormatLaw, TruncatedAndMutatedBytesAreRefusedOrExplained) {
  long decoded = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random r(seed);
    const Bytes whole = seed % 2 == 0 ? encode(subject(), quantities(), random_valid(r)) : encode(subject(), random_invalid(r));
    const std::size_t line = static_cast<std::size_t>(std::find(whole.begin(), whole.end(), '\n') - whole.begin());
    for (std::size_t n = line > 5 ? line - 5 : 0; n < whole.size(); ++n) {
      std::string why;
      const auto c = decode(std::span(whole).first(n), why);
      c ? ++decoded : ++refused;
      if (c) {
        EXPECT_FALSE(explain(*c, 3).empty());
      } else {
        EXPECT_FALSE(why.empty());
      }
    }
    for (int i = 0; i < 100; ++i) {
      Bytes bytes = whole;
      for (std::uint32_t n = 1 + below(r, 4); n > 0; --n) {
        const std::size_t at = below(r, 3) == 0 ? below(r, static_cast<std::uint32_t>(bytes.size())) : line + below(r, static_cast<std::uint32_t>(bytes.size() - line));
        switch (below(r, 4)) {
          case 0: bytes[at] = static_cast<unsigned char>(r()); break;
          case 1: bytes[at] ^= static_cast<unsigned char>(1u << below(r, 8)); break;
          case 2: bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), static_cast<unsigned char>(r())); break;
          default: bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
        }
        if (bytes.size() <= line) bytes.push_back(0);
      }
      std::string why;
      const auto c = decode(bytes, why);
      c ? ++decoded : ++refused;
      if (c) {
        for (char ch : explain(*c, 5)) ASSERT_TRUE((ch >= ' ' && ch <= '~') || ch == '\n') << "seed " << seed;
      }
    }
  }
  EXPECT_GT(decoded, 1000);
  EXPECT_GT(refused, 1000);
}

TEST(MeshCertificateFormat, ExplainsAValidBody) {
  ValidBody b;
  b.num_vertex_ids = 4;
  b.order = {2, 0, 1, 3};
  b.stars = {3, 14, 3, 0};
  b.star_vectors = {{5, -3, 1}};
  b.separators = {{7, {1, -1, 64}}};
  b.codes = {0, 33, 2 | 64, 10 | 32, 11, 16 | 32, 17};
  b.nesting = {0, 3, 9};
  const Certificate c{"{\"claim\":\"mesh-valid-1\",\"volume\":\"1/6\",\"as_indexed\":false}", b, std::nullopt};
  EXPECT_EQ(explain(c, 100), R"(claim: mesh-valid-1
volume: 1/6
as_indexed: false

body: mesh-valid-1, 4 triangles, 4 vertex ids
order (triangle at each leaf): 4
  0: 2
  1: 0
  2: 1
  3: 3
stars: 3 of 4
  direction 3: 2 vertices
  direction 14: 1 vertices
star vectors: 1
  0: (5, -3, 1)
separators (pair of nodes, direction): 1
  0: pair 7, (1, -1, 64)
codes of leaf pairs: 7
  0: n(a)
  1: -n(b)
  2: e0(a) x e0(b), then
  3: -e2(a) x e2(b)
  4: n(a) x e0(a)
  5: -n(b) x e2(b)
  6: unknown axis 17
nesting rays: 3
  0: +x
  1: -y
  2: unknown axis 9
)");
}

TEST(MeshCertificateFormat, ExplainsAnInvalidBodyAndCutsLongLists) {
  InvalidBody b;
  b.num_faces = 9;
  b.num_vertex_ids = 8;
  for (std::uint8_t rule = 1; rule <= 9; ++rule) {
    Witness w;
    w.rule = rule;
    w.first = 10u * rule;
    w.second = 10u * rule + 1;
    w.axis = 2;
    w.weights = {Natural{1}, Natural{}, Natural{0xff, 1}, Natural{2}, Natural{}, Natural{}};
    b.witnesses.push_back(w);
  }
  const Certificate c{"{\"claim\":\"mesh-invalid-1\",\"rules\":\"M1, M2\"}", std::nullopt, b};
  EXPECT_EQ(explain(c, 9), R"(claim: mesh-invalid-1
rules: M1, M2

witnesses: 9
  0: M1: face 10 is degenerate
  1: M2: faces 20 and 21 have the same vertices
  2: M3: edge 30-31 has one face
  3: M4: edge 40-41 has more than two faces
  4: M5: both faces of edge 50-51 run from 50 to 51
  5: M6: the faces at vertex 60 form more than one fan
  6: M7: faces 70 and 71 meet in the point with weights 0x01 0 0x01ff 0x02 0 0
  7: M8: just outside face 80 the winding number is not 0 (ray along z)
  8: M9: just outside face 90 the winding number is not 0 (ray along z)
)");
  EXPECT_NE(explain(c, 2).find("  ... and 7 more\n"), std::string::npos);
  EXPECT_EQ(explain(c, 2).find("M3"), std::string::npos);
  EXPECT_NE(explain(c, 0).find("  ... and 9 more\n"), std::string::npos);
}

}  // namespace
}  // namespace veritope::certificate
