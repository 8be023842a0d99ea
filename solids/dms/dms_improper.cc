// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_improper.cc: common points of two triangles beside their common vertices and edge (dms_domain.h).
#include <algorithm>
#include <utility>

#include "solids/dms/dms_domain.h"
#include "solids/dms/dms_exact_knots_internal.h"
#include "solids/dms/dms_knots.h"

namespace veritope::internal {
namespace {

using Triple = std::array<Rational, 3>;

bool has(const CornersWithIds& t, std::uint32_t id) {
  return std::find(t.ids.begin(), t.ids.end(), id) != t.ids.end();
}
std::array<Sign, 3> signs_beside(const CornersWithIds& plane, const CornersWithIds& t) {
  std::array<Sign, 3> out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = has(plane, t.ids[i]) ? Sign::kZero : side_of(plane.points, *t.points[i]);
  return out;
}
// Whether the plane has t on one closed side, and only common vertices lie in it.
bool parts(const CornersWithIds& plane, const CornersWithIds& t, const std::array<Sign, 3>& signs) {
  int side = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (signs[i] == Sign::kZero) {
      if (!has(plane, t.ids[i])) return false;
      continue;
    }
    const int here = static_cast<int>(signs[i]);
    if (here == -side) return false;
    side = here;
  }
  return true;
}

// The axis along which the plane of a triangle is not seen edge on, and its orientation then.
std::pair<int, Sign> axis_of(const CornersWithIds& t) {
  for (int axis = 0; axis < 2; ++axis)
    if (const Sign s = orient2d_projected(*t.points[0], *t.points[1], *t.points[2], axis);
        s != Sign::kZero)
      return {axis, s};
  return {2, orient2d_projected(*t.points[0], *t.points[1], *t.points[2], 2)};
}
// Whether a side's line parts two triangles of one plane, and only common vertices of the other one lie on it.
bool is_parted_in_plane(const CornersWithIds& f, const CornersWithIds& g) {
  const auto [axis, turn] = axis_of(f);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    bool is_off = true;
    for (std::size_t k = 0; k < 3 && is_off; ++k) {
      if (g.ids[k] == f.ids[i] || g.ids[k] == f.ids[j]) continue;
      const Sign s = orient2d_projected(*f.points[i], *f.points[j], *g.points[k], axis);
      is_off = s == -turn || (s == Sign::kZero && has(f, g.ids[k]));
    }
    if (is_off) return true;
  }
  return false;
}

const DmsPoint& at(const CornersWithIds& t, std::size_t i) { return t.points[i]->at(); }
DmsPoint normal_of(const CornersWithIds& t) {
  return cross_product(difference(at(t, 1), at(t, 0)), difference(at(t, 2), at(t, 0)));
}
// The weights of a point of the plane; nothing if it is outside of the triangle.
std::optional<Triple> weights_of(const CornersWithIds& t, const DmsPoint& p) {
  const DmsPoint normal = normal_of(t);
  const Rational whole = dot_product(normal, normal);
  Triple out;
  for (std::size_t i = 0; i < 3; ++i) {
    const DmsPoint area =
        cross_product(difference(at(t, (i + 1) % 3), p), difference(at(t, (i + 2) % 3), p));
    out[i] = dot_product(normal, area) / whole;
    if (out[i].sign() == Sign::kNegative) return std::nullopt;
  }
  return out;
}

// A common point of f and g, as weights of f, if it is one of g, too.
std::optional<ImproperPoint> if_common(const CornersWithIds& f, const CornersWithIds& g,
                                       Triple weights) {
  DmsPoint p;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t c = 0; c < 3; ++c) p[c] += weights[i] * at(f, i)[c];
  auto others = weights_of(g, p);
  if (!others) return std::nullopt;
  bool is_proper = true;
  for (std::size_t i = 0; i < 3; ++i)
    is_proper = is_proper && (weights[i].sign() == Sign::kZero || has(g, f.ids[i]));
  if (is_proper) return std::nullopt;
  return ImproperPoint{false, {std::move(weights), std::move(*others)}, std::move(p)};
}

// A vertex of f in g, or a point where an edge of f crosses the plane of g in g.
std::optional<ImproperPoint> through(const CornersWithIds& f, const CornersWithIds& g) {
  const DmsPoint normal = normal_of(g);
  Triple height;
  for (std::size_t i = 0; i < 3; ++i)
    height[i] = dot_product(normal, difference(at(f, i), at(g, 0)));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    Triple weights;
    if (height[i].sign() == Sign::kZero) {
      weights[i] = Rational(1);
    } else if ((height[i] * height[j]).sign() == Sign::kNegative) {
      weights[j] = height[i] / (height[i] - height[j]);
      weights[i] = Rational(1) - weights[j];
    } else {
      continue;
    }
    if (auto found = if_common(f, g, std::move(weights))) return found;
  }
  return std::nullopt;
}
// A point inside of an edge of each of two triangles of one plane.
std::optional<ImproperPoint> across(const CornersWithIds& f, const CornersWithIds& g) {
  const DmsPoint normal = normal_of(f);
  const auto area = [&](const DmsPoint& a, const DmsPoint& b, const DmsPoint& p) {
    return dot_product(normal, cross_product(difference(b, a), difference(p, a)));
  };
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t j = (i + 1) % 3, l = (k + 1) % 3;
      const Rational from = area(at(g, k), at(g, l), at(f, i)),
                     to = area(at(g, k), at(g, l), at(f, j));
      if ((from * to).sign() != Sign::kNegative) continue;
      Triple weights;
      weights[j] = from / (from - to);
      weights[i] = Rational(1) - weights[j];
      if (auto found = if_common(f, g, std::move(weights))) return found;
    }
  return std::nullopt;
}

}  // namespace

// The common points are a convex set; if one of them is improper, so is one of its corners: a vertex of one triangle
// in the other, an edge through the other's plane, or, in one plane, two edges that cross.
std::optional<ImproperPoint> find_improper_point(const CornersWithIds& f, const CornersWithIds& g) {
  const std::array<Sign, 3> of_g = signs_beside(f, g);
  if (parts(f, g, of_g)) return std::nullopt;
  const std::array<Sign, 3> of_f = signs_beside(g, f);
  if (parts(g, f, of_f)) return std::nullopt;
  const bool is_flat =
      std::all_of(of_g.begin(), of_g.end(), [](Sign s) { return s == Sign::kZero; });
  if (is_flat && (is_parted_in_plane(f, g) || is_parted_in_plane(g, f))) return std::nullopt;
  if (auto found = through(f, g)) return found;
  if (auto found = through(g, f)) {
    found->is_swapped = true;
    return found;
  }
  return is_flat ? across(f, g) : std::nullopt;
}

}  // namespace veritope::internal
