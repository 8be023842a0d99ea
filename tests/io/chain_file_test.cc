// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/chains/chain_file.h"

#include <gtest/gtest.h>

namespace veritope {
namespace {

const std::string kDigest(64, 'a');

std::string operand(const std::string& name, const std::string& path = "a.off") {
  return "{\"name\": \"" + name + "\", \"path\": \"" + path + "\", \"sha256\": \"" + kDigest +
         "\", \"format\": \"off\"}";
}
std::string chain(const std::string& expression, const std::string& operands,
                  const std::string& box = R"(["0", "0", "0", "1", "1/2", "0x1p-1"])",
                  const std::string& boundary = "\"not certified\"",
                  const std::string& schema = "veritope-chain-1") {
  return "{\"schema\": \"" + schema + "\", \"tool\": \"t\", \"expression\": \"" + expression +
         "\",\n\"operands\": [" + operands + "],\n\"box\": " + box + ", \"boundary\": " + boundary +
         "}";
}

Result<ChainFile> read(const std::string& text) {
  const ByteBuffer buffer =
      copy_to_buffer({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  const std::string name = "c.json";
  return read_chain(source_of(buffer, name), {});
}
std::string error(const std::string& text) {
  const Result<ChainFile> made = read(text);
  return made ? "none" : to_string(made.error());
}
bool looks(const std::string& text) {
  const ByteBuffer buffer =
      copy_to_buffer({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  const std::string name = "c.json";
  return looks_like_chain(source_of(buffer, name));
}

TEST(ChainFile, ReadsWhatItWrites) {
  ChainFile c;
  c.tool = "veritope \"x\"";
  ExpressionText text = read_expression("(A | B) - A").value();
  c.tree = text.tree;
  c.operands = {{"A", "../\u00e4\\\"b.off", kDigest, "off"},
                {"B", "/abs/c.json", std::string(64, '0'), "chain"}};
  c.box = {{ExactInterval{Rational(-1), Rational(Integer(1), Integer(3))}, ExactInterval{0, 5},
            ExactInterval{Rational(Integer(-7), Integer(2)), 9}}};
  const std::string written = write_chain(c);
  EXPECT_TRUE(looks(written));
  const ChainFile back = read(written).value();
  EXPECT_EQ(write_chain(back), written);
  EXPECT_EQ(back.tool, c.tool);
  EXPECT_EQ(back.box, c.box);
  ASSERT_EQ(back.operands.size(), 2u);
  EXPECT_EQ(back.operands[0].path, c.operands[0].path);
  EXPECT_EQ(back.operands[1].format, "chain");
}

TEST(ChainFile, PutsOperandsIntoTheOrderOfTheExpression) {
  const ChainFile c = read(chain("B - A", operand("A", "1") + ", " + operand("B", "2"))).value();
  EXPECT_EQ(c.operands[0].name, "B");
  EXPECT_EQ(c.operands[0].path, "2");
  EXPECT_EQ(c.box[2].hi, Rational(Integer(1), Integer(2)));
}

TEST(ChainFile, RefusesWhatItCannotMean) {
  const std::string a = operand("A");
  EXPECT_EQ(error(chain("A", a)), "none");
  EXPECT_EQ(error(""), "c.json: line 1: '{' expected, but there is the end of the file");
  EXPECT_EQ(error(chain("A", a) + "x"),
            "c.json: line 3: the end of the file expected, but there is 'x'");
  EXPECT_EQ(error(chain("A", a, "[]")), "c.json: line 3: a box has six bounds, but there are 0");
  EXPECT_NE(error(chain("A", a, R"(["0", "0", "0", "1", "0", "1"])"))
                .find("line 3: the box has no interior"),
            std::string::npos);
  EXPECT_NE(error(chain("A", a, R"(["0", "0", "0", "1", "x", "1"])")).find("line 3"),
            std::string::npos);
  EXPECT_NE(error(chain("A", a, R"(["0", "0", "0", "1", "nan", "1"])")).find("line 3"),
            std::string::npos);
  EXPECT_EQ(error(chain("A", a, R"(["0", "0", "0", "1", "1", "1"])", "\"certified\"")),
            "c.json: line 3: the boundary must be 'not certified', not 'certified'");
  EXPECT_NE(error(chain("A", a, R"(["0", "0", "0", "1", "1", "1"])", "\"not certified\"",
                        "veritope-chain-2"))
                .find("the schema must be"),
            std::string::npos);
  EXPECT_EQ(error(chain("A |", a)),
            "c.json: line 1: the expression: column 4: an operand expected, but there is the end");
  EXPECT_EQ(error(chain("A | B", a)),
            "c.json: line 1: the expression: column 5: no operand has the name B");
  EXPECT_EQ(error(chain("A", a + "," + operand("B"))),
            "c.json: line 2: the expression does not name the operand B");
  EXPECT_EQ(error(chain("A", a + "," + a)), "c.json: line 2: two operands have the name A");
  EXPECT_NE(error(chain("A", operand("A-1"))).find("an operand's name has letters"),
            std::string::npos);
  EXPECT_EQ(error(chain("A", operand("A", ""))),
            "c.json: line 2: the path of the operand A names no file");
  EXPECT_EQ(error(chain("A", operand("A", "a\\u0000b"))),
            "c.json: line 2: the path of the operand A names no file");
  EXPECT_NE(
      error(chain("A | \\\"b.off\\\"", a)).find("operands of chain files have names, not 'b.off'"),
      std::string::npos);
  std::string short_hash = a;
  short_hash.erase(short_hash.find("aaaa"), 1);
  EXPECT_NE(error(chain("A", short_hash)).find("a sha256 has 64 digits"), std::string::npos);
  std::string twice = chain("A", a);
  twice.insert(1, "\"tool\": \"u\", ");
  EXPECT_NE(error(twice).find("occurs twice"), std::string::npos);
  std::string extra = chain("A", a);
  extra.insert(1, "\"more\": 1, ");
  EXPECT_EQ(error(extra), "c.json: line 1: unknown key 'more'");
  std::string wide = "A";
  for (std::uint64_t i = 0; i < kMostLeaves; ++i) wide += "|A";
  const Result<ChainFile> over = read(chain(wide, a));
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().code, Code::kOverLimit);
}

TEST(ChainFile, IsRecognisedByItsSchema) {
  EXPECT_TRUE(looks("\n {\"schema\" : \"veritope-chain-1\"}"));
  EXPECT_TRUE(looks("{\"schema\":\"veritope-chain-2\"}"));
  EXPECT_FALSE(looks("{\"format\": \"veritope-spline-1\", \"groups\": []}"));
  EXPECT_FALSE(looks("[\"schema\", \"veritope-chain-1\"]"));
  EXPECT_FALSE(looks(""));
  EXPECT_FALSE(looks("{\"schema\""));
}

}  // namespace
}  // namespace veritope
