// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/volumes/primitives.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "tests/solids/volume_support.h"

namespace veritope {
namespace {

using volume_test::faces_of;
using volume_test::part_counts;
using volume_test::signs_of_jacobian;
using Counts = std::array<std::size_t, 5>;
using Poly = BezierSurface<Rational>;

Rational q(int p, int r = 1) { return Rational(Integer(p), Integer(r)); }
Poly operator*(const Poly& a, const Poly& b) { return multiplied(a, b); }
Poly operator+(const Poly& a, const Poly& b) { return sum(a, b); }
Poly operator-(const Poly& a, const Poly& b) { return difference(a, b); }
Poly constant(const Rational& x) { return {{0, 0}, 1, false, {x}}; }

void expect_regular_and_right_handed(const Cells& cells) {
  for (const CellVolume& cell : cells)
    EXPECT_EQ(signs_of_jacobian(cell), (std::array{1, 1})) << &cell - cells.data();
}

void expect_on(const CellSurface& face,
               const std::function<Poly(const std::vector<Poly>&)>& equation) {
  for (const auto& xyzw : volume_test::homogeneous_pieces(face))
    EXPECT_TRUE(volume_test::is_zero(equation(xyzw)));
}

TEST(VolumePrimitives, HaveTheCellsWallsEdgesAndCornersOfTheirFigures) {
  EXPECT_EQ(part_counts(box_cells({q(0), q(1), q(2)}, {q(1), q(3), q(7, 2)}).value()),
            (Counts{8, 12, 6, 0, 6}));
  EXPECT_EQ(part_counts(cylinder_cells(q(3), q(5, 7)).value()), (Counts{16, 32, 22, 8, 30}));
  EXPECT_EQ(part_counts(cone_cells(q(3), q(1, 2), q(4)).value()), (Counts{16, 32, 22, 8, 30}));
  EXPECT_EQ(part_counts(cone_cells(q(3), q(0), q(4)).value()), (Counts{9, 20, 17, 8, 25}));
  EXPECT_EQ(part_counts(torus_cells(q(3), q(1)).value()), (Counts{8, 20, 17, 13, 30}));
  EXPECT_EQ(part_counts(sphere_cells(q(2)).value()), (Counts{16, 32, 24, 18, 42}));
}

TEST(VolumePrimitives, HavePositiveCoefficientsOfTheJacobianNumerator) {
  expect_regular_and_right_handed(box_cells({q(-1), q(1), q(2)}, {q(1), q(3), q(7, 2)}).value());
  expect_regular_and_right_handed(cylinder_cells(q(3), q(5, 7)).value());
  expect_regular_and_right_handed(cone_cells(q(3), q(1, 100), q(4)).value());
  expect_regular_and_right_handed(cone_cells(q(1), q(50), q(4)).value());
  expect_regular_and_right_handed(torus_cells(q(3), q(1)).value());
  expect_regular_and_right_handed(torus_cells(q(1001), q(1000)).value());
  expect_regular_and_right_handed(sphere_cells(q(2)).value());
}

TEST(VolumePrimitives, OnlyTheApexOfAConeAndTheAxisOfOneCellAreSingular) {
  const Cells cone = cone_cells(q(3), q(0), q(4)).value();
  for (const CellVolume& cell : cone) EXPECT_EQ(signs_of_jacobian(cell), (std::array{0, 1}));
  for (const Cells& cells :
       {one_cell_cylinder(q(1), q(2)).value(), one_cell_sphere(q(3)).value()}) {
    ASSERT_EQ(cells.size(), 1u);
    EXPECT_EQ(signs_of_jacobian(cells[0]), (std::array{0, 1}));
  }
  EXPECT_EQ(part_counts(one_cell_cylinder(q(1), q(2)).value()), (Counts{4, 6, 4, 1, 5}));
  EXPECT_EQ(part_counts(one_cell_sphere(q(1)).value()), (Counts{2, 2, 2, 1, 3}));
}

TEST(VolumePrimitives, SatisfyTheirEquationsAsPolynomialIdentities) {
  std::mt19937_64 random(2101);
  for (int loop = 0; loop < 12; ++loop) {
    const auto draw = [&] {
      return q(1 + static_cast<int>(random() % 1000), 1 + static_cast<int>(random() % 97));
    };
    const Rational r = draw(), h = draw(), b = draw(), t = loop == 0 ? q(0) : draw(), more = draw();
    SCOPED_TRACE("loop " + std::to_string(loop) + " r " + r.to_string() + " h " + h.to_string() +
                 " b " + b.to_string() + " t " + t.to_string());
    const Cells cylinder = cylinder_cells(r, h).value(), cone = cone_cells(b, t, h).value(),
                torus = torus_cells(r + more, r).value(), sphere = sphere_cells(r).value();
    for (std::size_t i = 1; i < 5; ++i) {
      expect_on(faces_of(cylinder[i])[1].surface, [&](const auto& p) {
        return p[0] * p[0] + p[1] * p[1] - constant(r * r) * p[3] * p[3];
      });
      expect_on(faces_of(cone[i])[1].surface, [&](const auto& p) {
        const Poly radius = constant(b * h) * p[3] + constant(t - b) * p[2];
        return constant(h * h) * (p[0] * p[0] + p[1] * p[1]) - radius * radius;
      });
      expect_on(faces_of(torus[i])[3].surface, [&](const auto& p) {
        const Rational major = r + more;
        const Poly flat = p[0] * p[0] + p[1] * p[1], ww = p[3] * p[3];
        const Poly left = flat + p[2] * p[2] + constant(major * major - r * r) * ww;
        return left * left - constant(q(4) * major * major) * flat * ww;
      });
    }
    for (std::size_t i = 1; i < 7; ++i)
      expect_on(faces_of(sphere[i])[5].surface, [&](const auto& p) {
        return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - constant(r * r) * p[3] * p[3];
      });
  }
}

TEST(VolumePrimitives, LieWhereTheirPagesSay) {
  const auto corner = [](const CellVolume& cell, std::size_t u, std::size_t v, std::size_t w) {
    const std::array<std::size_t, 3> end = {u, v, w};
    std::array<Rational, 3> at;
    for (std::size_t a = 0; a < 3; ++a)
      at[a] = end[a] == 0 ? cell.axis(a).domain_begin() : cell.axis(a).domain_end();
    return point(cell, at).value();
  };
  using P = std::vector<Rational>;
  const Cells cylinder = cylinder_cells(q(2), q(5)).value();
  EXPECT_EQ(corner(cylinder[1], 1, 0, 0), (P{q(2), q(0), q(0)}));
  EXPECT_EQ(corner(cylinder[1], 1, 1, 1), (P{q(0), q(2), q(5)}));
  EXPECT_EQ(corner(cylinder[4], 1, 1, 0), (P{q(2), q(0), q(0)}));
  const Cells cone = cone_cells(q(2), q(0), q(5)).value();
  for (const CellVolume& cell : cone) EXPECT_EQ(corner(cell, 0, 1, 1), (P{q(0), q(0), q(5)}));
  const Cells torus = torus_cells(q(3), q(1)).value();
  EXPECT_EQ(corner(torus[1], 0, 1, 0), (P{q(4), q(0), q(0)}));
  EXPECT_EQ(corner(torus[1], 1, 1, 1), (P{q(3), q(0), q(1)}));
  const Cells sphere = sphere_cells(q(1)).value();
  EXPECT_EQ(corner(sphere[0], 1, 1, 1), (P{q(1, 2), q(1, 2), q(1, 2)}));
  const auto outer = [](const CellVolume& cell) {
    return point(cell, {q(1, 2), q(1, 2), q(1)}).value();
  };
  EXPECT_EQ(outer(sphere[1]), (P{q(0), q(0), q(-1)}));
  EXPECT_EQ(outer(sphere[2]), (P{q(0), q(0), q(1)}));
  EXPECT_EQ(outer(sphere[3])[1], q(0));
  EXPECT_GT(outer(sphere[3])[0], q(9, 10));
  EXPECT_GT(outer(sphere[4])[1], q(9, 10));
  EXPECT_LT(outer(sphere[5])[0], q(-9, 10));
  EXPECT_LT(outer(sphere[6])[1], q(-9, 10));
}

TEST(VolumePrimitives, RefuseWrongParametersByName) {
  const auto sentence = [](const Result<Cells>& cells) {
    return cells ? std::string("built") : cells.error().message;
  };
  EXPECT_EQ(sentence(box_cells({q(0), q(0), q(0)}, {q(1), q(0), q(1)})),
            "min must be less than max, and in y they are 0 and 0");
  EXPECT_EQ(sentence(cylinder_cells(q(0), q(1))), "radius must be positive, not 0");
  EXPECT_EQ(sentence(cylinder_cells(q(1), q(-1))), "height must be positive, not -1");
  EXPECT_EQ(sentence(cone_cells(q(0), q(1), q(1))), "bottom must be positive, not 0");
  EXPECT_EQ(sentence(cone_cells(q(1), q(-1), q(1))), "top must not be negative, and it is -1");
  EXPECT_EQ(sentence(cone_cells(q(1), q(1), q(0))), "height must be positive, not 0");
  EXPECT_EQ(sentence(torus_cells(q(1), q(1))),
            "minor must be less than major, and they are 1 and 1");
  EXPECT_EQ(sentence(torus_cells(q(1), q(0))), "minor must be positive, not 0");
  EXPECT_EQ(sentence(sphere_cells(q(-1, 2))), "radius must be positive, not -1/2");
  EXPECT_EQ(sentence(one_cell_sphere(q(0))), "radius must be positive, not 0");
  EXPECT_EQ(sentence(one_cell_cylinder(q(1), q(0))), "height must be positive, not 0");
}

}  // namespace
}  // namespace veritope
