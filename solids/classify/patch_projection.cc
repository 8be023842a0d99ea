// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/patch_projection.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "robust/base/disjoint_sets.h"
#include "solids/base/box_hierarchy.h"
#include "solids/classify/distance_net_internal.h"

namespace veritope {

using namespace internal;

namespace {

// Parts below this part of the model's size are examined no further.
constexpr double kSmallestPart = 0x1p-26;
// Newton's method begins with parts that were halved so often along each axis.
constexpr double kWidestStart = 0.25;
// If Newton's method leaves more than this of the parameters, it goes on with halves of the part.
constexpr double kWideZero = 0x1p-30;

Interval square_of_gap(const Box3& q, const Box3& p) {
  const Box3 d = q - p;
  return sqr(d[0]) + sqr(d[1]) + sqr(d[2]);
}

// A lower bound of the squared distance between points of both boxes.
double least_square_to(const Box3& q, const Box3d& box) {
  Interval sum;
  for (std::size_t c = 0; c < 3; ++c) {
    const Interval below = Interval(box.lo[c]) - q[c], above = q[c] - Interval(box.hi[c]);
    sum += sqr(Interval(std::max({below.lo(), above.lo(), 0.0})));
  }
  return sum.lo();
}

// A lower bound of the squared distances from a part of a patch: by its box, and by the plane across the line to its
// middle.
double least_square_to(const Box3& q, const PatchPiece& piece) {
  const double by_box = least_square_to(q, piece.box());
  const Point3d middle = approx_centre(piece.box()), from = approx_middle(q);
  Box3 n;
  for (std::size_t c = 0; c < 3; ++c) n[c] = Interval(middle[c] - from[c]);
  const Interval length = sqr(n[0]) + sqr(n[1]) + sqr(n[2]);
  if (!(length.lo() > 0) || !std::isfinite(length.hi())) return by_box;
  double gap = HUGE_VAL;
  for (const Box3& p : piece.corners()) gap = std::min(gap, dot(n, p - q).lo());
  Interval reach;
  for (std::size_t c = 0; c < 3; ++c) reach += Interval(mag(n[c])) * Interval(piece.excess()[c]);
  const double beyond = (Interval(gap) - reach).lo();
  if (!(beyond > 0)) return by_box;
  return std::max(by_box, (sqr(Interval(beyond)) / length).lo());
}

}  // namespace

class PatchProjectionSearch {
 public:
  PatchProjectionSearch(const PatchProjection& over, const ExactPoint& point, std::size_t max_parts)
      : over_(over),
        complex_(*over.complex_),
        q_(enclose(point[0]), enclose(point[1]), enclose(point[2])),
        max_parts_(max_parts) {}

  PatchProjectionAnswer run() {
    queue_.push({0, kRange, 0, over_.tree_.root()});
    std::size_t num_parts = 0;
    bool is_decided = true;
    while (!queue_.empty() && queue_.top().least <= bound_) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (entry.kind == kRange) {
        open_range(entry.range);
      } else if (++num_parts > max_parts_) {
        is_decided = false;
        leave(entry.kind, items_[entry.item]);
      } else {
        visit(entry);
      }
    }
    return answer(is_decided);
  }

