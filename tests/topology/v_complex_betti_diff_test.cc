// SPDX-License-Identifier: LGPL-3.0-or-later
// Betti numbers of V-complexes against GUDHI's simplicial homology of their second barycentric subdivision, which is
// built from the uses of V-curves and not from the boundary maps.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "robust/base/random.h"
#include "tests/support/v_complex_edits.h"
#include "tests/support/v_complex_shapes.h"
#include "topology/v_complex_homology.h"

#if __has_include(<gudhi/Simplex_tree.h>)
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>
#define VT_HAVE_GUDHI_SIMPLICES
#endif

namespace veritope {
namespace {

#ifdef VT_HAVE_GUDHI_SIMPLICES

using Betti = std::array<std::uint64_t, 4>;

// The first subdivision has a tetrahedron for each end of each use, with the middles of a cell, a V-surface and a
// V-curve, and a V-point, as corners. Faces of tetrahedra are one if across, mate or the loop says so.
class Subdivision {
 public:
  explicit Subdivision(const VComplex& complex) : t_(complex.tables()) {
    for (const CurveUseId u : t_.uses)
      for (unsigned end = 0; end < 2; ++end) add_tetrahedron(u, end);
  }

  Betti betti() const {
    Gudhi::Simplex_tree<> tree;
    for (const auto& chain : chains_) tree.insert_simplex_and_subfaces(chain);
    tree.set_dimension(3);
    Gudhi::persistent_cohomology::Persistent_cohomology<Gudhi::Simplex_tree<>,
                                                        Gudhi::persistent_cohomology::Field_Zp>
        cohomology(tree, true);
    cohomology.init_coefficients(1009);
    cohomology.compute_persistent_cohomology(0.0);
    Betti out{};
    for (int d = 0; d < 4; ++d)
      out[static_cast<std::size_t>(d)] = static_cast<std::uint64_t>(cohomology.betti_number(d));
    return out;
  }

 private:
  using Flag = std::pair<CurveUseId, unsigned>;  // an end (0: start) of a use

  // Moves to a neighbouring tetrahedron: across a face without the V-point, curve, surface or cell. The id is missing outside.
  Flag neighbour(Flag flag, unsigned without) const {
    const CurveUse& use = t_.uses[flag.first];
    switch (without) {
      case 0: return {flag.first, 1 - flag.second};
      case 1: return flag.second == 0 ? Flag{use.previous, 1} : Flag{use.next, 0};
      case 2: return {use.across, 1 - flag.second};
      default: return {use.mate, 1 - flag.second};
    }
  }

  // The simplex of these corners (bits: 1 V-point, 2 curve, 4 surface, 8 cell): all flags that share it.
  int simplex_of(Flag flag, unsigned corners) {
    std::set<Flag> seen{flag};
    std::vector<Flag> todo{flag};
    while (!todo.empty()) {
      const Flag at = todo.back();
      todo.pop_back();
      for (unsigned k = 0; k < 4; ++k) {
        if ((corners >> k & 1) != 0) continue;
        const Flag next = neighbour(at, k);
        if (!next.first.is_none() && seen.insert(next).second) todo.push_back(next);
      }
    }
    // V-points and V-curves may hold several classes: they are corners by their ids.
    std::pair<std::uint32_t, std::uint32_t> name{
        corners, seen.begin()->first.value * 2 + seen.begin()->second};
    if (corners == 1)
      name.second = (flag.second == 0 ? t_.start(flag.first) : t_.end(flag.first)).value;
    if (corners == 2) name.second = t_.uses[flag.first].curve.value;
    if (corners == 3) {
      const unsigned end = t_.start_end(flag.first) ^ flag.second;
      name.second = 2 * t_.uses[flag.first].curve.value + end;
    }
    if (corners == 8) name.second = t_.half_surfaces[t_.uses[flag.first].half_surface].cell.value;
    return numbers_.try_emplace(name, static_cast<int>(numbers_.size())).first->second;
  }

