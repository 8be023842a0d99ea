// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/expression_classifier.h"

#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeedOfExpressions = 20261128;

using Solids = std::vector<std::shared_ptr<const Operand>>;

std::shared_ptr<const Operand> mesh(const std::string& text) {
  return mesh_operand(shapes::parse(text));
}
std::unique_ptr<const Operand> block(int x0, int y0, int z0, int x1, int y1, int z1) {
  return box_operand({{ExactInterval{x0, x1}, ExactInterval{y0, y1}, ExactInterval{z0, z1}}});
}
Formula variable(std::uint32_t i) { return Formula::variable(i); }
Formula either(const Formula& a, const Formula& b) { return Formula::any_of({a, b}); }
Formula both(const Formula& a, const Formula& b) { return Formula::all_of({a, b}); }

const char* name(PointWord word) {
  constexpr const char* kNames[] = {"in", "on", "out", "undecided"};
  return kNames[static_cast<std::size_t>(word)];
}
std::string word(const Formula& f, const Solids& solids, const Vec3d& p) {
  const ExpressionClassifier c(f, solids);
  const PointWord exact = c.classify(ExactPoint{
      Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)});
  EXPECT_EQ(exact, c.classify(p));
  return name(exact);
}
// The words for union, intersection, difference and the other difference.
std::string words(const Solids& solids, const Vec3d& p) {
  const Formula a = variable(0), b = variable(1);
  return word(either(a, b), solids, p) + " " + word(both(a, b), solids, p) + " " +
         word(both(a, b.negated()), solids, p) + " " + word(both(b, a.negated()), solids, p);
}

// PROVES POINT-6, POINT-6.D1
TEST(ExpressionClassifier, DecidesWallsThatTwoBlocksShare) {
  const Solids apart = {mesh("box 0,0,0 1,1,1"), mesh("box 1,0,0 2,1,1")};
  EXPECT_EQ(words(apart, {1, .5, .5}), "in out on on");
  EXPECT_EQ(words(apart, {1, 0, .5}), "on out on on");
  EXPECT_EQ(words(apart, {1, 1, 1}), "on out on on");
  EXPECT_EQ(words(apart, {.5, .5, .5}), "in out in out");
  const Solids nested = {mesh("box 0,0,0 2,2,2"),
                         mesh("box 0,0,0 1,1,1")};  // on the same sides of shared walls
  EXPECT_EQ(words(nested, {0, .5, .5}), "on on out out");
  EXPECT_EQ(words(nested, {0, 0, 0}), "on on out out");
  EXPECT_EQ(words(nested, {1, 1, 1}), "in on on out");
  EXPECT_EQ(words(nested, {0, 1, .5}), "on on on out");
  const Solids touching = {mesh("box 0,0,0 1,1,1"), mesh("box 1,1,0 2,2,1")};  // in an edge
  EXPECT_EQ(words(touching, {1, 1, .5}), "on out on on");
  const Solids corners = {mesh("box 0,0,0 1,1,1"), mesh("box 1,1,1 2,2,2")};
  EXPECT_EQ(words(corners, {1, 1, 1}), "on out on on");
}

// PROVES POINT-6.D2
TEST(ExpressionClassifier, IsOnWhereOneOperandMatters) {
  const Solids solids = {mesh("box 0,0,0 4,4,4"), mesh("box 1,1,1 2,2,2"), mesh("box 2,1,1 3,2,2")};
  const Formula a = variable(0), b = variable(1), c = variable(2);
  EXPECT_EQ(word(either(a, b), solids, {1, 1.5, 1.5}), "in");
  EXPECT_EQ(word(both(a, b), solids, {1, 1.5, 1.5}), "on");
  EXPECT_EQ(word(both(a, b.negated()), solids, {1, 1, 1}), "on");
  // On the wall of b and c, and F does not depend on c.
  EXPECT_EQ(word(either(both(b, c), both(b, c.negated())), solids, {2, 1.5, 1.5}), "on");
  EXPECT_EQ(word(both(a, either(b, c)), solids, {2, 1.5, 1.5}), "in");
}

