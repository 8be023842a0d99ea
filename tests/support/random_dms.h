// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/random_dms.h: random simplex-spline solids over convex domains, and points at special places of them:
// for tests and soak experiments.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/random.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_make.h"
#include "solids/dms/dms_model.h"
#include "tests/support/simplex_oracle.h"

namespace veritope {

/// Kuhn's six tetrahedra in each cube of a grid; all positively oriented. Vertex (x, y, z) has the number
/// (x (ny + 1) + y) (nz + 1) + z and the coordinates (x, y, z). keep(x, y, z) says which cubes there are.
template <typename Keep>
DmsModel kuhn_domain(std::array<int, 3> size, Keep keep) {
  DmsModel domain;
  const auto id = [&](const std::array<int, 3>& at) {
    return static_cast<std::uint32_t>((at[0] * (size[1] + 1) + at[1]) * (size[2] + 1) + at[2]);
  };
  for (int x = 0; x <= size[0]; ++x)
    for (int y = 0; y <= size[1]; ++y)
      for (int z = 0; z <= size[2]; ++z)
        domain.clouds.push_back({{Rational(x), Rational(y), Rational(z)}});
  constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) {
        if (!keep(x, y, z)) continue;
        for (std::size_t o = 0; o < 6; ++o) {
          std::array<int, 3> at{x, y, z};
          TetrahedronCorners t{id(at)};
          for (std::size_t i = 0; i < 3; ++i) ++at[kOrders[o][i]], t[i + 1] = id(at);
          if (o == 1 || o == 2 || o == 5) std::swap(t[2], t[3]);
          domain.tetrahedra.push_back(t);
        }
      }
  return domain;
}
inline DmsModel kuhn_domain(std::array<int, 3> size) {
  return kuhn_domain(size, [](int, int, int) { return true; });
}

enum class DmsClouds { kCollapsed, kAligned, kGeneral };

/// x -> m x + t
struct DmsAffine {
  std::array<std::array<Rational, 3>, 3> m;
  DmsPoint t;
  DmsPoint operator()(const DmsPoint& p) const {
    DmsPoint out = t;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) out[i] += m[i][j] * p[j];
    return out;
  }
};
inline DmsAffine draw_affine(Random& random, bool may_mirror = false) {
  DmsAffine a;
  for (;;) {
    for (auto& row : a.m)
      for (Rational& c : row) c = Rational(random.between(-2, 3)) / Rational(random.between(1, 2));
    for (Rational& c : a.t) c = Rational(random.between(-9, 9)) / Rational(4);
    const Sign s = simplex_oracle::volume6({}, a.m[0], a.m[1], a.m[2]).sign();
    if (s == Sign::kPositive || (may_mirror && s == Sign::kNegative)) return a;
  }
}

struct RandomDms {
  DmsModel model;
  std::string text;  ///< what was drawn, with the seed
};

namespace internal {

/// A convex domain: a tetrahedron, one cut into four, or a box of up to 2 x 2 x 1 cubes (2 x 2 x 2 with a moved middle).
inline DmsModel draw_domain(Random& random, std::string& text) {
  const auto kind = random.below(4);
  const auto draw = [&](int low, int high) { return static_cast<int>(random.between(low, high)); };
  if (kind == 3) {
    DmsModel box = kuhn_domain({2, 2, 2});
    for (Rational& c : box.clouds[13][0]) c += Rational(draw(-2, 2)) / Rational(8);
    text += "2x2x2 ";
    return box;
  }
  if (kind == 2) {
    const std::array<int, 3> size{draw(1, 2), draw(1, 2), 1};
    text += std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x1 ";
    return kuhn_domain(size);
  }
  DmsModel one;
  one.clouds = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  one.tetrahedra = {{0, 1, 2, 3}};
  text += kind == 0 ? "tetrahedron " : "four tetrahedra ";
  if (kind == 0) return one;
  one.clouds.push_back({{Rational(draw(1, 3)) / Rational(10), Rational(draw(1, 3)) / Rational(10),
                         Rational(draw(1, 3)) / Rational(10)}});
  one.tetrahedra = {{4, 1, 2, 3}, {0, 4, 2, 3}, {0, 1, 4, 3}, {0, 1, 2, 4}};
  return one;
}

/// A knot near a vertex: on no inner side of a face of the boundary, so that (c) holds to any degree in a convex domain.
inline DmsPoint draw_knot(Random& random, const DmsModel& domain, const TetrahedralComplex& complex,
                          std::uint32_t v, DmsClouds clouds) {
  const DmsPoint& at = domain.clouds[v][0];
  for (int i = 0; i < 200; ++i) {
    DmsPoint knot = at;
    if (clouds == DmsClouds::kAligned) {
      // Along edges of a tetrahedron at the vertex, away from its other ends: on the planes of its faces.
      const auto tetrahedra = complex.tetrahedra_at(v);
      const auto& t = domain.tetrahedra[tetrahedra[random.below(tetrahedra.size())]];
      for (const std::uint32_t w : t) {
        if (w == v || random.below(2) == 0) continue;
        const Rational step = Rational(random.between(-2, 4)) / Rational(40);
        for (std::size_t c = 0; c < 3; ++c) knot[c] += step * (at[c] - domain.clouds[w][0][c]);
      }
    } else {
      for (Rational& c : knot) c += Rational(random.between(-6, 6)) / Rational(60);
    }
    bool is_outward = true;
    for (const TetrahedronFace f : complex.boundary()) {
      const auto face = complex.vertices(f);
      if (std::find(face.begin(), face.end(), v) == face.end()) continue;
      is_outward = is_outward &&
                   simplex_oracle::volume6(domain.clouds[face[0]][0], domain.clouds[face[1]][0],
                                           domain.clouds[face[2]][0], knot)
                           .sign() != Sign::kNegative;
    }
    if (is_outward) return knot;
  }
  return at;
}

}  // namespace internal

