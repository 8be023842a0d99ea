// SPDX-License-Identifier: LGPL-3.0-or-later
// Words where curved walls of several operands abut or touch.
#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "models/round_parts.h"
#include "robust/base/random.h"
#include "solids/expression/expression_classifier.h"
#include "solids/patches/patch_transform.h"
#include "splines/bezier_triangle.h"
#include "splines/de_casteljau.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using patch_shapes::Patches;
using Solids = std::vector<std::shared_ptr<const Operand>>;

constexpr std::uint64_t kSeedOfCurvedWalls = 20261127;

Rational ratio(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

std::shared_ptr<const Operand> solid(const Patches& shape) {
  auto complex = make_patch_complex(shape).value();
  EXPECT_TRUE(complex.is_closed_oriented_surface());
  return patch_operand(std::make_unique<const PatchComplex>(std::move(complex)));
}
std::shared_ptr<const Operand> block(const PatchPoint& lo, const PatchPoint& hi) {
  ExactBox<3> box;
  for (std::size_t k = 0; k < 3; ++k) box[k] = {lo[k], hi[k]};
  return box_operand(box);
}

std::string word(const Formula& f, const Solids& solids, const ExactPoint& p) {
  constexpr const char* kNames[] = {"in", "on", "out", "undecided"};
  return kNames[static_cast<std::size_t>(ExpressionClassifier(f, solids).classify(p))];
}
// The words for union, intersection, difference and the other difference.
std::string words(const Solids& solids, const ExactPoint& p) {
  const Formula a = Formula::variable(0), b = Formula::variable(1);
  std::string out;
  for (const Formula& f : {Formula::any_of({a, b}), Formula::all_of({a, b}),
                           Formula::all_of({a, b.negated()}), Formula::all_of({b, a.negated()})})
    out += (out.empty() ? "" : " ") + word(f, solids, p);
  return out;
}

std::string text(const ExactPoint& p) {
  return p[0].to_string() + "," + p[1].to_string() + "," + p[2].to_string();
}

// PROVES POINT-8, POINT-8.T
TEST(CurvedWalls, AbutAlongCommonRims) {
  const Patches tall = patch_shapes::frustum(1, 1, 2);
  const Solids stacked = {solid(tall), solid(patch_shapes::placed(tall, 1, {0, 0, 2}))};
  EXPECT_EQ(words(stacked, {ratio(3, 5), ratio(4, 5), 2}), "on out on on");
  EXPECT_EQ(words(stacked, {1, 0, 2}), "on out on on");  // a vertex of both
  EXPECT_EQ(words(stacked, {0, 0, 2}), "in out on on");
  // A cylinder on a block: the rim lies in a face.
  const Solids standing = {solid(tall), block({-2, -2, -1}, {2, 2, 0})};
  EXPECT_EQ(words(standing, {ratio(3, 5), ratio(4, 5), 0}), "on out on on");
  EXPECT_EQ(words(standing, {-1, 0, 0}), "on out on on");
  EXPECT_EQ(words(standing, {ratio(1, 5), ratio(1, 3), 0}), "in out on on");
  // A cylinder in a block, both ends in its faces.
  const Solids inside = {solid(tall), block({-2, -2, 0}, {2, 2, 2})};
  EXPECT_EQ(words(inside, {ratio(3, 5), ratio(4, 5), 0}), "on on out on");
  EXPECT_EQ(words(inside, {ratio(3, 5), ratio(4, 5), 1}), "in on out on");
}

// The ends are discs with poles.
// PROVES POINT-8.D2
TEST(CurvedWalls, AbutAtTheCentresOfDiscs) {
  const Patches tall = patch_shapes::disc_cylinder(2), cone = patch_shapes::disc_cone(1);
  const Solids stacked = {solid(tall), solid(patch_shapes::placed(tall, 1, {0, 0, 2}))};
  EXPECT_EQ(words(stacked, {0, 0, 2}), "in out on on");
  EXPECT_EQ(words(stacked, {ratio(3, 5), ratio(-4, 5), 2}), "on out on on");
  const Solids pencil = {solid(tall), solid(patch_shapes::placed(cone, 1, {0, 0, 2}))};
  EXPECT_EQ(words(pencil, {0, 0, 2}), "in out on on");
  EXPECT_EQ(words(pencil, {ratio(3, 5), ratio(-4, 5), 2}), "on out on on");
  // Against a block that holds a half of the disc, with an edge through its centre.
  const Solids half = {solid(tall), block({0, -2, 2}, {2, 2, 3})};
  EXPECT_EQ(words(half, {0, 0, 2}), "on out on on");
  // The apex of a cone, and a plane through it: one value on the plane's sides, another one in the cone. There is no
  // tangent cone of flat sectors.
  const Solids needle = {solid(cone), block({-2, -2, 1}, {2, 2, 3})};
  EXPECT_EQ(words(needle, {0, 0, 1}), "undecided undecided undecided undecided");
}

// Places on a patch: inside, on its sides, at its corners.
std::vector<ExactPoint> points_on(const Patch& patch, Random& random) {
  const auto at = [&](const Rational& u, const Rational& v) {
    return *point_of(patch.is_triangle() ? evaluate(patch.triangle(), {Rational(1) - u - v, u, v})
                                         : evaluate(patch.tensor(), {u, v}));
  };
  const Rational part = ratio(1 + static_cast<std::int64_t>(random.below(7)), 16);
  return {at(part, ratio(3, 7)),
          at(ratio(1, 2), part),
          at(part, 0),
          at(0, part),
          at(0, 0),
          at(1, 0),
          at(0, 1)};
}

// A and the same solid from other patches: poles included.
// PROVES POINT-8.D1
TEST(CurvedWalls, OfOneSurfaceFromOtherPatches) {
  Random random(kSeedOfCurvedWalls);
  const Patches models[] = {patch_shapes::sphere(),         patch_shapes::octant_sphere(),
                            patch_shapes::torus(3, 1),      patch_shapes::one_patch_torus(3, 1),
                            patch_shapes::frustum(1, 2, 2), patch_shapes::teapot(),
                            patch_shapes::pn_torus(12, 8)};
  for (std::size_t m = 0; m < std::size(models); ++m) {
    const Patches& model = models[m];
    const std::shared_ptr<const Operand> first = solid(model);
    for (int way = 0; way < 3; ++way) {
      const Patches other = way == 0   ? subdivided(model)
                            : way == 1 ? elevated(model, 1)
                                       : relabelled(model, random);
      const Solids solids = {first, solid(other)};
      for (int i = 0; i < scaled(1); ++i)
        for (const ExactPoint& p : points_on(model[random.below(model.size())], random))
          EXPECT_EQ(words(solids, p), "on on out out") << "seed " << kSeedOfCurvedWalls << " model "
                                                       << m << " way " << way << " at " << text(p);
    }
  }
}

// Rational points whose parameters in the octants are irrational.
// PROVES POINT-8.D3
TEST(CurvedWalls, AtIrrationalParameters) {
  const Patches ball = patch_shapes::octant_sphere();
  const ExactPoint p{ratio(2, 3), ratio(2, 3), ratio(1, 3)};
  const std::shared_ptr<const Operand> first = solid(ball);
  for (const Patches& other : {subdivided(ball), elevated(ball, 1)})
    EXPECT_EQ(words({first, solid(other)}, p), "on on out out");
  const std::shared_ptr<const Operand> above = block({-2, -2, p[2]}, {2, 2, 2});
  EXPECT_EQ(words({first, above}, p), "on on on on");
  EXPECT_EQ(words({first, block({-2, -2, -2}, {2, 2, p[2]})}, p), "on on on on");
  // A shell around the ball: its hole is the ball.
  const Patches hole = patch_shapes::joined(
      {patch_shapes::box({-2, -2, -2}, {2, 2, 2}), patch_shapes::reversed(subdivided(ball))});
  EXPECT_EQ(words({first, solid(hole)}, p), "in out on on");
  // Both halves of a block beside the walls of two equal balls: the union is known by all three together.
  const Solids solids = {first, solid(subdivided(ball)), above, block({-2, -2, -2}, {2, 2, p[2]})};
  const auto v = [](std::uint32_t i) { return Formula::variable(i); };
  EXPECT_EQ(word(Formula::any_of({v(0), v(2), v(3)}), solids, p), "in");
  EXPECT_EQ(word(Formula::all_of({v(0), v(1).negated(), v(2)}), solids, p), "out");
  EXPECT_EQ(word(Formula::all_of({v(0), v(1), v(2)}), solids, p), "on");
}

// Eight octants of a ball.
// PROVES POINT-8, POINT-8.T
TEST(CurvedWalls, AddUpToABall) {
  Solids octants;
  const Patches ball = patch_shapes::octant_sphere();
  for (int i = 0; i < 8; ++i)
    octants.push_back(solid(patch_shapes::coned(
        patch_shapes::patches_with_signs(ball, {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1}),
        {0, 0, 0})));
  std::vector<Formula> all, upper;
  for (std::uint32_t i = 0; i < 8; ++i) all.push_back(Formula::variable(i));
  upper.assign(all.begin() + 4, all.end());
  const Formula whole = Formula::any_of(all), half = Formula::any_of(upper),
                one = Formula::all_of({all[7], half}), none = Formula::all_of({all[7], all[6]});
  const auto at = [&](const ExactPoint& p) {
    return word(whole, octants, p) + " " + word(half, octants, p) + " " + word(one, octants, p) +
           " " + word(none, octants, p);
  };
  EXPECT_EQ(at({0, 0, 0}), "in on on out");
  EXPECT_EQ(at({0, 0, 1}), "on on on out");
  EXPECT_EQ(at({0, 0, -1}), "on out out out");
  EXPECT_EQ(at({1, 0, 0}), "on on on out");
  EXPECT_EQ(at({ratio(3, 5), ratio(4, 5), 0}), "on on on out");  // on the equator
  EXPECT_EQ(at({ratio(3, 5), 0, ratio(4, 5)}), "on on on out");
  EXPECT_EQ(at({0, ratio(3, 5), ratio(4, 5)}), "on on on out");
  EXPECT_EQ(at({0, 0, ratio(1, 2)}), "in in on out");
  EXPECT_EQ(at({0, ratio(1, 2), 0}), "in on on out");
  EXPECT_EQ(at({ratio(1, 3), ratio(2, 3), ratio(2, 3)}), "on on on out");
  EXPECT_EQ(at({ratio(1, 3), ratio(1, 2), 0}), "in on on out");
}

// A tetrahedron, bent by (x, y, z) -> (x, y + z^2 / 4, z): four triangles of degree 2.
Patches bent_tetrahedron(const std::array<PatchPoint, 4>& corners) {
  Patches out;
  for (const auto& [i, j, k] : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    const std::array<PatchPoint, 3> t = {corners[static_cast<std::size_t>(i)],
                                         corners[static_cast<std::size_t>(j)],
                                         corners[static_cast<std::size_t>(k)]};
    constexpr std::size_t kPairs[6][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
    Patch::Triangle map(2, 3, false);
    for (std::size_t n = 0; n < 6; ++n) {
      const PatchPoint &a = t[kPairs[n][0]], &b = t[kPairs[n][1]];
      for (std::size_t c = 0; c < 3; ++c)
        map.component(static_cast<int>(c))[n] = ratio(1, 2) * (a[c] + b[c]);
      map.component(1)[n] += ratio(1, 4) * a[2] * b[2];
    }
    out.push_back(make_patch(std::move(map)).value());
  }
  return out;
}

// Sixteen of them around one curved edge, more than patterns could be listed for.
// PROVES POINT-8.T
TEST(CurvedWalls, AbutInAnyNumberAlongOneEdge) {
  const int rim[16][2] = {{4, 0},  {4, 2},  {4, 4},  {2, 4},   {0, 4},   {-2, 4},
                          {-4, 4}, {-4, 2}, {-4, 0}, {-4, -2}, {-4, -4}, {-2, -4},
                          {0, -4}, {2, -4}, {4, -4}, {4, -2}};
  Solids wedges;
  std::vector<Formula> all;
  for (std::uint32_t i = 0; i < 16; ++i) {
    const int *a = rim[i], *b = rim[(i + 1) % 16];
    wedges.push_back(solid(
        bent_tetrahedron({PatchPoint{0, 0, 0}, {a[0], a[1], 0}, {b[0], b[1], 0}, {0, 0, 2}})));
    all.push_back(Formula::variable(i));
  }
  const ExactPoint p{0, ratio(1, 4), 1};
  EXPECT_EQ(word(Formula::any_of(all), wedges, p), "in");
  EXPECT_EQ(word(Formula::all_of(all), wedges, p), "out");
  all.pop_back();
  EXPECT_EQ(word(Formula::any_of(all), wedges, p), "on");
}

// Under a plane curve (x(t), z(t)), in the middle of a slab: x in the curve's range, y in [0,1], z >= -1.
Patches under_curve(const std::vector<Rational>& x, const std::vector<Rational>& z) {
  const int n = static_cast<int>(x.size()) - 1;
  // One patch with rows of control points (x_i, y, z_i) for v = 0 and v = 1.
  const auto ruled = [&](const auto& at) {
    Patch::Tensor out({n, 1}, 3, false);
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        const PatchPoint p = at(i, j);
        for (std::size_t k = 0; k < 3; ++k) out.component(static_cast<int>(k))[2 * i + j] = p[k];
      }
    return make_patch(std::move(out)).value();
  };
  const auto y = [](std::size_t j) { return Rational(static_cast<std::int64_t>(j)); };
  const auto wall = [&](std::size_t i, bool is_first) {
    Patch::Tensor out({1, 1}, 3, false);
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 0; b < 2; ++b) {
        const PatchPoint p{x[i], is_first ? y(1 - a) : y(a), b == 0 ? Rational(-1) : z[i]};
        for (std::size_t k = 0; k < 3; ++k) out.component(static_cast<int>(k))[2 * a + b] = p[k];
      }
    return make_patch(std::move(out)).value();
  };
  return {ruled([&](std::size_t i, std::size_t j) {
            return PatchPoint{x[i], y(j), z[i]};
          }),
          ruled([&](std::size_t i, std::size_t j) {
            return PatchPoint{x[i], y(1 - j), -1};
          }),
          ruled([&](std::size_t i, std::size_t j) {
            return PatchPoint{x[i], 0, j == 0 ? Rational(-1) : z[i]};
          }),
          ruled([&](std::size_t i, std::size_t j) {
            return PatchPoint{x[i], 1, j == 1 ? Rational(-1) : z[i]};
          }),
          wall(0, true),
          wall(x.size() - 1, false)};
}