TEST(ExpressionClassifier, TakesEqualOperandsForOne) {
  const Solids solids = {mesh("tet 0,0,0 1,0,0 0,1,0 0,0,1")};
  const Formula nothing = both(variable(0), variable(0).negated());
  for (const Vec3d& p : {Vec3d{0, 0, 0}, Vec3d{.25, .25, 0}, Vec3d{.5, .5, 0}, Vec3d{.1, .1, .1}}) {
    EXPECT_EQ(word(nothing, solids, p), "out");
    EXPECT_EQ(word(nothing.negated(), solids, p), "in");
  }
  // Two descriptions of one solid are decided by their sectors.
  const Solids twice = {mesh_operand(shapes::box({0, 0, 0}, {1, 1, 1}, 1)),
                        mesh_operand(shapes::box({0, 0, 0}, {1, 1, 1}, 4))};
  for (const Vec3d& p :
       {Vec3d{0, 0, 0}, Vec3d{0, .25, .5}, Vec3d{0, .3, .7}, Vec3d{1, .25, .25}, Vec3d{.5, .5, 1}})
    EXPECT_EQ(words(twice, p), "on on out out");
}

// Complements in a box: its sides are walls.
TEST(ExpressionClassifier, DecidesComplementsOnTheSidesOfTheirBox) {
  const Solids solids = {mesh("box 0,0,0 1,1,1"), block(-1, -1, -1, 2, 2, 2)};
  const Formula complement = both(variable(1), variable(0).negated());
  EXPECT_EQ(word(complement, solids, {0, .5, .5}), "on");
  EXPECT_EQ(word(complement, solids, {-1, 0, 0}), "on");
  EXPECT_EQ(word(complement, solids, {2, 2, 2}), "on");
  EXPECT_EQ(word(complement, solids, {-.5, .5, .5}), "in");
  EXPECT_EQ(word(complement, solids, {.5, .5, .5}), "out");
  EXPECT_EQ(word(complement, solids, {3, 0, 0}), "out");
  EXPECT_EQ(word(either(complement, variable(0)), solids, {0, .5, .5}), "in");
  EXPECT_EQ(word(either(complement, variable(0)), solids, {2, .5, .5}), "on");
}

// Six wedges around a line, and tetrahedra around a point: unions without walls, in any number.
// PROVES POINT-6.D3
TEST(ExpressionClassifier, DecidesManyWedgesAroundALineAndAPoint) {
  const std::vector<Vec3d> rim = {{2, 0, 0},  {1, 2, 0},   {-1, 2, 0},
                                  {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}};
  Solids solids;
  std::vector<Formula> all;
  const auto text = [](const Vec3d& p) {
    return std::to_string(p.x) + "," + std::to_string(p.y) + "," + std::to_string(p.z) + " ";
  };
  for (std::size_t i = 0; i < 6; ++i)
    for (const char* tip : {"0,0,3", "0,0,-3"}) {
      const Vec3d &a = rim[i], &b = rim[(i + 1) % 6];
      const bool is_up = tip[4] != '-';
      solids.push_back(mesh("tet 0,0,0 " + text(is_up ? a : b) + text(is_up ? b : a) + tip));
      all.push_back(variable(static_cast<std::uint32_t>(all.size())));
    }
  EXPECT_EQ(word(Formula::any_of(all), solids, {0, 0, 0}), "in");
  EXPECT_EQ(word(Formula::any_of(all), solids, {0, 0, 1}), "in");
  EXPECT_EQ(word(Formula::any_of(all), solids, {.5, 0, .5}), "in");
  EXPECT_EQ(word(Formula::any_of(all), solids, {0, 0, 3}), "on");
  EXPECT_EQ(word(Formula::any_of(all), solids, {2, 0, 0}), "on");
  EXPECT_EQ(word(Formula::all_of(all), solids, {0, 0, 0}), "out");
  for (std::size_t left_out = 0; left_out < all.size(); ++left_out) {
    std::vector<Formula> rest = all;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
    EXPECT_EQ(word(Formula::any_of(rest), solids, {0, 0, 0}), "on") << left_out;
  }
}

// A knife edge between two operands: the blade misses every direction on the planes, and all sample points of a grid.
TEST(ExpressionClassifier, SeesSliversBetweenWalls) {
  const Solids solids = {mesh("tet 0,0,0 1,0,0 0,1,0 0,0,1"),
                         mesh("tet 0,0,0 1,0x1p-60,0 0,1,0 0,0,1")};
  const Formula sliver = both(variable(0), variable(1).negated());
  EXPECT_EQ(word(sliver, solids, {0, 0, 0}), "on");
  EXPECT_EQ(word(either(variable(0), variable(1)), solids, {0, 0, 0}), "on");
}

