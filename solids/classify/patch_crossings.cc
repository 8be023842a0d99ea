// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/classify/corner_hull.h"
#include "solids/classify/curve_crossings.h"
#include "solids/classify/distance_net_internal.h"

namespace veritope {

using namespace internal;

namespace {

// Parts below this part of the model's size are examined no further.
constexpr double kSmallPart = 0x1p-26;
// Parts as wide as this in all parameters are not tried yet.
constexpr double kWidestTrial = 0.5;
constexpr double kNarrowPart = 0x1p-12;
constexpr int kCrossingRounds = 10;

// Values t, u, v of the equation C(t) = S(u, v).
using TripleBox = std::array<Interval, 3>;

Interval unit() { return Interval::from_bounds(0.0, 1.0); }

// Grown by half its width at both ends, in [0,1].
Interval grown_range(const Interval& a) {
  const double by = 0.5 * wid(a);
  return Interval::from_bounds(std::max(a.lo() - by, 0.0), std::min(a.hi() + by, 1.0));
}

// C(t) - S(u, v) of one curve and one patch.
class Meeting {
 public:
  Meeting(const PatchPiece& curve, const PatchPiece& patch)
      : curve_(curve.net()), patch_(patch.net()) {}

  Box3 difference_at(const std::array<double, 3>& m) const {
    return point_at(curve_, m[0], 0) - point_at(patch_, m[1], m[2]);
  }
  // Columns: C_t, -S_u, -S_v over the box.
  std::array<Box3, 3> derivatives(const TripleBox& x) const {
    const auto c = first_derivatives(curve_, Box2(x[0], unit()));
    const auto s = first_derivatives(patch_, Box2(x[1], x[2]));
    return {c[0], Box3() - s[0], Box3() - s[1]};
  }

 private:
  static Box3 point_at(const BezierSurface<Interval>& net, double u, double v) {
    return hull_of_net(net_over(net, Box2(Interval(u), Interval(v))));
  }
  const BezierSurface<Interval>&curve_, &patch_;
};

enum class Trial { kNone, kOne, kUnknown };

// Whether the box holds no solution, or exactly one, which then is in what it is shrunk to. By Krawczyk's operator.
Trial try_crossing(const Meeting& meeting, TripleBox* x) {
  std::array<Box3, 3> j;
  bool is_proved = false;
  for (int round = 0; round < kCrossingRounds; ++round) {
    if (round == 0 ||
        std::all_of(x->begin(), x->end(), [](const Interval& a) { return wid(a) > kNarrowPart; }))
      j = meeting.derivatives(*x);
    std::array<double, 3> m;
    for (std::size_t i = 0; i < 3; ++i) m[i] = mid((*x)[i]);
    // The rows of an approximate inverse: crosses of columns, over the determinant.
    std::array<Point3d, 3> a;
    for (std::size_t i = 0; i < 3; ++i) a[i] = approx_middle(j[i]);
    std::array<Box3, 3> y;
    const auto approx_cross_of = [&](const Point3d& p, const Point3d& q) {
      return Point3d{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                     p[0] * q[1] - p[1] * q[0]};
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3d n = approx_cross_of(a[(i + 1) % 3], a[(i + 2) % 3]);
      const double det = n[0] * a[i][0] + n[1] * a[i][1] + n[2] * a[i][2];
      for (std::size_t c = 0; c < 3; ++c) {
        if (!std::isfinite(n[c] / det)) return is_proved ? Trial::kOne : Trial::kUnknown;
        y[i][c] = Interval(n[c] / det);
      }
    }
    const Box3 f = meeting.difference_at(m);
    TripleBox next;
    bool is_inside = true, shrinks = false;
    for (std::size_t i = 0; i < 3; ++i) {
      Interval k = Interval(m[i]) - dot(y[i], f);
      for (std::size_t b = 0; b < 3; ++b)
        k += (Interval(i == b ? 1.0 : 0.0) - dot(y[i], j[b])) * ((*x)[b] - Interval(m[b]));
      is_inside = is_inside && k.lo() > (*x)[i].lo() && k.hi() < (*x)[i].hi();
      next[i] = intersection(k, (*x)[i]);
      if (next[i].is_empty()) return Trial::kNone;
      shrinks = shrinks || wid(next[i]) < 0.75 * wid((*x)[i]);
    }
    is_proved = is_proved || is_inside;
    *x = next;
    if (!shrinks) break;
  }
  return is_proved ? Trial::kOne : Trial::kUnknown;
}

class PatchCrossingSearch {
 public:
  PatchCrossingSearch(const std::vector<PatchPiece>& roots, const PatchPiece& curve, double size)
      : roots_(roots), curve_(curve), size_(size) {}

  void with_patch(std::uint32_t patch, std::size_t* pairs_left, CurveCrossings* out) {
    proved_.clear();
    stack_.clear();
    stack_.push_back({curve_, roots_[patch]});
    std::vector<CurveCrossing> open;
    while (!stack_.empty()) {
      const Pair pair = std::move(stack_.back());
      stack_.pop_back();
      if (CornerHull(pair.curve).is_apart(CornerHull(pair.patch))) continue;
      if (*pairs_left == 0) {
        out->is_complete = false;
        leave(pair, &open);
        continue;
      }
      --*pairs_left;
      if (is_settled(pair)) continue;
      if (!halve(pair)) leave(pair, &open);
    }
    for (const Proved& p : proved_) out->places.push_back(p.place);
    join(std::move(open), out);
  }

