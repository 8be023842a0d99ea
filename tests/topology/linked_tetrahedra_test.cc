// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/topology/linked_tetrahedra_test.cc: cones over balls of tetrahedra, against the complex that is built anew.
#include "topology/linked_tetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "robust/base/random.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using Linked = LinkedTetrahedra;

// The boundary of a 4-simplex: five tetrahedra, a sphere.
Linked smallest_sphere(std::uint32_t num_vertices) {
  Linked out(num_vertices);
  const std::array<TetrahedronCorners, 5> cells{
      {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 3, 4}, {0, 3, 2, 4}, {1, 2, 3, 4}}};
  std::vector<std::uint32_t> all;
  for (const TetrahedronCorners& c : cells) all.push_back(out.add(c));
  out.glue_all(all);
  return out;
}

std::vector<std::uint32_t> used_slots(const Linked& linked) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t t = 0; t < linked.num_slots(); ++t)
    if (linked.is_used(t)) out.push_back(t);
  return out;
}

// The links say what faces with equal vertices say, and the whole is a sphere.
void expect_sphere(const Linked& linked, std::uint32_t num_vertices) {
  const std::vector<std::uint32_t> slots = used_slots(linked);
  ASSERT_EQ(linked.num_tetrahedra(), slots.size());
  std::vector<TetrahedronCorners> cells;
  for (const std::uint32_t t : slots) cells.push_back(linked.corners(t));
  const TetrahedralComplex complex(cells, num_vertices);
  EXPECT_TRUE(complex.overused().empty());
  EXPECT_TRUE(complex.boundary().empty());
  EXPECT_EQ(complex.euler(), 0);
  for (std::uint32_t i = 0; i < slots.size(); ++i)
    for (std::uint32_t m = 0; m < 4; ++m) {
      const auto partner = complex.partner(4 * i + m);
      ASSERT_TRUE(partner);
      EXPECT_EQ(linked.across(4 * slots[i] + m),
                4 * slots[face_tetrahedron(*partner)] + face_corner(*partner));
    }
  for (std::uint32_t v = 0; v < num_vertices; ++v) {
    const LinkKind link = classify_link(complex.link(v));
    EXPECT_TRUE(link == LinkKind::kClosed || link == LinkKind::kEmpty) << v;
  }
}

std::vector<TetrahedronFace> shell_of(const Linked& linked,
                                      const std::vector<std::uint32_t>& ball) {
  std::vector<TetrahedronFace> out;
  for (const std::uint32_t t : ball)
    for (std::uint32_t m = 0; m < 4; ++m)
      if (std::find(ball.begin(), ball.end(), face_tetrahedron(linked.across(4 * t + m))) ==
          ball.end())
        out.push_back(4 * t + m);
  return out;
}

// The tetrahedra at an edge, in order around it.
std::vector<std::uint32_t> around_edge(const Linked& linked, std::uint32_t t, std::uint32_t a,
                                       std::uint32_t b) {
  std::vector<std::uint32_t> out;
  const auto place = [&](std::uint32_t s, std::uint32_t v) {
    const TetrahedronCorners& c = linked.corners(s);
    return static_cast<std::uint32_t>(std::find(c.begin(), c.end(), v) - c.begin());
  };
  std::uint32_t leave = 0;
  while (leave == place(t, a) || leave == place(t, b)) ++leave;
  for (std::uint32_t s = t; out.empty() || s != t;) {
    out.push_back(s);
    const TetrahedronFace next = linked.across(4 * s + leave);
    s = face_tetrahedron(next);
    leave = 6 - place(s, a) - place(s, b) - face_corner(next);
  }
  return out;
}

