// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/zero_shapes.h: solids with normals that are zero in corners or along sides, with cusps, with flat faces
// of other kinds than triangles of degree 1; and neighbours of them that are no solids.
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "models/patch_shapes.h"
#include "solids/patches/patch_transform.h"

namespace veritope::zero_shapes {

using patch_shapes::Patches;
using patch_shapes::Point;
using HomogeneousPoint = std::array<Rational, 4>;

inline Rational ratio(std::int64_t p, std::int64_t q = 1) { return Rational(p) / Rational(q); }

/// Points row by row: the second index is fastest.
inline Patch polynomial(int p, int q, const std::vector<Point>& points) {
  Patch::Tensor map({p, q}, 3, false);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) map.component(static_cast<int>(k))[i] = points[i][k];
  return make_patch(std::move(map)).value();
}
inline Patch rational(int p, int q, const std::vector<HomogeneousPoint>& points) {
  Patch::Tensor map({p, q}, 4, true);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) map.component(static_cast<int>(k))[i] = points[i][k];
  return make_patch(std::move(map)).value();
}
inline Patch elevated_patch(const Patch& patch) {
  return elevated(std::vector<Patch>{patch}, 1).front();
}

/// A curve in the plane as (x, y) control points, extruded from z = low to z = high; outward if it runs round the solid
/// from +x to +y.
inline Patch wall(const std::vector<std::array<Rational, 2>>& curve, const Rational& low,
                  const Rational& high) {
  std::vector<Point> points;
  for (const auto& [x, y] : curve) points.insert(points.end(), {Point{x, y, low}, {x, y, high}});
  return polynomial(static_cast<int>(curve.size()) - 1, 1, points);
}

/// A prism over a round section: four parabolas whose tangents agree where they meet. Each cap is one biquadratic patch
/// with parallel tangents, and so with no normal, in its corners; or the same one as a bicubic patch.
inline Patches round_prism(bool is_bicubic = false) {
  const auto P = [](int x, int y, int z) { return Point{ratio(x), ratio(y), ratio(z)}; };
  Patches out{polynomial(2, 2,
                         {P(1, 0, 1), P(1, -1, 1), P(0, -1, 1), P(1, 1, 1), P(0, 0, 1),
                          P(-1, -1, 1), P(0, 1, 1), P(-1, 1, 1), P(-1, 0, 1)}),
              polynomial(2, 2,
                         {P(1, 0, -1), P(1, 1, -1), P(0, 1, -1), P(1, -1, -1), P(0, 0, -1),
                          P(-1, 1, -1), P(0, -1, -1), P(-1, -1, -1), P(-1, 0, -1)})};
  if (is_bicubic)
    for (Patch& cap : out) cap = elevated_patch(cap);
  int x = 1, y = 0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    out.push_back(wall({{ratio(x), ratio(y)}, {ratio(x - y), ratio(y + x)}, {ratio(-y), ratio(x)}},
                       ratio(-1), ratio(1)));
    x = std::exchange(y, x), x = -x;
  }
  return out;
}

/// The prism with the middle control point of its upper cap moved: by (a, 0, 0).
inline Patches round_prism_with_middle_at(const Rational& a) {
  Patches out = round_prism();
  Patch::Tensor map = out[0].tensor();
  map.component(0)[4] = a;
  out[0] = make_patch(std::move(map)).value();
  return out;
}

/// A profile (r, z) revolved about the z axis, a quarter a patch.
inline Patches revolved(const std::vector<std::vector<std::array<int, 2>>>& profile) {
  Patches out;
  int x = 1, y = 0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (const auto& curve : profile) {
      std::vector<HomogeneousPoint> points;
      for (const auto& [a, b, w] :
           {std::array{x, y, 1}, std::array{x - y, y + x, 1}, std::array{-2 * y, 2 * x, 2}})
        for (const auto& [r, z] : curve)
          points.push_back({ratio(a * r), ratio(b * r), ratio(w * z), ratio(w)});
      out.push_back(rational(2, static_cast<int>(curve.size()) - 1, points));
    }
    x = std::exchange(y, x), x = -x;
  }
  return out;
}
/// A spike: its tip is a pole at which all meridians touch the axis.
inline Patches cusp_tip() { return revolved({{{0, -1}, {1, -1}}, {{1, -1}, {0, 0}, {0, 1}}}); }
/// A lens whose two sides touch each other along its rim.
inline Patches cusp_edge() {
  return revolved({{{0, -1}, {1, 0}, {2, 0}}, {{2, 0}, {1, 0}, {0, 1}}});
}

