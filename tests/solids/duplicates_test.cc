// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/duplicates.h"

#include <gtest/gtest.h>

#include "tests/predicates/test_scale.h"
#include "tests/support/brute_force.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

DuplicateFaces duplicates(const oracle::Faces& faces, std::size_t max_listed = 1000) {
  std::uint32_t n = 0;
  for (const auto& f : faces)
    for (std::uint32_t v : f) n = std::max(n, v + 1);
  const Incidence incidence = Incidence::build(faces, n, 1);
  return find_duplicate_faces(faces, analyse_surface(faces, incidence, 0, 1), max_listed);
}

TEST(DuplicateFaces, AreThoseWithTheSameVerticesInAnyOrder) {
  const DuplicateFaces d = duplicates({{0, 1, 2}, {3, 1, 2}, {2, 0, 1}, {2, 1, 0}});
  EXPECT_EQ(d.count, 2u);
  EXPECT_EQ(d.first, (Pairs{{0, 2}, {0, 3}}));
}

TEST(DuplicateFaces, OfAPillowAreFoundThoughEveryEdgeHasTwoFaces) {
  for (const oracle::Faces& faces : {oracle::Faces{{0, 1, 2}, {0, 2, 1}}, oracle::Faces{{0, 1, 2}, {0, 1, 2}},
                                     oracle::Faces{{9, 8, 7}, {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {7, 8, 9}}})
    EXPECT_EQ(duplicates(faces).count, 1u);
}

TEST(DuplicateFaces, CollapsedFacesAreNone) { EXPECT_EQ(duplicates({{0, 0, 1}, {0, 0, 1}, {2, 2, 2}, {2, 2, 2}}).count, 0u); }

TEST(DuplicateFacesLaw, AreAsDefinedOnRandomSoups) {
  std::size_t some = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(500)); ++seed) {
    Random random(seed);
    const auto faces = shapes::random_indexed(random, static_cast<int>(1 + random.below(30)), static_cast<int>(3 + random.below(7)), 2).faces;
    auto want = oracle::brute_topology(faces).duplicate_pairs;
    some += !want.empty();
    const std::size_t max_listed = random.below(5) == 0 ? random.below(4) : 1000;
    const DuplicateFaces got = duplicates(faces, max_listed);
    EXPECT_EQ(got.count, want.size()) << "seed " << seed;
    if (want.size() > max_listed) want.resize(max_listed);
    EXPECT_EQ(got.first, want) << "seed " << seed;
  }
  EXPECT_GT(some, 100u);
}

}  // namespace
}  // namespace veritope