  // The second subdivision: chains of faces of the tetrahedron.
  void add_tetrahedron(CurveUseId u, unsigned end) {
    std::array<int, 16> simplices{};
    for (unsigned corners = 1; corners < 16; ++corners)
      simplices[corners] = simplex_of({u, end}, corners);
    for (unsigned a = 0; a < 4; ++a)
      for (unsigned b = 0; b < 4; ++b)
        for (unsigned c = 0; c < 4; ++c) {
          if (a == b || b == c || a == c) continue;
          const unsigned one = 1u << a, two = one | 1u << b, three = two | 1u << c;
          chains_.push_back({simplices[one], simplices[two], simplices[three], simplices[15]});
        }
  }

  const VComplexTables& t_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> numbers_;
  std::vector<std::vector<int>> chains_;
};

// Only disks and balls: the cones over the loops of a surface, or over the boundary surfaces of a cell, would be joined.
bool has_balls_only(const VComplex& complex) {
  for (const HalfVSurfaceId h : complex.tables().half_surfaces)
    if (complex.half_surface(h).loops.size() != 1) return false;
  for (const VCellId c : complex.tables().cells) {
    const auto boundary = boundary_of_cell(complex, c);
    if (boundary.size() != 1 || boundary[0].genus() != 0) return false;
  }
  return true;
}

void expect_agreement(const VComplex& complex, const std::string& what) {
  ASSERT_TRUE(has_balls_only(complex)) << what;
  EXPECT_EQ(betti_numbers(complex).value(), Subdivision(complex).betti()) << what;
}

TEST(VComplexBetti, AgreeWithGudhiOnPolycubes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    std::vector<std::array<std::uint32_t, 3>> cubes;
    for (std::uint32_t n = 0; n < 18; ++n)
      if (random.below(5) < 3) cubes.push_back({n % 3, n / 3 % 3, n / 9});
    if (!cubes.empty())
      expect_agreement(v_shapes::complex_of(v_shapes::polycube(cubes)),
                       "seed " + std::to_string(seed));
  }
}

// Torsion in most of them, and points whose links are tori.
TEST(VComplexBetti, AgreeWithGudhiOnAllCubesGluedToThemselves) {
  constexpr std::array<std::uint32_t, 4> kTurns{0, 3, 6, 5};
  for (unsigned n = 0; n < 64; ++n) {
    std::vector<HexahedralCell> cells(1);
    for (unsigned axis = 0; axis < 3; ++axis)
      v_shapes::glue_faces(cells, 0, 2 * axis, 0, 2 * axis + 1, kTurns[n >> 2 * axis & 3]);
    expect_agreement(hexahedral_v_complex(cells).value().complex, "gluing " + std::to_string(n));
  }
}

TEST(VComplexBetti, AgreeWithGudhiAfterRandomEdits) {
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    VComplex complex;
    for (const v_edits::Step& step : v_edits::random_sequence(seed, 25))
      v_edits::apply(complex, step);
    if (!has_balls_only(complex) || complex.tables().uses.size() > 150) continue;
    ++compared;
    expect_agreement(complex, "seed " + std::to_string(seed));
  }
  EXPECT_GT(compared, 20u);
}

TEST(VComplexBetti, AgreeWithGudhiOnRandomCuboids) {
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    std::vector<HexahedralCell> cells(1 + random.below(3));
    const auto n = static_cast<std::uint32_t>(cells.size());
    for (std::uint32_t k = 0; k < 2 * n; ++k) {
      const auto any = [&](std::uint32_t bound) {
        return static_cast<std::uint32_t>(random.below(bound));
      };
      const std::uint32_t a = any(n), f = any(6), b = any(n), g = any(6);
      const auto is_free = [&](std::uint32_t c, std::uint32_t face) {
        return cells[c].faces[face].kind == HexahedralFace::Kind::kBoundary;
      };
      if (random.below(4) == 0 && is_free(a, f))
        cells[a].faces[f].kind = static_cast<HexahedralFace::Kind>(2 + any(3));
      if (is_free(a, f) && is_free(b, g) && (a != b || f != g))
        v_shapes::glue_faces(cells, a, f, b, g, any(8));
    }
    const auto made = hexahedral_v_complex(cells);
    if (!made || !has_balls_only(made.value().complex)) continue;
    ++compared;
    expect_agreement(made.value().complex, "seed " + std::to_string(seed));
  }
  EXPECT_GT(compared, 100u);
}

#else

TEST(VComplexBetti, AgreeWithGudhiOnPolycubes) { GTEST_SKIP() << "libgudhi-dev is not installed"; }

#endif

}  // namespace
}  // namespace veritope