/// The bar [-1, 1] x [0, 1] x [0, 1] whose long faces are cut along x, with these control points of x in each part. If
/// two are equal where parts meet, normals are zero there.
inline Patches cut_bar(const std::vector<std::vector<Rational>>& parts) {
  const Rational zero, one(1);
  Patches out;
  const auto face = [&](const std::vector<Rational>& xs, const std::array<Rational, 2>& from,
                        const std::array<Rational, 2>& to) {
    std::vector<Point> points;
    for (const Rational& x : xs)
      points.insert(points.end(), {Point{x, from[0], from[1]}, {x, to[0], to[1]}});
    out.push_back(polynomial(static_cast<int>(xs.size()) - 1, 1, points));
  };
  for (const auto& xs : parts) {
    face(xs, {zero, one}, {one, one});    // z = 1
    face(xs, {one, zero}, {zero, zero});  // z = 0
    face(xs, {zero, zero}, {zero, one});  // y = 0
    face(xs, {one, one}, {one, zero});    // y = 1
  }
  const auto end = [&](const Rational& x, bool is_right) {
    const std::array<Point, 4> p{{{x, zero, zero}, {x, zero, one}, {x, one, zero}, {x, one, one}}};
    out.push_back(is_right ? polynomial(1, 1, {p[0], p[1], p[2], p[3]})
                           : polynomial(1, 1, {p[0], p[2], p[1], p[3]}));
  };
  end(parts.front().front(), false);
  end(parts.back().back(), true);
  return out;
}
inline Patches repeated_points_bar() {
  return cut_bar({{ratio(-1), ratio(0), ratio(0)}, {ratio(0), ratio(0), ratio(1)}});
}
/// The middle part runs back, from x = 1/2 to x = -1/2.
inline Patches folded_bar() {
  return cut_bar({{ratio(-1), ratio(1, 2), ratio(1, 2)},
                  {ratio(1, 2), ratio(1, 2), ratio(-1, 2), ratio(-1, 2)},
                  {ratio(-1, 2), ratio(-1, 2), ratio(1)}});
}

/// A prism between z = 0 and z = 1 over a quadrilateral, whose caps are bilinear.
inline Patches quad_prism(const std::array<std::array<Rational, 2>, 4>& c) {
  Patches out;
  const auto at = [&](std::size_t i, int z) { return Point{c[i][0], c[i][1], ratio(z)}; };
  out.push_back(polynomial(1, 1, {at(0, 1), at(3, 1), at(1, 1), at(2, 1)}));
  out.push_back(polynomial(1, 1, {at(0, 0), at(1, 0), at(3, 0), at(2, 0)}));
  for (std::size_t i = 0; i < 4; ++i)
    out.push_back(wall({c[i], c[(i + 1) % 4]}, ratio(0), ratio(1)));
  return out;
}

/// Four unit cubes that meet in a vertex whose normals lie in no open half-space.
inline Patches four_blocks() {
  return patch_shapes::blocks({{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 1, 1}});
}
/// Those cubes with faces as biquadratic patches whose middle control points are moved by `by` in their planes.
inline Patches four_bent_blocks(const Rational& by) {
  Patches out;
  for (const Patch& face : four_blocks()) {
    Patch::Tensor map = elevated_patch(face).tensor();
    for (int k = 0; k < 3; ++k) {
      const auto x = map.component(k);
      x[4] += by * (x[8] - x[0]);
    }
    out.push_back(make_patch(std::move(map)).value());
  }
  return out;
}

}  // namespace veritope::zero_shapes
