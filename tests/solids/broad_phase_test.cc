// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/broad_phase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

#include "solids/polyhedron/broad_phase_internal.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

constexpr std::uint64_t kNoLimit = ~std::uint64_t{0} >> 1;

std::vector<std::uint32_t> all_facets(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> out(mesh.faces.size());
  std::iota(out.begin(), out.end(), 0u);
  return out;
}

// Stars as the broad phase sees them: ids to mask out. Any choice must work.
VertexStars marked(const TriangleMesh& mesh, Random& random, unsigned one_in) {
  VertexStars stars;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) stars.code.push_back(one_in != 0 && random.below(one_in) == 0 ? 1 : 0);
  return stars;
}

struct Box {
  std::array<double, 3> lo, hi;
};

// Boxes of the facets, of the coordinates themselves or after the monotone map.
std::vector<Box> boxes_of(const TriangleMesh& mesh, const UnitScale* scale) {
  std::vector<Box> out;
  for (const auto& f : mesh.faces) {
    Box b{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (std::uint32_t v : f) {
      const Vec3d& p = mesh.positions[v];
      const std::array<double, 3> c = scale == nullptr ? std::array<double, 3>{p.x, p.y, p.z}
                                                       : std::array<double, 3>{scale->x(p.x), scale->y(p.y), scale->z(p.z)};
      for (std::size_t k = 0; k < 3; ++k) {
        b.lo[k] = std::min(b.lo[k], c[k]);
        b.hi[k] = std::max(b.hi[k], c[k]);
      }
    }
    out.push_back(b);
  }
  return out;
}

bool overlap(const Box& a, const Box& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.lo[k] > b.hi[k] || b.lo[k] > a.hi[k]) return false;
  return true;
}

std::vector<FacetPair> brute_pairs(const TriangleMesh& mesh, const std::vector<std::uint32_t>& facets, const VertexStars& stars,
                                   const UnitScale* scale) {
  const auto boxes = boxes_of(mesh, scale);
  std::vector<FacetPair> out;
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (std::size_t j = i + 1; j < facets.size(); ++j) {
      const std::uint32_t f = std::min(facets[i], facets[j]), g = std::max(facets[i], facets[j]);
      bool settled = false;
      for (std::uint32_t v : mesh.faces[f])
        for (std::uint32_t w : mesh.faces[g]) settled = settled || (v == w && stars[v]);
      if (!settled && overlap(boxes[f], boxes[g])) out.emplace_back(f, g);
    }
  std::sort(out.begin(), out.end());
  return out;
}

struct Found {
  std::vector<FacetPair> pairs;              // least facet first, sorted
  std::vector<std::vector<FacetPair>> tasks;  // as they came
  bool complete = false;
};

Found walk(const BoxGroups& groups, std::uint64_t budget, unsigned jobs) {
  Found out;
  out.tasks.resize(groups.num_tasks());
  out.complete = groups.for_each_overlap(budget, jobs, [&](std::size_t task, std::span<const FacetPair> pairs) {
    out.tasks[task].insert(out.tasks[task].end(), pairs.begin(), pairs.end());
  });
  for (const auto& task : out.tasks)
    for (const auto& [f, g] : task) out.pairs.emplace_back(std::minmax(f, g));
  std::sort(out.pairs.begin(), out.pairs.end());
  return out;
}

// All pairs, each once; exactly those whose mapped boxes overlap, among them all whose boxes do. With both instruction sets.
void expect_complete(const TriangleMesh& mesh, const std::vector<std::uint32_t>& facets, const VertexStars& stars) {
  const UnitScale scale(bounding_box(mesh.positions, 1));
  const auto want = brute_pairs(mesh, facets, stars, &scale), least = brute_pairs(mesh, facets, stars, nullptr);
  EXPECT_TRUE(std::includes(want.begin(), want.end(), least.begin(), least.end()));
  std::vector<std::vector<FacetPair>> tasks;
  for (const bool baseline : {false, true}) {
    internal::use_baseline_boxes(baseline);
    for (unsigned jobs : {1u, 2u, 5u}) {
      const BoxGroups groups(mesh, morton_order(mesh, facets, scale, jobs), stars, scale, jobs);
      const Found found = walk(groups, kNoLimit, jobs);
      EXPECT_TRUE(found.complete);
      EXPECT_EQ(found.pairs == want, true) << (baseline ? "baseline" : "fastest") << ", " << found.pairs.size() << " pairs, want "
                                           << want.size() << " of " << shapes::to_text(mesh);
      if (tasks.empty()) tasks = found.tasks;
      EXPECT_EQ(tasks == found.tasks, true) << "which task finds a pair depends on jobs or instructions";
    }
  }
  internal::use_baseline_boxes(false);
}

