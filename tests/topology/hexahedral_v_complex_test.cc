// SPDX-License-Identifier: LGPL-3.0-or-later
// Cuboids with glued and collapsed faces: the primitives of [ME16] figures 8 and 9, rings, and what is refused.
#include "topology/hexahedral_v_complex.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "robust/base/random.h"
#include "tests/support/v_complex_shapes.h"
#include "topology/v_complex_boundary.h"
#include "topology/v_complex_homology.h"
#include "topology/v_complex_links.h"

namespace veritope {
namespace {

using Kind = HexahedralFace::Kind;
using Corners = std::array<int, 8>;  // equal numbers: one point
using Betti = std::array<std::uint64_t, 4>;

// Corner of a face at the ends i, j of its parameters, written anew.
unsigned corner_at(unsigned face, unsigned i, unsigned j) {
  std::array<unsigned, 3> ends{};
  ends[face / 2] = face % 2;
  ends[face / 2 == 0 ? 1 : 0] = i;
  ends[face / 2 == 2 ? 1 : 2] = j;
  return ends[0] + 2 * ends[1] + 4 * ends[2];
}

std::array<int, 4> labels(const Corners& cell, unsigned face) {  // (0,0), (1,0), (0,1), (1,1)
  return {cell[corner_at(face, 0, 0)], cell[corner_at(face, 1, 0)], cell[corner_at(face, 0, 1)],
          cell[corner_at(face, 1, 1)]};
}

// The place of the parameters (i, j) after a symmetry: exchange, reverse the first, reverse the second.
unsigned image(std::uint32_t symmetry, unsigned k) {
  std::array<unsigned, 2> ij{k & 1, k >> 1};
  if ((symmetry & 1) != 0) std::swap(ij[0], ij[1]);
  if ((symmetry & 2) != 0) ij[0] ^= 1;
  if ((symmetry & 4) != 0) ij[1] ^= 1;
  return ij[0] + 2 * ij[1];
}

// Faces with four different labels are glued where another face has them, too; others are collapsed as their labels say.
std::vector<HexahedralCell> cells_of(const std::vector<Corners>& corners) {
  std::vector<HexahedralCell> out(corners.size());
  for (std::uint32_t c = 0; c < corners.size(); ++c) {
    for (std::uint32_t f = 0; f < 6; ++f) {
      const auto here = labels(corners[c], f);
      HexahedralFace& face = out[c].faces[f];
      const bool first = here[0] == here[1] && here[2] == here[3],
                 second = here[0] == here[2] && here[1] == here[3];
      if (first || second) {
        face.kind = first && second ? Kind::kToPoint
                    : first         ? Kind::kAlongFirst
                                    : Kind::kAlongSecond;
        continue;
      }
      for (std::uint32_t d = 0; d < corners.size(); ++d)
        for (std::uint32_t g = 0; g < 6; ++g)
          for (std::uint32_t s = 0; s < 8 && (c != d || f != g); ++s) {
            const auto there = labels(corners[d], g);
            bool is_equal = true;
            for (unsigned k = 0; k < 4; ++k) is_equal = is_equal && here[k] == there[image(s, k)];
            if (is_equal) face = {Kind::kGlued, d, g, s};
          }
    }
    for (unsigned axis = 0; axis < 3; ++axis)
      for (unsigned k = 0; k < 4; ++k) {
        const unsigned p = axis == 0 ? 1 : 0, q = axis == 2 ? 1 : 2;
        const unsigned begin = (k & 1) << p | (k >> 1) << q;
        out[c].is_collapsed[4 * axis + k] = corners[c][begin] == corners[c][begin | 1u << axis];
      }
  }
  return out;
}

// An inner square and four walls around it, between the heights `bottom` and `top`: labels of height h are 8 h + 0..3
// (inner) and 8 h + 4..7 (outer).
std::vector<Corners> five_cells(int bottom, int top) {
  const std::array<int, 4> ring{0, 1, 3, 2};  // around the square of the labels 0, 1, 2, 3
  const int b = 8 * bottom, t = 8 * top;
  std::vector<Corners> out{{b, b + 1, b + 2, b + 3, t, t + 1, t + 2, t + 3}};
  for (unsigned k = 0; k < 4; ++k) {
    const int i = ring[k], j = ring[(k + 1) % 4];
    out.push_back({b + i, b + i + 4, b + j, b + j + 4, t + i, t + i + 4, t + j, t + j + 4});
  }
  return out;
}

HexahedralVComplex made(const std::vector<HexahedralCell>& cells) {
  Result<HexahedralVComplex> out = hexahedral_v_complex(cells);
  EXPECT_TRUE(out) << out.error().message;
  return out ? std::move(out).value() : HexahedralVComplex();
}

struct Facts {
  VComplexCounts counts;
  Betti betti{};
  std::vector<std::int64_t> genera;
  bool is_manifold = false;
};
Facts facts_of(const std::vector<HexahedralCell>& cells) {
  const VComplex complex = made(cells).complex;
  Facts out{complex.counts(), betti_numbers(complex).value(), {}, is_manifold(complex)};
  const BoundaryBrep brep = boundary_brep(complex);
  for (const VShell& shell : brep.shells) out.genera.push_back(shell.genus());
  return out;
}
void expect_facts(const std::vector<HexahedralCell>& cells, const VComplexCounts& counts,
                  const Betti& betti, const std::vector<std::int64_t>& genera) {
  const Facts facts = facts_of(cells);
  EXPECT_EQ(facts.counts, counts);
  EXPECT_EQ(facts.betti, betti);
  EXPECT_EQ(facts.genera, genera);
  EXPECT_TRUE(facts.is_manifold);
}

TEST(HexahedralVComplex, OfOneBox) {
  expect_facts(std::vector<HexahedralCell>(1), {1, 6, 0, 6, 12, 8}, {1, 0, 0, 0}, {0});
}

TEST(HexahedralVComplex, OfThreeCubesInAnL) {
  std::vector<HexahedralCell> cells(3);
  v_shapes::glue_faces(cells, 0, 1, 1, 0, 0);
  v_shapes::glue_faces(cells, 1, 3, 2, 2, 0);
  expect_facts(cells, {3, 16, 2, 18, 28, 16}, {1, 0, 0, 0}, {0});
}

// [ME16] figure 9, by the labels of corners.
TEST(HexahedralVComplex, OfThePrimitives) {
  expect_facts(cells_of(five_cells(0, 1)), {5, 22, 8, 30, 32, 16}, {1, 0, 0, 0},
               {0});  // cylinder, frustum
  std::vector<Corners> cone = five_cells(0, 1);
  for (Corners& cell : cone)
    for (int& label : cell) label = std::min(label, 8);  // the top is a point
  expect_facts(cells_of(cone), {5, 17, 8, 25, 20, 9}, {1, 0, 0, 0}, {0});
  std::vector<HexahedralCell> torus = cells_of(five_cells(0, 1));
  for (std::uint32_t c = 0; c < 5; ++c) v_shapes::glue_faces(torus, c, 4, c, 5, 0);
  expect_facts(torus, {5, 17, 13, 30, 20, 8}, {1, 1, 0, 0}, {1});
  // A cube with a cell on each face; outer corners are 8 more.
  std::vector<Corners> sphere{{0, 1, 2, 3, 4, 5, 6, 7}};
  for (unsigned f = 0; f < 6; ++f) {
    const auto inner = labels(sphere[0], f);
    sphere.push_back({inner[0], inner[1], inner[2], inner[3], inner[0] + 8, inner[1] + 8,
                      inner[2] + 8, inner[3] + 8});
  }
  expect_facts(cells_of(sphere), {7, 24, 18, 42, 32, 16}, {1, 0, 0, 0}, {0});
}

// Cells whose axes are left-handed are found: three of the sphere's six outer ones here.
TEST(HexahedralVComplex, FindsReversedCells) {
  std::vector<HexahedralCell> cells(2);
  v_shapes::glue_faces(cells, 0, 1, 1, 0, 1);  // parameters exchanged
  const HexahedralVComplex out = made(cells);
  EXPECT_EQ(out.is_reversed, (std::vector<bool>{false, true}));
  EXPECT_TRUE(is_manifold(out.complex));
  v_shapes::glue_faces(cells, 0, 1, 1, 0, 3);
  EXPECT_EQ(made(cells).is_reversed, (std::vector<bool>{false, false}));
  // A cell and its copy, glued on equal faces: seen from the same side.
  v_shapes::glue_faces(cells, 0, 1, 1, 1, 0);
  cells[1].faces[0] = {};
  EXPECT_EQ(made(cells).is_reversed, (std::vector<bool>{false, true}));
}

TEST(HexahedralVComplex, OfRings) {
  std::vector<HexahedralCell> ring(1);
  v_shapes::glue_faces(ring, 0, 0, 0, 1, 0);
  expect_facts(ring, {1, 5, 1, 6, 8, 4}, {1, 1, 0, 0}, {1});
  v_shapes::glue_faces(ring, 0, 0, 0, 1, 6);  // with a half turn
  EXPECT_EQ(facts_of(ring).counts, (VComplexCounts{1, 5, 1, 6, 8, 4}));
  std::vector<HexahedralCell> two(2);
  v_shapes::glue_faces(two, 0, 1, 1, 0, 0);
  v_shapes::glue_faces(two, 1, 1, 0, 0, 0);
  expect_facts(two, {2, 10, 2, 12, 16, 8}, {1, 1, 0, 0}, {1});
}

// [ME16] figure 8: one cell, the axis of the cylinder is a collapsed face; v runs around.
// PROVES VCOMPLEX-3
TEST(HexahedralVComplex, OfASingularCylinder) {
  std::vector<HexahedralCell> cells(1);
  v_shapes::glue_faces(cells, 0, 2, 0, 3, 0);
  cells[0].faces[0].kind = Kind::kAlongFirst;
  expect_facts(cells, {1, 4, 1, 5, 6, 4}, {1, 0, 0, 0}, {0});
  const HexahedralVComplex out = made(cells);
  EXPECT_EQ(out.points[0][0], out.points[0][2]);
  EXPECT_EQ(out.points[0][4], out.points[0][6]);
  EXPECT_NE(out.points[0][0], out.points[0][4]);
  const VCurveId axis = out.curves[0][8];
  EXPECT_EQ(out.curves[0][10], axis);
  ASSERT_EQ(out.complex.fans(axis).size(), 1u);
  EXPECT_TRUE(out.complex.fans(axis)[0].is_cyclic);
  EXPECT_EQ(out.complex.half_surfaces_of_curve(axis).size(), 2u);
  EXPECT_TRUE(out.curves[0][4].is_none());
  EXPECT_TRUE(out.half_surfaces[0][0].is_none());
}

TEST(HexahedralVComplex, OfASingularSphere) {
  std::vector<HexahedralCell> cells(1);
  v_shapes::glue_faces(cells, 0, 2, 0, 3, 0);
  cells[0].faces[0].kind = Kind::kToPoint;      // the centre
  cells[0].faces[4].kind = Kind::kAlongSecond;  // the axis to the south pole
  cells[0].faces[5].kind = Kind::kAlongSecond;
  expect_facts(cells, {1, 2, 1, 3, 3, 3}, {1, 0, 0, 0}, {0});
}

// One cell without a gluing whose face collapses: a wedge, its four corners become two points.
TEST(HexahedralVComplex, OfAWedgeAndAPyramid) {
  std::vector<HexahedralCell> wedge(1);
  wedge[0].faces[0].kind = Kind::kAlongFirst;
  expect_facts(wedge, {1, 5, 0, 5, 9, 6}, {1, 0, 0, 0}, {0});
  std::vector<HexahedralCell> pyramid(1);
  pyramid[0].faces[5].kind = Kind::kToPoint;
  expect_facts(pyramid, {1, 5, 0, 5, 8, 5}, {1, 0, 0, 0}, {0});
  // Two opposite faces, collapsed in different directions: a tetrahedron.
  std::vector<HexahedralCell> tetrahedron(1);
  tetrahedron[0].faces[4].kind = Kind::kAlongFirst;
  tetrahedron[0].faces[5].kind = Kind::kAlongSecond;
  expect_facts(tetrahedron, {1, 4, 0, 4, 6, 4}, {1, 0, 0, 0}, {0});
  // In the same direction: a lens between two arcs.
  tetrahedron[0].faces[5].kind = Kind::kAlongFirst;
  expect_facts(tetrahedron, {1, 4, 0, 4, 6, 4}, {1, 0, 0, 0}, {0});
  // A single collapsed edge: two triangles among the faces.
  std::vector<HexahedralCell> edge(1);
  edge[0].is_collapsed[0] = true;
  expect_facts(edge, {1, 6, 0, 6, 11, 7}, {1, 0, 0, 0}, {0});
}

// All symmetries of all pairs of faces of two cuboids: one V-surface, and which points are glued.
// PROVES VCOMPLEX-3
TEST(HexahedralVComplex, GluesByEachSymmetry) {
  for (std::uint32_t f = 0; f < 6; ++f)
    for (std::uint32_t g = 0; g < 6; ++g)
      for (std::uint32_t s = 0; s < 8; ++s) {
        std::vector<HexahedralCell> cells(2);
        cells[0].faces[f] = {Kind::kGlued, 1, g, s};  // the other side need not say it
        const HexahedralVComplex out = made(cells);
        ASSERT_EQ(out.complex.counts(), (VComplexCounts{2, 11, 1, 12, 20, 12}));
        ASSERT_TRUE(is_manifold(out.complex));
        for (unsigned k = 0; k < 4; ++k) {
          const unsigned to = image(s, k);
          ASSERT_EQ(out.points[0][corner_at(f, k & 1, k >> 1)],
                    out.points[1][corner_at(g, to & 1, to >> 1)]);
        }
        ASSERT_EQ(image(inverse_symmetry(s), image(s, 1)), 1u);
        ASSERT_EQ(image(inverse_symmetry(s), image(s, 2)), 2u);
      }
}

TEST(HexahedralVComplex, SaysHowEdgesRunAlongTheirCurves) {
  std::vector<HexahedralCell> cells(2);
  v_shapes::glue_faces(cells, 0, 1, 1, 0, 3);
  const HexahedralVComplex out = made(cells);
  for (std::size_t c = 0; c < 2; ++c)
    for (unsigned e = 0; e < 12; ++e) {
      const unsigned axis = e / 4, p = axis == 0 ? 1 : 0, q = axis == 2 ? 1 : 2;
      const unsigned begin = (e & 1) << p | (e >> 1 & 1) << q, end = begin | 1u << axis;
      const auto& ends = out.complex.curve(out.curves[c][e]).ends;
      const bool is_reversed = out.is_edge_reversed[c][e];
      EXPECT_EQ(ends[is_reversed ? 1 : 0], out.points[c][begin]);
      EXPECT_EQ(ends[is_reversed ? 0 : 1], out.points[c][end]);
    }
}

std::string error_of(const std::vector<HexahedralCell>& cells, std::uint64_t cell) {
  const auto out = hexahedral_v_complex(cells);
  if (out) return "none";
  EXPECT_EQ(out.error().code, Code::kBadArgument);
  EXPECT_EQ(out.error().place.entity, cell);
  return out.error().message;
}
#define EXPECT_HAS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(HexahedralVComplex, IsRefusedWithTheCell) {
  std::vector<HexahedralCell> cells(2);
  cells[1].faces[2] = {Kind::kGlued, 2, 0, 0};
  EXPECT_HAS(error_of(cells, 1), "does not exist");
  cells[1].faces[2] = {Kind::kGlued, 1, 2, 0};
  EXPECT_HAS(error_of(cells, 1), "glued to itself");
  cells[1].faces[2] = {Kind::kGlued, 0, 2, 0};
  cells[0].faces[2].kind = Kind::kToPoint;
  EXPECT_HAS(error_of(cells, 1), "collapsed face");
  cells[0].faces[2] = {Kind::kGlued, 1, 2, 1};
  EXPECT_HAS(error_of(cells, 0), "in another way");

