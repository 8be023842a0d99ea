// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/expression_points_certifier.h"

#include <gtest/gtest.h>

#include "models/round_parts.h"
#include "solids/patches/patch_transform.h"
#include "verify/format/claims.h"

namespace veritope {
namespace {

using enum PointWord;

TriangleMesh block(const Vec3d& lo, const Vec3d& hi) {
  TriangleMesh mesh;
  for (unsigned i = 0; i < 8; ++i)
    mesh.positions.push_back(
        {(i & 1u) != 0 ? hi.x : lo.x, (i & 2u) != 0 ? hi.y : lo.y, (i & 4u) != 0 ? hi.z : lo.z});
  mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {1, 3, 7}, {1, 7, 5}, {3, 2, 6}, {3, 6, 7}, {2, 0, 4}, {2, 4, 6}};
  return mesh;
}

ExactBox<3> exact_box(const Vec3d& lo, const Vec3d& hi) {
  ExactBox<3> out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = {Rational::from_double(lo[static_cast<int>(k)]),
              Rational::from_double(hi[static_cast<int>(k)])};
  return out;
}

ExpressionSolid solid(const Vec3d& lo, const Vec3d& hi) {
  ExpressionSolid out;
  out.operand = mesh_operand(block(lo, hi));
  out.box = exact_box(lo, hi);
  return out;
}

// 0: [0,1]^3. 1: [1,2] x [0,1]^2, which shares a face with it. 2: the box [-1,3]^3.
std::vector<ExpressionSolid> solids() {
  std::vector<ExpressionSolid> out;
  out.push_back(solid({0, 0, 0}, {1, 1, 1}));
  out.push_back(solid({1, 0, 0}, {2, 1, 1}));
  ExpressionSolid box;
  box.box = exact_box({-1, -1, -1}, {3, 3, 3});
  box.operand = box_operand(box.box);
  out.push_back(std::move(box));
  return out;
}

struct Certified {
  std::uint64_t num_uncovered = 0;
  certificate::PointsBody body;
  std::vector<int> codes;  // after what is said of the solids
};

Certified certify(const Formula& formula, const std::vector<Vec3d>& points,
                  const std::vector<PointWord>& words) {
  ExpressionPointsCertifier certifier(formula, solids(), 2, 1);
  certifier.add(points, {}, words);
  Certified out;
  out.num_uncovered = certifier.num_uncovered();
  certificate::Subject subject;
  subject.format = "chain";
  const certificate::Bytes bytes = certifier.finish(subject, {}).value();
  std::string why;
  const auto decoded = certificate::decode_certificate(bytes, why);
  EXPECT_TRUE(decoded) << why;
  EXPECT_EQ(decoded->claim->name, "points-1");
  out.body = std::get<certificate::PointsBody>(decoded->body);
  constexpr std::size_t kHeader =
      8 + 2 * 8;  // the number of uncovered points; F and V of two meshes
  out.codes.assign(out.body.codes.begin() + kHeader, out.body.codes.end());
  return out;
}

const Formula kLeft = Formula::variable(0), kRight = Formula::variable(1),
              kBox = Formula::variable(2);

TEST(ExpressionPointsCertifier, SaysHowManySolidsAndOperandsThereAre) {
  const Certified c = certify(Formula::any_of({kLeft, kRight}), {}, {});
  EXPECT_EQ(c.body.num_faces, 2u);  // without the box
  EXPECT_EQ(c.body.num_vertex_ids, 2u);
  EXPECT_EQ(c.body.num_points, 0u);
  const certificate::Bytes heads(c.body.codes.begin(), c.body.codes.end());
  EXPECT_EQ(heads, (certificate::Bytes{0, 0, 0, 0, 0,  0, 0, 0, 12, 0, 0, 0,
                                       8, 0, 0, 0, 12, 0, 0, 0, 8,  0, 0, 0}));
}

TEST(ExpressionPointsCertifier, HasNoCodeForSolidsWhoseBoxDoesNotHoldThePoint) {
  const Certified c =
      certify(Formula::any_of({kLeft, kRight}), {{5, 5, 5}, {1.5, .5, .25}}, {kOut, kIn});
  ASSERT_EQ(c.codes.size(), 1u);  // of the second point, about the second solid
  EXPECT_GE(c.codes[0], 6);
  EXPECT_LE(c.codes[0], 11);
  EXPECT_EQ(c.num_uncovered, 0u);
}

TEST(ExpressionPointsCertifier, StopsWhereAPartDecides) {
  // In [0,1]^3 the second solid is not asked for, in this order.
  const Certified c = certify(Formula::any_of({kLeft, kLeft}), {{.5, .25, .125}}, {kIn});
  EXPECT_EQ(c.codes.size(), 1u);
  // On the common face both are asked for, each once, and the box has no code.
  const Certified d =
      certify(Formula::all_of({kBox, Formula::any_of({kLeft, kRight, kLeft}).negated()}),
              {{1, .5, .25}}, {kOut});
  ASSERT_EQ(d.codes.size(), 4u);
  EXPECT_EQ(d.codes[0], 12);
  EXPECT_EQ(d.codes[2], 12);
  EXPECT_EQ(d.num_uncovered, 0u);
}

TEST(ExpressionPointsCertifier, SaysNothingOfUndecidedPoints) {
  const Certified c = certify(kLeft, {{.5, .5, .5}, {0, 0, 0}}, {kUndecided, kOn});
  ASSERT_EQ(c.codes.size(), 2u);
  EXPECT_EQ(c.codes[0], 12);
  EXPECT_EQ(c.body.num_points, 2u);
  EXPECT_EQ(c.num_uncovered, 0u);
}

// The number of points of two solids that are not covered.
std::uint64_t num_uncovered(const patch_shapes::Patches& a, const patch_shapes::Patches& b,
                            const std::vector<Vec3d>& points, const std::vector<PointWord>& words) {
  std::vector<ExpressionSolid> both;
  for (const auto* const shape : {&a, &b}) {
    ExpressionSolid next;
    next.operand =
        patch_operand(std::make_unique<const PatchComplex>(make_patch_complex(*shape).value()));
    next.box = exact_box({-4, -4, -4}, {4, 4, 4});
    both.push_back(std::move(next));
  }
  ExpressionPointsCertifier certifier(Formula::any_of({kLeft, kRight}), std::move(both), 2, 1);
  certifier.add(points, {}, words);
  return certifier.num_uncovered();
}

// PROVES POINT-7.P
TEST(ExpressionPointsCertifier, CoversCentresOfDiscsButNoCurvedPoles) {
  const patch_shapes::Patches cylinder = patch_shapes::disc_cylinder(1),
                              on_it = patch_shapes::placed(cylinder, 1, {0, 0, 1}),
                              beside = patch_shapes::placed(cylinder, 1, {Rational(1) / 2, 0, 1}),
                              ball = patch_shapes::octant_sphere();
  EXPECT_EQ(num_uncovered(cylinder, on_it, {{0, 0, 1}, {.25, 0, 1}}, {kIn, kIn}), 0u);
  EXPECT_EQ(num_uncovered(cylinder, beside, {{0, 0, 1}, {.5, 0, 1}}, {kIn, kIn}), 0u);
  EXPECT_EQ(num_uncovered(cylinder, subdivided(on_it), {{0, 0, 1}, {0, .25, 1}}, {kIn, kIn}), 0u);
  // The ball touches the cylinder's end from inside, in points of both.
  EXPECT_EQ(num_uncovered(ball, cylinder, {{0, 0, 1}}, {kOn}), 1u);
}

TEST(ExpressionPointsCertifier, TakesPointsThatBinary64DoesNotHave) {
  const ExactPoint third{Rational(Integer(1), Integer(3)), Rational(Integer(1), Integer(3)),
                         Rational(1)};
  ExpressionPointsCertifier certifier(kLeft, solids(), 1, 1);
  const std::vector<Vec3d> points = {{1 / 3., 1 / 3., 1}, {.5, .5, .5}};
  const std::vector<std::pair<std::size_t, ExactPoint>> exact = {{0, third}};
  certifier.add(points, exact, std::vector<PointWord>{kOn, kIn});
  certificate::Subject subject;
  subject.format = "chain";
  std::string why;
  const auto decoded = certificate::decode_certificate(certifier.finish(subject, {}).value(), why);
  ASSERT_TRUE(decoded) << why;
  EXPECT_EQ(std::get<certificate::PointsBody>(decoded->body).codes[24], 12);
}

}  // namespace
}  // namespace veritope