TEST(BroadPhase, FindsTheOneOverlapOfTwo) {
  const TriangleMesh mesh = shapes::parse("tri 0,0,0 2,0,0 0,2,0 ; tri 1,1,0 3,1,0 1,3,1");
  expect_complete(mesh, {0, 1}, {{0, 0, 0, 0, 0, 0}, {}});
  const BoxGroups groups(mesh, {0, 1}, {{0, 0, 0, 0, 0, 0}, {}}, UnitScale(bounding_box(mesh.positions, 1)), 1);
  EXPECT_EQ(walk(groups, kNoLimit, 1).pairs, (std::vector<FacetPair>{{0, 1}}));
}

TEST(BroadPhase, BoxesThatTouchOverlap) {
  const TriangleMesh mesh = shapes::parse("tri 0,0,0 1,0,0 0,1,0 ; tri 1,1,0 2,1,0 1,2,0");
  const BoxGroups groups(mesh, {0, 1}, {std::vector<std::uint8_t>(6), {}}, UnitScale(bounding_box(mesh.positions, 1)), 1);
  EXPECT_EQ(walk(groups, kNoLimit, 1).pairs.size(), 1u);
}

TEST(BroadPhase, LeavesOutPairsThatAStarSettlesAndNoOthers) {
  const TriangleMesh mesh = shapes::parse("tri 0,0,0 2,0,0 0,2,0 ; tri 0,0,0 2,2,0 0,2,1");
  for (std::uint32_t star = 0; star < 5; ++star) {
    VertexStars stars{std::vector<std::uint8_t>(5), {}};
    stars.code[star] = 1;
    const BoxGroups groups(mesh, {0, 1}, stars, UnitScale(bounding_box(mesh.positions, 1)), 1);
    EXPECT_EQ(walk(groups, kNoLimit, 1).pairs.size(), star == 0 ? 0u : 1u) << star;
  }
}

TEST(BroadPhase, OfNothingAndOfOneFacetIsEmpty) {
  const TriangleMesh mesh = shapes::parse("tri 0,0,0 2,0,0 0,2,0");
  for (const std::vector<std::uint32_t>& facets : {std::vector<std::uint32_t>{}, std::vector<std::uint32_t>{0}}) {
    const BoxGroups groups(mesh, facets, {std::vector<std::uint8_t>(3), {}}, UnitScale(bounding_box(mesh.positions, 1)), 1);
    const Found found = walk(groups, kNoLimit, 2);
    EXPECT_TRUE(found.complete);
    EXPECT_TRUE(found.pairs.empty());
  }
}

TEST(BroadPhaseLaw, FindsEveryOverlapOfEverySmallNumberOfFacets) {
  for (int n = 1; n <= 75; ++n) {  // groups of eight, one to three levels, with every remainder
    Random random(static_cast<std::uint64_t>(n));
    const TriangleMesh mesh = shapes::grid_soup(random, n, 6);
    expect_complete(mesh, all_facets(mesh), marked(mesh, random, 3));
  }
}

TEST(BroadPhaseLaw, FindsEveryOverlapOfScenesOfManyKinds) {
  Random random(7);
  const auto check = [&](const TriangleMesh& mesh, const char* what) {
    SCOPED_TRACE(what);
    for (unsigned one_in : {0u, 1u, 4u}) expect_complete(mesh, all_facets(mesh), marked(mesh, random, one_in));
    std::vector<std::uint32_t> some;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
      if (random.below(3) != 0) some.push_back(f);
    expect_complete(mesh, some, marked(mesh, random, 5));
  };
  check(shapes::torus(30, 20, 3, 1), "torus");
  check(shapes::needle_soup(random, 300), "needles");
  check(shapes::grid_soup(random, 600, 40), "soup");
  check(shapes::grid_soup(random, 400, 2), "everything overlaps");
  check(shapes::tilted_cylinder(300, shapes::Cap::kZigzag), "cylinder");
  check(shapes::scaled(shapes::torus(12, 12, 3, 1), 1020), "huge");
  check(shapes::scaled(shapes::torus(12, 12, 3, 1), -1066), "subnormal");
  check(shapes::joined(shapes::scaled(shapes::torus(9, 9, 3, 1), 1020), shapes::scaled(shapes::torus(9, 9, 3, 1), -1060)), "mixed scales");
  check(shapes::parse("tri 0,0,0 0,0,0 0,0,0 ; tri 1e308,1e308,1e308 -1e308,-1e308,-1e308 5e-324,0,0 ; tri 5e-324,5e-324,5e-324 0,0,0 "
                      "1e-320,0,0"),
        "extremes");
  TriangleMesh same = shapes::parse("tri 7,7,7 7,7,7 7,7,7");
  same.faces.resize(100, same.faces[0]);
  check(same, "one point");
}