 private:
  // With its parameters, of a patch or of an edge.
  struct Place : NearestPlace {
    Place() { squared_distance = Interval::from_bounds(0.0, HUGE_VAL); }
    Box2 at;
  };
  enum Kind { kRange, kOfPatch, kOfEdge };
  struct Entry {
    double least;
    Kind kind;
    std::size_t item;  // of items_
    TreeRange range;
    // The least comes first; ties in the order in which items were made.
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.least != b.least ? a.least > b.least : a.item > b.item;
    }
  };

  void open_range(const TreeRange& range) {
    if (range.is_leaf()) return push(kOfPatch, over_.roots_[over_.order_[range.lo]]);
    for (const TreeRange& r : {range.left(), range.right()}) {
      const double least = least_square_to(q_, over_.tree_[r]);
      if (least <= bound_) queue_.push({least, kRange, 0, r});
    }
  }
  void push(Kind kind, PatchPiece piece) {
    for (const Box3& p : piece.corners()) offer_bound(p);
    const double least = least_square_to(q_, piece);
    if (!(least <= bound_)) return;
    items_.push_back(std::move(piece));
    queue_.push({least, kind, items_.size() - 1, {}});
  }
  // A point of the surface lies in the box.
  void offer_bound(const Box3& p) { bound_ = std::min(bound_, square_of_gap(q_, p).hi()); }

  void open_edge(std::uint32_t edge) {
    if (!edges_.insert(edge).second) return;
    const PatchSide side = complex_.sides(edge).front();
    push(kOfEdge, PatchPiece(complex_.patch(side.patch).side(side.side), edge));
  }
  void open_vertex(PatchCorner corner) {
    const std::uint32_t vertex = complex_.vertex(corner);
    if (!vertices_.insert(vertex).second) return;
    const auto p = point_of(complex_.patch(corner.patch).corner(corner.corner));
    VT_CHECK(p.has_value(), "a weight of 0");
    const Box3 point(enclose((*p)[0]), enclose((*p)[1]), enclose((*p)[2]));
    offer_bound(point);
    Place out;
    out.point = point;
    out.feature = PatchFeature::kVertex;
    out.number = vertex;
    out.patch = corner.patch;
    out.is_single = true;
    put(std::move(out));
  }
  // The side u = 0 (axis 0, end 0), u = 1, v = 0 or v = 1 of the square.
  void open_side(std::uint32_t patch, std::size_t axis, std::size_t end) {
    constexpr std::array<std::array<std::uint32_t, 2>, 2> kSides{{{3, 1}, {0, 2}}};
    std::uint32_t side = kSides[axis][end];
    if (complex_.patch(patch).is_triangle() && side == 3) return open_vertex({patch, 0});
    if (complex_.is_collapsed({patch, side})) return open_vertex({patch, side});
    open_edge(complex_.edge({patch, side}));
  }
  // An end of the edge's first side.
  void open_end(std::uint32_t edge, std::size_t end) {
    const PatchSide side = complex_.sides(edge).front();
    const auto n = complex_.patch(side.patch).num_sides();
    open_vertex({side.patch, (side.side + static_cast<std::uint32_t>(end)) % n});
  }
  void open_border(Kind kind, std::uint32_t number, std::size_t axis, std::size_t end) {
    kind == kOfPatch ? open_side(number, axis, end) : open_end(number, end);
  }

  void visit(const Entry& entry) {
    const PatchPiece piece = std::move(items_[entry.item]);
    const std::size_t num_axes = entry.kind == kOfPatch ? 2 : 1;
    const DistanceBounds bounds = distance_bounds(q_, piece.net());
    for (std::size_t a = 0; a < num_axes; ++a) {
      const Sign3 sign = bounds.first[a].sign();
      if (sign != Sign3::kPositive && sign != Sign3::kNegative) continue;
      // The distance falls all the way towards one end of the axis: the least one is beyond it, unless it is a border.
      const std::size_t end = sign == Sign3::kPositive ? 0 : 1;
      if (end == 0 ? piece.begins_at_zero(a) : piece.ends_at_one(a))
        open_border(entry.kind, piece.patch(), a, end);
      return;
    }
    const bool is_convex =
        num_axes == 2 ? bounds.is_convex() : bounds.second[0].sign() == Sign3::kPositive;
    double widest = 0;
    for (std::size_t a = 0; a < num_axes; ++a) widest = std::max(widest, wid(piece.range(a)));
    if (is_convex && widest <= kWidestStart) return find_zero(entry.kind, piece);
    if (extent(piece.box()) <= kSmallestPart * over_.size_ || !piece.can_halve())
      return leave(entry.kind, piece);
    halve(entry.kind, piece);
  }
  void halve(Kind kind, const PatchPiece& piece) {
    auto [low, high] = piece.halves(kind == kOfPatch ? piece.longer_axis() : 0);
    push(kind, std::move(low));
    push(kind, std::move(high));
  }

  // The least point of a convex part is a zero of the gradient, or on the border of the patch.
  void find_zero(Kind kind, const PatchPiece& piece) {
    const std::size_t num_axes = kind == kOfPatch ? 2 : 1;
    for (std::size_t a = 0; a < num_axes; ++a) {
      if (piece.begins_at_zero(a)) open_border(kind, piece.patch(), a, 0);
      if (piece.ends_at_one(a)) open_border(kind, piece.patch(), a, 1);
    }
    const Box2 unit = Box2::filled(Interval::from_bounds(0.0, 1.0));
    Box2 at = unit;
    if (kind == kOfPatch)
      at = contracted(q_, piece.net(), unit);
    else
      at[0] = contracted_curve(q_, piece.net(), unit[0]);
    if (at.is_empty()) return;
    double widest = 0;
    for (std::size_t a = 0; a < num_axes; ++a)
      widest = std::max(widest, wid(at[a]) * wid(piece.range(a)));
    if (widest > kWideZero && extent(piece.box()) > kSmallestPart * over_.size_ &&
        piece.can_halve())
      return halve(kind, piece);
    // A point of the surface in the middle.
    const Box2 middle(Interval(mid(at[0])), kind == kOfPatch ? Interval(mid(at[1])) : Interval());
    offer_bound(hull_of_net(net_over(piece.net(), middle)));
    Place out = place_of(kind, piece, hull_of_net(net_over(piece.net(), at)));
    out.is_single = true;
    for (std::size_t a = 0; a < num_axes; ++a) {
      const Interval range = piece.range(a), lo(range.lo());
      out.at[a] = intersection(lo + (Interval(range.hi()) - lo) * at[a], range);
    }
    put(std::move(out));
  }
  static PatchFeature feature_of(Kind kind) {
    return kind == kOfPatch ? PatchFeature::kPatch : PatchFeature::kEdge;
  }
  std::uint32_t patch_of(Kind kind, const PatchPiece& piece) const {
    return kind == kOfPatch ? piece.patch() : complex_.sides(piece.patch()).front().patch;
  }
  Place place_of(Kind kind, const PatchPiece& piece, const Box3& point) const {
    Place out;
    out.point = point;
    out.feature = feature_of(kind);
    out.number = piece.patch();
    out.patch = patch_of(kind, piece);
    for (std::size_t a = 0; a < 2; ++a) out.at[a] = piece.range(a);
    return out;
  }
  void leave(Kind kind, const PatchPiece& piece) {
    Box3 box;
    for (std::size_t c = 0; c < 3; ++c)
      box[c] = Interval::from_bounds(piece.box().lo[c], piece.box().hi[c]);
    Place out = place_of(kind, piece, box);
    out.squared_distance = Interval::from_bounds(least_square_to(q_, piece), HUGE_VAL);
    put(std::move(out));
  }
  // The squared distance is what is known already and what the box tells.
  void put(Place place) {
    const Interval square = square_of_gap(q_, place.point), known = place.squared_distance;
    place.squared_distance = Interval::from_bounds(std::max({square.lo(), known.lo(), 0.0}),
                                                   std::min(square.hi(), known.hi()));
    places_.push_back(std::move(place));
  }

  void join(const Place& other, Place* into) const;
  bool is_convex_on(const Place& place) const;
  void join_rough_places();
  void join_near_places();
  PatchProjectionAnswer answer(bool is_decided);

  const PatchProjection& over_;
  const PatchComplex& complex_;
  const Box3 q_;
  const std::size_t max_parts_;
  double bound_ = HUGE_VAL;  // the least squared distance is not greater
  std::priority_queue<Entry> queue_;
  std::deque<PatchPiece> items_;
  std::set<std::uint32_t> edges_, vertices_;
  std::vector<Place> places_;
};

