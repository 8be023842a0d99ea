// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/facet_meetings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "solids/polyhedron/separating_axis.h"
#include "solids/polyhedron/validity.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

FacetMeetings decided(const TriangleMesh& mesh, unsigned jobs = 1, bool keeps = true) {
  ValidityOptions options;
  options.jobs = jobs;
  options.keep_meetings = keeps;
  return decide_validity(mesh, options).meetings;
}

bool boxes_meet_slowly(const TriangleMesh& mesh, std::uint32_t f, std::uint32_t g) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = [&](std::uint32_t face, std::size_t k) {
      return mesh.positions[mesh.faces[face][k]][axis];
    };
    const auto [f_low, f_high] = std::minmax({at(f, 0), at(f, 1), at(f, 2)});
    const auto [g_low, g_high] = std::minmax({at(g, 0), at(g, 1), at(g, 2)});
    if (f_high < g_low || g_high < f_low) return false;
  }
  return true;
}

// All pairs by brute force, with the axes that separate them.
void expect_all_meetings(const TriangleMesh& mesh, const char* what) {
  const ValidityReport report = decide_validity(mesh, {});
  ASSERT_TRUE(report.is_valid) << what;
  const FacetMeetings found = decided(mesh);
  ASSERT_EQ(found.order.size(), mesh.faces.size()) << what;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint8_t> expected, actual;
  for (std::uint32_t i = 0; i < found.order.size(); ++i)
    for (std::uint32_t j = i + 1; j < found.order.size(); ++j) {
      const std::uint32_t f = found.order[i], g = found.order[j];
      bool has_star = false;
      for (const std::uint32_t v : mesh.faces[f])
        for (const std::uint32_t w : mesh.faces[g])
          has_star = has_star || (v == w && report.stars[v]);
      if (!has_star && boxes_meet_slowly(mesh, f, g))
        expected[{i, j}] = separating_axis(mesh, f, g).value_or(FacetMeeting::kNoAxis);
    }
  for (const FacetMeeting& m : found.pairs) actual[{m.first, m.second}] = m.axis;
  EXPECT_EQ(actual.size(), found.pairs.size()) << what << ": a pair comes twice";
  EXPECT_TRUE(actual == expected) << what;
  const FacetMeetings alone = find_facet_meetings(mesh, report.stars, report.box, 2, nullptr);
  EXPECT_EQ(alone.order, found.order) << what;
  EXPECT_TRUE(alone.pairs == found.pairs) << what;
  EXPECT_TRUE(decided(mesh, 3).pairs == found.pairs) << what;
}

TEST(FacetMeetings, AreThePairsWhoseBoxesMeetWithoutACommonStar) {
  expect_all_meetings(shapes::box({0, 0, 0}, {1, 2, 3}), "box");
  expect_all_meetings(shapes::nested_boxes(6), "nested boxes");
  expect_all_meetings(shapes::box_grid(3, 0.5), "grid of boxes");
  expect_all_meetings(shapes::saddle(), "a vertex without a star");
  expect_all_meetings(shapes::cone(40), "cone");
}

TEST(FacetMeetings, AreKeptForValidMeshesOnRequestOnly) {
  const TriangleMesh box = shapes::box({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(decided(box, 1, false).order.empty());
  EXPECT_TRUE(decided(shapes::reversed(box)).order.empty());
}

}  // namespace
}  // namespace veritope
