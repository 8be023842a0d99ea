// SPDX-License-Identifier: LGPL-3.0-or-later
// The collection of real models: found through VERITOPE_DATA, read as its MANIFEST.tsv says.
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <map>

#include "tests/io/io_test_util.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result(1);
  for (const char c : line) {
    if (c == '\t') {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

std::vector<Row> read_manifest(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = cells(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> values = cells(line);
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && i < values.size(); ++i) row[names[i]] = values[i];
  }
  return rows;
}

void expect_refused(const std::string& path, const Row& row) {
  const auto start = std::chrono::steady_clock::now();
  const auto file = read_mesh_file(path, {});
  const auto time = std::chrono::steady_clock::now() - start;
  ASSERT_FALSE(file) << path << ": " << row.at("status");
  const Place& place = file.error().place;
  EXPECT_TRUE(place.line.has_value() || place.byte.has_value()) << to_string(file.error());
  EXPECT_LT(time, std::chrono::milliseconds(50)) << path;
}

void expect_read(const std::string& path, const Row& row) {
  const auto file = read_mesh_file(path, {});
  ASSERT_TRUE(file) << to_string(file.error());
  EXPECT_EQ(std::to_string(file->report.file_vertices), row.at("vertices")) << path;
  EXPECT_EQ(std::to_string(file->mesh.faces.size()), row.at("triangles")) << path;
  EXPECT_EQ(std::to_string(file->report.polygons_split), row.at("polygons_fan_split")) << path;
  EXPECT_EQ(file->sha256.substr(0, 16), row.at("sha256_16")) << path;
  ModelReadOptions two;
  two.jobs = 2;
  const auto again = read_mesh_file(path, two);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->mesh.positions, file->mesh.positions) << path;
  EXPECT_EQ(again->mesh.faces, file->mesh.faces) << path;
}

TEST(RealModels, AreReadOrRefusedAsTheirManifestSays) {
  const std::string folder = test::data_dir() + "/mesh/";
  const std::vector<Row> rows = read_manifest(folder + "MANIFEST.tsv");
  if (rows.empty())
    GTEST_SKIP() << "1 test skipped: no real models in " << folder << " (VERITOPE_DATA)";
  int num_refused = 0, num_read = 0;
  for (const Row& row : rows) {
    const bool is_malformed = row.at("class") == "malformed";
    (is_malformed ? num_refused : num_read)++;
    (is_malformed ? expect_refused : expect_read)(folder + row.at("file"), row);
  }
  EXPECT_GE(num_refused, 39);
  EXPECT_GE(num_read, 165);
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  RecordProperty("peak_kilobytes", static_cast<int>(usage.ru_maxrss));
}

}  // namespace
}  // namespace veritope
