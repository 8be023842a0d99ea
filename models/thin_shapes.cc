// SPDX-License-Identifier: LGPL-3.0-or-later
#include "models/thin_shapes.h"

#include "models/patch_shapes_internal.h"

namespace veritope::thin_shapes {
namespace {

using patch_shapes::Point;

// The distance of the walls at the one end where they are `gap` apart at the other, of a shape of equal thickness.
Rational other_end(const Rational& gap, Walls walls) {
  if (walls == Walls::kApart) return gap;
  return walls == Walls::kTouching ? Rational() : -gap;
}
// How far the inner one of two shells at the distance `gap` is moved.
Rational shift_of(const Rational& gap, Walls walls) {
  if (walls == Walls::kApart) return {};
  return walls == Walls::kTouching ? gap : gap + gap;
}

Patches with_hole(const Patches& outer, const Patches& hole, const Rational& shift) {
  return patch_shapes::joined(
      {outer, patch_shapes::reversed(patch_shapes::placed(hole, 1, {shift, 0, 0}))});
}

}  // namespace

Patches spheres(const Rational& gap, const Rational& shift) {
  const Patches ball = patch_shapes::sphere();
  return with_hole(ball, patch_shapes::placed(ball, Rational(1) - gap, {0, 0, 0}), shift);
}

Patches tori(const Rational& gap, const Rational& shift) {
  return with_hole(patch_shapes::torus(3, 1), patch_shapes::torus(3, Rational(1) - gap), shift);
}

Patches plate(const Rational& begin, const Rational& end) {
  const auto at = [&](int corner) -> Point {
    const Rational top = corner % 2 == 0 ? begin : end;
    return {corner & 1, corner >> 1 & 1, (corner >> 2) != 0 ? top : Rational()};
  };
  Patches out;
  for (const std::array<int, 4>& f :
       {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
        std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}})
    patch_shapes::internal::add(
        out, patch_shapes::internal::bilinear({at(f[0]), at(f[1]), at(f[2]), at(f[3])}));
  return out;
}

Patches turned(const Patches& patches) {
  constexpr int kTurn[3][3] = {{2, -1, 2}, {2, 2, -1}, {-1, 2, 2}};
  Patches out;
  for (const Patch& patch : patches) {
    Patch::Tensor map = patch.tensor();
    for (std::size_t i = 0; i < patch.num_control(); ++i)
      for (int r = 0; r < 3; ++r) {
        Rational sum;
        for (int c = 0; c < 3; ++c) sum += Rational(kTurn[r][c]) * patch.component(c)[i];
        map.component(r)[i] = sum / 3;
      }
    patch_shapes::internal::add(out, std::move(map));
  }
  return out;
}

Patches cone(const Rational& top, const Rational& begin, const Rational& end) {
  const Rational one(1), low = one - begin, high = top - end;
  Patches out;
  patch_shapes::internal::add_revolved(out, {{{low, one}, {0, 0}, {1, 1}},
                                             {{one, top}, {0, 2}, {1, 1}},
                                             {{top, high}, {2, 2}, {1, 1}},
                                             {{high, low}, {2, 0}, {1, 1}}});
  return out;
}

std::vector<Family> families() {
  using R = const Rational&;
  return {
      {"spheres", [](R g, Walls w) { return spheres(g, shift_of(g, w)); }, {0, 0}},
      {"plate", [](R g, Walls w) { return plate(g, other_end(g, w)); }, {0}},
      {"plate-turned", [](R g, Walls w) { return turned(plate(g, other_end(g, w))); }, {0}},
      {"tube", [](R g, Walls w) { return cone(1, g, other_end(g, w)); }, {1}},
      {"cone", [](R g, Walls w) { return cone(2, g, other_end(g, w)); }, {1}},
      {"tori", [](R g, Walls w) { return tori(g, shift_of(g, w)); }, {1, 1}},
      {"wedge",
       [](R g, Walls w) { return plate(other_end(g, w), Rational(1) / Rational(4)); },
       {0}},
  };
}

}  // namespace veritope::thin_shapes
