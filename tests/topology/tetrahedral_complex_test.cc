// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/topology/tetrahedral_complex_test.cc: complexes of tetrahedra against their definitions, on random complexes,
// and grids whose topology is known.
#include "topology/tetrahedral_complex.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "robust/base/check.h"
#include "robust/base/random.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using Tetrahedra = std::vector<TetrahedronCorners>;

std::string text(const Tetrahedra& tetrahedra) {
  std::string out;
  for (const auto& t : tetrahedra)
    out += "{" + std::to_string(t[0]) + "," + std::to_string(t[1]) + "," + std::to_string(t[2]) +
           "," + std::to_string(t[3]) + "}, ";
  return out;
}

// Kuhn's six tetrahedra in each cube of a grid that `keep` wants, all of one orientation.
template <typename Keep>
Tetrahedra kuhn_grid(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz, Keep keep) {
  Tetrahedra out;
  const auto id = [&](const std::array<std::uint32_t, 3>& at) {
    return (at[0] * (ny + 1) + at[1]) * (nz + 1) + at[2];
  };
  constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (std::uint32_t x = 0; x < nx; ++x)
    for (std::uint32_t y = 0; y < ny; ++y)
      for (std::uint32_t z = 0; z < nz; ++z) {
        if (!keep(x, y, z)) continue;
        for (const auto& order : kOrders) {
          std::array<std::uint32_t, 3> at{x, y, z};
          TetrahedronCorners t{id(at)};
          for (std::size_t i = 0; i < 3; ++i) ++at[order[i]], t[i + 1] = id(at);
          const bool is_odd = order == kOrders[1] || order == kOrders[2] || order == kOrders[5];
          if (is_odd) std::swap(t[2], t[3]);
          out.push_back(t);
        }
      }
  return out;
}
Tetrahedra kuhn_grid(std::uint32_t n) {
  return kuhn_grid(n, n, n, [](auto...) { return true; });
}

bool is_even_permutation(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::vector<std::uint32_t> rest = a;
  bool even = true;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const auto at =
        static_cast<std::size_t>(std::find(rest.begin(), rest.end(), b[i]) - rest.begin());
    if (at != i) std::swap(rest[i], rest[at]), even = !even;
  }
  return even;
}