class NotFlat : public Operand {
 public:
  explicit NotFlat(std::shared_ptr<const Operand> solid) : solid_(std::move(solid)) {}
  OperandPlace place(const Vec3d& p) const override { return solid_->place(p); }
  OperandPlace place(const ExactPoint& p) const override { return solid_->place(p); }
  Value3 value(const Vec3d& p) const override { return solid_->value(p); }
  Value3 value(const ExactPoint& p) const override { return solid_->value(p); }
  Value3 value(const Box3d& b) const override { return solid_->value(b); }
  std::optional<TangentCone> tangent_cone(const ExactPoint&, const OperandPlace&) const override {
    return std::nullopt;
  }
  ExactBox<3> box() const override { return solid_->box(); }

 private:
  std::shared_ptr<const Operand> solid_;
};

TEST(ExpressionClassifier, IsUndecidedOnlyWhereAnOperandThatMattersIsNotFlat) {
  const Solids solids = {mesh("box 0,0,0 1,1,1"),
                         std::make_shared<NotFlat>(mesh("box 1,0,0 2,1,1"))};
  EXPECT_EQ(words(solids, {1, .5, .5}), "undecided undecided undecided undecided");
  EXPECT_EQ(words(solids, {2, .5, .5}), "on out out on");
  const Formula a = variable(0), b = variable(1);
  EXPECT_EQ(word(either(both(a, b), both(a, b.negated())), solids, {1, .5, .5}), "on");
  EXPECT_EQ(word(both(b, b.negated()), solids, {1, .5, .5}), "out");
}

std::shared_ptr<const Operand> patches(patch_shapes::Patches shape) {
  return patch_operand(std::make_unique<const PatchComplex>(make_patch_complex(shape).value()));
}

// PROVES POINT-7
TEST(ExpressionClassifier, DecidesCurvedWallsThatCross) {
  const Solids ball_and_block = {patches(patch_shapes::octant_sphere()), block(0, -2, -2, 2, 2, 2)};
  const auto at = [&](const Solids& solids, const ExactPoint& p) {
    const Formula a = variable(0), b = variable(1);
    std::string out;
    for (const Formula& f : {either(a, b), both(a, b), both(a, b.negated()), both(b, a.negated())})
      out +=
          std::string(out.empty() ? "" : " ") + name(ExpressionClassifier(f, solids).classify(p));
    return out;
  };
  const auto r = [](int p, int q) { return Rational(p) / Rational(q); };
  EXPECT_EQ(at(ball_and_block, {0, r(3, 5), r(4, 5)}), "on on on on");  // the face cuts the sphere
  EXPECT_EQ(at(ball_and_block, {r(1, 3), r(2, 3), r(2, 3)}), "in on out on");
  EXPECT_EQ(at(ball_and_block, {0, r(1, 2), 0}), "in on on out");
  EXPECT_EQ(at(ball_and_block, {1, 0, 0}), "in on out on");
  // Tangent: the difference is on, the others are open.
  const Solids tangent = {patches(patch_shapes::sphere()), block(-2, -2, 1, 2, 2, 2)};
  EXPECT_EQ(at(tangent, {0, 0, 1}), "undecided undecided on on");
  // Two cylinders, one on the other: flat ends, at irrational parameters, too.
  const Solids stacked = {
      patches(patch_shapes::frustum(1, 1, 2)),
      patches(patch_shapes::placed(patch_shapes::frustum(1, 1, 2), 1, {0, 0, 2}))};
  EXPECT_EQ(at(stacked, {r(1, 4), r(1, 2), 2}), "in out on on");
  EXPECT_EQ(at(stacked, {0, 0, 2}), "in out on on");
  EXPECT_EQ(at(stacked, {r(3, 5), r(4, 5), 2}), "on out on on");  // on both rims
  EXPECT_EQ(at(stacked, {r(3, 5), r(4, 5), 1}), "on out on out");
  EXPECT_EQ(at(stacked, {0, 0, 1}), "in out in out");
  // A cylinder through a ball: transversal, but at no rational parameters of both; both values occur.
  const Solids crossing = {
      patches(patch_shapes::octant_sphere()),
      patches(patch_shapes::placed(patch_shapes::frustum(1, 1, 2), r(3, 5), {0, 0, r(-3, 5)}))};
  EXPECT_EQ(at(crossing, {r(3, 5), 0, r(3, 5)}), "in on on out");
  EXPECT_EQ(at(crossing, {0, 0, r(3, 5)}), "in on on out");
}

