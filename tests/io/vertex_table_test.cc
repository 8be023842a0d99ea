// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/vertex_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

namespace veritope {
namespace {

// Ids by the definition: the rank of the first occurrence.
std::vector<std::uint32_t> ids_by_map(const std::vector<Vec3d>& points) {
  std::map<std::tuple<double, double, double>, std::uint32_t> seen;
  std::vector<std::uint32_t> ids;
  for (const Vec3d& p : points) {
    const auto next = static_cast<std::uint32_t>(seen.size());
    ids.push_back(seen.try_emplace({p.x, p.y, p.z}, next).first->second);
  }
  return ids;
}

std::vector<std::uint32_t> ids_by_table(VertexTable table, const std::vector<Vec3d>& points,
                                        std::size_t batch, std::size_t reserved) {
  std::vector<Vec3d> store(points.size());
  std::vector<std::uint32_t> ids(points.size());
  table.reserve(reserved);
  for (std::size_t i = 0; i < points.size(); i += batch) {
    const std::size_t num = std::min(batch, points.size() - i);
    table.insert(std::span(points).subspan(i, num), store.data(), ids.data() + i);
  }
  EXPECT_EQ(table.num_positions(), 1 + *std::max_element(ids.begin(), ids.end()));
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(store[ids[i]], points[i]);
  return ids;
}

std::vector<Vec3d> grid_points(std::size_t num, int size, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vec3d> points;
  const auto coordinate = [&] {
    return static_cast<double>(random() % static_cast<unsigned>(size));
  };
  for (std::size_t i = 0; i < num; ++i)
    points.push_back({coordinate(), coordinate(), coordinate()});
  return points;
}

TEST(VertexTable, IdsAreRanksOfFirstOccurrences) {
  for (const int size : {1, 2, 5, 20, 1000}) {
    const std::vector<Vec3d> points = grid_points(5000, size, 1);
    const std::vector<std::uint32_t> expected = ids_by_map(points);
    for (const std::size_t batch : {std::size_t{1}, std::size_t{7}, VertexTable::kBatch}) {
      EXPECT_EQ(ids_by_table(VertexTable(), points, batch, 0), expected);
      EXPECT_EQ(ids_by_table(VertexTable(), points, batch, points.size()), expected);
    }
  }
}

TEST(VertexTable, IdsDoNotDependOnTheKey) {
  const std::vector<Vec3d> points = grid_points(3000, 10, 2);
  const std::vector<std::uint32_t> expected = ids_by_map(points);
  for (const std::uint64_t key : {0ull, 1ull, 0x3FF0000000000000ull, ~0ull}) {
    EXPECT_EQ(ids_by_table(VertexTable(key), points, 96, 0), expected);
  }
}

TEST(VertexTable, KeepsPositionsApartThatDifferInTheLastBit) {
  std::vector<Vec3d> points;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    points.push_back({std::bit_cast<double>(0x3FF0000000000000 + i), 0, 0});
    points.push_back({0, std::bit_cast<double>(0x3FF0000000000000 + i), 0});
    points.push_back({0, 0, std::bit_cast<double>(i)});
  }
  EXPECT_EQ(ids_by_table(VertexTable(), points, 96, 0), ids_by_map(points));
}

TEST(MergeEqualPositions, RenamesTheCorners) {
  TriangleMesh mesh;
  mesh.positions = grid_points(1000, 6, 3);
  for (std::uint32_t i = 0; i + 2 < 1000; ++i) mesh.faces.push_back({i, i + 1, i + 2});
  const TriangleMesh before = mesh;
  EXPECT_EQ(count_distinct_positions(mesh), 216u);
  EXPECT_EQ(merge_equal_positions(mesh), 216u);
  ASSERT_EQ(mesh.positions.size(), 216u);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(mesh.positions[mesh.faces[f][k]], before.positions[before.faces[f][k]]);
    }
  }
}

TEST(MergeEqualPositions, LeavesDistinctPositionsAlone) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces = {{2, 1, 0}};
  EXPECT_EQ(merge_equal_positions(mesh), 3u);
  EXPECT_EQ(mesh.faces[0], (std::array<std::uint32_t, 3>{2, 1, 0}));
  TriangleMesh none;
  EXPECT_EQ(merge_equal_positions(none), 0u);
}

}  // namespace
}  // namespace veritope
