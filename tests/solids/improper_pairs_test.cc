// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/improper_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robust/base/random.h"
#include "solids/polyhedron/duplicates.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/brute_force.h"
#include "tests/support/shapes.h"
#include "topology/surface.h"

namespace veritope {
namespace {

// With `as_copies`, faces of equal vertices are one facet with a number of copies. The pairs are ordered.
ImproperPairs find_pairs(const TriangleMesh& mesh, std::size_t max_listed = 100000, unsigned jobs = 1,
                         bool as_copies = false) {
  const Incidence incidence = Incidence::build(mesh.faces, static_cast<std::uint32_t>(mesh.positions.size()), 1);
  const SurfaceTopology topology = analyse_surface(mesh.faces, incidence, 0, 1);
  const FacetSigns signs = facet_signs(mesh, 1);
  const VertexStars stars = find_vertex_stars(mesh, incidence, signs, topology.irregular, 1);
  std::vector<std::uint32_t> facets;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    if (signs.signs[f] != 0) facets.push_back(f);
  FaceCopies copies;
  if (as_copies) {
    auto groups = find_duplicate_faces(mesh.faces, topology, 0).groups;
    std::erase_if(groups, [&](const auto& g) { return signs.signs[g.front()] == 0; });
    copies = FaceCopies(std::move(groups));
    facets = copies.without_copies(facets);
  }
  const UnitScale scale(bounding_box(mesh.positions, 1));
  const BoxGroups boxes(mesh, morton_order(mesh, facets, scale, jobs), stars, scale, jobs);
  ImproperPairs found = find_improper_pairs(mesh, boxes, facets, stars, max_listed, jobs, copies);
  const bool may_wait = max_listed > 0 && copies.groups().empty() && found.count <= kMostUnordered;
  EXPECT_EQ(found.is_ordered, !may_wait);
  if (!found.is_ordered) found.pairs = largest_pairs(mesh, found.pairs, max_listed);
  return found;
}

std::string first_difference(std::vector<FacetPair> got, const std::vector<FacetPair>& want) {
  std::sort(got.begin(), got.end());
  for (const auto& p : got)
    if (!std::binary_search(want.begin(), want.end(), p)) return "not improper: " + std::to_string(p.first) + ", " + std::to_string(p.second);
  for (const auto& p : want)
    if (!std::binary_search(got.begin(), got.end(), p)) return "missed: " + std::to_string(p.first) + ", " + std::to_string(p.second);
  return "";
}

// The exact pairs; the count; the first of the list when cut; the same for every number of jobs.
ImproperPairs expect_exact(const TriangleMesh& mesh) {
  const auto want = oracle::brute_improper(mesh);
  const ImproperPairs got = find_pairs(mesh);
  EXPECT_EQ(got.count, want.size()) << shapes::to_text(mesh);
  EXPECT_EQ(first_difference(got.pairs, want), "") << shapes::to_text(mesh);
  for (unsigned jobs : {2u, 3u})
    for (std::size_t max_listed : {0u, 3u}) {
      const ImproperPairs some = find_pairs(mesh, max_listed, jobs);
      EXPECT_EQ(some.count, want.size());
      EXPECT_EQ(some.long_thin, got.long_thin);
      auto largest = got.pairs;
      if (largest.size() > max_listed) largest.resize(max_listed);
      EXPECT_EQ(some.pairs == largest, true);
    }
  return got;
}

TEST(ImproperPairs, OfNothingAreNone) {
  const ImproperPairs p = find_pairs(shapes::parse("v 0,0,0 1,1,1 2,2,2 ; f 0,1,2 0,0,1"));
  EXPECT_EQ(p.count, 0u);
  EXPECT_FALSE(p.long_thin);
}

TEST(ImproperPairs, EveryKindOfContact) {
  for (const auto& [text, count] : std::vector<std::pair<const char*, std::uint64_t>>{
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,-1 1,1,1 2,1,1", 1},        // crossing
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,0 1,1,1 2,1,1", 1},         // a corner on a facet
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 2,0,0 2,-1,0 3,-1,1", 1},       // a corner on an edge
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 2,-1,-1 2,1,1 2,-1,2", 1},      // edge through edge
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,0 2,1,0 1,2,0", 1},         // inside, in one plane
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 4,0,0 8,0,0 8,1,0", 0},         // a common vertex
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 0,0,0 1,1,0 1,1,1", 1},         // a common vertex and more
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 4,0,0 0,0,0 0,-4,0", 0},        // a common edge, flat
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 4,0,0 0,0,0 0,0,4", 0},         // a common edge, folded
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 0,0,0 4,0,0 1,1,0", 1},         // a common edge, folded over
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 4,0,0 0,0,0 0,4,0", 1},         // the same vertices
           {"v 0,0,0 4,0,0 0,4,0 0,0,0 -1,0,0 0,-1,1 ; f 0,1,2 3,4,5", 1},  // equal coordinates, two vertices
           {"tri 0,0,0 4,0,0 0,4,0 ; tri 0,0,1 4,0,1 0,4,1", 0}})
    EXPECT_EQ(expect_exact(shapes::parse(text)).count, count) << text;
}

// Faces that occur again, in any turn and either direction, count for every pair that they are in.
TEST(ImproperPairsLaw, OfCopiesAreThoseOfTheFacesOneByOne) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(60)); ++seed) {
    Random random(seed);
    TriangleMesh mesh = shapes::grid_soup(random, static_cast<int>(2 + random.below(8)), 3);
    const std::size_t before = mesh.faces.size();
    for (std::uint64_t k = random.below(20); k > 0; --k) {
      auto copy = mesh.faces[random.below(before)];
      std::rotate(copy.begin(), copy.begin() + static_cast<std::ptrdiff_t>(random.below(3)), copy.end());
      if (random.below(2) == 0) std::swap(copy[0], copy[1]);
      mesh.faces.push_back(copy);
    }
    const ImproperPairs each = expect_exact(mesh);
    for (const std::size_t max_listed : {std::size_t{0}, std::size_t{5}, std::size_t{100000}}) {
      const ImproperPairs got = find_pairs(mesh, max_listed, 2, true);
      EXPECT_EQ(got.count, each.count) << "seed " << seed << ": " << shapes::to_text(mesh);
      EXPECT_EQ(got.pairs.size(), std::min<std::size_t>(max_listed, each.pairs.size()))
          << "seed " << seed;
      if (got.pairs.size() == each.pairs.size()) {
        EXPECT_EQ(first_difference(got.pairs, oracle::brute_improper(mesh)), "") << "seed " << seed;
      }
      // Faces with the same vertices come last.
      const auto is_copy = [&](const FacetPair& p) {
        auto f = mesh.faces[p.first], g = mesh.faces[p.second];
        std::sort(f.begin(), f.end()), std::sort(g.begin(), g.end());
        return f == g;
      };
      EXPECT_TRUE(std::is_partitioned(got.pairs.begin(), got.pairs.end(),
                                      [&](const auto& p) { return !is_copy(p); }));
      ASSERT_EQ(got.places.size(), each.places.size()) << "seed " << seed;
      for (std::size_t i = 0; i < each.places.size(); ++i) {
        EXPECT_EQ(got.places[i].pairs, each.places[i].pairs) << "seed " << seed;
        EXPECT_EQ(got.places[i].faces, each.places[i].faces) << "seed " << seed;
        EXPECT_EQ(got.places[i].first_face, each.places[i].first_face) << "seed " << seed;
        EXPECT_TRUE(got.places[i].box == each.places[i].box) << "seed " << seed;
      }
    }
  }
}

