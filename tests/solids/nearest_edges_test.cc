// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/nearest_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "tests/predicates/test_scale.h"
#include "tests/solids/edge_gap_oracle.h"

namespace veritope {
namespace {

using Edges = std::vector<EdgeEnds>;

std::string text(const Edges& edges) {
  std::string out;
  for (const EdgeEnds& e : edges) out += oracle::text(e) + ",\n";
  return out;
}

// Questions about pairs, answered by the library or by the oracle.
struct LibraryGaps {
  const Edges& edges;
  bool along(std::size_t i, std::size_t j) const { return run_along(edges[i], edges[j]); }
  Rational squared(std::size_t i, std::size_t j) const { return squared_gap(edges[i], edges[j]); }
};
struct OracleGaps {
  const Edges& edges;
  bool along(std::size_t i, std::size_t j) const {
    return oracle::run_along(oracle::rational(edges[i]), oracle::rational(edges[j]));
  }
  Rational squared(std::size_t i, std::size_t j) const {
    return oracle::squared_gap(oracle::rational(edges[i]), oracle::rational(edges[j]));
  }
};

// The least gap, and its edge, of all pairs.
template <typename Gaps>
std::optional<std::pair<Rational, std::uint32_t>> brute_nearest(const Edges& edges, std::size_t i,
                                                                const Gaps& gaps) {
  std::optional<std::pair<Rational, std::uint32_t>> best;
  for (std::uint32_t j = 0; j < edges.size(); ++j) {
    if (j == i || !gaps.along(i, j)) continue;
    std::pair<Rational, std::uint32_t> other{gaps.squared(i, j), j};
    if (other.first <= squared_length(edges[i]) && (!best || other < *best))
      best = std::move(other);
  }
  return best;
}

// What `n` says about its own edge and about i.
void expect_truth(const Edges& edges, std::size_t i, const NearestEdge& n,
                  const Rational& squared) {
  EXPECT_EQ(n.is_touching, squared == Rational(0));
  EXPECT_EQ(n.is_near, Rational(kNearPart * kNearPart) * squared <= squared_length(edges[i]));
  const Rational lo = Rational::from_double(n.gap.lo());
  EXPECT_GE(n.gap.lo(), 0);
  EXPECT_LE(lo * lo, squared);
  if (std::isfinite(n.gap.hi())) {
    const Rational hi = Rational::from_double(n.gap.hi());
    EXPECT_GE(hi * hi, squared);
    if (n.gap.lo() > 0x1p-900) {
      EXPECT_LE(n.gap.hi() - n.gap.lo(), 0x1p-40 * n.gap.lo());
    }
  }
}

template <typename Gaps>
void expect_as_brute_force(const Edges& edges, const Gaps& gaps) {
  constexpr std::uint32_t kNoLimit = 1 << 30;  // exact answers count much
  const auto nearest = find_nearest_edges(edges, 1, kNoLimit);
  ASSERT_EQ(nearest.size(), edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    SCOPED_TRACE("edge " + std::to_string(i));
    const auto want = brute_nearest(edges, i, gaps);
    EXPECT_TRUE(nearest[i].is_searched);
    ASSERT_EQ(nearest[i].edge, want ? want->second : NearestEdge::kNone) << text(edges);
    if (want) expect_truth(edges, i, nearest[i], want->first);
    EXPECT_TRUE(want || !(nearest[i].is_near || nearest[i].is_touching));
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << text(edges);
      return;
    }
  }
}

Edges random_edges(Random& random, std::size_t n, int kind) {
  Edges out;
  while (out.size() < n) out.push_back(oracle::random_edge(random, kind));
  return out;
}

// Short edges and, beside many of them, others that are moved by little.
Edges random_cracks(Random& random, std::size_t n, double gap) {
  const auto near = [&](Vec3d p, double by) {
    const Vec3d d = oracle::random_point(random, 1);
    return Vec3d{p.x + by * d.x, p.y + by * d.y, p.z + by * d.z};
  };
  Edges out;
  while (out.size() < n) {
    if (out.empty() || random.below(2) == 0) {
      const Vec3d p = oracle::random_point(random, 1);
      out.push_back({p, near(p, 0.3)});
    } else {
      const EdgeEnds& e = out[random.below(out.size())];
      EdgeEnds f{near(e.a, gap), near(e.b, gap)};
      if (random.below(4) == 0)
        f.b = near({(f.a.x + f.b.x) / 2, (f.a.y + f.b.y) / 2, (f.a.z + f.b.z) / 2}, gap);
      if (random.below(8) == 0) f = {e.b, e.a};
      out.push_back(f);
    }
  }
  return out;
}

TEST(NearestEdges, AreThoseOfTheDefinitionByRationals) {
  for (int kind = 0; kind < oracle::kNumEdgeKinds; ++kind)
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(4)); ++seed) {
      SCOPED_TRACE("kind " + std::to_string(kind) + " seed " + std::to_string(seed));
      Random random(seed);
      const Edges edges = random_edges(random, 1 + random.below(25), kind);
      expect_as_brute_force(edges, OracleGaps{edges});
    }
}

