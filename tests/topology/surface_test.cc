// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/surface.h"

#include <gtest/gtest.h>

#include <set>

#include "robust/base/check.h"
#include "robust/base/random.h"
#include "tests/support/brute_force.h"
#include "tests/support/shapes.h"
#include "topology/vertex_link.h"

namespace veritope {
namespace {

using oracle::BruteTopology;
using Faces = oracle::Faces;

std::string text(const Faces& faces) {
  std::string out;
  for (const auto& f : faces)
    out += "{" + std::to_string(f[0]) + "," + std::to_string(f[1]) + "," + std::to_string(f[2]) + "}, ";
  return out;
}

std::vector<std::uint32_t> list(std::span<const std::uint32_t> items) { return {items.begin(), items.end()}; }

std::uint32_t num_ids(const Faces& faces) {
  std::uint32_t n = 0;
  for (const auto& f : faces)
    for (std::uint32_t v : f) n = std::max(n, v + 1);
  return n;
}

SurfaceTopology analyse(const Faces& faces, unsigned jobs = 1, std::size_t max_listed = 1000, std::uint32_t spare = 0) {
  const Incidence incidence = Incidence::build(faces, num_ids(faces) + spare, jobs);
  return analyse_surface(faces, incidence, max_listed, jobs);
}

std::vector<oracle::Edge> edges_of(const std::vector<EdgeDefect>& defects) {
  std::vector<oracle::Edge> out;
  for (const auto& d : defects) out.emplace_back(d.a, d.b);
  return out;
}

// Everything that analyse_surface says, compared with sets and breadth-first searches.
void expect_as_defined(const Faces& faces, const SurfaceTopology& got, const BruteTopology& want, std::size_t max_listed) {
  SCOPED_TRACE("faces " + text(faces));
  EXPECT_EQ(got.vertices, want.vertices.size());
  EXPECT_EQ(got.edges, want.edges.size());
  EXPECT_EQ(got.faces, faces.size() - want.collapsed.size());
  EXPECT_EQ(got.collapsed, want.collapsed);
  EXPECT_EQ(got.boundary_edges, want.boundary.size());
  EXPECT_EQ(got.nonmanifold_edges, want.nonmanifold.size());
  EXPECT_EQ(got.misoriented_edges, want.misoriented.size());
  EXPECT_EQ(got.nonmanifold_vertices, want.pinched.size());
  EXPECT_EQ(got.is_cycle, want.is_cycle);
  EXPECT_EQ(got.irregular, want.irregular);
  EXPECT_EQ(got.euler(), static_cast<std::int64_t>(want.vertices.size()) - static_cast<std::int64_t>(want.edges.size()) +
                             static_cast<std::int64_t>(faces.size() - want.collapsed.size()));
  EXPECT_EQ(got.is_closed_oriented_manifold(), want.irregular.empty());

  const auto first = [&](auto list) {
    if (list.size() > max_listed) list.resize(max_listed);
    return list;
  };
  EXPECT_EQ(edges_of(got.boundary), first(want.boundary));
  EXPECT_EQ(edges_of(got.nonmanifold), first(want.nonmanifold));
  std::vector<oracle::Edge> directed;
  for (const auto& m : want.misoriented) directed.push_back(m.second);
  EXPECT_EQ(edges_of(got.misoriented), first(directed));
  for (const auto* defects : {&got.boundary, &got.nonmanifold, &got.misoriented})
    for (const EdgeDefect& d : *defects) {
      const auto& e = want.edges.at({std::min(d.a, d.b), std::max(d.a, d.b)});
      std::vector<std::uint32_t> all = e.up;
      all.insert(all.end(), e.down.begin(), e.down.end());
      std::sort(all.begin(), all.end());
      EXPECT_EQ(d.faces, all);
    }
  ASSERT_EQ(got.pinched.size(), first(want.pinched).size());
  for (std::size_t i = 0; i < got.pinched.size(); ++i) {
    const auto& fans = want.fans.at(want.pinched[i]);
    EXPECT_EQ(got.pinched[i].vertex, want.pinched[i]);
    EXPECT_EQ(got.pinched[i].fans, fans.size());
    std::vector<std::uint32_t> least;
    for (const auto& fan : fans) least.push_back(fan[0]);
    EXPECT_EQ(got.pinched[i].faces, least);
  }
  ASSERT_EQ(got.shells.size(), want.shells.size());
  ASSERT_EQ(got.shell_of_face.size(), faces.size());
  std::vector<std::uint32_t> shell_of_face(faces.size(), SurfaceTopology::kNoShell);
  for (std::size_t s = 0; s < want.shells.size(); ++s) {
    std::set<std::uint32_t> vertices;
    std::set<oracle::Edge> edges;
    for (std::uint32_t f : want.shells[s]) {
      shell_of_face[f] = static_cast<std::uint32_t>(s);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = faces[f][i], b = faces[f][(i + 1) % 3];
        vertices.insert(a);
        edges.insert({std::min(a, b), std::max(a, b)});
      }
    }
    EXPECT_EQ(got.shells[s].first_face, want.shells[s][0]);
    EXPECT_EQ(got.shells[s].faces, want.shells[s].size());
    EXPECT_EQ(got.shells[s].vertices, vertices.size());
    EXPECT_EQ(got.shells[s].edges, edges.size());
  }
  EXPECT_EQ(list(got.shell_of_face), shell_of_face);
}

void expect_as_defined(const Faces& faces, unsigned jobs = 1, std::size_t max_listed = 1000) {
  expect_as_defined(faces, analyse(faces, jobs, max_listed), oracle::brute_topology(faces), max_listed);
}

void expect_equal(const SurfaceTopology& a, const SurfaceTopology& b) {
  EXPECT_EQ(list(a.shell_of_face), list(b.shell_of_face));
  EXPECT_EQ(a.irregular, b.irregular);
  EXPECT_EQ(a.collapsed, b.collapsed);
  EXPECT_EQ(a.is_cycle, b.is_cycle);
  const auto counts = [](const SurfaceTopology& t) {
    std::vector<std::uint64_t> out{t.vertices, t.edges, t.faces, t.boundary_edges, t.nonmanifold_edges, t.misoriented_edges,
                                   t.nonmanifold_vertices};
    for (const Shell& s : t.shells) out.insert(out.end(), {s.first_face, s.vertices, s.edges, s.faces});
    for (const auto* defects : {&t.boundary, &t.nonmanifold, &t.misoriented})
      for (const EdgeDefect& d : *defects) {
        out.insert(out.end(), {d.a, d.b});
        out.insert(out.end(), d.faces.begin(), d.faces.end());
      }
    for (const VertexDefect& d : t.pinched) {
      out.insert(out.end(), {d.vertex, d.fans});
      out.insert(out.end(), d.faces.begin(), d.faces.end());
    }
    return out;
  };
  EXPECT_EQ(counts(a), counts(b));
}

TEST(Incidence, ListsTheCornersOfEveryVertexInAscendingOrderWithoutCollapsedFaces) {
  const Faces faces{{0, 1, 2}, {2, 2, 1}, {3, 2, 0}, {0, 2, 3}};
  for (unsigned jobs : {1u, 2u, 3u, 7u}) {
    const Incidence i = Incidence::build(faces, 5, jobs);
    EXPECT_EQ(i.num_vertices(), 5u);
    const auto corners = [&](std::uint32_t v) { return std::vector<std::uint32_t>(i.corners(v).begin(), i.corners(v).end()); };
    EXPECT_EQ(corners(0), (std::vector<std::uint32_t>{0, 10, 12}));
    EXPECT_EQ(corners(1), (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(corners(2), (std::vector<std::uint32_t>{2, 9, 13}));
    EXPECT_EQ(corners(3), (std::vector<std::uint32_t>{8, 14}));
    EXPECT_TRUE(corners(4).empty());
  }
  EXPECT_EQ(corner_face(14), 3u);
  EXPECT_EQ(corner_index(14), 2u);
}

TEST(Incidence, OfNothingIsEmpty) {
  const Incidence i = Incidence::build(Faces{}, 0, 1);
  EXPECT_EQ(i.num_vertices(), 0u);
  const SurfaceTopology t = analyse_surface(Faces{}, i, 10, 3);
  EXPECT_EQ(t.faces, 0u);
  EXPECT_TRUE(t.shells.empty());
}

TEST(Surface, OfATetrahedronIsASphere) {
  const SurfaceTopology t = analyse({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  EXPECT_TRUE(t.is_closed_oriented_manifold());
  EXPECT_EQ(t.euler(), 2);
  EXPECT_EQ(t.shells.size(), 1u);
  EXPECT_EQ(t.edges, 6u);
  expect_as_defined({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

TEST(Surface, OfATorusHasEulerZero) {
  const SurfaceTopology t = analyse(shapes::torus(7, 5, 3, 1).faces, 2);
  EXPECT_TRUE(t.is_closed_oriented_manifold());
  EXPECT_EQ(t.euler(), 0);
}

TEST(Surface, TwoFacesOnThreeVerticesAreAClosedShell) {
  for (const Faces& faces : {Faces{{0, 1, 2}, {0, 2, 1}}, Faces{{4, 1, 2}, {2, 1, 4}}}) {
    const SurfaceTopology t = analyse(faces);
    EXPECT_TRUE(t.is_closed_oriented_manifold());
    EXPECT_EQ(t.shells[0].vertices, 3u);
    expect_as_defined(faces);
  }
  expect_as_defined({{0, 1, 2}, {1, 2, 0}});  // the same side twice: three misoriented edges
}

TEST(Surface, OneFaceHasThreeBoundaryEdges) { expect_as_defined({{2, 0, 1}}); }

TEST(Surface, ThreeFacesAtAnEdgeAreCountedOnce) { expect_as_defined({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}); }

TEST(Surface, ACycleMayHaveNonmanifoldEdges) {
  // Two tetrahedra with a common edge: four faces along it, two each way.
  const Faces faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}};
  const SurfaceTopology t = analyse(faces);
  EXPECT_TRUE(t.is_cycle);
  EXPECT_EQ(t.nonmanifold_edges, 1u);
  EXPECT_FALSE(t.is_closed_oriented_manifold());
  expect_as_defined(faces);
}

TEST(Surface, TwoTetrahedraAtOneVertexAreTwoShellsThatBothCountIt) {
  const Faces faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {5, 0, 6}};
  const SurfaceTopology t = analyse(faces);
  EXPECT_EQ(t.nonmanifold_vertices, 1u);
  EXPECT_EQ(t.shells.size(), 2u);
  EXPECT_EQ(t.shells[0].vertices + t.shells[1].vertices, t.vertices + 1);
  expect_as_defined(faces);
}

TEST(Surface, AFanThatTouchesItselfInAVertexIsPinchedButOneShell) {
  // A strip of faces whose first and last vertex are the same.
  expect_as_defined({{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 0}});
}

TEST(Surface, AMoebiusStripIsNoCycle) {
  Faces faces;
  for (std::uint32_t i = 0; i < 5; ++i) faces.push_back({i, (i + 1) % 5, (i + 2) % 5});
  expect_as_defined(faces);
}

TEST(Surface, ListsAreCutButCountsAreNot) {
  Random random(3);
  const Faces faces = shapes::random_indexed(random, 60, 12, 4).faces;
  for (std::size_t max_listed : {0u, 1u, 2u, 5u}) expect_as_defined(faces, 3, max_listed);
}

TEST(Surface, UnreferencedVerticesDoNotCount) {
  const Faces faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  expect_equal(analyse(faces, 1, 1000, 0), analyse(faces, 5, 1000, 9));
}

TEST(SurfaceLaw, EveryComplexOfUpToThreeFacesOnFourVerticesIsAsDefined) {
  Faces all;
  for (std::uint32_t a = 0; a < 4; ++a)
    for (std::uint32_t b = 0; b < 4; ++b)
      for (std::uint32_t c = 0; c < 4; ++c)
        if (a <= b && a <= c) all.push_back({a, b, c});  // rotated so that the least comes first; collapsed ones too
  for (std::size_t i = 0; i < all.size(); ++i) {
    expect_as_defined({all[i]});
    for (std::size_t j = 0; j < all.size(); ++j) {
      expect_as_defined({all[i], all[j]});
      if (HasFailure()) return;
      for (std::size_t k = j; k < all.size(); ++k) expect_as_defined({all[i], all[j], all[k]});
    }
  }
}

TEST(SurfaceLaw, RandomSoupsAreAsDefinedForEveryNumberOfJobs) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const int vertices = static_cast<int>(3 + random.below(10)), faces = static_cast<int>(1 + random.below(40));
    const Faces soup = shapes::random_indexed(random, faces, vertices, 2).faces;
    const std::size_t max_listed = random.below(8);
    const SurfaceTopology one = analyse(soup, 1, max_listed);
    expect_as_defined(soup, one, oracle::brute_topology(soup), max_listed);
    for (unsigned jobs : {2u, 3u, 7u}) expect_equal(one, analyse(soup, jobs, max_listed));
    if (HasFailure()) return;
  }
}

TEST(SurfaceLaw, BrokenManifoldsAreAsDefinedForEveryNumberOfJobs) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Faces faces = shapes::random_polycube(random, 4, 24).faces;  // edges of four faces, pinched vertices
    for (int i = 0; i < 5; ++i) {
      auto& f = faces[random.below(faces.size())];
      switch (random.below(4)) {
        case 0: std::swap(f[0], f[1]); break;
        case 1: f = faces[random.below(faces.size())]; break;
        case 2: f[0] = f[1]; break;
        default: f[random.below(3)] = static_cast<std::uint32_t>(random.below(num_ids(faces)));
      }
    }
    const SurfaceTopology one = analyse(faces, 1, 20);
    expect_as_defined(faces, one, oracle::brute_topology(faces), 20);
    for (unsigned jobs : {2u, 3u, 7u}) expect_equal(one, analyse(faces, jobs, 20));
    if (HasFailure()) return;
  }
}

// PROVES MESH-8
TEST(SurfaceLaw, RelabellingChangesNoCount) {
  Random random(11);
  for (int i = 0; i < 20; ++i) {
    const TriangleMesh mesh = shapes::random_polycube(random, 3, 10);
    const SurfaceTopology a = analyse(mesh.faces), b = analyse(shapes::relabelled(mesh, random).faces, 3);
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.edges, b.edges);
    EXPECT_EQ(a.euler(), b.euler());
    EXPECT_EQ(a.nonmanifold_edges, b.nonmanifold_edges);
    EXPECT_EQ(a.nonmanifold_vertices, b.nonmanifold_vertices);
    EXPECT_EQ(a.shells.size(), b.shells.size());
    EXPECT_TRUE(a.is_cycle && b.is_cycle);
  }
}

TEST(FanWalker, SaysClosedExactlyIfTheFacesAreOneFanOfOppositeEdges) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const Faces faces = shapes::random_indexed(random, static_cast<int>(2 + random.below(8)), 5, 2).faces;
    const Incidence incidence = Incidence::build(faces, 5, 1);
    const BruteTopology want = oracle::brute_topology(faces);
    internal::FanWalker walker(5);
    std::uint64_t edges = 0;
    for (std::uint32_t v = 0; v < 5; ++v) {
      if (incidence.corners(v).empty()) continue;
      const std::uint64_t before = edges;
      const bool closed = walker.is_closed_fan(faces, incidence.corners(v), v, edges);
      EXPECT_EQ(closed, !std::binary_search(want.irregular.begin(), want.irregular.end(), v)) << text(faces) << " at " << v;
      std::uint64_t greater = 0;
      for (const auto& [edge, uses] : want.edges) greater += edge.first == v;
      EXPECT_EQ(edges - before, closed ? greater : 0u) << text(faces) << " at " << v;
    }
  }
}

}  // namespace
}  // namespace veritope