 private:
  struct Pair {
    PatchPiece curve, patch;
  };
  // In `within` there is no other crossing than this one.
  struct Proved {
    TripleBox within;
    CurveCrossing place;
  };

  static TripleBox ranges_of(const Pair& pair) {
    return {pair.curve.range(0), pair.patch.range(0), pair.patch.range(1)};
  }
  CurveCrossing place_at(const TripleBox& x, std::uint32_t patch) const {
    CurveCrossing out;
    out.t = x[0];
    out.patch = patch;
    out.parameters = Box2(x[1], x[2]);
    out.point = intersection(hull_of_net(net_over(curve_.net(), Box2(x[0], unit()))),
                             hull_of_net(net_over(roots_[patch].net(), out.parameters)));
    return out;
  }
  // Two boxes without a common point have no crossing.
  void leave(const Pair& pair, std::vector<CurveCrossing>* open) const {
    CurveCrossing place = place_at(ranges_of(pair), pair.patch.patch());
    if (!place.point.is_empty()) open->push_back(place);
  }
  static bool contains(const TripleBox& x, const TripleBox& part) {
    for (std::size_t i = 0; i < 3; ++i)
      if (!is_subset(part[i], x[i])) return false;
    return true;
  }

  bool is_settled(const Pair& pair) {
    const TripleBox own = ranges_of(pair);
    for (const Proved& p : proved_)
      if (contains(p.within, own)) return true;
    for (const Interval& a : own)
      if (wid(a) > kWidestTrial) return false;
    TripleBox x = own, within;
    for (Interval& a : x) a = grown_range(a);
    within = x;
    switch (try_crossing(Meeting(curve_, roots_[pair.patch.patch()]), &x)) {
      case Trial::kNone: return true;
      case Trial::kUnknown: return false;
      default: break;
    }
    for (const Proved& p : proved_)
      if (contains(p.within, x)) return true;
    CurveCrossing place = place_at(x, pair.patch.patch());
    place.is_proved = true;
    proved_.push_back({within, place});
    return true;
  }

  // False if both are small.
  bool halve(const Pair& pair) {
    const double c = extent(pair.curve.box()), s = extent(pair.patch.box());
    if (std::max(c, s) <= kSmallPart * size_) return false;
    if (!pair.curve.can_halve() || !pair.patch.can_halve()) return false;
    auto [low, high] = c >= s ? pair.curve.halves(0) : pair.patch.halves(pair.patch.longer_axis());
    Pair a = pair, b = pair;
    (c >= s ? a.curve : a.patch) = std::move(low);
    (c >= s ? b.curve : b.patch) = std::move(high);
    stack_.push_back(std::move(b));
    stack_.push_back(std::move(a));
    return true;
  }

  // Open places of one patch that have values in common become one.
  static void join(std::vector<CurveCrossing> open, CurveCrossings* out) {
    std::sort(open.begin(), open.end(),
              [](const CurveCrossing& a, const CurveCrossing& b) { return a.t.lo() < b.t.lo(); });
    const std::size_t first = out->places.size();
    for (const CurveCrossing& p : open) {
      bool is_joined = false;
      for (std::size_t i = first; i < out->places.size() && !is_joined; ++i) {
        CurveCrossing& q = out->places[i];
        if (is_disjoint(p.t, q.t) || is_disjoint(p.parameters, q.parameters)) continue;
        q.t = hull(q.t, p.t);
        q.parameters = hull(q.parameters, p.parameters);
        q.point = hull(q.point, p.point);
        is_joined = true;
      }
      if (!is_joined) out->places.push_back(p);
    }
  }

  const std::vector<PatchPiece>& roots_;
  const PatchPiece& curve_;
  const double size_;
  std::vector<Pair> stack_;
  std::vector<Proved> proved_;
};

}  // namespace

PatchCrossings::PatchCrossings(const PatchComplex& complex) {
  const ScopedUpward upward;
  std::vector<Box3d> boxes;
  Box3d all = empty_box();
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p) {
    roots_.emplace_back(complex.patch(p), p);
    boxes.push_back(roots_.back().box());
    all = hull(all, boxes.back());
  }
  size_ = extent(all);
  tree_ = BoxHierarchy(boxes);
}

CurveCrossings PatchCrossings::find(const BezierCurve<Rational>& curve,
                                    std::size_t max_pairs) const {
  VT_CHECK(curve.dimension() == 3 && curve.degree(0) >= 1, "a curve in space");
  const ScopedUpward upward;
  const PatchPiece piece(curve, 0);
  CurveCrossings out;
  PatchCrossingSearch search(roots_, piece, size_);
  tree_.visit([&](const Box3d& b) { return meets(b, piece.box()); },
              [&](std::uint32_t p) { search.with_patch(p, &max_pairs, &out); });
  std::sort(
      out.places.begin(), out.places.end(), [](const CurveCrossing& a, const CurveCrossing& b) {
        const double x = a.t.lo(), y = b.t.lo(), u = a.parameters[0].lo(), v = b.parameters[0].lo();
        return std::tie(x, a.patch, u) < std::tie(y, b.patch, v);
      });
  return out;
}

}  // namespace veritope
