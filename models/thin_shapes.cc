// SPDX-License-Identifier: LGPL-3.0-or-later
#include "models/thin_shapes.h"

#include <functional>
#include <utility>
#include <vector>

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

// A sheet of n x n bicubic patches over the unit square: their control heights by the position i, j in a net of
// (3 n + 1) x (3 n + 1), in which neighbours share a row.
struct Heights {
  int n;
  std::function<Rational(int, int)> at;
};

// The sheet, a copy of it that is `begin` to `end` higher, and ruled patches between their borders.
Patches sheet(const Heights& heights, const Rational& begin, const Rational& end) {
  const int n = heights.n, m = 3 * n;
  const auto point = [&](int i, int j, bool is_high) -> Point {
    const Rational x = Rational(i) / Rational(m), thick = begin + (end - begin) * x;
    return {x, Rational(j) / Rational(m), heights.at(i, j) + (is_high ? thick : Rational())};
  };
  Patches out;
  const auto add_net = [&](int columns, const std::function<Point(int, int)>& at) {
    std::vector<Rational> control;
    for (std::size_t k = 0; k < 3; ++k)
      for (int a = 0; a <= 3; ++a)
        for (int b = 0; b <= columns; ++b) control.push_back(at(a, b)[k]);
    patch_shapes::internal::add(out, Patch::Tensor({3, columns}, 3, false, std::move(control)));
  };
  for (int i = 0; i < m; i += 3)
    for (int j = 0; j < m; j += 3) {
      add_net(3, [&](int a, int b) { return point(i + b, j + a, false); });
      add_net(3, [&](int a, int b) { return point(i + a, j + b, true); });
    }
  for (int i = 0; i < m; i += 3) {
    add_net(1, [&](int a, int b) { return point(i + a, 0, b != 0); });
    add_net(1, [&](int a, int b) { return point(m - i - a, m, b != 0); });
    add_net(1, [&](int a, int b) { return point(m, i + a, b != 0); });
    add_net(1, [&](int a, int b) { return point(0, m - i - a, b != 0); });
  }
  return out;
}

// Bernstein coefficient i of a uniform cubic spline with the coefficients d(-1), d(0), ...: a row of weights over six
// at its place.
Rational bernstein(int i, const std::function<Rational(int)>& d) {
  const int k = i / 3;
  switch (i % 3) {
    case 0: return (d(k - 1) + Rational(4) * d(k) + d(k + 1)) / Rational(6);
    case 1: return (Rational(2) * d(k) + d(k + 1)) / Rational(3);
    default: return (d(k) + Rational(2) * d(k + 1)) / Rational(3);
  }
}
Heights uniform_spline(int n) {
  const auto height = [n](int i, int j) {  // sixteenths of a tenth of a span, of either sign
    const unsigned hash =
        static_cast<unsigned>(i + 7) * 2654435761u ^ static_cast<unsigned>(j + 7) * 40503u;
    return Rational(static_cast<int>(hash >> 16 & 63) - 32) / Rational(320 * n);
  };
  return {n, [height](int i, int j) {
            return bernstein(
                i, [&](int k) { return bernstein(j, [&](int l) { return height(k, l); }); });
          }};
}

}  // namespace

Patches spheres(const Rational& gap, const Rational& shift) {
  const Patches ball = patch_shapes::sphere();
  return with_hole(ball, patch_shapes::placed(ball, Rational(1) - gap, {0, 0, 0}), shift);
}

Patches tori(const Rational& gap, const Rational& shift) {
  return with_hole(patch_shapes::torus(3, 1), patch_shapes::torus(3, Rational(1) - gap), shift);
}

Patches nested_spheres(int count, const Rational& gap, const Rational& shift) {
  const Patches ball = patch_shapes::sphere();
  Patches out = ball;
  for (int i = 1; i < count; ++i) {
    const Rational move = i + 1 == count ? shift : Rational();
    const Patches next = patch_shapes::placed(ball, Rational(1) - gap * Rational(i), {move, 0, 0});
    out = patch_shapes::joined({out, i % 2 == 0 ? next : patch_shapes::reversed(next)});
  }
  return out;
}

Patches eccentric_spheres(const Rational& shift) {
  const Patches ball = patch_shapes::sphere();
  return with_hole(ball, patch_shapes::placed(ball, Rational(1) / Rational(2), {0, 0, 0}), shift);
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

Patches curved_plate(const Rational& begin, const Rational& end) {
  // Heights in tenths: a saddle with a bump.
  static constexpr int kHeights[4][4] = {
      {0, 1, 1, 0}, {1, 4, 3, -1}, {0, 2, -1, -2}, {-1, 0, -2, -3}};
  return sheet({1, [](int i, int j) { return Rational(kHeights[i][j]) / Rational(10); }}, begin,
               end);
}

Patches spline_sheet(int n, const Rational& thickness) {
  return sheet(uniform_spline(n), thickness, thickness);
}

Patches plate_with_hole(const Rational& width) {
  const Rational half = Rational(1) / Rational(2), low = half - width / Rational(2),
                 high = half + width / Rational(2), top = Rational(1) / Rational(8);
  const Point outer[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Point inner[4] = {{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}};
  const auto up = [&](const Point& p) -> Point { return {p[0], p[1], top}; };
  Patches out;
  const auto face = [&](const Point& a, const Point& b, const Point& c, const Point& d) {
    patch_shapes::internal::add(out, patch_shapes::internal::bilinear({a, b, c, d}));
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    face(outer[i], inner[i], inner[j], outer[j]);
    face(up(outer[i]), up(outer[j]), up(inner[j]), up(inner[i]));
    face(outer[i], outer[j], up(outer[j]), up(outer[i]));
    face(inner[i], up(inner[i]), up(inner[j]), inner[j]);
  }
  return out;
}

Patches pn_shell(double gap) {
  return with_hole(patch_shapes::internal::pn_torus(24, 16, 1),
                   patch_shapes::internal::pn_torus(24, 16, 1 - gap), {});
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
      {"nested",
       [](R g, Walls w) { return nested_spheres(5, g, shift_of(g, w)); },
       {0, 0, 0, 0, 0},
       3},
      {"eccentric",
       [](R g, Walls w) { return eccentric_spheres(Rational(1) / Rational(2) - other_end(g, w)); },
       {0, 0}},
      {"curved-plate", [](R g, Walls w) { return curved_plate(g, other_end(g, w)); }, {0}},
      {"wedge",
       [](R g, Walls w) { return plate(other_end(g, w), Rational(1) / Rational(4)); },
       {0}},
  };
}

}  // namespace veritope::thin_shapes
