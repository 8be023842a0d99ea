// SPDX-License-Identifier: LGPL-3.0-or-later
// The collection of real spline files: found through VERITOPE_DATA, read, counted and refused as its MANIFEST.tsv says;
// each goes through JSON and .itd and comes back the same. Label full.
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "io/formats.h"
#include "io/splines/write_splines.h"
#include "tests/io/spline_test_util.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

std::string data_folder() { return test::data_dir() + "/cad/"; }

/// File name to its column surface_types, "surface:4,curve:2", for the spline formats.
std::map<std::string, std::string> manifest() {
  std::map<std::string, std::string> rows;
  std::ifstream file(data_folder() + "MANIFEST.tsv");
  std::string line;
  while (std::getline(file, line)) {
    std::vector<std::string> cells;
    std::istringstream parts(line);
    for (std::string cell; std::getline(parts, cell, '\t');) cells.push_back(cell);
    if (cells.size() > 10 && format_from_path(cells[0], ModelKind::kSplines) != nullptr)
      rows[cells[0]] = cells[10];
  }
  return rows;
}

std::uint64_t left_out(const SplineFile& file, const std::string& start) {
  std::uint64_t count = 0;
  for (const LeftOut& l : file.left_out)
    if (l.what.starts_with(start)) count += l.count;
  return count;
}

// What we have of a kind that the manifest counts. It counts words of the text: splines within attributes, too.
std::uint64_t count_of(const SplineFile& file, const std::string& kind) {
  const auto splines = count_splines(file.model);
  std::uint64_t trimmed = 0, breps = 0, plain = 0, multivariates = 0;
  for (const SplineEntity& e : file.model.entities) {
    trimmed += std::holds_alternative<TrimmedSurface>(e.shape) ? 1u : 0u;
    breps += std::holds_alternative<SplineBrep>(e.shape) ? 1u : 0u;
    plain += std::holds_alternative<ExactSurface>(e.shape) ? 1u : 0u;
    for (auto g = e.group; g; g = file.model.groups[*g].parent)
      multivariates += file.model.groups[*g].name == "Multivars" ? 1u : 0u;
  }
  const std::uint64_t half = multivariates / 2;  // fltrtest: one of one parameter and one of two
  if (kind == "curve") return splines[0] - half + left_out(file, "curves within");
  if (kind == "surface") return splines[1] - half + left_out(file, "surfaces within");
  if (kind == "trivar" || kind == "spline_volume" || kind == "TensorBSpline3") return splines[2];
  if (kind == "trimsrf") return trimmed;
  if (kind == "model") return breps;
  if (kind == "polygon") return left_out(file, "polygons");
  if (kind == "spline_surface" || kind == "TensorBSpline2") return plain;
  if (kind == "bounded_surface") return trimmed + left_out(file, "trimmed");
  if (kind == "nurbs_patches") return file.model.entities.size();
  if (kind == "MultiPatch")
    return 2 * left_out(file, "elements <MultiPatch>");  // it counts both tags
  ADD_FAILURE() << kind;
  return 0;
}

void expect_counts(const std::string& name, const SplineFile& file, const std::string& expected) {
  std::istringstream parts(expected);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t colon = part.find(':');
    const std::string kind = part.substr(0, colon);
    std::uint64_t count = std::stoull(part.substr(colon + 1));
    if (kind == "dim") {
      const auto index = file.model.entities.at(0).shape.index();
      EXPECT_EQ(index + 1, count) << name;
      continue;
    }
    if (name == "gismo__scordelis_lo_roof.xml") count = 1;  // the other one is in a comment
    EXPECT_EQ(count_of(file, kind), count) << name << " " << kind;
  }
}

template <std::size_t N>
std::string value_at(const BSpline<Rational, N>& s) {
  std::array<Rational, N> at;
  for (std::size_t a = 0; a < N; ++a)
    at[a] = Rational(Integer(static_cast<int>(3 * a + 1)), Integer(static_cast<int>(7 + a)));
  return io_test::exact_value<N>(s, at);
}

