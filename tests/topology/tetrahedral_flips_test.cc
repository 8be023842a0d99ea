// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/topology/tetrahedral_flips_test.cc: random flips keep a complex and its boundary, and inverses restore it.
#include "topology/tetrahedral_flips.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robust/base/random.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

constexpr std::uint32_t kVertices = 60;

std::vector<std::uint32_t> used_slots(const LinkedTetrahedra& complex) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t t = 0; t < complex.num_slots(); ++t)
    if (complex.is_used(t)) out.push_back(t);
  return out;
}

// With positive corners in a normal form: the least first, then the order that keeps the orientation.
std::vector<TetrahedronCorners> tetrahedra_of(const LinkedTetrahedra& complex) {
  std::vector<TetrahedronCorners> out;
  for (const std::uint32_t t : used_slots(complex)) {
    TetrahedronCorners c = complex.corners(t);
    const bool even = is_even(c);
    std::sort(c.begin(), c.end());
    if (!even) std::swap(c[2], c[3]);
    out.push_back(c);
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<std::array<std::uint32_t, 3>> boundary_of(const LinkedTetrahedra& complex) {
  std::vector<std::array<std::uint32_t, 3>> out;
  const TetrahedralComplex whole(tetrahedra_of(complex), kVertices);
  for (const TetrahedronFace f : whole.boundary()) {
    auto v = whole.vertices(f);
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    out.push_back(v);
  }
  std::sort(out.begin(), out.end());
  return out;
}

LinkedTetrahedra linked(const std::vector<TetrahedronCorners>& tetrahedra) {
  LinkedTetrahedra out(kVertices);
  std::vector<std::uint32_t> all;
  for (const TetrahedronCorners& t : tetrahedra) all.push_back(out.add(t));
  out.glue_all(all);
  return out;
}

// The boundary of a 4-simplex; or one tetrahedron.
LinkedTetrahedra start(bool is_closed) {
  if (!is_closed) return linked({{0, 1, 2, 3}});
  return linked({{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 3, 4}, {0, 3, 2, 4}, {1, 2, 3, 4}});
}

// Faces are glued as their vertices say, and links are spheres and discs.
void expect_valid(const LinkedTetrahedra& complex, std::int64_t euler) {
  const std::vector<std::uint32_t> slots = used_slots(complex);
  ASSERT_EQ(complex.num_tetrahedra(), slots.size());
  std::vector<TetrahedronCorners> cells;
  for (const std::uint32_t t : slots) cells.push_back(complex.corners(t));
  const TetrahedralComplex whole(cells, kVertices);
  ASSERT_TRUE(whole.overused().empty());
  EXPECT_EQ(whole.euler(), euler);
  for (std::uint32_t i = 0; i < slots.size(); ++i)
    for (std::uint32_t m = 0; m < 4; ++m) {
      const auto partner = whole.partner(4 * i + m);
      const TetrahedronFace across = complex.across(4 * slots[i] + m);
      ASSERT_EQ(partner.has_value(), across != LinkedTetrahedra::kNoFace);
      if (!partner) continue;
      EXPECT_EQ(across, 4 * slots[face_tetrahedron(*partner)] + face_corner(*partner));
    }
  for (std::uint32_t v = 0; v < kVertices; ++v)
    EXPECT_NE(classify_link(whole.link(v)), LinkKind::kOther) << v;
}

TEST(TetrahedralFlips, InsertedVerticesKeepAComplexWithOrWithoutBoundary) {
  for (long round = 0; round < scaled(60); ++round) {
    Random random(static_cast<std::uint64_t>(round));
    LinkedTetrahedra complex = start(round % 2 == 0);
    for (std::uint32_t v = 5; v < 30; ++v) {
      const std::vector<std::uint32_t> slots = used_slots(complex);
      const std::uint32_t t = slots[random.below(slots.size())];
      const std::size_t before = complex.num_tetrahedra();
      const auto boundary = boundary_of(complex);
      const auto m = static_cast<std::uint32_t>(random.below(4)),
                 n = (m + 1 + static_cast<std::uint32_t>(random.below(3))) % 4;
      if (const auto kind = random.below(3); kind == 0) {
        insert_in_tetrahedron(complex, t, v);
        EXPECT_EQ(complex.num_tetrahedra(), before + 3);
        EXPECT_EQ(boundary_of(complex), boundary);
      } else if (kind == 1) {
        const bool is_inner = complex.across(4 * t + m) != LinkedTetrahedra::kNoFace;
        insert_in_face(complex, 4 * t + m, v);
        EXPECT_EQ(complex.num_tetrahedra(), before + (is_inner ? 4 : 2));
        if (is_inner) {
          EXPECT_EQ(boundary_of(complex), boundary);
        }
        if (!is_inner) {
          EXPECT_EQ(boundary_of(complex).size(), boundary.size() + 2);
        }
      } else {
        const std::uint32_t a = complex.corners(t)[m], b = complex.corners(t)[n];
        const std::size_t around = tetrahedra_around(complex, t, a, b).size();
        insert_in_edge(complex, t, a, b, v);
        EXPECT_EQ(complex.num_tetrahedra(), before + around);
      }
    }
    SCOPED_TRACE(round);
    expect_valid(complex, round % 2 == 0 ? 0 : 1);
  }
}

TEST(TetrahedralFlips, KeepAComplexAndItsBoundaryAndInversesRestoreIt) {
  std::array<int, 4> done{};
  for (long round = 0; round < scaled(30); ++round) {
    Random random(static_cast<std::uint64_t>(round));
    const bool is_closed = round % 2 == 0;
    LinkedTetrahedra complex = start(is_closed);
    for (std::uint32_t v = 5; v < 25; ++v) {
      const std::vector<std::uint32_t> slots = used_slots(complex);
      insert_in_tetrahedron(complex, slots[random.below(slots.size())], v);
    }
    const auto boundary = boundary_of(complex);
    for (int step = 0; step < 120; ++step) {
      const std::vector<std::uint32_t> slots = used_slots(complex);
      const std::uint32_t t = slots[random.below(slots.size())];
      const auto m = static_cast<std::uint32_t>(random.below(4)),
                 n = (m + 1 + static_cast<std::uint32_t>(random.below(3))) % 4;
      const std::uint32_t a = complex.corners(t)[m], b = complex.corners(t)[n];
      const auto before = tetrahedra_of(complex);
      const auto with_edge = [&](std::uint32_t v, std::uint32_t w) {
        for (const std::uint32_t s : used_slots(complex)) {
          const TetrahedronCorners& c = complex.corners(s);
          if (std::find(c.begin(), c.end(), v) != c.end() &&
              std::find(c.begin(), c.end(), w) != c.end())
            return s;
        }
        return LinkedTetrahedra::kNoFace;
      };
      SCOPED_TRACE("round " + std::to_string(round) + " step " + std::to_string(step));
      const auto kind = random.below(4);
      std::optional<FlipFault> fault;
      if (kind == 0) {
        const TetrahedronFace across = complex.across(4 * t + m);
        const std::uint32_t e =
            across == LinkedTetrahedra::kNoFace
                ? 0
                : complex.corners(face_tetrahedron(across))[face_corner(across)];
        fault = flip_2_3(complex, 4 * t + m);
        if (!fault) {
          EXPECT_EQ(tetrahedra_around(complex, with_edge(a, e), a, e).size(), 3u);
          LinkedTetrahedra back = complex;
          EXPECT_EQ(flip_3_2(back, with_edge(a, e), a, e), std::nullopt);
          EXPECT_EQ(tetrahedra_of(back), before);
        }
      } else if (kind == 1) {
        fault = flip_3_2(complex, t, a, b);
      } else if (kind == 2) {
        std::uint32_t c = 0;
        for (const std::uint32_t v : complex.corners(t))
          if (v != a && v != b) c = v;
        fault = flip_4_4(complex, t, a, b, c);
      } else {
        constexpr std::uint32_t next = 25;
        insert_in_tetrahedron(complex, t, next);
        EXPECT_NE(tetrahedra_of(complex), before);
        fault = flip_4_1(complex, with_edge(a, next), next);
        EXPECT_EQ(fault, std::nullopt);
        EXPECT_EQ(tetrahedra_of(complex), before);
      }
      if (fault) {
        EXPECT_EQ(tetrahedra_of(complex), before);
      } else {
        ++done[kind];
      }
      ASSERT_EQ(boundary_of(complex), boundary);
    }
    expect_valid(complex, is_closed ? 0 : 1);
  }
  for (const int count : done) EXPECT_GT(count, 20);
}

// An octahedron around the edge 0 1, inside of nothing.
TEST(TetrahedralFlips, AnOctahedronHasThreeDiagonals) {
  LinkedTetrahedra complex = linked({{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 5}, {0, 1, 5, 2}});
  const auto before = tetrahedra_of(complex);
  EXPECT_EQ(flip_3_2(complex, 0, 0, 1), FlipFault::kWrongCount);
  EXPECT_EQ(flip_4_4(complex, 0, 0, 2, 1), FlipFault::kBoundary);
  ASSERT_EQ(flip_4_4(complex, 0, 0, 1, 2), std::nullopt);
  EXPECT_EQ(tetrahedra_around(complex, used_slots(complex)[0], 2, 4).size(), 4u);
  const auto other = tetrahedra_of(complex);
  EXPECT_NE(other, before);
  expect_valid(complex, 1);
  for (const std::uint32_t t : used_slots(complex)) {
    const TetrahedronCorners& c = complex.corners(t);
    if (std::find(c.begin(), c.end(), 0u) == c.end()) continue;
    ASSERT_EQ(flip_4_4(complex, t, 2, 4, 0), std::nullopt);
    break;
  }
  EXPECT_EQ(tetrahedra_of(complex), before);
}

TEST(TetrahedralFlips, AreRefusedWhereTheResultWouldBeNoComplex) {
  LinkedTetrahedra sphere = start(true);
  EXPECT_EQ(flip_2_3(sphere, 0), FlipFault::kEdgeExists);
  EXPECT_EQ(flip_4_1(sphere, 0, 0), FlipFault::kEdgeExists);
  EXPECT_EQ(flip_3_2(sphere, 0, 0, 1), FlipFault::kEdgeExists);
  LinkedTetrahedra one = start(false);
  EXPECT_EQ(flip_2_3(one, 0), FlipFault::kBoundary);
  EXPECT_EQ(flip_4_1(one, 0, 0), FlipFault::kWrongCount);
  EXPECT_EQ(one.num_tetrahedra(), 1u);
}

}  // namespace
}  // namespace veritope
