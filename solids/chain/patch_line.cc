// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "robust/simplest.h"
#include "solids/chain/integer_net_internal.h"
#include "solids/chain/literal_polynomials_internal.h"
#include "solids/chain/patch_line_internal.h"

namespace veritope::internal {
namespace {

constexpr std::size_t kMostPieces = 512;  // of one level

using GridPoint =
    std::array<std::uint64_t, 2>;     // the first two barycentric coordinates, times 2^level
using Net = BezierTriangle<Integer>;  // x, y along the base from the line, z along it
using Plane2 = std::array<Integer, 2>;

struct LinePiece {
  Net net;
  std::array<GridPoint, 3> corners;
};

Sign turn(const Plane2& a, const Plane2& b) { return (a[0] * b[1] - a[1] * b[0]).sign(); }

// Whether the origin is off the convex hull: then some point has all others within half a turn to its left.
bool misses_origin(const std::vector<Plane2>& points) {
  return std::any_of(points.begin(), points.end(), [&](const Plane2& a) {
    return std::all_of(points.begin(), points.end(), [&](const Plane2& b) {
      const Sign s = turn(a, b);
      return s > 0 || (s == 0 && (a[0] * b[0] + a[1] * b[1]).sign() > 0);
    });
  });
}

Plane2 at(const Net& net, std::size_t i) { return {net.component(0)[i], net.component(1)[i]}; }

struct SignRange {
  bool has_positive = false, has_negative = false, has_zero = false;
  explicit SignRange(std::span<const Integer> values) {
    for (const Integer& v : values) {
      const Sign s = v.sign();
      has_positive = has_positive || s > 0;
      has_negative = has_negative || s < 0;
      has_zero = has_zero || s == 0;
    }
  }
  bool is_positive() const { return !has_negative && !has_zero; }
  bool is_negative() const { return !has_positive && !has_zero; }
};

// No point of the piece is on the half-line.
bool misses_half_line(const Net& net) {
  for (const int c : {0, 1}) {
    const SignRange range(net.component(c));
    if (range.is_positive() || range.is_negative()) return true;
  }
  if (SignRange(net.component(2)).is_negative()) return true;
  std::vector<Plane2> points;
  for (std::size_t i = 0; i < net.count(); ++i) points.push_back(at(net, i));
  return misses_origin(points);
}

GridPoint doubled(const GridPoint& a) { return {2 * a[0], 2 * a[1]}; }
GridPoint sum_of(const GridPoint& a, const GridPoint& b) { return {a[0] + b[0], a[1] + b[1]}; }

std::vector<LinePiece> parts_of(const LinePiece& p) {
  const GridPoint g0 = doubled(p.corners[0]), g1 = doubled(p.corners[1]),
                  g2 = doubled(p.corners[2]), h0 = sum_of(p.corners[1], p.corners[2]),
                  h1 = sum_of(p.corners[0], p.corners[2]), h2 = sum_of(p.corners[0], p.corners[1]);
  auto parts = quarters_of(p.net);
  return {{std::move(parts[0]), {g0, h2, h1}},
          {std::move(parts[1]), {h2, g1, h0}},
          {std::move(parts[2]), {h1, h0, g2}},
          {std::move(parts[3]), {h0, h1, h2}}};
}

// The control polygon of a side, from corner s to corner s + 1.
std::vector<Plane2> side_polygon(const Net& net, std::size_t s) {
  std::vector<Plane2> out;
  const int n = net.degree();
  for (int t = 0; t <= n; ++t)
    out.push_back(at(net, s == 0   ? triangle_index(t, 0)
                          : s == 1 ? triangle_index(n - t, t)
                                   : triangle_index(0, n - t)));
  return out;
}

// How often a part of a closed polygon crosses the first axis to the right of the origin.
int crossings(const std::vector<Plane2>& polygon) {
  int out = 0;
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    const Plane2 &p = polygon[i], &q = polygon[i + 1];
    const bool is_low = p[1].sign() <= 0, ends_low = q[1].sign() <= 0;
    if (is_low && !ends_low && turn(p, q) > 0) ++out;
    if (!is_low && ends_low && turn(p, q) < 0) --out;
  }
  return out;
}

// Pieces that share corners, directly or through others, as lists of their numbers.
std::vector<std::vector<std::size_t>> clusters_of(const std::vector<LinePiece>& pieces) {
  std::vector<std::size_t> root(pieces.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  std::map<GridPoint, std::size_t> first;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const GridPoint& g : pieces[i].corners)
      if (const auto [known, is_new] = first.emplace(g, i); !is_new)
        root[find(i)] = find(known->second);
  std::map<std::size_t, std::vector<std::size_t>> by_root;
  for (std::size_t i = 0; i < pieces.size(); ++i) by_root[find(i)].push_back(i);
  std::vector<std::vector<std::size_t>> out;
  for (auto& [r, members] : by_root) out.push_back(std::move(members));
  return out;
}

// Whether the union of these pieces has a point on the line, and all of it is beyond the point: the projected boundary
// of the union misses the origin and winds around it.
bool is_met(const std::vector<LinePiece>& pieces, const std::vector<std::size_t>& cluster) {
  std::map<std::pair<GridPoint, GridPoint>, std::pair<std::size_t, std::size_t>> border;
  for (const std::size_t i : cluster) {
    if (!SignRange(pieces[i].net.component(2)).is_positive()) return false;
    for (std::size_t s = 0; s < 3; ++s) {
      const GridPoint &a = pieces[i].corners[s], &b = pieces[i].corners[(s + 1) % 3];
      const auto [known, is_new] = border.emplace(std::minmax(a, b), std::pair(i, s));
      if (!is_new) border.erase(known);
    }
  }
  int winding = 0;
  for (const auto& [ends, side] : border) {
    const std::vector<Plane2> polygon = side_polygon(pieces[side.first].net, side.second);
    if (!misses_origin(polygon)) return false;
    winding += crossings(polygon);
  }
  return winding != 0;
}

// The simplest number of [lo, hi] / unit, or so near that the halvings do not tell.
Rational simplest_parameter(std::uint64_t lo, std::uint64_t hi, const Rational& unit) {
  if (lo == 0) return Rational(0);
  if (Rational(hi) >= unit) return Rational(1);
  const Rational half = Rational(1) / Rational(2);
  return simplest_between((Rational(lo) - half) / unit, (Rational(hi) + half) / unit);
}

// Tries the simplest parameters of a cluster: whether there the patch is on the half-line.
Meets guess(const Net& net, const std::vector<LinePiece>& pieces,
            const std::vector<std::size_t>& cluster, int level) {
  GridPoint lo = pieces[cluster.front()].corners[0], hi = lo;
  for (const std::size_t i : cluster)
    for (const GridPoint& g : pieces[i].corners)
      for (std::size_t k = 0; k < 2; ++k) {
        lo[k] = std::min(lo[k], g[k]);
        hi[k] = std::max(hi[k], g[k]);
      }
  const Rational unit = Rational::power_of_two(level);
  const Rational u = simplest_parameter(lo[0], hi[0], unit),
                 v = simplest_parameter(lo[1], hi[1], unit), w = Rational(1) - u - v;
  if (w.sign() < 0) return Meets::kOpen;
  const Integer scale = lcm(u.denominator(), v.denominator());
  const auto times_scale = [&](const Rational& x) {
    return x.numerator() * divide_exactly(scale, x.denominator());
  };
  const std::vector<Integer> at =
      evaluate<Integer>(net, {times_scale(u), times_scale(v), times_scale(w)});
  if (!at[0].is_zero() || !at[1].is_zero() || at[2].sign() < 0) return Meets::kOpen;
  return at[2].is_zero() ? Meets::kOn : Meets::kTouches;
}

Meets search(const Net& net) {
  std::vector<LinePiece> pieces;
  pieces.push_back({net, {{{1, 0}, {0, 1}, {0, 0}}}});
  for (int level = 0; level <= PatchLine::kMostLevels; ++level) {
    std::erase_if(pieces, [](const LinePiece& p) { return misses_half_line(p.net); });
    if (pieces.empty()) return Meets::kNone;
    if (pieces.size() > kMostPieces) return Meets::kOpen;
    const bool guesses = level > 0 && level % 16 == 0;
    for (const auto& cluster : clusters_of(pieces)) {
      if (is_met(pieces, cluster)) return Meets::kSome;
      if (!guesses) continue;
      const Meets guessed = guess(net, pieces, cluster, level);
      if (guessed != Meets::kOpen) return guessed;
    }
    std::vector<LinePiece> next;
    for (const LinePiece& p : pieces)
      for (LinePiece& q : parts_of(p)) next.push_back(std::move(q));
    pieces = std::move(next);
  }
  return Meets::kOpen;
}

// a - at w, times a positive integer and `factor`.
void set_difference(std::span<const Integer> a, std::span<const Integer> w, const Rational& at,
                    int factor, std::span<Integer> out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = at.denominator() * a[i] - at.numerator() * w[i];
    if (factor < 0) out[i].negate();
  }
}

}  // namespace