// Values at an odd point of every spline.
std::vector<std::string> values(const SplineModel& model) {
  std::vector<std::string> out;
  for (const SplineEntity& e : model.entities)
    for_each_spline(e, [&](const auto& s) { out.push_back(value_at(s)); });
  return out;
}

void expect_round_trips(const std::string& name, const SplineFile& file) {
  const std::string json = spline_json_bytes(file.model);
  const SplineModel back = io_test::model_of(SplineFormat::kJson, json);
  EXPECT_TRUE(back == file.model) << name;
  EXPECT_EQ(spline_json_bytes(back), json) << name;
  if (file.model.entities.empty()) {
    EXPECT_TRUE(spline_loss(file.model, SplineFormat::kItd, itd_bytes(file.model)).unreadable);
    return;
  }
  const SplineModel again = io_test::model_of(SplineFormat::kItd, itd_bytes(file.model));
  EXPECT_TRUE(again == file.model) << name;
  const auto expected = values(file.model);
  EXPECT_EQ(values(back), expected) << name;
  EXPECT_EQ(values(again), expected) << name;
}

TEST(SplineData, IsReadCountedAndRefusedAsItsManifestSaysAndRoundTrips) {
  const auto rows = manifest();
  if (rows.empty())
    GTEST_SKIP() << "1 test skipped: no real splines in " << data_folder() << " (VERITOPE_DATA)";
  int num_read = 0, num_refused = 0;
  for (const auto& [name, expected] : rows) {
    const auto file = read_spline_file(data_folder() + name, {});
    if (name.starts_with("bad__")) {
      ++num_refused;
      ASSERT_FALSE(file) << name;
      EXPECT_TRUE(file.error().place.line) << to_string(file.error());
      continue;
    }
    ++num_read;
    ASSERT_TRUE(file) << to_string(file.error());
    expect_counts(name, *file, expected);
    expect_round_trips(name, *file);
  }
  EXPECT_EQ(num_refused, 3);
  EXPECT_GE(num_read, 76);
}

// The sign of det J at the middle of each Bezier piece, in rationals by differences of control points of the blossom: here
// by exact values at three points close by.
int handedness(const ExactVolume& volume) {
  const auto at = [&](int i, int j, int k) {
    const auto cut = bezier_pieces(volume);
    const Rational h(Integer(1), Integer(1000)), half(Integer(1), Integer(2));
    const auto v = evaluate(cut.pieces[0],
                            std::array<Rational, 3>{half + Rational(i) * h, half + Rational(j) * h,
                                                    half + Rational(k) * h});
    std::array<Rational, 3> p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = volume.is_rational() ? v[c] / v.back() : v[c];
    return p;
  };
  const auto o = at(0, 0, 0), x = at(1, 0, 0), y = at(0, 1, 0), z = at(0, 0, 1);
  const auto d = [&](const auto& p, std::size_t c) { return p[c] - o[c]; };
  const Rational det = d(x, 0) * (d(y, 1) * d(z, 2) - d(y, 2) * d(z, 1)) -
                       d(x, 1) * (d(y, 0) * d(z, 2) - d(y, 2) * d(z, 0)) +
                       d(x, 2) * (d(y, 0) * d(z, 1) - d(y, 1) * d(z, 0));
  return static_cast<int>(det.sign());
}

TEST(SplineData, TheVolumesOfMfemAreRightHanded) {
  // A wrong numbering of shared control points would fold them.
  int num_volumes = 0;
  for (const char* name :
       {"ball-nurbs", "beam-hex-nurbs", "cube-nurbs", "two-cubes-nurbs", "two-cubes-nurbs-rot"}) {
    const auto file = read_spline_file(data_folder() + "mfem__" + name + ".mesh", {});
    if (!file)
      GTEST_SKIP() << "1 test skipped: no real splines in " << data_folder() << " (VERITOPE_DATA)";
    for (const SplineEntity& e : file->model.entities) {
      EXPECT_EQ(handedness(std::get<ExactVolume>(e.shape)), 1) << name;
      ++num_volumes;
    }
  }
  EXPECT_EQ(num_volumes, 14);
}

}  // namespace
}  // namespace veritope