  cells = std::vector<HexahedralCell>(2);
  v_shapes::glue_faces(cells, 0, 1, 1, 0, 0);
  cells[1].is_collapsed[4] = true;  // an edge of the glued face
  EXPECT_HAS(error_of(cells, 0), "differs");

  cells = std::vector<HexahedralCell>(1);
  cells[0].faces[0].kind = Kind::kAlongFirst;
  cells[0].is_collapsed[8] = true;
  EXPECT_HAS(error_of(cells, 0), "only one is collapsed");

  cells = std::vector<HexahedralCell>(1);
  for (const unsigned e : {4, 6, 8, 10}) cells[0].is_collapsed[e] = true;  // around face 0
  EXPECT_HAS(error_of(cells, 0), "but the face is not");

  cells = std::vector<HexahedralCell>(1);
  for (unsigned f = 0; f < 4; ++f)
    cells[0].faces[f].kind = Kind::kAlongFirst;  // constant along both: only axis 2 is left
  EXPECT_HAS(error_of(cells, 0), "between collapsed faces only");

  // A ring with a reflection is one-sided.
  cells = std::vector<HexahedralCell>(1);
  v_shapes::glue_faces(cells, 0, 0, 0, 1, 2);
  EXPECT_HAS(error_of(cells, 0), "no common orientation");
}

// Cuboids glued and collapsed at random: all that is not refused is a V-complex, and all counts are those of classes.
TEST(HexahedralVComplex, OfRandomGluingsIsAVComplex) {
  std::uint64_t built = 0, refused = 0, with_collapse = 0;
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    Random random(seed);
    std::vector<HexahedralCell> cells(1 + random.below(4));
    const auto n = static_cast<std::uint32_t>(cells.size());
    bool has_collapse = false;
    for (std::uint64_t k = random.below(2 * n + 1); k-- > 0;) {
      const auto any = [&](std::uint32_t bound) {
        return static_cast<std::uint32_t>(random.below(bound));
      };
      const std::uint32_t a = any(n), f = any(6), b = any(n), g = any(6);
      if (random.below(4) == 0) {
        cells[a].faces[f] = {static_cast<Kind>(2 + any(3)), 0, 0, 0};
        has_collapse = true;
      } else if (cells[a].faces[f].kind == Kind::kBoundary &&
                 cells[b].faces[g].kind == Kind::kBoundary && (a != b || f != g)) {
        v_shapes::glue_faces(cells, a, f, b, g, any(8));
      }
    }
    const auto out = hexahedral_v_complex(cells);
    ++(out ? built : refused);
    if (!out) continue;
    with_collapse += has_collapse ? 1 : 0;
    const VComplex& complex = out.value().complex;
    ASSERT_FALSE(validate(complex.tables())) << "seed " << seed;
    // Gluing and collapsing make one fan a curve.
    ASSERT_TRUE(nonmanifold_curves(complex).empty()) << "seed " << seed;
    std::set<VPointId> points;
    std::set<VCurveId> curves;
    std::size_t halves = 0;
    for (std::size_t c = 0; c < n; ++c) {
      points.insert(out.value().points[c].begin(), out.value().points[c].end());
      for (const VCurveId curve : out.value().curves[c])
        if (!curve.is_none()) curves.insert(curve);
      for (const HalfVSurfaceId h : out.value().half_surfaces[c]) halves += h.is_none() ? 0 : 1;
    }
    ASSERT_EQ(points.size(), complex.counts().points) << "seed " << seed;
    ASSERT_EQ(curves.size(), complex.counts().curves) << "seed " << seed;
    ASSERT_EQ(halves, complex.counts().half_surfaces) << "seed " << seed;
    const BoundaryMaps maps = boundary_maps(complex);
    ASSERT_TRUE(product(maps.d2, maps.d3).is_zero() && product(maps.d1, maps.d2).is_zero())
        << "seed " << seed;
    const auto betti = betti_numbers(complex);
    if (!betti) continue;
    const auto& b = betti.value();
    ASSERT_EQ(static_cast<std::int64_t>(b[0] + b[2]) - static_cast<std::int64_t>(b[1] + b[3]),
              euler_characteristic(complex))
        << "seed " << seed;
  }
  EXPECT_GT(built, 5000u);
  EXPECT_GT(refused, 1000u);
  EXPECT_GT(with_collapse, 1000u);
}

}  // namespace
}  // namespace veritope
