// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/exact_nodes.h: bent sheets, and the nodes of a PieceForest in rationals.
#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "robust/base/random.h"
#include "solids/patches/patch_transform.h"
#include "solids/pieces/piece_forest.h"
#include "tests/solids/patch_support.h"

namespace veritope {

using Numbers = std::vector<Rational>;

// Components one after the other, as in a net.
struct RationalNet {
  FormShape shape;
  int components;
  Numbers values;

  const Rational& at(std::size_t c, std::size_t i) const { return values[c * shape.count() + i]; }
};

template <typename Map>
inline RationalNet net_of(const RationalNet& like, const Map& map) {
  return {like.shape, like.components,
          Numbers(map.coefficients().begin(), map.coefficients().end())};
}
inline RationalNet half_of(const RationalNet& net, std::size_t axis, bool is_upper) {
  const Bezier<Rational, 2> map({net.shape.p, net.shape.q}, net.components, false, net.values);
  const auto halves = split(map, axis, Rational(1) / Rational(2));
  return net_of(net, is_upper ? halves.second : halves.first);
}
inline RationalNet quarter_of(const RationalNet& net, std::size_t k) {
  if (!net.shape.is_triangle) return half_of(half_of(net, 0, k >= 2), 1, k % 2 == 1);
  const BezierTriangle<Rational> map(net.shape.p, net.components, false, net.values);
  return net_of(net, split_in_four(map)[k]);
}

// The patch as a forest sees it: homogeneous control points relative to the origin of its nets, and determinants.
inline RationalNet control_of(const PieceForest& forest, std::uint32_t p) {
  const PieceForest::Form& form = forest.form(p);
  const Patch& patch = forest.complex().patch(p);
  const bool is_rational = patch.is_rational();
  Rational largest(1);
  if (is_rational) {
    largest = patch.component(3)[0];
    for (const Rational& w : patch.component(3)) largest = std::max(largest, w);
  }
  RationalNet out{form.shape, is_rational ? 4 : 3, {}};
  for (int c = 0; c < out.components; ++c)
    for (std::size_t i = 0; i < form.shape.count(); ++i) {
      const auto k = static_cast<std::size_t>(c);
      const Rational w = is_rational ? patch.component(3)[i] : Rational(1);
      const Rational x = c == 3 ? w
                                : w * (forest.in_frame(k, patch.component(c)[i] / w) -
                                       Rational::from_double(form.origin[k]));
      out.values.push_back(x / largest);
    }
  return out;
}

// A bent sheet with coordinates that no double holds: about as wide as long, times `stretch` along its first parameter.
// Sides in `collapsed` (bits) are points; equal places where two of them share a corner.
inline Patch bent_sheet(const FormShape& shape, bool is_rational, unsigned collapsed, int stretch,
                        Random& random) {
  const int q = shape.is_triangle ? shape.p : shape.q;
  Numbers values(4 * shape.count());
  const auto set = [&](std::size_t at, int i, int j, const bool is_held[4]) {
    const Rational w = is_rational ? Rational(random.between(3, 9)) / Rational(7) : Rational(1);
    // A point that stands for a collapsed side does not depend on the place in it.
    Rational x = Rational(i) / Rational(shape.p), y = Rational(j) / Rational(q);
    const auto noise = [&] { return Rational(random.between(-20, 20)) / Rational(3 * 64); };
    Rational z = noise();
    x += noise() * Rational(1) / Rational(2), y += noise() * Rational(1) / Rational(2);
    const Rational zero, one(1), half = Rational(1) / Rational(2);
    for (int s = 0; s < 4; ++s)
      if (is_held[s]) {
        const bool is_first = s == 0 || s == 3;
        x = s == 1 ? one : s == 3 ? zero : half, y = s == 2 ? one : s == 0 ? zero : half;
        if (shape.is_triangle) x = s == 2 ? zero : half, y = s == 0 ? zero : half;
        if (collapsed == 3 || collapsed == 9 || collapsed == 6) x = one, y = zero;
        z = is_first ? zero : one / Rational(3);
        if (collapsed == 3 || collapsed == 9 || collapsed == 6) z = zero;
      }
    x *= Rational(stretch);
    const std::size_t n = shape.count();
    values[at] = w * (x + z / Rational(5)), values[n + at] = w * (y - x / Rational(7));
    values[2 * n + at] = w * (z + x / Rational(3)), values[3 * n + at] = w;
  };
  const auto held = [&](int s) { return (collapsed >> s & 1) != 0; };
  if (shape.is_triangle) {
    for_each_triangle_index(shape.p, [&](int i, int j, int k) {
      const bool is_held[4] = {held(0) && k == 0, held(1) && i == 0, held(2) && j == 0, false};
      set(triangle_index(j, k), j, k, is_held);
    });
  } else {
    for (int i = 0; i <= shape.p; ++i)
      for (int j = 0; j <= shape.q; ++j) {
        const bool is_held[4] = {held(0) && j == 0, held(1) && i == shape.p,
                                 held(2) && j == shape.q, held(3) && i == 0};
        set(static_cast<std::size_t>(i * (shape.q + 1) + j), i, j, is_held);
      }
  }
  const int components = is_rational ? 4 : 3;
  values.resize(static_cast<std::size_t>(components) * shape.count());
  if (shape.is_triangle)
    return make_patch(Patch::Triangle(shape.p, components, is_rational, std::move(values))).value();
  return make_patch(Patch::Tensor({shape.p, shape.q}, components, is_rational, std::move(values)))
      .value();
}

// A sheet and its back: a closed surface.
inline PatchComplex both_sides(const Patch& sheet) { return complex_of({sheet, reversed(sheet)}); }

inline bool is_within(const Rational& x, const Rational& y, const Rational& bound) {
  return abs(x - y) <= bound;
}
inline Rational from(double v) { return Rational::from_double(v); }

/// Homogeneous control points (x, y, z, w) of a node, in the forest's coordinates.
using ExactPoints = std::vector<std::array<Rational, 4>>;
inline ExactPoints points_of(const PieceForest& forest, std::uint32_t patch, const RationalNet& net) {
  ExactPoints out;
  for (std::size_t i = 0; i < net.shape.count(); ++i) {
    const Rational w = net.components == 4 ? net.at(3, i) : Rational(1);
    out.push_back({{{}, {}, {}, w}});
    for (std::size_t k = 0; k < 3; ++k)
      out.back()[k] = net.at(k, i) + w * from(forest.form(patch).origin[k]);
  }
  return out;
}

/// Calls visit(id, points) for the nodes of one random way down from each root. REQUIRES one root a patch.
template <typename Visit>
void for_some_nodes(PieceForest& forest, Random& random, int depth, Visit visit) {
  for (std::uint32_t p = 0; p < forest.num_patches(); ++p) {
    PieceForest::Id id = forest.form(p).first_root;
    RationalNet net = control_of(forest, p);
    for (int level = 0;; ++level) {
      visit(id, points_of(forest, p, net));
      if (level == depth) break;
      const auto k = static_cast<PieceForest::Id>(random.below(4));
      id = forest.children(id) + k, net = quarter_of(net, k);
    }
  }
}

}  // namespace veritope