/// A model over a convex domain on which (a) and (c) hold to the degree, so that the basis functions of both forms add
/// up to 1. Control points are drawn; they are shared.
inline RandomDms draw_dms(std::uint64_t seed, int max_degree, std::size_t max_attributes = 2) {
  Random random(seed);
  RandomDms out;
  out.text = "seed " + std::to_string(seed) + ": ";
  DmsModel domain = internal::draw_domain(random, out.text);
  const int degree = static_cast<int>(random.between(1, max_degree));
  const auto clouds = static_cast<DmsClouds>(random.below(3));
  out.text +=
      "degree " + std::to_string(degree) + ", clouds " + std::to_string(static_cast<int>(clouds));
  const TetrahedralComplex complex(domain.tetrahedra,
                                   static_cast<std::uint32_t>(domain.clouds.size()));
  DmsModel model;
  model.degree = degree;
  for (std::size_t a = 0, n = random.below(max_attributes + 1); a < n; ++a)
    model.attributes.push_back("a" + std::to_string(a));
  model.tetrahedra = domain.tetrahedra;
  model.clouds = domain.clouds;
  if (clouds != DmsClouds::kCollapsed) {
    for (std::uint32_t v = 0; v < model.clouds.size(); ++v) {
      if (random.below(8) == 0) continue;  // collapsed
      for (int i = 1; i <= degree; ++i)
        model.clouds[v].push_back(internal::draw_knot(random, domain, complex, v, clouds));
    }
  }
  // (a) to the degree: clouds are halved until it holds.
  model.control.is_separate = true;
  for (DmsDefects defects = find_dms_defects(model, 1); defects.count > 0;
       defects = find_dms_defects(model, 1)) {
    for (DmsCloud& cloud : model.clouds)
      for (std::size_t i = 1; i < cloud.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) cloud[i][c] = (cloud[i][c] + cloud[0][c]) / Rational(2);
  }
  model.control.is_separate = false;
  const DmsAffine affine = draw_affine(random);
  for (DmsCloud& cloud : model.clouds)
    for (DmsPoint& knot : cloud) knot = affine(knot);
  set_control_by_rule(model, DmsControlRule::kGreville,
                      std::vector<Rational>(model.clouds.size() * model.attributes.size()));
  for (Rational& c : model.control.values)
    c = Rational(random.between(-20, 20)) / Rational(random.between(1, 6));
  out.model = std::move(model);
  return out;
}

/// A point of the closed domain: in two of three cases inside a tetrahedron; else a vertex, or on an edge, a face, a
/// knot's plane; knots outside of the domain are moved to a vertex.
inline DmsPoint draw_dms_point(Random& random, const DmsModel& model) {
  const auto& t = model.tetrahedra[random.below(model.tetrahedra.size())];
  const auto mix = [](const std::vector<std::pair<Rational, DmsPoint>>& parts) {
    DmsPoint sum;
    Rational total;
    for (const auto& [weight, p] : parts) {
      for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * p[c];
      total += weight;
    }
    for (Rational& c : sum) c /= total;
    return sum;
  };
  const bool is_special = random.below(3) == 0;
  const auto kind = random.below(5);
  std::vector<std::pair<Rational, DmsPoint>> parts;
  if (is_special && kind < 3) {  // a vertex, on an edge, on a face
    for (std::size_t m = 0; m <= kind; ++m)
      parts.emplace_back(Rational(random.between(1, 5)), model.clouds[t[m]][0]);
    return mix(parts);
  }
  for (const std::uint32_t v : t)
    parts.emplace_back(Rational(random.between(1, 9)), model.clouds[v][0]);
  const DmsPoint inside = mix(parts);
  if (!is_special) return inside;
  // On a knot or the plane of three: the point of the segment from `inside` to it that may lie in the domain.
  parts.clear();
  for (std::uint64_t m = 0; m <= kind - 3 + random.below(2); ++m) {
    const std::uint32_t v = t[random.below(4)];
    const auto& cloud = model.clouds[v];
    parts.emplace_back(Rational(random.between(1, 5)), cloud[random.below(cloud.size())]);
  }
  const DmsPoint special = mix(parts);
  std::array<simplex_oracle::Point, 4> corners;
  for (const auto& other : model.tetrahedra) {
    for (std::size_t m = 0; m < 4; ++m) corners[m] = model.clouds[other[m]][0];
    if (simplex_oracle::contains(corners, simplex_oracle::axes_path(special))) return special;
  }
  return model.clouds[t[0]][0];
}

inline std::string text_of(const DmsPoint& p) { return simplex_oracle::text(p); }

}  // namespace veritope
