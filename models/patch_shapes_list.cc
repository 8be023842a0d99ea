// SPDX-License-Identifier: LGPL-3.0-or-later
// The lists of models with their truth, and the builders of the broken ones.
#include "models/patch_shapes.h"
#include "models/patch_shapes_internal.h"

namespace veritope::patch_shapes {
namespace {

const Rational kHalf = Rational(1) / 2, kQuarter = Rational(1) / 4;

// The sphere with the inner control points of its bottom lifted by 4: above each point of the lower cap the way up
// leaves the ball through other patches, and the middle is lifted by over 2, so that it lies beyond them.
Patches pushed_through_sphere() {
  Patches out = sphere();
  Patch::Tensor map = out[0].tensor();
  for (std::size_t i = 1; i < 4; ++i)
    for (std::size_t j = 1; j < 4; ++j)
      map.component(2)[5 * i + j] += Rational(4) * map.component(3)[5 * i + j];
  out[0] = make_patch(std::move(map), out[0].origin()).value();
  return out;
}

// The unit box whose top is a bicubic patch in the same plane with inner control points at x = 2 and x = -1, in this
// order: it runs to and fro, three sheets deep in the middle.
Patches folded_box() {
  Patches out = box({0, 0, 0}, {1, 1, 1});
  Patch::Tensor map = elevate_to(out[5].tensor(), {3, 3});
  for (std::size_t j = 1; j < 3; ++j) {
    map.component(0)[4 + j] = 2;
    map.component(0)[8 + j] = -1;
  }
  out[5] = make_patch(std::move(map), out[5].origin()).value();
  return out;
}

// The torus (3, 1) of one patch, with an inner control point pulled so far that a horn crosses the tube on the other
// side.
Patches pulled_torus() {
  Patches out = one_patch_torus(3, 1);
  Patch::Tensor map = out[0].tensor();
  const std::size_t at = 6 * 2 + 2;
  map.component(0)[at] -= Rational(90) * map.component(3)[at];
  map.component(1)[at] -= Rational(30) * map.component(3)[at];
  out[0] = make_patch(std::move(map), out[0].origin()).value();
  return out;
}

// The cylinder with the middle of its upper end pushed down below the lower end, which it crosses.
Patches pushed_through_cylinder() {
  Patches out;
  internal::add_revolved(out, {{{1, 1}, {0, 2}, {1, 1}}});
  internal::add_end(out, {1, 0, {0, 0, 0}, false});
  internal::add_end(out, {1, 2, {0, 0, -1}, true});
  return out;
}
// The cone with the middle of its base moved up and aside, out of the cone: segments from the far side of the rim enter
// the cone and leave it.
Patches pushed_through_cone() {
  Patches out;
  internal::add_revolved(out, {{{1, 0}, {0, 2}, {1, 1}}});
  internal::add_end(out, {1, 0, {2, 0, kHalf}, false});
  return out;
}

// The plate with its corner (0, 0, 1) pulled down to z = -1: the upper face of its cube crosses the lower one.
Patches crossed_plate(int g) {
  return internal::block_faces(internal::plate_cubes(g), [](const internal::Cube& p) {
    Point out = internal::at_integers(p);
    if (p == internal::Cube{0, 0, 1}) out[2] = -1;
    return out;
  });
}

// The teapot with a neck that turns outwards and down, and returns through the belly: from outside of the lower part of
// the profile to inside.
Patches crossed_teapot() {
  auto profile = internal::teapot_profile();
  const std::vector<Rational> w{1, 1, 1, 1};
  const Rational half5 = Rational(5) / 2, top = Rational(25) / 8;
  profile[2] = {{1, 1, half5, half5}, {half5, 3, 3, 2}, w};
  profile.insert(profile.begin() + 3,
                 {{half5, half5, kQuarter, kQuarter}, {2, kHalf, kHalf, top}, w});
  Patches out;
  internal::add_revolved(out, profile);
  return out;
}

Patches at_x(const Patches& patches, const Rational& x) { return placed(patches, 1, {x, 0, 0}); }

// Radius 3 with a hole of radius 2, and in it a ball of radius 1.
Patches nested_spheres() {
  const Point o{0, 0, 0};
  return joined({placed(sphere(), 3, o), reversed(placed(sphere(), 2, o)), sphere()});
}

// The unit square's prism up to z = 1 - (x^2 - 1/2)^2, and a box on the plane z = 1: they meet where 2 x^2 = 1.
Patches lid_below_box() {
  using internal::Scalar;
  const Rational side = Rational(3) / 4;
  const Scalar height = Scalar::along(0, {side, side, Rational(11) / 12, Rational(5) / 4, side});
  const Scalar x = Scalar::linear(0, 0, 1), v = Scalar::linear(1, 0, 1);
  Patches out;
  const std::array<Point, 4> walls[] = {{{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}},
                                        {{{0, 0, 0}, {0, 0, side}, {0, 1, side}, {0, 1, 0}}},
                                        {{{1, 0, 0}, {1, 1, 0}, {1, 1, side}, {1, 0, side}}}};
  for (const std::array<Point, 4>& wall : walls) internal::add(out, internal::bilinear(wall));
  internal::add(out, internal::tensor_of(x, v, height));
  internal::add(out, internal::tensor_of(x, 0, v * height));
  internal::add(out, internal::tensor_of(x, 1, height - v * height));
  return joined({out, box({0, 0, 1}, {1, 1, 2})});
}

}  // namespace

Patches thin_shell(const Rational& thickness) {
  return joined({sphere(), reversed(placed(sphere(), Rational(1) - thickness, {0, 0, 0}))});
}

std::vector<Shape> sound_shapes() {
  const Patches unit_box = box({0, 0, 0}, {1, 1, 1});
  return {{"box", unit_box, Truth::kEmbedded, {0}, 1},
          {"sphere", sphere(), Truth::kEmbedded, {0}, 1},
          {"octant-sphere", octant_sphere(), Truth::kEmbedded, {0}, 1},
          {"torus", torus(3, 1), Truth::kEmbedded, {1}, 1},
          {"one-patch-torus", one_patch_torus(3, 1), Truth::kEmbedded, {1}, 1},
          {"cylinder", frustum(1, 1, 2), Truth::kEmbedded, {0}, 1},
          {"frustum", frustum(1, kHalf, 2), Truth::kEmbedded, {0}, 1},
          {"cone", frustum(1, 0, 2), Truth::kEmbedded, {0}, 1},
          {"plate-genus-3", plate(3), Truth::kEmbedded, {3}, 1},
          {"thin-shell", thin_shell(Rational(1) / 16), Truth::kEmbedded, {0, 0}, 1},
          {"two-boxes", joined({unit_box, at_x(unit_box, 2)}), Truth::kEmbedded, {0, 0}, 2},
          {"spheres-3-2-1", nested_spheres(), Truth::kEmbedded, {0, 0, 0}, 2},
          {"knotted-tube", knotted_tube(kQuarter, 6, 48), Truth::kEmbedded, {1}, 1},
          {"teapot", teapot(), Truth::kEmbedded, {0}, 1},
          {"pn-torus-192", pn_torus(12, 8), Truth::kEmbedded, {1}, 1}};
}

std::vector<Shape> broken_shapes() {
  const Patches unit_box = box({0, 0, 0}, {1, 1, 1}), ball = sphere();
  const auto other_box = [&](const Point& low, const Point& high) {
    return joined({unit_box, box(low, high)});
  };
  const auto hole = [&](const Rational& x) {
    return joined({ball, reversed(placed(ball, kHalf, {x, 0, 0}))});
  };
  const Rational near = kQuarter, far = Rational(3) / 4;
  return {
      {"boxes-crossing",
       other_box({kHalf, near, near}, {2, far, far}),
       Truth::kCrossing,
       {0, 0},
       0},
      {"boxes-touching-in-a-face",
       other_box({1, near, near}, {2, far, far}),
       Truth::kTouching,
       {0, 0},
       0},
      {"boxes-touching-in-an-edge",
       other_box({1, 1, near}, {2, 2, far}),
       Truth::kTouching,
       {0, 0},
       0},
      {"boxes-touching-in-a-vertex", other_box({1, 1, 1}, {2, 2, 2}), Truth::kTouching, {0, 0}, 0},
      {"lid-touching-in-an-irrational-line", lid_below_box(), Truth::kTouching, {0, 0}, 0},
      {"box-folded", folded_box(), Truth::kTouching, {0}, 0},
      {"cube-wrinkled", wrinkled_cube(), Truth::kTouching, {0}, 0},
      {"sphere-pushed-through", pushed_through_sphere(), Truth::kCrossing, {0}, 0},
      {"spheres-crossing", joined({ball, at_x(ball, 1)}), Truth::kCrossing, {0, 0}, 0},
      {"spheres-touching", joined({ball, at_x(ball, 2)}), Truth::kTouching, {0, 0}, 0},
      {"octant-spheres-touching-at-poles",
       joined({octant_sphere(), placed(octant_sphere(), 1, {0, 0, 2})}),
       Truth::kTouching,
       {0, 0},
       0},
      // Collapsed sides, so a sphere with both poles in one place.
      {"torus-touching-itself", torus(1, 1), Truth::kTouching, {0}, 0},
      // They meet themselves in two cone points only, where S_u = 0. Near one, (t cos s, t sin s, t), they are a limit
      // of embedded hyperboloids (t cos s - e sin s, t sin s + e cos s, t): no crossing that stays under small changes
      // can be proved.
      {"spindle-torus", torus(1, 2), Truth::kTouching, {1}, 0},
      {"one-patch-spindle-torus", one_patch_torus(1, 2), Truth::kTouching, {1}, 0},
      {"one-patch-torus-crossing-itself", pulled_torus(), Truth::kCrossing, {1}, 0},
      {"cylinder-end-pushed-through", pushed_through_cylinder(), Truth::kCrossing, {0}, 0},
      {"cone-end-pushed-through", pushed_through_cone(), Truth::kCrossing, {0}, 0},
      {"plate-crossing-itself", crossed_plate(3), Truth::kCrossing, {3}, 0},
      {"thin-shell-touching", hole(kHalf), Truth::kTouching, {0, 0}, 0},
      {"thin-shell-crossing", hole(far), Truth::kCrossing, {0, 0}, 0},
      {"knotted-tube-crossing-itself",
       internal::tube(kQuarter, 6, 48, true),
       Truth::kCrossing,
       {1},
       0},
      {"teapot-crossing-itself", crossed_teapot(), Truth::kCrossing, {0}, 0},
      {"pn-tori-crossing",
       joined({pn_torus(12, 8), at_x(pn_torus(12, 8), 3)}),
       Truth::kCrossing,
       {1, 1},
       0},
  };
}

}  // namespace veritope::patch_shapes