// (t^2 - t, t^2 (1 - t)^2 (1 + 3 t)) comes back to 0 with the same tangent, on another sheet: z near x^2 and 4 x^2.
// PROVES POINT-8.D1
TEST(CurvedWalls, DoNotTakeTwoSheetsOfOneMapForOne) {
  BezierCurve<Rational> curve({5}, 2, false);
  // In Bernstein form of degree 5: t^2 - t, and t^2 (1-t)^2 ((1-t) + 4 t).
  const Rational x[6] = {0, ratio(-1, 5), ratio(-3, 10), ratio(-3, 10), ratio(-1, 5), 0};
  const Rational z[6] = {0, 0, ratio(1, 10), ratio(4, 10), 0, 0};
  for (std::size_t i = 0; i < 6; ++i) {
    curve.component(0)[i] = x[i];
    curve.component(1)[i] = z[i];
  }
  const auto half = [&](bool is_first) {
    const Rational middle = ratio(1, 2);
    const auto part = is_first ? left_part(curve, 0, middle) : right_part(curve, 0, middle);
    std::vector<Rational> px(part.component(0).begin(), part.component(0).end()),
        pz(part.component(1).begin(), part.component(1).end());
    if (is_first) {
      std::reverse(px.begin(), px.end());
      std::reverse(pz.begin(), pz.end());
    }
    return under_curve(px, pz);
  };
  const Solids solids = {solid(half(true)), solid(half(false))};
  EXPECT_EQ(words(solids, {0, ratio(1, 2), 0}), "on on undecided undecided");
  EXPECT_EQ(words({solids[0], solid(subdivided(half(true)))}, {0, ratio(1, 2), 0}),
            "on on out out");
  EXPECT_EQ(words({solids[1], solid(elevated(half(false), 2))}, {0, 0, 0}), "on on out out");
}

