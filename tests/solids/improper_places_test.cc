// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/improper_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/solids/decision_check.h"

namespace veritope {
namespace {

bool contains(const Box3d& box, const RationalPoint& point) {
  for (std::size_t k = 0; k < 3; ++k)
    if (point.at[k] < Rational::from_double(box.lo[k]) ||
        Rational::from_double(box.hi[k]) < point.at[k])
      return false;
  return true;
}

// Clusters by the definition: faces of improper pairs, joined until nothing changes.
std::map<std::uint32_t, std::pair<std::uint64_t, std::uint64_t>> slow_places(
    const TriangleMesh& mesh, const std::vector<Finding>& pairs) {
  std::map<std::uint32_t, std::uint32_t> label;
  for (const Finding& d : pairs)
    for (const std::uint32_t f : d.place.faces) label[f] = f;
  std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
  for (const Finding& d : pairs) joined.insert({d.place.faces[0], d.place.faces[1]});
  const auto are_joined = [&](std::uint32_t f, std::uint32_t g) {
    for (const std::uint32_t v : mesh.faces[f])
      for (const std::uint32_t w : mesh.faces[g])
        if (v == w) return true;
    return joined.contains(std::minmax(f, g));
  };
  for (bool changes = true; changes;) {
    changes = false;
    for (auto& [f, l] : label)
      for (auto& [g, m] : label)
        if (m < l && are_joined(f, g)) l = m, changes = true;
  }
  std::map<std::uint32_t, std::pair<std::uint64_t, std::uint64_t>> out;
  for (const auto& [f, l] : label) ++out[l].second;
  for (const Finding& d : pairs) ++out[label[d.place.faces[0]]].first;
  return out;
}

std::vector<Finding> improper(const ListedReport& r) {
  std::vector<Finding> out;
  for (const Finding& d : r.defects)
    if (rule_of(d) == MeshRule::kM7) out.push_back(d);
  return out;
}

void expect_places(const TriangleMesh& mesh) {
  const ListedReport one = decide(mesh, 1, 100'000), many = decide(mesh, 4, 1);
  const auto pairs = improper(one);
  ASSERT_EQ(pairs.size(), one.counts.selfint_pairs);
  const auto expected = slow_places(mesh, pairs);
  ASSERT_EQ(one.places.size(), expected.size());
  ASSERT_EQ(many.places.size(), expected.size());
  std::size_t i = 0;
  for (const auto& [first, counts] : expected) {
    for (const ImproperPlace& p : {one.places[i], many.places[i]}) {
      EXPECT_EQ(p.first_face, first);
      EXPECT_EQ(p.pairs, counts.first);
      EXPECT_EQ(p.faces, counts.second);
    }
    EXPECT_EQ(one.places[i].box.lo, many.places[i].box.lo);
    EXPECT_EQ(one.places[i].box.hi, many.places[i].box.hi);
    ++i;
  }
  for (const Finding& d : pairs)
    EXPECT_TRUE(std::any_of(one.places.begin(), one.places.end(), [&](const ImproperPlace& p) {
      return contains(p.box, *d.witness.point);
    }));
}

TEST(ImproperPlaces, AreTheClustersOfTheirDefinitionWhateverTheThreads) {
  Random random(17);
  for (int i = 0; i < 8; ++i) {
    SCOPED_TRACE(i);
    const int n = 5 + static_cast<int>(random.below(25));
    expect_places(shapes::grid_soup(random, n, 3 + static_cast<int>(random.below(12))));
    expect_places(shapes::random_indexed(random, n, 2 * n, 20));
    expect_places(shapes::needle_soup(random, n));
  }
}

TEST(ImproperPlaces, TwoCrossingsOfTwoBoxesAreTwoPlaces) {
  // Far from each other, each pair of boxes crosses in a ring of faces.
  const auto pair_at = [](double x) {
    return shapes::joined(shapes::box({x, 0, 0}, {x + 2, 2, 2}),
                          shapes::box({x + 1, 1, 1}, {x + 3, 3, 3}));
  };
  const TriangleMesh mesh = shapes::joined(pair_at(0), pair_at(100));
  expect_places(mesh);
  const ListedReport r = decide(mesh);
  ASSERT_EQ(r.places.size(), 2u);
  EXPECT_EQ(r.places[0].pairs + r.places[1].pairs, r.counts.selfint_pairs);
  // The boxes meet between 1 and 2.
  EXPECT_GE(r.places[0].box.lo[0], 0);
  EXPECT_LE(r.places[0].box.hi[0], 3);
  EXPECT_GE(r.places[1].box.lo[0], 100);
}

TEST(ImproperPlaces, ASoundMeshHasNone) { EXPECT_TRUE(decide(shapes::saddle()).places.empty()); }

}  // namespace
}  // namespace veritope