// On some box around the place's parameters: the derivatives on a tiny one would be lost in rounding.
bool PatchProjectionSearch::is_convex_on(const Place& place) const {
  if (place.feature == PatchFeature::kVertex) return true;
  const bool is_patch = place.feature == PatchFeature::kPatch;
  std::optional<PatchPiece> curve;
  if (!is_patch) {
    const PatchSide side = complex_.sides(place.number).front();
    curve.emplace(complex_.patch(side.patch).side(side.side), 0);
  }
  const BezierSurface<Interval>& net = (is_patch ? over_.roots_[place.number] : *curve).net();
  for (const double by : {0x1p-4, 0x1p-8, 0x1p-12}) {
    Box2 around = place.at;
    for (std::size_t a = 0; a < 2; ++a)
      around[a] =
          intersection(around[a] + Interval::from_bounds(-by, by), Interval::from_bounds(0.0, 1.0));
    const DistanceBounds bounds = distance_bounds(q_, net_over(net, around));
    if (is_patch ? bounds.is_convex() : bounds.second[0].sign() == Sign3::kPositive) return true;
  }
  return false;
}

// One place that holds both. It is single if both are of one convex part.
void PatchProjectionSearch::join(const Place& other, Place* into) const {
  into->point = hull(into->point, other.point);
  into->squared_distance = hull(into->squared_distance, other.squared_distance);
  const bool is_one_cell = into->feature == other.feature && into->number == other.number;
  const bool are_single = into->is_single && other.is_single;
  if (!is_one_cell && other.feature < into->feature) {
    into->feature = other.feature;
    into->number = other.number;
  }
  into->patch = std::min(into->patch, other.patch);
  into->at = hull(into->at, other.at);
  into->is_single = is_one_cell && are_single && is_convex_on(*into);
}