TEST(ImproperPairsLaw, AreExactOnGridSoups) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(60)); ++seed) {
    Random random(seed);
    expect_exact(shapes::grid_soup(random, static_cast<int>(2 + random.below(25)), static_cast<int>(2 + random.below(3))));
    expect_exact(shapes::random_indexed(random, 12, 9, 3));  // equal coordinates under two ids
    if (HasFailure()) return;
  }
}

// Once there are too many pairs to keep, the search orders them; the list is the one that largest_pairs makes of all.
TEST(ImproperPairs, AreTheSameWhereverTheyAreOrdered) {
  Random random(1);
  const TriangleMesh mesh = shapes::grid_soup(random, 500, 4);
  const ImproperPairs all = find_pairs(mesh, 1000000);
  ASSERT_GT(all.count, kMostUnordered);
  ASSERT_EQ(all.pairs.size(), all.count);
  auto ascending = all.pairs;
  std::sort(ascending.begin(), ascending.end());
  for (const std::size_t max_listed : {1u, 20u, 20000u})
    for (const unsigned jobs : {1u, 3u})
      EXPECT_TRUE(find_pairs(mesh, max_listed, jobs).pairs ==
                  largest_pairs(mesh, ascending, max_listed))
          << max_listed << " of seed 1, " << jobs << " threads";
}

TEST(ImproperPairsLaw, BothWalksAreExact) {
  bool thin = false, ordinary = false;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(3)); ++seed) {
    Random random(seed);
    for (const TriangleMesh& mesh : {shapes::needle_soup(random, 70), shapes::needle_soup(random, 20), shapes::grid_soup(random, 60, 3),
                                     shapes::joined(shapes::needle_soup(random, 64), shapes::hyperboloid(12, 3))}) {
      const ImproperPairs p = expect_exact(mesh);
      (p.long_thin ? thin : ordinary) = true;
    }
    if (HasFailure()) return;
  }
  EXPECT_TRUE(thin);
  EXPECT_TRUE(ordinary);
}

TEST(ImproperPairsLaw, LongThinValidModelsHaveNone) {
  using shapes::Cap;
  for (const TriangleMesh& mesh : {shapes::tilted_cylinder(200, Cap::kCentreFan), shapes::tilted_cylinder(200, Cap::kRimFan),
                                   shapes::tilted_cylinder(200, Cap::kZigzag), shapes::hyperboloid(300, 90)}) {
    const ImproperPairs p = find_pairs(mesh);
    EXPECT_EQ(p.count, 0u);
    EXPECT_TRUE(p.long_thin) << mesh.faces.size();
  }
}

// A hyperboloid whose one ring was moved a little: hits appear in the middle of long thin facets.
TEST(ImproperPairsLaw, LongThinModelsThatCrossThemselvesAreExact) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    TriangleMesh mesh = shapes::hyperboloid(36, 11);
    for (int i = 0; i < 6; ++i) mesh.positions[2 * random.below(36)].x *= 0.6;
    EXPECT_TRUE(expect_exact(mesh).long_thin);
  }
}

}  // namespace
}  // namespace veritope