// z = +-(1 - x^2)^2 over [-1, 1] x [0, 1], with flat ends: along x = +-1 both sheets have one tangent plane.
patch_shapes::Patches sharp_lens() {
  patch_shapes::Patches out;
  const Rational top[5] = {0, 0, Rational(8) / Rational(3), 0, 0};
  const auto x = [](std::size_t i) {
    return Rational(static_cast<std::int64_t>(i)) / Rational(2) - Rational(1);
  };
  for (const int side : {1, -1}) {
    Patch::Tensor sheet({4, 1}, 3, false), end({4, 1}, 3, false);
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        const std::size_t at = 2 * i + j;
        sheet.component(0)[at] = end.component(0)[at] = x(i);
        sheet.component(1)[at] = Rational((j == 0) == (side > 0) ? 0 : 1);
        sheet.component(2)[at] = Rational(side) * top[i];
        end.component(1)[at] = Rational(side > 0 ? 0 : 1);
        end.component(2)[at] = Rational((j == 0) == (side > 0) ? -1 : 1) * top[i];
      }
    out.push_back(make_patch(std::move(sheet)).value());
    out.push_back(make_patch(std::move(end)).value());
  }
  return out;
}

TEST(ExpressionClassifier, IsUndecidedAtEdgesWithoutAnAngle) {
  ASSERT_TRUE(make_patch_complex(sharp_lens()).value().is_closed_oriented_surface());
  const Solids solids = {patches(sharp_lens()), block(1, -1, -1, 3, 2, 1)};
  const Rational half = Rational(1) / Rational(2);
  const auto at = [&](const Formula& f, const ExactPoint& p) {
    return std::string(name(ExpressionClassifier(f, solids).classify(p)));
  };
  // In truth the intersection misses the point, whose tangent cone is that of an edge of 360 degrees, too.
  EXPECT_EQ(at(both(variable(0), variable(1)), {1, half, 0}), "undecided");
  EXPECT_EQ(at(either(variable(0), variable(1)), {1, half, 0}), "undecided");
  EXPECT_EQ(at(variable(0), {1, half, 0}), "on");
  EXPECT_EQ(at(both(variable(0), variable(1)), {0, half, 0}), "out");
  EXPECT_EQ(at(variable(0), {0, half, half}), "in");
}

TEST(ExpressionClassifier, HasTheValueOfBoxes) {
  const ExpressionClassifier c(both(variable(0), variable(1).negated()),
                               {mesh("box 0,0,0 4,4,4"), mesh("box 2,2,2 6,6,6")});
  EXPECT_EQ(c.value(Box3d{{.5, .5, .5}, {1.5, 1.5, 1.5}}), Value3::kOne);
  EXPECT_EQ(c.value(Box3d{{2.5, 2.5, 2.5}, {3, 3, 3}}), Value3::kZero);
  EXPECT_EQ(c.value(Box3d{{7, 0, 0}, {8, 1, 1}}), Value3::kZero);
  EXPECT_EQ(c.value(Box3d{{3, 3, 3}, {5, 5, 5}}), Value3::kZero);  // in the subtrahend
  EXPECT_EQ(c.value(Box3d{{1, 1, 1}, {3, 3, 3}}), Value3::kMixed);
}

// ---- polycubes: all walls lie in planes of the lattice, so that the eight octants around a point decide

struct Cells {
  std::vector<std::array<int, 3>> cells;
  bool holds(const std::array<double, 3>& p) const {
    for (const auto& c : cells)
      if (c[0] < p[0] && p[0] < c[0] + 1 && c[1] < p[1] && p[1] < c[1] + 1 && c[2] < p[2] &&
          p[2] < c[2] + 1)
        return true;
    return false;
  }
};

// Boxes of cells, which are solids whatever their size; equal ones, shared walls and edges are frequent.
Cells random_block(Random& random) {
  std::array<int, 3> lo{}, size{};
  for (std::size_t k = 0; k < 3; ++k) {
    lo[k] = static_cast<int>(random.below(3));
    size[k] = 1 + static_cast<int>(random.below(2));
  }
  Cells out;
  for (int i = 0; i < size[0]; ++i)
    for (int j = 0; j < size[1]; ++j)
      for (int k = 0; k < size[2]; ++k) out.cells.push_back({lo[0] + i, lo[1] + j, lo[2] + k});
  return out;
}

Formula random_expression(Random& random, std::size_t num_solids, int depth) {
  if (depth == 0 || random.below(6) == 0)
    return variable(static_cast<std::uint32_t>(random.below(num_solids)));
  const Formula a = random_expression(random, num_solids, depth - 1),
                b = random_expression(random, num_solids, depth - 1);
  switch (random.below(3)) {
    case 0: return either(a, b);
    case 1: return both(a, b);
    default: return both(a, b.negated());
  }
}

