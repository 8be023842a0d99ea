// SPDX-License-Identifier: LGPL-3.0-or-later
// docs/certificates/reading-rule-itd.md: the kernel's reader of .itd and the C++ checker's, which share no line, find the
// same surfaces, and refuse the same texts; on the samples, on mutations of them, on the real files of VERITOPE_DATA.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "io/read_model.h"
#include "tests/certify/checker_numbers.h"
#include "tests/io/spline_test_util.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/paths.h"
#include "verify/checker/patches/star.h"

namespace veritope {
namespace {

namespace fs = std::filesystem;

/// What a certificate may speak about: surfaces in space and no other geometry.
std::optional<std::vector<ExactSurface>> by_kernel(const std::string& text) {
  const auto file = io_test::read_splines(SplineFormat::kItd, text);
  if (!file) return std::nullopt;
  for (const LeftOut& l : file->left_out)
    if (l.is_geometry) return std::nullopt;
  std::vector<ExactSurface> out;
  for (const SplineEntity& e : file->model.entities) {
    const auto* const surface = std::get_if<ExactSurface>(&e.shape);
    if (surface == nullptr || surface->dimension() != 3) return std::nullopt;
    out.push_back(*surface);
  }
  return out;
}
std::optional<std::vector<::Entity>> by_checker(const std::string& text) {
  try {
    return ::read_spline_model(text, "itd");
  } catch (const ::Refused&) {
    return std::nullopt;
  }
}

// "" if they are the same, or what differs.
std::string difference(const ExactSurface& a, const ::Entity& b) {
  if (b.kind != ::Entity::kSurface || b.is_rational != a.is_rational() ||
      b.components != a.num_components())
    return "kind";
  for (std::size_t k = 0; k < 2; ++k) {
    if (a.axis(k).degree != b.degrees[k]) return "degree";
    if (a.axis(k).knots.size() != b.knots[k].size()) return "number of knots";
    for (std::size_t i = 0; i < b.knots[k].size(); ++i)
      if (a.axis(k).knots[i] != rational_of(b.knots[k][i])) return "knot " + std::to_string(i);
  }
  const auto c = static_cast<std::size_t>(b.components);
  const std::size_t count = a.axis(0).num_control() * a.axis(1).num_control();
  if (count != b.places.size()) return "number of points";
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < c; ++k)
      if (a.component(static_cast<int>(k))[i] != rational_of(b.number(i, k)))
        return "point " + std::to_string(i);
  return "";
}

/// How many surfaces both find; nothing if both refuse.
std::optional<std::size_t> agreed(const std::string& text, const std::string& name) {
  const auto kernel = by_kernel(text);
  const auto checker = by_checker(text);
  EXPECT_EQ(kernel.has_value(), checker.has_value()) << name << "\n" << text;
  if (!kernel || !checker) return std::nullopt;
  EXPECT_EQ(kernel->size(), checker->size()) << name;
  for (std::size_t i = 0; i < std::min(kernel->size(), checker->size()); ++i)
    EXPECT_EQ(difference((*kernel)[i], (*checker)[i]), "") << name << ", surface " << i << "\n"
                                                           << text;
  return kernel->size();
}

const std::vector<std::string>& samples() {
  static const std::vector<std::string> kSamples = {
      "[SURFACE BEZIER 2 3 E3 [0 0 0][1 0 .25] [0 1 0][1 1 -0.5e0] [0 2 0][1 2 1e-1]]",
      "x ] \" [OBJECT [c 5] [t \"a]\"] N\n [SURFACE BSPLINE [r \"1\"] 3 2 2 2 P3 [KV 0 0 .5 1 1] "
      "[KV "
      "-1 0 1 2]\n [1 0 0 0][2 1 0 0][1 2 0 0] [1 0 1 0][.5 1 1 0][1 2 1 0]] [MATRIX 1 0] ] end",
      "[OBJECT [OBJECT A [SURFACE BSPLINE 4 2 3 2 E3 [KVP 0 1 2 3 4 5 6 7 8][KV 0 0 1 1] [0 0 0][1 "
      "0 0]"
      "[1 1 0][0 1 0] [0 0 1][1 0 1][1 1 1][0 1 1]]] \"B \\\" C\" [NUMBER 3]]",
      "[MULTIVAR POWER 2 3 2 E3 [1 0 0] [1 0 2] [0 0 3] [0 1 0] [0 0 0] [0 0 6]] [STRING \"[\"]",
      "[SURFACE POWER 2 3 P3 [3 0 0 0][1 1 0 0] [.1 0 1 0][-.2 0 0 1] [1 1 1 1][2 2 2 2]]"};
  return kSamples;
}

TEST(ItdReading, KernelAndCheckerFindTheSameSurfacesInTheSamples) {
  const std::size_t expected[] = {1, 1, 1, 1, 1};
  for (std::size_t i = 0; i < samples().size(); ++i)
    EXPECT_EQ(agreed(samples()[i], "sample " + std::to_string(i)), expected[i]);
  std::string all;
  for (const std::string& s : samples()) all += s;
  EXPECT_EQ(agreed(all, "all"), samples().size());
  EXPECT_EQ(agreed("[OBJECT EMPTY]", "no entity"), 0u);
}

TEST(ItdReading, KernelAndCheckerRefuseTheSameOtherGeometry) {
  for (const char* const other :
       {"[CURVE BEZIER 2 E3 [0 0 0][1 0 0]]", "[POLYGON 3 [0 0 0][1 0 0][0 1 0]]", "[INSTANCE A]",
        "[TRIVAR BEZIER 1 1 1 E3 [0 0 0]]", "[SURFACE BEZIER 2 2 E2 [0 0][1 0][0 1][1 1]]",
        "[MULTIVAR BEZIER 1 2 E3 [0 0 0][1 0 0]]", "[MULTIVAR BEZIER 4 1 1 1 1 E1 [0]]",
        "[POINTLIST 1 [0 0 0]]", "[POLYLINE 2 [0 0 0] [1 1 1]]", "[TRISRF BEZIER 2 E3]",
        "[TRIMSRF [SURFACE BEZIER 2 2 E3 [0 0 0][1 0 0][0 1 0][1 1 0]]]", "[MODEL 0 0]"})
    for (const std::string& text : {samples()[0] + other, "[OBJECT A " + std::string(other) + "]"})
      EXPECT_EQ(agreed(text, other), std::nullopt) << text;
}

TEST(ItdReading, KernelAndCheckerAgreeOnMutatedTexts) {
  constexpr unsigned kSeed = 20260;
  std::mt19937 random(kSeed);
  const auto below = [&](std::size_t n) { return random() % n; };
  const std::vector<std::string> pieces = {"[",
                                           "]",
                                           "\"",
                                           "\\",
                                           " ",
                                           "\n",
                                           "\v",
                                           "0",
                                           "1",
                                           "9",
                                           "-",
                                           "+",
                                           ".",
                                           "e",
                                           "e2",
                                           "1e4096",
                                           "1e-4097",
                                           "KV",
                                           "KVP",
                                           "E3",
                                           "P3",
                                           "E2",
                                           "2",
                                           "3",
                                           "-1",
                                           "[a]",
                                           "[KV]",
                                           "NUMBER",
                                           "POLYGON",
                                           "[OBJECT",
                                           "]]",
                                           "POWER",
                                           "BEZIER",
                                           "[0 0 0]",
                                           "[1 0 0 0]",
                                           "MULTIVAR",
                                           "SURFACE",
                                           "[SURFACE",
                                           "[CTLPT E3]",
                                           std::string(1, '\0'),
                                           std::string(1, '\xff'),
                                           "[[",
                                           "\"\"",
                                           "0.5",
                                           "64",
                                           "65"};
  std::size_t num_read = 0, num_refused = 0;
  for (int i = 0; i < scaled(20'000); ++i) {
    std::string text = samples()[below(samples().size())];
    for (std::size_t k = 1 + below(2); k > 0; --k) {
      const std::size_t at = below(text.size() + 1);
      if (below(3) == 0) {  // copy a part elsewhere
        const std::string part = text.substr(at, below(30));
        text.insert(below(text.size() + 1), part);
      } else {
        text.replace(at, below(4), below(4) == 0 ? "" : pieces[below(pieces.size())]);
      }
    }
    const auto found =
        agreed(text, "seed " + std::to_string(kSeed) + ", text " + std::to_string(i));
    ++(found && *found > 0 ? num_read : num_refused);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GE(num_read, 1'000u);
  EXPECT_GE(num_refused, 5'000u);
}

std::string slurp(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ItdReading, KernelAndCheckerAgreeOnRealFiles) {
  const fs::path folder = fs::path(test::data_dir()) / "cad";
  if (!fs::is_directory(folder))
    GTEST_SKIP() << "1 test skipped: no real .itd files in " << folder << " (VERITOPE_DATA)";
  std::size_t num_files = 0, num_read = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".itd") continue;
    ++num_files;
    num_read += agreed(slurp(entry.path()), entry.path().filename().string()) ? 1u : 0u;
  }
  EXPECT_GE(num_files, 27u);
  EXPECT_GE(num_read, 12u);
}

}  // namespace
}  // namespace veritope
