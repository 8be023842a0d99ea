// SPDX-License-Identifier: LGPL-3.0-or-later
// The kernel's readers and both checkers read the same triangles from odd files, or refuse them alike. The checkers are
// black boxes here: a certificate that claims an open edge is accepted only if the triangles, ids and counts agree.
#include <sys/wait.h>
#include <cmath>
#include <map>

#include "io/mesh/reading_rule.h"
#include "tests/io/io_test_util.h"
#include "tests/support/paths.h"
#include "verify/format/sha256.h"

namespace veritope {
namespace {

using io_test::packed;
using io_test::TempFolder;
using namespace std::string_literals;

struct Case {
  const char* name;
  MeshFormat format;
  std::string bytes;
  bool is_read;
};

const std::string kVertices =
    "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kStrips = "element tristrips 1\nproperty list int int vertex_indices\n";
const std::string kPoints = "0 0 0 1 0 0 0 1 0 ";
const std::string kDoubles = packed(0., 0., 0., 1., 0., 0., 0., 1., 0.);

std::string ply_text(const std::string& header, const std::string& body = kPoints + "3 0 1 2\n") {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}
std::string ply_bytes(const std::string& header, const std::string& body) {
  return "ply\nformat binary_little_endian 1.0\n" + header + "end_header\n" + body;
}
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::vector<Case> ply_cases() {
  constexpr auto kPly = MeshFormat::kPly;
  const std::string all = kVertices + kFaces;
  return {
      {"plain", kPly, ply_text(all), true},
      {"comment before format", kPly,
       "ply\ncomment a\nformat ascii 1.0\n" + all + "end_header\n" + kPoints + "3 0 1 2", false},
      {"CR in a comment of an LF header", kPly, ply_text("comment a\rb\n" + all), false},
      {"CR LF behind a property of an LF header", kPly,
       ply_text(replaced(all, "double x\n", "double x\r\n")), false},
      {"empty header lines", kPly, ply_text("\n \t\n" + all), true},
      {"blank behind ply", kPly, replaced(ply_text(all), "ply\n", "ply \n"), false},
      {"format with a fourth word", kPly, replaced(ply_text(all), "1.0", "1.0 x"), false},
      {"version 1", kPly, replaced(ply_text(all), "1.0", "1"), false},
      {"blanks in the header", kPly, ply_text(replaced(replaced(all, " ", "\t "), "\n", " \n")),
       true},
      {"indented header", kPly, ply_text("  " + replaced(all, "\nproperty", "\n property")), true},
      {"blank behind end_header", kPly, replaced(ply_text(all), "end_header", "end_header "), true},
      {"word behind end_header", kPly, replaced(ply_text(all), "end_header", "end_header x"),
       false},
      {"CR LF in an LF header", kPly, replaced(ply_text(all), "1.0\n", "1.0\r\n"), false},
      {"LF in a CR LF header", kPly, replaced(ply_text(all), "ply\n", "ply\r\n"), false},
      {"CR header", kPly, replaced(ply_text(all), "\n", "\r"), true},
      {"CR LF header", kPly, replaced(ply_text(all), "\n", "\r\n"), true},
      {"second format line", kPly, ply_text("format ascii 1.0\n" + all), false},
      {"x twice", kPly,
       ply_text(replaced(all, "property double y", "property int x\nproperty double y"),
                "0 0 0 0 1 0 0 0 0 1 0 0 3 0 1 2"),
       false},
      {"x a list only", kPly, ply_text(replaced(all, "double x", "list uchar double x")), false},
      {"x a scalar and a list", kPly,
       ply_text(kVertices + "property list uchar int x\n" + kFaces,
                "0 0 0 0 1 0 0 0 0 1 0 1 5 3 0 1 2"),
       true},
      {"two index lists", kPly,
       ply_text(all + "property list uchar int vertex_index\n", kPoints + "3 0 1 2 0"), false},
      {"index list twice", kPly,
       ply_text(all + "property list uchar int vertex_indices\n", kPoints + "3 0 1 2 0"), false},
      {"scalar beside the index list", kPly,
       ply_text(all + "property int vertex_index\n", kPoints + "3 0 1 2 0"), true},
      {"float indices", kPly, ply_text(replaced(all, "uchar int", "uchar float")), false},
      {"float counts in another element", kPly,
       ply_text("element e 0\nproperty list float int b\n" + all), false},
      {"faces without a list, strips", kPly,
       ply_text(kVertices + "element face 0\nproperty int a\n" + kStrips, kPoints + "3 0 1 2"),
       false},
      {"wrong index in a short strip", kPly,
       ply_text(kVertices + kStrips, kPoints + "6 0 1 2 -1 7 8"), false},
      {"index -2 in a strip", kPly, ply_text(kVertices + kStrips, kPoints + "5 0 1 2 -2 0"), false},
      {"wrong index in a joint", kPly, ply_text(kVertices + kStrips, kPoints + "5 0 1 2 9 9"),
       false},
      {"strip that ends", kPly, ply_text(kVertices + kStrips, kPoints + "9 -1 0 1 2 2 1 0 -1 1"),
       true},
      {"unsigned -1 in a strip", kPly,
       ply_bytes(kVertices + replaced(kStrips, "int int", "int uint"),
                 kDoubles + packed(4, 0, 1, 2, -1)),
       false},
      {"char -1 in a strip", kPly,
       ply_bytes(kVertices + replaced(kStrips, "int int", "int char"),
                 kDoubles + packed(4) + "\0\1\2\xFF"s),
       true},
      {"uchar 255 in a strip", kPly,
       ply_bytes(kVertices + replaced(kStrips, "int int", "int uchar"),
                 kDoubles + packed(4) + "\0\1\2\xFF"s),
       false},
      {"byte order mark", kPly, "\xEF\xBB\xBF" + ply_text(all), true},
      {"signed count", kPly, ply_text(replaced(all, "vertex 3", "vertex +03")), true},
      {"minus zero instances", kPly, ply_text("element e -0\nproperty int a\n" + all), true},
      {"negative count", kPly, ply_text("element e -1\nproperty int a\n" + all), false},
      {"any number of nothing", kPly, ply_text("element e 99999999999999999999999\n" + all), true},
      {"a great number of something", kPly,
       ply_text("element e 99999999999999999999999\nproperty int a\n" + all), false},
      {"signed indices", kPly, ply_text(all, kPoints + "+3 +0 01 0002"), true},
      {"ignored words", kPly,
       ply_text("element e 1\nproperty float a\nproperty list uchar float b\n" + all,
                "nan 2 x # " + kPoints + "3 0 1 2"),
       true},
      {"fractional count of ignored values", kPly,
       ply_text("element e 1\nproperty list uchar float b\n" + all,
                "2.0 1 1 " + kPoints + "3 0 1 2"),
       false},
      {"unused vertex nan", kPly,
       ply_text(replaced(all, "vertex 3", "vertex 4"), kPoints + "nan 0 0 3 0 1 2"), false},
      {"NUL in the body", kPly, ply_text(all, kPoints + "\0 3 0 1 2"s), false},
      {"no body", kPly, ply_text(all, ""), false},
      {"no line end at the end", kPly, "ply\nformat ascii 1.0\n" + all + "end_header", false},
      {"CR in a name", kPly, ply_text(replaced(all, "double x", "double x\r")), false},
      {"faces first", kPly, ply_text(kFaces + kVertices, "3 2 1 0 " + kPoints), true},
      {"other bytes behind", kPly,
       ply_bytes(all, kDoubles + packed(std::uint8_t{3}, 0, 1, 2) + "\0x"s), true},
  };
}

std::vector<Case> obj_cases() {
  constexpr auto kObj = MeshFormat::kObj;
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  return {
      {"joint in a number", kObj, "v 0 0 0\nv 1 0 0\nv 0 1\\\n2 0\nf 1 2 3\n", true},
      {"joint before CR LF", kObj, v + "f 1 2 \\\r\n3\n", true},
      {"joint before CR", kObj, v + "f 1 2 \\\r3\n", true},
      {"joint behind the keyword", kObj, v + "f\\\r\n 1 2 3\n", true},
      {"joint in a comment", kObj, v + "# a \\\nf 1 2 3\nf 3 2 1\n", true},
      {"joint in the comment of a face", kObj, v + "f 1 2 3 # \\\n 2\n", true},
      {"joint behind a slash", kObj, v + "v 0 0 1\nf 1/1 2/1 3/1\\\n 4/1\n", true},
      {"joint behind a slash before CR LF", kObj, v + "f 1/1 2/1 3/\\\r\n", true},
      {"joint behind two corners with slashes", kObj, v + "f 1/1 2/1\\\n 3/1\n", true},
      {"backslash behind a slash at the end", kObj, v + "f 1/1 2/1 3/\\", true},
      {"joint before a byte order mark", kObj, "\\\n\xef\xbb\xbfv 9 9 9\n" + v + "f 1 2 3\n", true},
      {"byte order mark before a joint", kObj,
       "\xef\xbb\xbf\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", true},
      {"joint in a byte order mark", kObj, "\xef\\\n\xbb\xbf" + v + "f 1 2 3\n", false},
      {"two joints", kObj, v + "f 1 2 \\\n\\\n3\n", true},
      {"backslash before a blank", kObj, v + "f 1 2 \\ \n3\n", false},
      {"backslash at the end", kObj, v + "f 1 2 3 \\", false},
      {"joint at the end", kObj, v + "f 1 2 3 \\\n", true},
      {"two backslashes", kObj, v + "f 1 2 3 \\\\\n", false},
      {"joint on an empty line", kObj, "\\\n" + v + "f 1 2 3\n", true},
      {"joint in an ignored rest", kObj, "v 0 0 0 \\\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\n", true},
      {"comment glued to a number", kObj, "v 0 0 0#x\nv 1 0 0\nv 0 1 0\nf 1 2 3#4\n", true},
      {"comment in a corner", kObj, v + "f 1/#2 2 3\n", false},
      {"slash first", kObj, v + "f /1 2 3\n", false},
      {"bytes behind the slash", kObj, v + "f 1/a\\b 2//\x01 3/\xff\n", true},
      {"relative before all vertices", kObj, "f -1 -2 -3\n" + v, false},
      {"forward", kObj, "f 1 2 3\n" + v, true},
      {"blanks of all kinds", kObj, "v\t0\v0\f0\nv 1 0 0\nv 0 1 0\nf\t1\v2\f3\n", true},
      {"v alone", kObj, v + "v\nf 1 2 3\n", false},
      {"f alone", kObj, v + "f\nf 1 2 3\n", false},
      {"fo", kObj, v + "fo 1 2 3\n", true},
      {"other case", kObj, v + "F 1 2 9\nV x\nf 1 2 3\n", true},
      {"words behind a position", kObj, "v 0 0 0 x\nv 1 0 0 nan\nv 0 1 0\nf 1 2 3\n", true},
      {"unused vertex nan", kObj, v + "v nan 0 0\nf 1 2 3\n", false},
      {"NUL in a corner", kObj, v + "f 1 2 3\0\n"s, false},
      {"NUL in an ignored line", kObj, v + "g \0\nf 1 2 3\n"s, true},
      {"byte order mark", kObj, "\xEF\xBB\xBF" + v + "f 1 2 3", true},
      {"no-break space", kObj,
       "v\xA0"
       "0 0 0\n" +
           v + "f 1 2 3",
       true},
      {"index beyond 128 bits", kObj, v + "f 1 2 340282366920938463463374607431768211459\n", false},
      {"underflow", kObj, "v 1e-4000 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", true},
      {"overflow", kObj, "v 1e309 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", false},
      {"just below overflow", kObj, "v 1.7976931348623158079e308 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
       true},
      {"dots", kObj, "v 1.E+0 .5e-1 +.5\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", true},
      {"dot alone", kObj, "v . 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", false},
      {"empty exponent", kObj, "v 1e 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", false},
      {"equal points", kObj,
       "v 0 0 -0\nv -0 0 0\nv 1 0 0\nv 0 1 0\nv 2e-400 0 0\nf 1 3 4\nf 2 3 5\n", true},
      {"all corners equal", kObj, v + "f 1 1 1\n", true},
      {"no face", kObj, v, false},
  };
}

std::vector<Case> off_cases() {
  constexpr auto kOff = MeshFormat::kOff;
  const std::string rest = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  std::vector<Case> cases = {
      {"binary", kOff, "OFF BINARY\n3 1 0\n" + rest, false},
      {"counts behind the keyword", kOff, "OFF 3 1\n" + rest, true},
      {"counts on two lines", kOff, "OFF\n3\n1\n" + rest, true},
      {"edges on a line of their own", kOff, "OFF\n3\n1\n0\n" + rest, false},
      {"comments behind counts", kOff, "OFF\n3#x\n1#y\n" + rest, true},
      {"signs", kOff, "OFF\n+3 +01 x\n0 0 0\n1 0 0\n0 1 0\n+3 +0 01 02", true},
      {"vertex on two lines", kOff, "OFF\n3 1 0\n0 0\n0\n1 0 0\n0 1 0\n3 0 1 2", false},
      {"face on two lines", kOff, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n2", false},
      {"glued comments", kOff, "OFF#\n3 1 0\n0 0 0#\n1 0 0#1\n0 1 0\n3 0 1 2#", true},
      {"negative faces", kOff, "OFF\n3 -1 0\n" + rest, false},
      {"no faces", kOff, "OFF\n3 0 0\n" + rest, false},
      {"one face missing", kOff, "OFF\n3 2 0\n" + rest, false},
      {"two corners", kOff, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n", false},
      {"words behind values", kOff, "OFF\n3 1 0\n0 0 0 zz\n1 0 0\n0 1 0\n3 0 1 2 zz # \n", true},
      {"anything behind", kOff, "OFF\n3 1 0\n" + rest + "junk \0\n"s, true},
      {"NUL", kOff, "OFF\n3 1 0\n0 0 0\0\n1 0 0\n0 1 0\n3 0 1 2\n"s, false},
      {"counts in a comment", kOff, "OFF # 3 1\n3 1 0\n" + rest, true},
  };
  for (const char* word : {"OFF", "STCNOFF", "NOFF", "STNOFF"}) {
    cases.push_back({word, kOff, word + "\n3 1 0\n"s + rest, true});
  }
  for (const char* word : {"NCOFF", "4OFF", "nOFF", "ST4OFF", "off", "OFF3", "CSTOFF", "CC"}) {
    cases.push_back({word, kOff, word + "\n3 1 0\n"s + rest, false});
  }
  return cases;
}

std::string binary_stl(std::uint32_t count, const std::string& facets, std::string header = "x") {
  header.resize(80, ' ');
  return header + packed(count) + facets;
}

std::vector<Case> stl_cases() {
  constexpr auto kStl = MeshFormat::kStl;
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\n";
  const std::string bare =
      "outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet endsolid";
  const std::string one =
      packed(0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, std::uint16_t{9});
  const std::string zeros =
      packed(0.f, 0.f, 0.f, -0.f, 0.f, -0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, std::uint16_t{0});
  std::vector<Case> cases = {
      {"plain", kStl, "solid\n" + facet + "endsolid\n", true},
      {"byte order mark", kStl, "\xEF\xBB\xBFsolid\n" + facet + "endsolid\n", true},
      {"blanks first", kStl, " \r\n\tsolid\n" + facet + "endsolid\n", true},
      {"one line", kStl, replaced("solid\n" + facet + "endsolid", "\n", " "), false},
      {"CR", kStl, replaced("solid\n" + facet + "endsolid\n", "\n", "\r"), true},
      {"facet behind endsolid", kStl, "solid\n" + facet + "endsolid facet junk", true},
      {"word between blocks", kStl,
       "solid\n" + facet + "endsolid\njunk\nsolid\n" + facet + "endsolid", false},
      {"no endsolid", kStl, "solid\n" + facet, false},
      {"second block open", kStl, "solid\n" + facet + "endsolid\nsolid\n", false},
      {"first block empty", kStl, "solid\nendsolid\nsolid\n" + facet + "endsolid", true},
      {"no normal", kStl, "solid\nfacet " + bare, true},
      {"odd normal", kStl, "solid\nfacet endsolid solid facet nan " + bare, true},
      {"normal of five words", kStl, "solid\nfacet normal 0 0 1 1 " + bare, false},
      {"facet inside a normal", kStl, "solid\nfacet normal 0 0 1\n" + facet + "endsolid", false},
      {"comment", kStl, "solid\n# c\n" + facet + "endsolid", false},
      {"longer word", kStl, "solidx\n" + facet + "endsolid\n", false},
      {"NUL in the name", kStl, "solid a\0b\n"s + facet + "endsolid\n", true},
      {"binary with solid", kStl, binary_stl(1, one, "solid"), true},
      {"longer binary", kStl, binary_stl(1, one + "zz"), true},
      {"longer binary with solid", kStl, binary_stl(1, one + "zz", "solid"), false},
      {"shorter binary", kStl, binary_stl(2, one), false},
      {"no facet", kStl, binary_stl(0, one), false},
      {"header that is an empty ASCII file", kStl, binary_stl(0, "", "solid\nendsolid\n"), false},
      {"minus zero", kStl, binary_stl(2, one + zeros), true},
      {"infinity", kStl, binary_stl(1, replaced(one, packed(1.f), packed(HUGE_VALF))), false},
  };
  for (const std::string& start : {"\x1F\x8B"s, "PK\3\4"s, "PK\5\6"s, "BZh"s,
                                   "\xFD"
                                   "7zXZ"s,
                                   "\x28\xB5\x2F\xFD"s, "\xFF\xFE"s, "\xFE\xFF"s, "\0\0\xFE\xFF"s,
                                   "version https://git-lfs"s}) {
    cases.push_back({"foreign", kStl, binary_stl(1, one, start), false});
  }
  for (const char* start : {"\x1F", "PK\3", "BZ",
                            "\xFD"
                            "7zX",
                            "\x28\xB5\x2F", "\xFF", "\xFE", "version https://git"}) {
    cases.push_back({start, kStl, binary_stl(1, one, start), true});
  }
  return cases;
}

// The edges {a, b}, a < b, and how many triangles have them.
std::map<std::array<std::uint32_t, 2>, int> edges_of(const TriangleMesh& mesh) {
  std::map<std::array<std::uint32_t, 2>, int> edges;
  for (const auto& f : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = f[k], b = f[(k + 1) % 3];
      if (a != b) ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  return edges;
}

// An edge that exactly one triangle has; without one any pair of ids.
std::array<std::uint32_t, 2> open_edge(const TriangleMesh& mesh) {
  for (const auto& [edge, count] : edges_of(mesh)) {
    if (count == 1) return edge;
  }
  return {0, 0};
}

bool has_open_edge(const TriangleMesh& mesh) { return open_edge(mesh)[1] != 0; }

// A certificate of claim mesh-invalid-1 with one witness of M3 (docs/certificates/mesh.md, section 7).
std::string certificate(const Case& c, const TriangleMesh& mesh,
                        std::array<std::uint32_t, 2> edge) {
  const std::string body = "VTMI" + packed(static_cast<std::uint32_t>(mesh.faces.size()),
                                           static_cast<std::uint32_t>(mesh.positions.size()), 1u,
                                           std::uint8_t{3}, edge[0], edge[1]);
  const auto hash = [](const std::string& bytes) { return to_hex(sha256(io_test::bytes(bytes))); };
  return "{\"certificate\":\"veritope-certificate-1\",\"tool\":\"test\",\"claim\":\"mesh-invalid-"
         "1\",\"subject_sha256\":\"" +
         hash(c.bytes) + "\",\"subject_bytes\":" + std::to_string(c.bytes.size()) +
         ",\"subject_format\":\"" + mesh_format_name(c.format) + "\",\"reading_rule\":\"" +
         std::string(kReadingRule) + "\",\"as_indexed\":false,\"body_sha256\":\"" + hash(body) +
         "\",\"rules\":\"M3\"}\n" + body;
}

// Exit status, and what was printed.
std::pair<int, std::string> run(const std::string& command) {
  std::FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::string output;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) output += static_cast<char>(c);
  const int status = ::pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

// One folder for each case, with what the kernel reads as a certificate.
void write_cases(const std::vector<Case>& cases, const TempFolder& folder) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(cases[i].name);
    const auto file = io_test::read(cases[i].format, cases[i].bytes);
    EXPECT_EQ(file.has_value(), cases[i].is_read) << io_test::content(file);
    const TriangleMesh mesh = file ? file->mesh : TriangleMesh{{{}}, {{{0, 0, 0}}}};
    const std::string number = std::to_string(i);
    folder.write("certificate" + number, certificate(cases[i], mesh, open_edge(mesh)));
    folder.write("model" + number, cases[i].bytes);
  }
}

// 0 accepted, 1 rejected, and for the edge alone: the counts agree; 4 the model is refused.
void expect_outcome(const Case& c, int status, const std::string& output) {
  SCOPED_TRACE(c.name);
  const auto file = io_test::read(c.format, c.bytes);
  if (!file) {
    EXPECT_EQ(status, 4) << output;
  } else if (has_open_edge(file->mesh)) {
    EXPECT_EQ(status, 0) << output;
  } else {
    EXPECT_EQ(status, 1) << output;
    EXPECT_NE(output.find("REJECT I3"), output.npos) << output;
  }
}

void expect_agreement(const std::vector<Case>& cases) {
  const TempFolder folder;
  write_cases(cases, folder);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::string number = std::to_string(i);
    const auto [status, output] =
        run(test::program_dir() + "/veritope-check " + (folder / "model") + number + " " +
            (folder / "certificate") + number);
    expect_outcome(cases[i], status, output);
  }
}

// Compares with Python, all cases in one Python process.
void expect_python_agreement(const std::vector<Case>& cases) {
  const TempFolder folder;
  write_cases(cases, folder);
  const std::string driver =
      folder.write("driver.py",
                   "import runpy, sys\n"
                   "checker, folder, count = sys.argv[1:]\n"
                   "for i in range(int(count)):\n"
                   "    sys.argv = [checker, f'{folder}/model{i}', f'{folder}/certificate{i}']\n"
                   "    status = 0\n"
                   "    try:\n"
                   "        runpy.run_path(checker, run_name='__main__')\n"
                   "    except SystemExit as end:\n"
                   "        status = end.code or 0\n"
                   "    print(f'\\nstatus {status}', flush=True)\n");
  const auto [status, output] = run("PYTHONDONTWRITEBYTECODE=1 python3 " + driver + " " +
                                    test::source_dir() + "/verify/checker/veritope_check.py " +
                                    (folder / ".") + " " + std::to_string(cases.size()));
  ASSERT_EQ(status, 0) << output;
  std::size_t at = 0;
  for (const Case& c : cases) {
    const std::size_t end = output.find("status ", at);
    ASSERT_NE(end, output.npos) << output;
    expect_outcome(c, output[end + 7] - '0', output.substr(at, end - at));
    at = end + 8;
  }
}

TEST(ReadingAgreement, TheCheckerReadsStlLikeTheKernel) { expect_agreement(stl_cases()); }
TEST(ReadingAgreement, TheCheckerReadsObjLikeTheKernel) { expect_agreement(obj_cases()); }
TEST(ReadingAgreement, TheCheckerReadsPlyLikeTheKernel) { expect_agreement(ply_cases()); }
TEST(ReadingAgreement, TheCheckerReadsOffLikeTheKernel) { expect_agreement(off_cases()); }
TEST(ReadingAgreement, ThePythonCheckerReadsStlLikeTheKernel) {
  expect_python_agreement(stl_cases());
}
TEST(ReadingAgreement, ThePythonCheckerReadsObjLikeTheKernel) {
  expect_python_agreement(obj_cases());
}
TEST(ReadingAgreement, ThePythonCheckerReadsPlyLikeTheKernel) {
  expect_python_agreement(ply_cases());
}
TEST(ReadingAgreement, ThePythonCheckerReadsOffLikeTheKernel) {
  expect_python_agreement(off_cases());
}

}  // namespace
}  // namespace veritope