std::string word_by_octants(const Formula& f, const std::vector<Cells>& solids, const Vec3d& p) {
  int num_in = 0;
  for (int octant = 0; octant < 8; ++octant) {
    std::array<double, 3> q{};
    for (int k = 0; k < 3; ++k)
      q[static_cast<std::size_t>(k)] = p[k] + ((octant >> k & 1) != 0 ? 1 : -1) * 0x1p-10;
    num_in += f.value([&](std::uint32_t v) { return to_value(solids[v].holds(q)); }) == Value3::kOne
                  ? 1
                  : 0;
  }
  return num_in == 8 ? "in" : num_in == 0 ? "out" : "on";
}

TEST(ExpressionClassifier, AgreesWithOctantsOnSumsOfCubes) {
  Random random(kSeedOfExpressions);
  for (int i = 0; i < scaled(60); ++i) {
    std::vector<Cells> cells;
    Solids solids;
    for (std::uint64_t n = 2 + random.below(5); n > 0; --n) {
      cells.push_back(random_block(random));
      const auto& [lo, hi] = std::pair(cells.back().cells.front(), cells.back().cells.back());
      solids.push_back(random.below(2) != 0
                           ? mesh_operand(shapes::polycube(cells.back().cells))
                           : block(lo[0], lo[1], lo[2], hi[0] + 1, hi[1] + 1, hi[2] + 1));
    }
    const Formula f = random_expression(random, cells.size(), 4);
    const ExpressionClassifier c(f, solids);
    std::vector<Vec3d> points;
    for (int k = 0; k < 60; ++k) {
      const auto at = [&] { return static_cast<double>(random.below(21)) / 4 - .25; };
      points.push_back({at(), at(), at()});
    }
    std::vector<PointWord> all(points.size());
    c.classify(points, all, 2);
    for (std::size_t k = 0; k < points.size(); ++k)
      ASSERT_EQ(name(all[k]), word_by_octants(f, cells, points[k]))
          << "seed " << kSeedOfExpressions << " expression " << i << " " << f.to_string()
          << " point " << points[k].x << "," << points[k].y << "," << points[k].z;
  }
}

TEST(FormulaCells, FoldLongFormulasWithoutAChangeOfWords) {
  Random random(kSeedOfExpressions + 2);
  for (int i = 0; i < scaled(6); ++i) {
    std::vector<Cells> cells;
    Solids solids;
    for (int n = 0; n < 12; ++n) {
      cells.push_back(random_block(random));
      solids.push_back(mesh_operand(shapes::polycube(cells.back().cells)));
    }
    std::vector<Formula> parts;
    for (int n = 0; n < 12; ++n) parts.push_back(random_expression(random, cells.size(), 3));
    const Formula f = i % 2 == 0 ? Formula::any_of(parts)
                                 : Formula::any_of({Formula::all_of(parts), parts[0], parts[3]});
    const FormulaCells tree(f, solids);
    EXPECT_GT(tree.num_cells(), 1u);
    EXPECT_LE(tree.num_cells(), FormulaCells::kMostCells);
    const ExpressionClassifier c(f, solids);
    std::size_t literals = 0;
    for (int k = 0; k < 500; ++k) {
      const auto at = [&] { return static_cast<double>(random.below(28)) / 4 - .75; };
      const Vec3d p{at(), at(), at()};
      ASSERT_EQ(name(c.classify(p)), word_by_octants(f, cells, p))
          << "seed " << kSeedOfExpressions + 2 << " expression " << i << " " << f.to_string()
          << " point " << p.x << "," << p.y << "," << p.z;
      const ExactPoint q = {Rational::from_double(p.x), Rational::from_double(p.y),
                            Rational::from_double(p.z)};
      ASSERT_EQ(&tree.at(p), &tree.at(q));
      literals += tree.at(p).num_literals();
      ASSERT_EQ(c.classify(q), c.classify(p));
    }
    EXPECT_LT(literals, 500 * 12u);  // those of cells that need no more halvings
  }
}