PatchLine::PatchLine(const LiteralFacet& facet) : net_(facet.map->degree(), 4, false) {
  const auto base = base_forms(facet);
  Polynomial weight = weight_form(facet);
  if (!facet.map->is_rational())
    weight = Polynomial(net_.degree(), 1, false, std::vector<Rational>(net_.count(), Rational(1)));
  const std::array<Polynomial, 4> forms{base[0], base[1], height_form(facet), std::move(weight)};
  BezierTriangle<Rational> all(net_.degree(), 4, false);
  for (int k = 0; k < 4; ++k)
    std::copy(forms[static_cast<std::size_t>(k)].coefficients().begin(),
              forms[static_cast<std::size_t>(k)].coefficients().end(), all.component(k).begin());
  net_ = integer_net(all);
}

Meets PatchLine::half_line(const LiteralFacet& facet, const ExactPoint& q, bool is_upward) const {
  const auto along = base_coordinates(facet, q);
  Net net(net_.degree(), 3, false);
  const auto w = net_.component(3);
  set_difference(net_.component(0), w, along[0], 1, net.component(0));
  set_difference(net_.component(1), w, along[1], 1, net.component(1));
  set_difference(net_.component(2), w, facet.height(q), is_upward ? 1 : -1, net.component(2));
  return search(net);
}

Meets PatchLine::point(const LiteralFacet& facet, const ExactPoint& q) const {
  for (const bool is_upward : {false, true}) {
    const Meets met = half_line(facet, q, is_upward);
    if (met == Meets::kNone || met == Meets::kOn) return met;
  }
  return Meets::kOpen;
}

}  // namespace veritope::internal