TEST(BroadPhaseLaw, AgreesOverSeveralChunksOfThreads) {
  Random random(3);
  const TriangleMesh mesh = shapes::torus(140, 100, 30, 12);
  const UnitScale scale(bounding_box(mesh.positions, 1));
  const VertexStars stars = marked(mesh, random, 2);
  std::vector<std::vector<FacetPair>> tasks;
  for (const bool baseline : {false, true}) {
    internal::use_baseline_boxes(baseline);
    for (unsigned jobs : {1u, 3u}) {
      const BoxGroups groups(mesh, morton_order(mesh, all_facets(mesh), scale, jobs), stars, scale, jobs);
      const Found found = walk(groups, kNoLimit, jobs);
      ASSERT_TRUE(found.complete);
      if (tasks.empty()) tasks = found.tasks;
      EXPECT_EQ(tasks == found.tasks, true);
    }
  }
  internal::use_baseline_boxes(false);
}

TEST(BroadPhase, BudgetDecidesAloneWhetherTheWalkIsComplete) {
  Random random(1);
  const TriangleMesh mesh = shapes::needle_soup(random, 700);
  const UnitScale scale(bounding_box(mesh.positions, 1));
  const BoxGroups groups(mesh, morton_order(mesh, all_facets(mesh), scale, 1), marked(mesh, random, 0), scale, 1);
  std::uint64_t low = 0, high = 1 << 24;  // incomplete at low, complete at high
  ASSERT_FALSE(walk(groups, low, 1).complete);
  ASSERT_TRUE(walk(groups, high, 1).complete);
  while (high - low > 1) {
    const std::uint64_t mid = (low + high) / 2;
    (walk(groups, mid, 1).complete ? high : low) = mid;
  }
  EXPECT_GE(high, 8 * walk(groups, high, 1).pairs.size());
  for (const bool baseline : {false, true}) {
    internal::use_baseline_boxes(baseline);
    for (unsigned jobs : {1u, 2u, 4u})
      for (int i = 0; i < 3; ++i) {
        EXPECT_FALSE(walk(groups, low, jobs).complete);
        EXPECT_TRUE(walk(groups, high, jobs).complete);
      }
  }
  internal::use_baseline_boxes(false);
  // Giving up early is cheap.
  EXPECT_LT(walk(groups, 1000, 1).pairs.size(), 2000u);
}

TEST(BroadPhase, StabbedAreTheBoxesOnTheWayInAscendingPosition) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(30)); ++seed) {
    Random random(seed);
    const TriangleMesh mesh = seed % 2 == 0 ? shapes::grid_soup(random, static_cast<int>(1 + random.below(300)), 8)
                                            : shapes::needle_soup(random, static_cast<int>(1 + random.below(300)));
    const UnitScale scale(bounding_box(mesh.positions, 1));
    const auto order = morton_order(mesh, all_facets(mesh), scale, 1);
    const BoxGroups groups(mesh, order, marked(mesh, random, 0), scale, 1);
    const auto boxes = boxes_of(mesh, nullptr), mapped = boxes_of(mesh, &scale);
    for (int i = 0; i < 20; ++i) {
      const Vec3d from = mesh.positions[random.below(mesh.positions.size())];
      const auto axis = static_cast<std::size_t>(random.below(3));
      const bool positive = random.below(2) == 0;
      const auto meets = [&](const Box& b, const std::array<double, 3>& p) {
        for (std::size_t k = 0; k < 3; ++k) {
          if ((k != axis || positive) && b.hi[k] < p[k]) return false;
          if ((k != axis || !positive) && b.lo[k] > p[k]) return false;
        }
        return true;
      };
      std::vector<std::uint32_t> got, want, least;
      EXPECT_TRUE(groups.stabbed(from, static_cast<int>(axis), positive, mesh.faces.size(), got));
      for (std::uint32_t f : order) {
        if (meets(mapped[f], {scale.x(from.x), scale.y(from.y), scale.z(from.z)})) want.push_back(f);
        if (meets(boxes[f], {from.x, from.y, from.z})) least.push_back(f);
      }
      EXPECT_EQ(got, want) << "seed " << seed;
      for (std::size_t most : {want.size() + 1, want.size(), want.size() - 1, want.size() / 2}) {
        std::vector<std::uint32_t> some;
        EXPECT_EQ(groups.stabbed(from, static_cast<int>(axis), positive, most, some), want.size() <= most) << "seed " << seed;
        EXPECT_EQ(some.size(), std::min(most, want.size())) << "seed " << seed;
      }
      for (std::uint32_t f : least) EXPECT_NE(std::find(got.begin(), got.end(), f), got.end()) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace veritope