// Two solids in a formula of depth 1,000: its short form has one cell.
TEST(FormulaCells, ShortenLongFormulasOfFewSolids) {
  const Solids solids = {mesh("box 0,0,0 1,1,1"), block(-1, -1, -1, 2, 2, 2)};
  Formula f = variable(0);
  for (int i = 0; i < 1000; ++i) f = both(variable(1), f.negated());
  const FormulaCells tree(f, solids);
  EXPECT_EQ(tree.num_cells(), 1u);
  EXPECT_LE(tree.at(Vec3d{0, 0, 0}).num_literals(), 2u);
  EXPECT_EQ(word(f, solids, {0, .5, .5}), "on");
  EXPECT_EQ(word(f, solids, {.5, .5, .5}), "in");
  EXPECT_EQ(word(f, solids, {2, 2, 2}), "out");
}

TEST(FormulaCells, AreConstantOutsideOfTheSolids) {
  const Solids solids = {mesh("box 0,0,0 1,1,1"), mesh("box 1,0,0 2,1,1")};
  const FormulaCells tree(either(variable(0), variable(1)).negated(), solids);
  EXPECT_EQ(tree.num_cells(), 1u);
  EXPECT_EQ(tree.at(Vec3d{3, 0, 0}), Formula::constant(true));
  EXPECT_EQ(
      tree.at(ExactPoint{Rational(2) + Rational::power_of_two(-99), Rational(0), Rational(0)}),
      Formula::constant(true));
  EXPECT_EQ(tree.at(Vec3d{2, 1, 1}).to_string(), "!x0 & !x1");
}

// ---- laws, on walls and off them

Vec3d random_place(const std::vector<TriangleMesh>& meshes, Random& random) {
  const TriangleMesh& m = meshes[random.below(meshes.size())];
  const auto& t = m.faces[random.below(m.faces.size())];
  const Vec3d &a = m.positions[t[0]], &b = m.positions[t[1]], &c = m.positions[t[2]];
  switch (random.below(4)) {
    case 0: return a;
    case 1: return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    case 2:
      return {(2 * a.x + b.x + c.x) / 4, (2 * a.y + b.y + c.y) / 4, (2 * a.z + b.z + c.z) / 4};
    default: return {random.unit() * 4 - 1, random.unit() * 4 - 1, random.unit() * 4 - 1};
  }
}

// PROVES POINT-6
TEST(ExpressionClassifier, ObeysTheLawsOfSetsOnWallsToo) {
  Random random(kSeedOfExpressions + 1);
  for (int i = 0; i < scaled(40); ++i) {
    std::vector<TriangleMesh> meshes = {shapes::box({0, 0, 0}, {2, 2, 2}),
                                        shapes::box({1, 0, 0}, {3, 1, 1})};
    const auto step = [&] { return static_cast<double>(random.below(3)) - 1; };
    const Vec3d shift{step(), step(), step()};
    meshes.push_back(shapes::moved(
        random.below(2) != 0 ? shapes::bipyramid(4) : shapes::parse("tet 0,0,0 1,0,0 0,1,0 0,0,1"),
        shift));
    Solids solids;
    for (const TriangleMesh& m : meshes) solids.push_back(mesh_operand(m));
    solids.push_back(block(-9, -9, -9, 9, 9, 9));
    const Formula a = variable(0), b = variable(1), c = variable(2), box = variable(3);
    const auto complement = [&](const Formula& f) { return both(box, f.negated()); };
    const std::vector<std::pair<Formula, Formula>> laws = {
        {either(a, b), either(b, a)},
        {both(a, either(b, c)), either(both(a, b), both(a, c))},
        {either(a, both(b, c)), both(either(a, b), either(a, c))},
        {either(a, either(b, c)), either(either(a, b), c)},
        {both(a, both(b, c)), both(both(a, b), c)},
        {either(a, a), a},
        {complement(either(b, c)), both(complement(b), complement(c))},
        {complement(both(a, c)), either(complement(a), complement(c))},
        {complement(complement(b)), both(box, b)},
        {both(a, either(a, c)), a},
    };
    Solids cut = solids;  // one operand with other facets
    cut[i % 2] = mesh_operand(shapes::subdivided(meshes[i % 2]));
    for (int k = 0; k < 20; ++k) {
      const Vec3d p = random_place(meshes, random);
      for (const auto& [f, g] : laws)
        ASSERT_EQ(word(f, cut, p), word(f, solids, p))
            << "seed " << kSeedOfExpressions + 1 << " model " << i << " " << f.to_string();
      for (std::size_t law = 0; law < laws.size(); ++law)
        ASSERT_EQ(word(laws[law].first, solids, p), word(laws[law].second, solids, p))
            << "seed " << kSeedOfExpressions + 1 << " model " << i << " law " << law << " point "
            << p.x << "," << p.y << "," << p.z;
    }
  }
}

}  // namespace
}  // namespace veritope