// z <= 0 against z >= x^2 + y^2 and z >= -x^2 - y^2: a contact that the tangent planes do not tell.
TEST(CurvedWalls, AreUndecidedInContact) {
  const auto bowl = [](int sign) {  // z = sign (x^2 + y^2), and the box above it up to z = 3
    Patches out;
    const auto corner = [](std::size_t i) { return Rational(static_cast<std::int64_t>(i) - 1); };
    const Rational square[3] = {1, -1, 1};  // t^2 on [-1,1] in Bernstein form
    Patch::Tensor floor({2, 2}, 3, false), roof({2, 2}, 3, false);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t at = 3 * i + j, up = 3 * j + i;
        floor.component(0)[up] = roof.component(0)[at] = corner(i);
        floor.component(1)[up] = roof.component(1)[at] = corner(j);
        floor.component(2)[up] = Rational(sign) * (square[i] + square[j]);
        roof.component(2)[at] = 3;
      }
    const Patch low = make_patch(floor).value(), high = make_patch(roof).value();
    out = {low, high};
    for (std::uint32_t s = 0; s < 4; ++s) {  // from the floor's side straight up
      const Patch::Curve c = low.side(s);
      Patch::Tensor wall({2, 1}, 3, false);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 2; ++j)
          for (int k = 0; k < 3; ++k)
            wall.component(k)[2 * i + j] = k == 2 && j == 1 ? Rational(3) : c.component(k)[2 - i];
      out.push_back(make_patch(std::move(wall)).value());
    }
    return out;
  };
  const std::shared_ptr<const Operand> slab = block({-2, -2, -2}, {2, 2, 0});
  for (const int sign : {1, -1}) {
    EXPECT_EQ(words({slab, solid(bowl(sign))}, {0, 0, 0}), "undecided undecided on on") << sign;
    EXPECT_EQ(words({solid(bowl(sign)), solid(subdivided(bowl(sign)))}, {0, 0, 0}),
              "on on out out");
  }
}

}  // namespace
}  // namespace veritope