// Where work has ended early, one place for each cell.
void PatchProjectionSearch::join_rough_places() {
  std::map<std::pair<PatchFeature, std::uint32_t>, Place> all;
  for (const Place& p : places_) {
    const auto [at, is_new] = all.try_emplace({p.feature, p.number}, p);
    if (is_new) continue;
    at->second.is_single = false;
    join(p, &at->second);
  }
  places_.clear();
  for (const auto& entry : all) places_.push_back(entry.second);
}

// Places that may have a point in common become one.
void PatchProjectionSearch::join_near_places() {
  for (bool has_joined = true; has_joined;) {
    has_joined = false;
    for (std::size_t i = 0; i < places_.size(); ++i)
      for (std::size_t k = places_.size(); k-- > i + 1;) {
        if (is_disjoint(places_[i].point, places_[k].point)) continue;
        join(places_[k], &places_[i]);
        places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(k));
        has_joined = true;
      }
  }
}

PatchProjectionAnswer PatchProjectionSearch::answer(bool is_decided) {
  if (!is_decided) join_rough_places();
  std::erase_if(places_, [&](const Place& p) { return square_of_gap(q_, p.point).lo() > bound_; });
  join_near_places();
  PatchProjectionAnswer out;
  out.is_decided = is_decided;
  double least = bound_;
  for (const Place& p : places_) {
    least = std::min(least, p.squared_distance.lo());
    out.places.push_back(p);
  }
  out.squared_distance = Interval::from_bounds(std::max(least, 0.0), bound_);
  std::sort(out.places.begin(), out.places.end(), [](const NearestPlace& a, const NearestPlace& b) {
    for (std::size_t c = 0; c < 3; ++c)
      if (a.point[c].lo() != b.point[c].lo()) return a.point[c].lo() < b.point[c].lo();
    return std::pair(a.feature, a.number) < std::pair(b.feature, b.number);
  });
  return out;
}

PatchProjection::PatchProjection(const PatchComplex& complex) : complex_(&complex) {
  const ScopedUpward upward;
  std::vector<Box3d> boxes;
  Box3d all = empty_box();
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p) {
    roots_.emplace_back(complex.patch(p), p);
    boxes.push_back(roots_.back().box());
    all = veritope::hull(all, boxes.back());
  }
  size_ = extent(all);
  order_ = BoxHierarchy(boxes).order();
  tree_ = RangeTree<Box3d>(
      boxes.size(), 1, [&](std::uint32_t p) { return boxes[order_[p]]; },
      [](const Box3d& a, const Box3d& b) { return veritope::hull(a, b); });
}

PatchProjectionAnswer PatchProjection::project(const ExactPoint& point,
                                               std::size_t max_parts) const {
  const ScopedUpward upward;
  return PatchProjectionSearch(*this, point, max_parts).run();
}

}  // namespace veritope