TEST(NearestEdges, AreThoseOfAllPairsWhereTheTreeIsDeep) {
  for (int kind = 0; kind < oracle::kNumEdgeKinds; ++kind)
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(1)); ++seed) {
      SCOPED_TRACE("kind " + std::to_string(kind) + " seed " + std::to_string(seed));
      Random random(seed);
      const Edges edges = random_edges(random, 100 + random.below(40), kind);
      expect_as_brute_force(edges, LibraryGaps{edges});
    }
}

TEST(NearestEdges, AreThoseOfAllPairsAlongCracks) {
  for (const double gap : {0x1p-52, 1e-12, 1e-6, 1e-3, 0.02, 0.1})
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(1)); ++seed) {
      SCOPED_TRACE("gap " + std::to_string(gap) + " seed " + std::to_string(seed));
      Random random(seed);
      const Edges edges = random_cracks(random, 200, gap);
      expect_as_brute_force(edges, LibraryGaps{edges});
    }
}

TEST(NearestEdges, OfCoincidingEdgesAreTheLeastOthers) {
  const EdgeEnds e{{0, 0, 0}, {1, 2, 3}}, back{{1, 2, 3}, {0, 0, 0}},
      half{{0, 0, 0}, {0.5, 1, 1.5}};
  const Edges edges{{{5, 5, 5}, {6, 5, 5}}, half, e, back, e, half, {{7, 7, 7}, {7, 7, 7}},
                    {{7, 7, 7}, {7, 7, 7}}};
  const auto n = find_nearest_edges(edges, 1);
  EXPECT_EQ(n[0].edge, NearestEdge::kNone);
  EXPECT_EQ(n[1].edge, 2u);
  for (const std::size_t i : {2, 3, 4, 5}) EXPECT_EQ(n[i].edge, 1u) << i;
  for (const std::size_t i : {1, 2, 3, 4, 5}) EXPECT_TRUE(n[i].is_near && n[i].is_touching) << i;
  for (const std::size_t i : {6, 7}) EXPECT_EQ(n[i].edge, NearestEdge::kNone) << "no length";
}

// Were coinciding edges compared with each other, this would take minutes.
TEST(NearestEdges, AreFoundWhereAllEdgesCoincide) {
  Random random(1);
  const Edges segments = random_edges(random, 3, 1);
  Edges edges;
  for (std::size_t i = 0; i < 100'000; ++i) edges.push_back(segments[i % 3]);
  const auto n = find_nearest_edges(edges, 2);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    ASSERT_EQ(n[i].edge, i < 3 ? i + 3 : i % 3);
    ASSERT_TRUE(n[i].is_touching && n[i].is_searched);
  }
}

void expect_same(const NearestEdge& a, const NearestEdge& b) {
  EXPECT_EQ(a.is_near, b.is_near);
  EXPECT_EQ(a.is_touching, b.is_touching);
  EXPECT_EQ(a.is_searched, b.is_searched);
}

