// SPDX-License-Identifier: LGPL-3.0-or-later
// docs/certificates/reading-rule-g2.md, reading-rule-mfem.md and reading-rule-faces.md: the kernel's readers and the C++
// checker's, which share no line, find the same entities and refuse the same texts; on samples, on mutations of them, on
// the real files of VERITOPE_DATA. Those of .itd alone: itd_reading_test.cc.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <random>

#include "io/splines/boundary_faces.h"
#include "io/splines/write_splines.h"
#include "tests/certify/checker_numbers.h"
#include "tests/io/spline_test_util.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/paths.h"
#include "verify/checker/patches/star.h"

namespace veritope {
namespace {

namespace fs = std::filesystem;

/// A surface, or nothing for a volume.
using Entities = std::vector<std::optional<ExactSurface>>;

/// A format of statements: "g2", "vjson-faces".
struct Rule {
  SplineFormat format;
  bool is_of_faces = false;
  std::string name() const {
    return std::string(spline_format_name(format)) + (is_of_faces ? "-faces" : "");
  }
};
constexpr SplineFormat kG2 = SplineFormat::kG2, kMfem = SplineFormat::kMfem,
                       kItd = SplineFormat::kItd, kJson = SplineFormat::kJson;

std::optional<Entities> by_kernel(const std::string& text, const Rule& rule) {
  const auto file = io_test::read_splines(rule.format, text);
  if (!file || file->has_converted_shapes) return std::nullopt;
  for (const LeftOut& l : file->left_out)
    if (l.is_geometry) return std::nullopt;
  Entities out;
  if (rule.is_of_faces) {
    const auto faces = boundary_faces(file->model);
    if (!faces) return std::nullopt;
    for (const SplineEntity& e : faces->model.entities)
      out.push_back(std::get<ExactSurface>(e.shape));
    return out;
  }
  for (const SplineEntity& e : file->model.entities) {
    const auto* const surface = std::get_if<ExactSurface>(&e.shape);
    if (surface == nullptr && !std::holds_alternative<ExactVolume>(e.shape)) return std::nullopt;
    out.push_back(surface != nullptr ? std::optional(*surface) : std::nullopt);
  }
  if (out.empty()) return std::nullopt;
  return out;
}
std::optional<std::vector<::Entity>> by_checker(const std::string& text, const Rule& rule) {
  try {
    return ::read_spline_model(text, rule.name());
  } catch (const ::Refused&) {
    return std::nullopt;
  }
}

// "" if they are the same, or what differs.
std::string difference(const std::optional<ExactSurface>& surface, const ::Entity& b) {
  if (!surface) return b.kind == ::Entity::kOther ? "" : "kind";
  const ExactSurface& a = *surface;
  if (b.kind != ::Entity::kSurface || b.is_rational != a.is_rational() ||
      b.components != a.num_components())
    return "kind";
  if (a.dimension() != 3) return "";  // B2 fails; the checker keeps no points
  for (std::size_t k = 0; k < 2; ++k) {
    if (a.axis(k).degree != b.degrees[k]) return "degree";
    if (a.axis(k).knots.size() != b.knots[k].size()) return "number of knots";
    for (std::size_t i = 0; i < b.knots[k].size(); ++i)
      if (a.axis(k).knots[i] != rational_of(b.knots[k][i])) return "knot " + std::to_string(i);
  }
  const std::size_t count = a.grid().count();
  if (count != b.places.size()) return "number of points";
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < static_cast<std::size_t>(a.num_components()); ++c)
      if (a.component(static_cast<int>(c))[i] != rational_of(b.number(i, c)))
        return "point " + std::to_string(i);
  return "";
}

/// How many entities both find; nothing if both refuse.
std::optional<std::size_t> agreed(const std::string& text, const Rule& rule,
                                  const std::string& name) {
  const auto kernel = by_kernel(text, rule);
  const auto checker = by_checker(text, rule);
  EXPECT_EQ(kernel.has_value(), checker.has_value()) << rule.name() << ", " << name << "\n"
                                                     << text.substr(0, 4000);
  if (!kernel || !checker) return std::nullopt;
  EXPECT_EQ(kernel->size(), checker->size()) << rule.name() << ", " << name;
  for (std::size_t i = 0; i < std::min(kernel->size(), checker->size()); ++i)
    EXPECT_EQ(difference((*kernel)[i], (*checker)[i]), "")
        << rule.name() << ", " << name << ", entity " << i << "\n"
        << text.substr(0, 4000);
  return kernel->size();
}

// ---- samples

/// The brick from (x, 0, 0) to (x + 1, 1, 1) in each format; `weights` is 1 for all points, or not.
std::string g2_brick(int x) {
  std::string out = "700 1 0 0 3 0 2 2 0 0 1 1 2 2 0 0 1 1 2 2 0 0 1 1\n";
  for (int k = 0; k < 8; ++k)
    out += std::to_string(x + (k & 1)) + " " + std::to_string(k >> 1 & 1) + " " +
           std::to_string(k >> 2) + "\n";
  return out;
}
std::string itd_brick(int x) {
  std::string out = "[TRIVAR BSPLINE 2 2 2 2 2 2 P3 [KV 0 0 1 1][KV 0 0 1 1][KV 0 0 1 1]";
  for (int k = 0; k < 8; ++k)
    out += "[2 " + std::to_string(2 * x + 2 * (k & 1)) + " " + std::to_string(2 * (k >> 1 & 1)) +
           " " + std::to_string(2 * (k >> 2)) + "]";
  return out + "]\n";
}

const std::vector<std::string>& g2_samples() {
  static const std::vector<std::string> kSamples = {
      "200 1 0 0\n3 0\n2 2\n0 0 1 1\n3 2\n0 0 .5 1 1\n0 0 0 1 0 .25\n0 1 0 1 1 -0.5e0\n0 2 0 1 2 "
      "1e-1\n",
      "200 1 0 4 255 0 0 255\n3 1 3 3 0 0 0 1 1 1 2 2 -1 -1 2 2\n1 0 0 1 .5 .5 0 .5 0 1 0 1\n1 0 "
      "1 1 .5 .5 .5 .5 0 1 1 1",
      "200 1 0 0 2 1 2 2 0 0 1 1 2 2 0 0 1 1 0 0 1 1 0 1 0 1 1 1 1 1",
      g2_brick(0),
      g2_brick(0) + g2_brick(1),
  };
  return kSamples;
}

std::string mfem_header(const std::string& dimension, const std::string& elements,
                        const std::string& edges, const std::string& vertices) {
  return "MFEM NURBS mesh v1.0\n# a mesh\ndimension\n" + dimension + "\nelements\n" + elements +
         "\nboundary\n1\n1 1 0 1\nedges\n" + edges + "\nvertices\n" + vertices + "\n";
}
std::string slurp(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
const std::vector<std::string>& mfem_samples() {
  static const std::vector<std::string> kSamples = {
      slurp(io_test::spline_folder() + "two_cubes.mesh"),
      slurp(io_test::spline_folder() + "patches.mesh"),
      mfem_header("2", "2 1 3 0 1 4 3 2 3 5 4 1 2", "7 0 0 1 0 3 4 1 0 3 1 1 4 2 2 1 2 5 4 1 2 5",
                  "6") +
          "knotvectors 3\n2 4 0 0 0 1 3 3 3\n1 2 0 0 1 1\n1 3 0 0 1 4 4\nunitweights\n"
          "FiniteElementSpace\nFiniteElementCollection: NURBS\nVDim: 3\nOrdering: 1\n"
          "0 0 0 4 0 0 8 0 1 0 2 0 4 2 0 8 2 1\n1 0 1 3 0 1 1 2 1 3 2 1 6 0 1 6 2 1\n",
      "MFEM NURBS mesh v1.1 dimension 2 elements 1 7 3 0 1 2 3 boundary 0 edges 4 0 0 1 0 3 2 1 0 "
      "3 1 1 2 vertices 4 knotvectors 2 1 2 0 0 1 1 1 2 0 0 1 1 refinements 1 1 "
      "knotvector_refinements 1 2 0 spacing 1 0 5 1 1 4 .5 weights 1 2 1 .5 FiniteElementSpace "
      "FiniteElementCollection: NURBS1 VDim: 3 Ordering: 0 0 1 1 0 0 0 1 1 0 0 0 1",
      mfem_header("3", "1 1 5 0 1 2 3 4 5 6 7", "0", "8") +
          "patches knotvectors 3 1 2 0 0 1 1 1 2 0 0 1 1 1 2 0 0 1 1 dimension 3 "
          "controlpoints_cartesian\n0 0 0 1 1 0 0 1 0 1 0 1 1 1 0 1 0 0 1 2 1 0 1 2 0 1 1 2 1 1 1 "
          "3\n"};
  return kSamples;
}

std::string json_of(SplineFormat format, const std::string& text) {
  return spline_json_bytes(io_test::model_of(format, text));
}

const std::vector<std::string>& samples_of(const Rule& rule) {
  static std::map<std::string, std::vector<std::string>> all;
  std::vector<std::string>& out = all[rule.name()];
  if (!out.empty()) return out;
  switch (rule.format) {
    case SplineFormat::kG2: out = g2_samples(); break;
    case SplineFormat::kMfem: out = mfem_samples(); break;
    case SplineFormat::kItd:
      out = {itd_brick(0), "x [OBJECT A [c 5] " + itd_brick(0) + itd_brick(1) + "] [NUMBER 1]",
             "[MULTIVAR POWER 3 2 2 2 E3 [0 0 0][0 0 1][0 1 0][0 0 0][1 0 0][0 0 0][0 0 0][0 0 0]]",
             // A ring of three sides, closed on itself, of which v = 0 is collapsed to its axis.
             "[TRIVAR BSPLINE 4 2 2 2 2 2 E3 [KV 0 0 1 2 3 3][KV 0 0 1 1][KV 0 0 5 5] [0 0 0][0 0 "
             "0][0 0 0][0 0 0] [1 0 0][0 1 0][-1 -1 0][1 0 0] [0 0 1][0 0 1][0 0 1][0 0 1] [1 0 1]"
             "[0 1 1][-1 -1 1][1 0 1]]"};
      break;
    default:
      for (const std::string& text : samples_of({kItd, true})) out.push_back(json_of(kItd, text));
      out.push_back(json_of(kMfem, mfem_samples()[0]));
      break;
  }
  return out;
}

TEST(ReadingRules, KernelAndCheckerFindTheSameEntitiesInTheSamples) {
  const auto expect = [](const Rule& rule, const std::vector<std::optional<std::size_t>>& counts) {
    ASSERT_EQ(samples_of(rule).size(), counts.size()) << rule.name();
    for (std::size_t i = 0; i < counts.size(); ++i)
      EXPECT_EQ(agreed(samples_of(rule)[i], rule, "sample " + std::to_string(i)), counts[i])
          << rule.name() << " " << i;
  };
  const std::optional<std::size_t> none;
  expect({kG2}, {1, 1, 1, 1, 2});
  expect({kG2, true}, {none, none, none, 6, 10});
  expect({kMfem}, {2, 1, 2, 1, 1});
  expect({kMfem, true}, {10, none, none, none, 6});
  expect({kItd, true}, {6, 10, 6, 3});
  expect({kJson, true}, {6, 10, 6, 3, 10});
}

TEST(ReadingRules, KernelAndCheckerRefuseTheSameOtherContent) {
  for (const std::string other :
       {"100 1 0 0 3 0 2 2 0 0 1 1 0 0 0 1 1 1", "250 1 0 0 3 0 0 0 0 0 1 1 0 0 1 0 1 0 1 0",
        "261 1 0 0 3 3 0 2 2 0 0 1 1 0 0 0 1 0 0 0 1 0 1 0 1 0 1 0", "201 1 0 0", "7 1 0 0", "x",
        "200 1 0", "200 1 0 -1", "200 1 0 0 1001 0", "200.0 1 0 0 3 0 1 1 0 1 1 1 0 1 0 0 0"})
    for (const bool is_of_faces : {false, true})
      EXPECT_EQ(agreed(g2_brick(0) + other, {kG2, is_of_faces}, other), std::nullopt) << other;
  const std::string mesh = mfem_samples()[4];
  for (const auto& [from, to] : std::map<std::string, std::string>{{"v1.0", "v1.2"},
                                                                   {"dimension\n3", "dimension\n1"},
                                                                   {"1 5 0", "1 3 0"},
                                                                   {"7\nboundary", "8\nboundary"},
                                                                   {"elements\n1", "elements\n0"},
                                                                   {"patches", "periodic"}})
    for (const bool is_of_faces : {false, true}) {
      std::string text = mesh;
      ASSERT_NE(text.find(from), text.npos) << from;
      text.replace(text.find(from), from.size(), to);
      EXPECT_EQ(agreed(text, {kMfem, is_of_faces}, to), std::nullopt) << to;
    }
  for (const char* const other :
       {"[SURFACE BEZIER 2 2 E3 [0 0 0][1 0 0][0 1 0][1 1 0]]",
        "[CURVE BEZIER 2 E3 [0 0 0][1 0 0]]", "[POLYGON 3 [0 0 0][1 0 0][0 1 0]]",
        "[MULTIVAR BEZIER 2 2 2 E3 [0 0 0][1 0 0][0 1 0][1 1 0]]",
        "[TRIVAR BEZIER 2 2 2 E1 [0][1][2][3][4][5][6][7]]",
        "[TRIVAR BSPLINE 2 2 2 2 2 2 E3 [KV 0 0 1 1][KV 0 0 1 1][KV 0 1 2 3] [0 0 0][1 0 0][0 1 0]"
        "[1 1 0][0 0 1][1 0 1][0 1 1][1 1 1]]"})
    EXPECT_EQ(agreed(itd_brick(0) + other, {kItd, true}, other), std::nullopt) << other;
}

// Both take a mesh apart by its topology: patches that share a face in each of its eight positions, and edges listed
// either way, with the knots that this means.
TEST(ReadingRules, KernelAndCheckerNumberSharedControlPointsAlike) {
  constexpr unsigned kSeed = 20261;
  std::mt19937 random(kSeed);
  // The corners of a patch, named by (u, v, w); MFEM's order.
  constexpr int kCorner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                 {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::size_t num_read = 0;
  for (int run = 0; run < scaled(300); ++run) {
    // Two bricks in a row in the lattice; the second one's axes are permuted and reversed.
    std::vector<int> label(12);
    for (int i = 0; i < 12; ++i) label[static_cast<std::size_t>(i)] = i;
    std::shuffle(label.begin(), label.end(), random);
    const auto vertex = [&](int x, int y, int z) {
      return label[static_cast<std::size_t>(x + 3 * (y + 2 * z))];
    };
    std::array<int, 3> from = {0, 1, 2};
    std::shuffle(from.begin(), from.end(), random);
    const unsigned flips = random() % 8;
    std::array<std::array<int, 8>, 2> patches{};
    for (int p = 0; p < 2; ++p)
      for (std::size_t c = 0; c < 8; ++c) {
        std::array<int, 3> at{};
        for (std::size_t a = 0; a < 3; ++a) {
          const int t = kCorner[c][a];
          if (p == 0)
            at[a] = t;
          else
            at[static_cast<std::size_t>(from[a])] = (flips >> a & 1) != 0 ? 1 - t : t;
        }
        patches[static_cast<std::size_t>(p)][c] = vertex(at[0] + p, at[1], at[2]);
      }
    // Lattice directions have knot vectors 0 (x of the first), 1 (x of the second), 2 (y), 3 (z).
    std::map<std::pair<int, int>, std::array<int, 3>> edges;
    const std::array<bool, 4> is_turned = {random() % 2 == 0, random() % 2 == 0, random() % 2 == 0,
                                           random() % 2 == 0};
    for (int x = 0; x < 3; ++x)
      for (int y = 0; y < 2; ++y)
        for (int z = 0; z < 2; ++z)
          for (int a = 0; a < 3; ++a) {
            if ((a == 0 ? x : a == 1 ? y : z) + 1 > (a == 0 ? 2 : 1)) continue;
            const int b = vertex(x + (a == 0), y + (a == 1), z + (a == 2)), v = vertex(x, y, z);
            const int k = a == 0 ? x : a + 1;
            const bool turn = is_turned[static_cast<std::size_t>(k)];
            edges[{std::min(v, b), std::max(v, b)}] = {k, turn ? b : v, turn ? v : b};
          }
    std::vector<std::array<int, 3>> listed;
    for (const auto& entry : edges) listed.push_back(entry.second);
    std::shuffle(listed.begin(), listed.end(), random);
    std::string text = "MFEM NURBS mesh v1.0\ndimension 3\nelements 2\n";
    for (const auto& patch : patches) {
      text += "1 5";
      for (const int v : patch) text += " " + std::to_string(v);
      text += "\n";
    }
    text += "boundary 0\nedges " + std::to_string(listed.size()) + "\n";
    for (const auto& [k, a, b] : listed)
      text += std::to_string(k) + " " + std::to_string(a) + " " + std::to_string(b) + "\n";
    text +=
        "vertices 12\nknotvectors 4\n1 2 0 0 1 1\n2 4 0 0 0 1 3 3 3\n2 5 0 0 0 1 2 5 5 5\n1 4 0 0 "
        "2 "
        "3 7 7\n";
    // Each control point has another weight and place, so that any other numbering is another model.
    const int counts[4] = {2, 4, 5, 4};
    int points = 12;
    for (const auto& edge : listed) points += counts[edge[0]] - 2;
    const int i = counts[0] - 2, j = counts[1] - 2, k = counts[2] - 2, l = counts[3] - 2;
    points += 3 * k * l + 2 * (i * k + i * l + j * k + j * l) + (i + j) * k * l;
    text += "weights\n";
    for (int n = 0; n < points; ++n) text += std::to_string(n + 1) + "\n";
    text += "FiniteElementSpace FiniteElementCollection: NURBS VDim: 3 Ordering: 1\n";
    for (int n = 0; n < points; ++n)
      text += std::to_string(n * n % 101) + " " + std::to_string(n) + " " +
              std::to_string(n * n * n % 103) + "\n";
    const std::string name = "seed " + std::to_string(kSeed) + ", mesh " + std::to_string(run);
    EXPECT_EQ(agreed(text, {kMfem}, name), 2u);
    const auto faces = agreed(text, {kMfem, true}, name);
    // The common face is a wall, unless the hands of the two say that they lie on one side of it. Most fold.
    EXPECT_TRUE(!faces || faces == 10u || faces == 12u) << name;
    ++num_read;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GE(num_read, 300u);
}

// ---- mutations

const std::vector<std::string> kPieces = {" ",
                                          "\n",
                                          "\v",
                                          "0",
                                          "1",
                                          "9",
                                          "-",
                                          "+",
                                          ".",
                                          "e",
                                          "1e4096",
                                          "1e-4097",
                                          "2",
                                          "3",
                                          "-1",
                                          "0.5",
                                          "64",
                                          "65",
                                          "200 1 0 0",
                                          "700",
                                          "#",
                                          "# x\n",
                                          "patches",
                                          "knotvectors",
                                          "weights",
                                          "unitweights",
                                          "autoweights",
                                          "dimension",
                                          "controlpoints",
                                          "controlpoints_cartesian",
                                          "NURBS2",
                                          "spacing 0",
                                          "v1.1",
                                          "Ordering: 0",
                                          "[",
                                          "]",
                                          "KVP",
                                          "KV",
                                          "P3",
                                          "E3",
                                          "[a]",
                                          "1 1 1",
                                          "0 0 1 1",
                                          "\"",
                                          "1/3",
                                          "1e3000",
                                          "9223372036854775807",
                                          "4611686018427387904",
                                          "4611686018427387905",
                                          "true",
                                          "volume",
                                          "surface",
                                          std::string(1, '\0'),
                                          std::string(1, '\xff'),
                                          "\xef\xbb\xbf"};

void agree_on_mutations(const Rule& rule, unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto below = [&](std::size_t n) { return random() % n; };
  const std::vector<std::string>& samples = samples_of(rule);
  std::size_t num_read = 0, num_refused = 0;
  for (int i = 0; i < scaled(count); ++i) {
    std::string text = samples[below(samples.size())];
    for (std::size_t k = 1 + below(2); k > 0; --k) {
      const std::size_t at = below(text.size() + 1);
      switch (below(4)) {
        case 0: {  // copy a part elsewhere
          const std::string part = text.substr(at, below(30));
          text.insert(below(text.size() + 1), part);
          break;
        }
        case 1: {  // another digit
          const std::size_t digit = text.find_first_of("0123456789", at);
          if (digit != text.npos) text[digit] = static_cast<char>('0' + below(10));
          break;
        }
        default: text.replace(at, below(4), below(4) == 0 ? "" : kPieces[below(kPieces.size())]);
      }
    }
    const auto found =
        agreed(text, rule, "seed " + std::to_string(seed) + ", text " + std::to_string(i));
    ++(found ? num_read : num_refused);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GE(num_read, static_cast<std::size_t>(count) / 50) << rule.name();
  EXPECT_GE(num_refused, static_cast<std::size_t>(count) / 5) << rule.name();
}
TEST(ReadingRules, KernelAndCheckerAgreeOnMutatedG2) { agree_on_mutations({kG2}, 20262, 6'000); }
TEST(ReadingRules, KernelAndCheckerAgreeOnMutatedMeshes) {
  agree_on_mutations({kMfem}, 20263, 6'000);
}
TEST(ReadingRules, KernelAndCheckerAgreeOnTheFacesOfMutatedVolumes) {
  agree_on_mutations({kG2, true}, 20264, 3'000);
  agree_on_mutations({kMfem, true}, 20265, 3'000);
  agree_on_mutations({kItd, true}, 20266, 3'000);
  agree_on_mutations({kJson, true}, 20267, 3'000);
}

// ---- real files

TEST(ReadingRules, KernelAndCheckerAgreeOnRealFiles) {
  const fs::path folder = fs::path(test::data_dir()) / "cad";
  if (!fs::is_directory(folder))
    GTEST_SKIP() << "1 test skipped: no real files in " << folder << " (VERITOPE_DATA)";
  const std::map<std::string, SplineFormat> formats = {
      {".g2", kG2}, {".mesh", kMfem}, {".itd", kItd}, {".xml", SplineFormat::kGismo}};
  std::map<std::string, std::size_t> num_read;
  std::size_t num_files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto format = formats.find(entry.path().extension().string());
    if (format == formats.end()) continue;
    ++num_files;
    const std::string name = entry.path().filename().string(), text = slurp(entry.path());
    if (format->second != SplineFormat::kGismo) {
      for (const Rule& rule : {Rule{format->second}, Rule{format->second, true}}) {
        if (rule.name() == "itd") continue;
        num_read[rule.name()] += agreed(text, rule, name) ? 1u : 0u;
      }
    }
    const auto file = io_test::read_splines(format->second, text);
    if (file && !file->model.entities.empty())
      num_read["vjson-faces"] +=
          agreed(spline_json_bytes(file->model), {kJson, true}, name) ? 1u : 0u;
  }
  EXPECT_GE(num_files, 79u);
  EXPECT_GE(num_read["g2"], 6u);
  EXPECT_GE(num_read["g2-faces"], 1u);
  EXPECT_GE(num_read["mfem"], 16u);
  EXPECT_GE(num_read["mfem-faces"], 7u);
  EXPECT_GE(num_read["itd-faces"], 4u);
  EXPECT_GE(num_read["vjson-faces"], 15u);
}

}  // namespace
}  // namespace veritope