void expect_as_defined(const Tetrahedra& tetrahedra, std::uint32_t num_vertices) {
  SCOPED_TRACE(text(tetrahedra));
  const TetrahedralComplex complex(tetrahedra, num_vertices);
  std::map<std::set<std::uint32_t>, std::vector<TetrahedronFace>> faces;
  std::set<std::set<std::uint32_t>> edges, vertices;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
    for (std::uint32_t m = 0; m < 4; ++m) {
      std::set<std::uint32_t> others(tetrahedra[t].begin(), tetrahedra[t].end());
      others.erase(tetrahedra[t][m]);
      const auto of_face = complex.vertices(4 * t + m);
      EXPECT_EQ(std::set<std::uint32_t>(of_face.begin(), of_face.end()), others);
      // The face is seen from outside: with the opposite corner first, it is an even permutation of the corners.
      EXPECT_TRUE(is_even_permutation({tetrahedra[t][m], of_face[0], of_face[1], of_face[2]},
                                      {tetrahedra[t].begin(), tetrahedra[t].end()}));
      faces[others].push_back(4 * t + m);
      vertices.insert({tetrahedra[t][m]});
      for (std::uint32_t n = 0; n < m; ++n) edges.insert({tetrahedra[t][m], tetrahedra[t][n]});
    }
  std::vector<TetrahedronFace> boundary;
  std::size_t num_overused = 0;
  for (const auto& [set, uses] : faces) {
    const auto of = [&](TetrahedronFace f) {
      const auto v = complex.vertices(f);
      return std::vector<std::uint32_t>(v.begin(), v.end());
    };
    const bool is_pair = uses.size() == 2 && !is_even_permutation(of(uses[0]), of(uses[1]));
    if (uses.size() == 1) boundary.push_back(uses[0]);
    if (is_pair) {
      EXPECT_EQ(complex.partner(uses[0]), uses[1]);
      EXPECT_EQ(complex.partner(uses[1]), uses[0]);
    } else {
      for (const TetrahedronFace f : uses) EXPECT_FALSE(complex.partner(f).has_value());
      if (uses.size() == 1) continue;
      ASSERT_LT(num_overused, complex.overused().size());
      const FaceOveruse& over = complex.overused()[num_overused++];
      EXPECT_EQ(std::vector<std::uint32_t>(over.vertices.begin(), over.vertices.end()),
                std::vector<std::uint32_t>(set.begin(), set.end()));
      EXPECT_EQ(over.faces, uses);
    }
  }
  EXPECT_EQ(num_overused, complex.overused().size());
  std::sort(boundary.begin(), boundary.end());
  EXPECT_EQ(complex.boundary(), boundary);
  EXPECT_EQ(complex.counts(), (std::array<std::uint64_t, 4>{vertices.size(), edges.size(),
                                                            faces.size(), tetrahedra.size()}));
  for (std::uint32_t v = 0; v < num_vertices; ++v) {
    std::vector<std::uint32_t> at;
    for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
      if (std::count(tetrahedra[t].begin(), tetrahedra[t].end(), v) > 0) at.push_back(t);
    const auto got = complex.tetrahedra_at(v);
    EXPECT_EQ(std::vector<std::uint32_t>(got.begin(), got.end()), at);
    const auto link = complex.link(v);
    ASSERT_EQ(link.size(), at.size());
    for (std::size_t i = 0; i < at.size(); ++i)
      EXPECT_TRUE(is_even_permutation({v, link[i][0], link[i][1], link[i][2]},
                                      {tetrahedra[at[i]].begin(), tetrahedra[at[i]].end()}));
  }
  for (const auto& edge : edges) {
    const std::uint32_t a = *edge.begin(), b = *edge.rbegin();
    std::vector<std::uint32_t> at;
    for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
      if (std::count(tetrahedra[t].begin(), tetrahedra[t].end(), a) +
              std::count(tetrahedra[t].begin(), tetrahedra[t].end(), b) ==
          2)
        at.push_back(t);
    EXPECT_EQ(complex.tetrahedra_at(a, b), at);
    const auto link = complex.link(a, b);
    ASSERT_EQ(link.size(), at.size());
    for (std::size_t i = 0; i < at.size(); ++i)
      EXPECT_TRUE(is_even_permutation({a, b, link[i][0], link[i][1]},
                                      {tetrahedra[at[i]].begin(), tetrahedra[at[i]].end()}));
  }
}