TEST(LinkedTetrahedra, ConesOverOneTetrahedronAFaceAndAnEdgeKeepASphere) {
  for (long round = 0; round < scaled(40); ++round) {
    Random random(static_cast<std::uint64_t>(round));
    constexpr std::uint32_t kVertices = 40;
    Linked linked = smallest_sphere(kVertices);
    for (std::uint32_t apex = 5; apex < kVertices; ++apex) {
      const std::vector<std::uint32_t> slots = used_slots(linked);
      const std::uint32_t t = slots[random.below(slots.size())];
      std::vector<std::uint32_t> ball{t};
      const auto kind = random.below(3);
      if (kind == 1) ball.push_back(face_tetrahedron(linked.across(4 * t + 1)));
      if (kind == 2) ball = around_edge(linked, t, linked.corners(t)[0], linked.corners(t)[3]);
      const std::vector<TetrahedronFace> shell = shell_of(linked, ball);
      const std::size_t before = linked.num_tetrahedra();
      const std::uint32_t one = linked.cone(ball, shell, apex);
      EXPECT_EQ(linked.num_tetrahedra(), before - ball.size() + shell.size());
      EXPECT_NE(std::find(linked.corners(one).begin(), linked.corners(one).end(), apex),
                linked.corners(one).end());
    }
    expect_sphere(linked, kVertices);
  }
}

// All tetrahedra at vertex 0 are replaced by a cone from another apex: as many slots, and more vertices than the table
// takes.
TEST(LinkedTetrahedra, ConesOverManyVerticesKeepASphere) {
  constexpr auto kApex = static_cast<std::uint32_t>(2 * Linked::kManyVertices);
  Linked linked = smallest_sphere(kApex + 1);
  Random random(7);
  for (std::uint32_t v = 5; v < kApex; ++v) {
    std::vector<std::uint32_t> at_zero;
    for (const std::uint32_t t : used_slots(linked)) {
      const TetrahedronCorners& c = linked.corners(t);
      if (std::find(c.begin(), c.end(), 0u) != c.end()) at_zero.push_back(t);
    }
    const std::vector<std::uint32_t> ball{at_zero[random.below(at_zero.size())]};
    linked.cone(ball, shell_of(linked, ball), v);
  }
  std::vector<std::uint32_t> star;
  std::set<std::uint32_t> link;
  for (const std::uint32_t t : used_slots(linked)) {
    const TetrahedronCorners& c = linked.corners(t);
    if (std::find(c.begin(), c.end(), 0u) == c.end()) continue;
    star.push_back(t);
    link.insert(c.begin(), c.end());
  }
  ASSERT_GT(link.size(), Linked::kManyVertices + 1);
  const std::size_t before = linked.num_tetrahedra();
  linked.cone(star, shell_of(linked, star), kApex);
  EXPECT_EQ(linked.num_tetrahedra(), before);
  for (const std::uint32_t t : used_slots(linked)) {
    const TetrahedronCorners& c = linked.corners(t);
    EXPECT_EQ(std::find(c.begin(), c.end(), 0u), c.end());
  }
  expect_sphere(linked, kApex + 1);
}

TEST(LinkedTetrahedra, SlotsAreUsedAgain) {
  Linked linked(6);
  const std::uint32_t a = linked.add({0, 1, 2, 3}), b = linked.add({0, 2, 1, 4});
  EXPECT_EQ(linked.across(4 * a), Linked::kNoFace);
  const std::array<std::uint32_t, 2> both{a, b};
  linked.glue_all(both);
  EXPECT_EQ(linked.across(4 * a + 3), 4 * b + 3);
  EXPECT_EQ(linked.across(4 * b + 3), 4 * a + 3);
  EXPECT_EQ(linked.vertices(4 * a + 3), (std::array<std::uint32_t, 3>{0, 2, 1}));
  std::vector<TetrahedronFace> shell;
  for (std::uint32_t m = 0; m < 3; ++m) shell.push_back(4 * a + m), shell.push_back(4 * b + m);
  linked.cone(both, shell, 5);
  EXPECT_EQ(linked.num_slots(), 6u);
  EXPECT_EQ(linked.num_tetrahedra(), 6u);
}

}  // namespace
}  // namespace veritope