TEST(NearestEdges, DoNotDependOnTheNumberOfThreads) {
  Random random(2);
  Edges edges = random_edges(random, 3000, 0);  // many coincide, and many gaps are equal
  const Edges cracks = random_cracks(random, 3000, 1e-5);
  edges.insert(edges.end(), cracks.begin(), cracks.end());
  const auto one = find_nearest_edges(edges, 1), many = find_nearest_edges(edges, 4);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    ASSERT_EQ(one[i].edge, many[i].edge) << i;
    expect_same(one[i], many[i]);
    EXPECT_EQ(one[i].gap, many[i].gap);
  }
}

TEST(NearestEdges, DependOnTheOrderOfTheEdgesInTiesOnly) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(4)); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Edges edges =
        seed % 2 == 0 ? random_edges(random, 300, 0) : random_cracks(random, 1000, 1e-4);
    std::vector<std::uint32_t> order(edges.size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    Edges moved;
    for (const std::uint32_t i : order) moved.push_back(edges[i]);
    const auto before = find_nearest_edges(edges, 1), after = find_nearest_edges(moved, 1);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const NearestEdge &b = before[order[i]], &a = after[i];
      ASSERT_EQ(b.edge == NearestEdge::kNone, a.edge == NearestEdge::kNone) << i;
      if (a.edge == NearestEdge::kNone) continue;
      expect_same(a, b);
      if (order[a.edge] == b.edge) {
        EXPECT_EQ(a.gap, b.gap);
      } else {
        ASSERT_EQ(squared_gap(moved[i], moved[a.edge]), squared_gap(moved[i], edges[b.edge])) << i;
      }
    }
  }
}

TEST(NearestEdges, OfASearchThatIsGivenUpAreTrueNevertheless) {
  Random random(5);
  const Edges edges = random_cracks(random, 2000, 0.01);
  const auto whole = find_nearest_edges(edges, 1), part = find_nearest_edges(edges, 1, 12);
  std::size_t unsearched = 0, near = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_TRUE(whole[i].is_searched);
    unsearched += !part[i].is_searched;
    if (part[i].edge == NearestEdge::kNone) continue;
    near += part[i].is_near;
    ASSERT_TRUE(run_along(edges[i], edges[part[i].edge]));
    expect_truth(edges, i, part[i], squared_gap(edges[i], edges[part[i].edge]));
    EXPECT_GE(part[i].gap.hi(), whole[i].gap.lo());
  }
  EXPECT_GT(unsearched, 100u);
  EXPECT_GT(near, 100u);
}

TEST(NearestEdges, AreNearWhereManyEdgesDifferInTheirLastBits) {
  Random random(6);
  const auto c = [&](double v) {
    return v * (1 + 0x1p-52 * static_cast<double>(random.between(0, 8)));
  };
  Edges edges;
  for (int i = 0; i < 2000; ++i) edges.push_back({{c(1), c(1), c(1)}, {c(2), c(3), c(5)}});
  for (const NearestEdge& n : find_nearest_edges(edges, 2)) {
    ASSERT_TRUE(n.is_near);
    ASSERT_LE(n.gap.hi(), 0x1p-48);
  }
}

TEST(NearestEdges, AreWithinTheLengthOfTheEdge) {
  const Edges edges{
      {{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 0}}, {{0, 2 + 0x1p-51, 0}, {1, 2 + 0x1p-51, 0}}};
  const auto n = find_nearest_edges(edges, 1);
  EXPECT_EQ(n[0].edge, 1u) << "a gap as large as the length";
  EXPECT_EQ(n[1].edge, 0u);
  EXPECT_EQ(n[2].edge, NearestEdge::kNone) << "a gap that is larger by its last bit";
  EXPECT_FALSE(n[0].is_near);
}

TEST(NearestEdges, AreNearUpToASixteenthExactly) {
  for (const double more : {0.0, 0x1p-56}) {
    const Edges edges{{{0, 0, 0}, {1, 0, 0}}, {{0, 0x1p-4 + more, 0}, {1, 0x1p-4 + more, 0}}};
    EXPECT_EQ(find_nearest_edges(edges, 1)[0].is_near, more == 0) << more;
  }
}

}  // namespace
}  // namespace veritope