TEST(TetrahedralComplex, IsAsDefinedOnRandomTetrahedra) {
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(scaled(300)); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto num_vertices = static_cast<std::uint32_t>(random.between(4, 8));
    Tetrahedra tetrahedra;
    for (std::uint64_t i = 0, n = random.below(12); i < n; ++i) {
      std::vector<std::uint32_t> ids(num_vertices);
      for (std::uint32_t v = 0; v < num_vertices; ++v) ids[v] = v;
      std::shuffle(ids.begin(), ids.end(), random);
      tetrahedra.push_back({ids[0], ids[1], ids[2], ids[3]});
    }
    expect_as_defined(tetrahedra, num_vertices);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(TetrahedralComplex, OfAGridIsABall) {
  for (std::uint32_t n = 1; n <= 3; ++n) {
    const TetrahedralComplex complex(kuhn_grid(n), (n + 1) * (n + 1) * (n + 1));
    EXPECT_TRUE(complex.overused().empty());
    EXPECT_EQ(complex.boundary().size(), 12 * n * n);
    EXPECT_EQ(complex.euler(), 1);
    for (std::uint32_t v = 0; v < complex.num_vertices(); ++v) {
      const std::uint32_t x = v / ((n + 1) * (n + 1)), y = v / (n + 1) % (n + 1), z = v % (n + 1);
      const bool is_inner = x > 0 && x < n && y > 0 && y < n && z > 0 && z < n;
      EXPECT_EQ(classify_link(complex.link(v)), is_inner ? LinkKind::kClosed : LinkKind::kOpen);
    }
    EXPECT_EQ(classify_link(complex.link(0, complex.num_vertices() - 1)),
              n == 1 ? LinkKind::kClosed : LinkKind::kEmpty);
    EXPECT_EQ(classify_link(complex.link(0, 1)), LinkKind::kOpen);
  }
  expect_as_defined(kuhn_grid(2), 27);
}

TEST(TetrahedralComplex, OfARingIsATorus) {
  const auto ring = kuhn_grid(3, 3, 1, [](auto x, auto y, auto) { return x != 1 || y != 1; });
  const TetrahedralComplex complex(ring, 32);
  EXPECT_EQ(complex.euler(), 0);
  EXPECT_TRUE(complex.overused().empty());
  for (std::uint32_t v = 0; v < 32; ++v)
    EXPECT_EQ(classify_link(complex.link(v)), LinkKind::kOpen) << v;
}

TEST(TetrahedralComplex, FindsLinksThatAreNoManifolds) {
  // Two cubes that share an edge, and two that share a vertex.
  const auto at_edge = kuhn_grid(2, 2, 1, [](auto x, auto y, auto) { return x == y; });
  const TetrahedralComplex edge(at_edge, 18);
  EXPECT_EQ(classify_link(edge.link(8, 9)), LinkKind::kOther);
  EXPECT_EQ(classify_link(edge.link(8)), LinkKind::kOther);
  const auto at_vertex =
      kuhn_grid(2, 2, 2, [](auto x, auto y, auto z) { return x == y && y == z; });
  const TetrahedralComplex vertex(at_vertex, 27);
  EXPECT_EQ(classify_link(vertex.link(13)), LinkKind::kOther);
}

TEST(TetrahedralComplex, ClassifiesLinks) {
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  using Pairs = std::vector<std::array<std::uint32_t, 2>>;
  EXPECT_EQ(classify_link(Triangles{}), LinkKind::kEmpty);
  EXPECT_EQ(classify_link(Triangles{{5, 6, 9}}), LinkKind::kOpen);
  const Triangles sphere{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  EXPECT_EQ(classify_link(sphere), LinkKind::kClosed);
  Triangles two = sphere;
  for (const auto& t : sphere) two.push_back({t[0] + 10, t[1] + 10, t[2] + 10});
  EXPECT_EQ(classify_link(two), LinkKind::kOther);
  EXPECT_EQ(classify_link(Triangles{{0, 1, 2}, {0, 1, 3}}), LinkKind::kOther);  // misoriented
  // A torus of 7 vertices.
  Triangles torus;
  for (std::uint32_t i = 0; i < 7; ++i) {
    torus.push_back({i, (i + 1) % 7, (i + 3) % 7});
    torus.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  EXPECT_EQ(classify_link(torus), LinkKind::kOther);
  // An annulus.
  EXPECT_EQ(
      classify_link(Triangles{{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}}),
      LinkKind::kOther);
  EXPECT_EQ(classify_link(Pairs{}), LinkKind::kEmpty);
  EXPECT_EQ(classify_link(Pairs{{4, 7}}), LinkKind::kOpen);
  EXPECT_EQ(classify_link(Pairs{{4, 7}, {2, 4}}), LinkKind::kOpen);
  EXPECT_EQ(classify_link(Pairs{{4, 7}, {2, 4}, {7, 2}}), LinkKind::kClosed);
  EXPECT_EQ(classify_link(Pairs{{4, 7}, {2, 4}, {7, 9}, {9, 4}}), LinkKind::kOther);
  EXPECT_EQ(classify_link(Pairs{{0, 1}, {2, 3}}), LinkKind::kOther);
  EXPECT_EQ(classify_link(Pairs{{0, 1}, {1, 0}, {2, 3}, {3, 2}}), LinkKind::kOther);
}

TEST(TetrahedralComplex, ChecksItsArguments) {
  EXPECT_THROW(TetrahedralComplex({{0, 1, 2, 2}}, 3), InternalError);
  EXPECT_THROW(TetrahedralComplex({{0, 1, 2, 3}}, 3), InternalError);
  const TetrahedralComplex one({{0, 1, 2, 3}}, 5);
  EXPECT_THROW((void)one.partner(4), InternalError);
  EXPECT_THROW((void)one.tetrahedra_at(0, 0), InternalError);
  EXPECT_THROW((void)one.tetrahedra_at(0, 5), InternalError);
  EXPECT_TRUE(one.tetrahedra_at(4).empty());
}

}  // namespace
}  // namespace veritope
