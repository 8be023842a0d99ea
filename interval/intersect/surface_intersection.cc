// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/surface_intersection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/intersect/intersection_clip.h"
#include "interval/intersect/intersection_contact.h"
#include "interval/upward.h"

namespace veritope {
namespace {

using internal::approx_middle;

Result<EnclosedSurface> prepared(const BSpline<Rational, 2>& surface, const char* which) {
  auto made = EnclosedSurface::make(surface);
  if (made) return made;
  Error error = made.error();
  error.message = std::string("the ") + which + " surface: " + error.message;
  return error;
}

class Intersector {
 public:
  Intersector(const BSpline<Rational, 2>& first, const BSpline<Rational, 2>& second,
              const EnclosedSurface& s1, const EnclosedSurface& s2,
              const IntersectionOptions& options)
      : first_(first), second_(second), s1_(s1), s2_(s2), options_(options) {}

  SurfaceIntersection run() {
    const IntersectionCover cover = cover_intersection(s1_, s2_, options_.budget);
    out_.pairs = cover.pairs, out_.proofs = cover.proofs;
    const BranchSet set = join_branches(s1_, s2_, cover.tubes);
    std::vector<Box4> open = set.unresolved;
    for (const BranchChain& chain : set.chains) {
      const Box4 box = box_of(set, chain);
      if (chain.is_partial && is_part_of_one(box, set.unresolved)) {
        open.push_back(box);
      } else {
        add_branch(set, chain);
      }
    }
    for (const OpenPair reason : {OpenPair::kSmallest, OpenPair::kCluster, OpenPair::kBudget}) {
      std::vector<Box4> boxes;
      for (std::size_t i = 0; i < cover.undecided.size(); ++i)
        if (cover.reasons[i] == reason) boxes.push_back(cover.undecided[i]);
      add_contacts(boxes, text_of(reason), true, reason == OpenPair::kSmallest);
    }
    add_contacts(open,
                 "a branch touches the border of a domain, or its continuation is not decided",
                 false, false);
    return std::move(out_);
  }

 private:
  double wanted_gap() const {
    const Box3 box = s1_.range(parameter_domain(s1_, s2_, 0), parameter_domain(s1_, s2_, 1)).point;
    // Nobody can prove a gap smaller than rounding permits.
    const double rounding = 0x1p-38 * std::max({mag(box[0]), mag(box[1]), mag(box[2])});
    return std::max(options_.gap > 0 ? options_.gap : 0x1p-24 * width(box), rounding);
  }

  static Box4 box_of(const BranchSet& set, const BranchChain& chain) {
    Box4 out = Box4::empty();
    for (const BranchStep& step : chain.steps) {
      const auto [lo, hi] = std::minmax(step.from, step.to);
      out = hull(out, set.arcs[step.arc].tube.over(Interval::from_bounds(lo, hi)));
    }
    return out;
  }
  /// Whether a partial branch is little more than a piece of an undecided place.
  static bool is_part_of_one(const Box4& box, const std::vector<Box4>& places) {
    return std::any_of(places.begin(), places.end(), [&](const Box4& place) {
      return !is_disjoint(box, place) && width(box) <= 64 * width(place);
    });
  }

  void add_branch(const BranchSet& set, const BranchChain& chain) {
    IntersectionBranch branch;
    branch.is_closed = chain.is_closed, branch.is_partial = chain.is_partial;
    branch.num_boxes = chain.steps.size();
    branch.segments = trace_branch(s1_, s2_, set, chain, wanted_gap());
    for (const CurveSegment& s : branch.segments) {
      branch.length = branch.length + s.length;
      branch.gap = std::max(branch.gap, s.gap);
    }
    for (const BranchStep& step : chain.steps) {
      // Two steps meet in a place that is only enclosed: what lies there is counted once, twice or not at all.
      const double meeting = length_over(s1_, set.arcs[step.arc], step.entry);
      branch.length = branch.length + Interval::from_bounds(-meeting, meeting);
    }
    const BranchStep &first = chain.steps.front(), &last = chain.steps.back();
    const double rest = length_over(s1_, set.arcs[last.arc], last.exit);
    branch.length = intersection(branch.length + Interval::from_bounds(0, rest),
                                 Interval::from_bounds(0, std::numeric_limits<double>::infinity()));
    extend(set.arcs[first.arc], first.entry, first.from, &branch.segments.front());
    extend(set.arcs[last.arc], last.exit, last.to, &branch.segments.back());
    out_.branches.push_back(std::move(branch));
  }

  /// Extends the boxes of a segment so that they hold its ends, too.
  void extend(const DomainArc& arc, const Interval& place, double inner,
              CurveSegment* segment) const {
    const Box4 x = box_over(s1_, s2_, arc, place, inner);
    segment->parameters = hull(segment->parameters, x);
    segment->space = hull(segment->space, s1_.range(x[0], x[1]).point);
  }

  static const char* text_of(OpenPair reason) {
    switch (reason) {
      case OpenPair::kSmallest:
        return "at the smallest size: nearly tangential, degenerate, or within rounding";
      case OpenPair::kCluster: return "contact along a curve or an area, or nearly so";
      case OpenPair::kBudget: return "the subdivision's budget was spent";
    }
    return "";
  }

  void add_contacts(const std::vector<Box4>& boxes, const char* reason, bool may_overlap,
                    bool may_touch) {
    for (const auto& cluster : clusters_of(boxes)) {
      IntersectionContact contact;
      contact.parameters = boxes[cluster.front()];
      for (const std::size_t i : cluster) contact.parameters = hull(contact.parameters, boxes[i]);
      contact.num_boxes = cluster.size();
      contact.reason = reason;
      if (may_touch && is_tangency(&contact)) {
        contact.reason.clear();
      } else if (may_overlap) {
        classify_overlap(boxes, cluster, &contact);
      }
      contact.space = s1_.range(contact.parameters[0], contact.parameters[1]).point;
      list_of(contact.kind).push_back(std::move(contact));
    }
  }
  std::vector<IntersectionContact>& list_of(IntersectionContact::Kind kind) {
    if (kind == IntersectionContact::Kind::kOverlap) return out_.overlaps;
    return kind == IntersectionContact::Kind::kTangency ? out_.tangencies : out_.unresolved;
  }

  /// True for one pair of points with a common normal and no proved distance, in a box so small that its place is the
  /// answer. The box lies inside both domains, and inside one piece of each surface, so that the normals are
  /// differentiable.
  bool is_tangency(IntersectionContact* contact) const {
    if (!is_small_and_smooth(contact->parameters)) return false;
    const auto normal = find_common_normal(s1_, s2_, contact->parameters);
    if (!normal || !is_small_and_smooth(normal->unique_in) || !is_member(0, normal->separation))
      return false;
    contact->kind = IntersectionContact::Kind::kTangency;
    contact->shape = normal->shape;
    contact->separation = normal->separation;
    contact->parameters = hull(contact->parameters, normal->parameters);
    return true;
  }
  bool is_small_and_smooth(const Box4& x) const {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& breaks = (i < 2 ? s1_ : s2_).breaks(i % 2);
      const auto above = std::upper_bound(breaks.begin(), breaks.end(), x[i].lo());
      if (above == breaks.begin() || above == breaks.end()) return false;
      const double begin = *(above - 1), end = *above;
      if (!(begin < x[i].lo() && x[i].hi() < end &&
            x[i].hi() - x[i].lo() < 0x1p-12 * (end - begin)))
        return false;
    }
    return true;
  }

  void classify_overlap(const std::vector<Box4>& boxes, const std::vector<std::size_t>& cluster,
                        IntersectionContact* contact) {
    std::vector<Point4> pairs;
    for (const std::size_t i : cluster)
      if (auto x = foot_points(boxes[i])) pairs.push_back(*x);
    if (!s1_.has_exact_knots() || !s2_.has_exact_knots())
      return;  // boxes are in rounded parameters
    const auto overlap = find_overlap(first_, second_, pairs);
    if (!overlap) return;
    std::vector<Box4> beside;
    for (const std::size_t i : cluster)
      if (!holds_all_of(s1_, s2_, *overlap, boxes[i])) beside.push_back(boxes[i]);
    if (!beside.empty())
      add_contacts(beside,
                   "beside an overlap, where this one is not shown to hold all common points",
                   false, false);
    contact->kind = IntersectionContact::Kind::kOverlap;
    contact->parameters = overlap->parameters;
    contact->num_boxes -= beside.size();
    contact->reason.clear();
  }

  /// Gauss-Newton for (s, t) with (u, v) fixed at the box's middle, in doubles. Returns nothing if no near point of the
  /// second surface is nearly equal.
  std::optional<Point4> foot_points(const Box4& x) const {
    Point4 p = approx_middle(x);
    const Box3 at = s1_.point(p[0], p[1]);
    for (int step = 0; step < 12; ++step) {
      const auto r = s2_.range(Interval(p[2]), Interval(p[3]));
      double a = 0, b = 0, c = 0, f = 0, g = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double d = approx_middle(at[i]) - approx_middle(r.point[i]),
                     s = approx_middle(r.du[i]), t = approx_middle(r.dv[i]);
        a += s * s, b += s * t, c += t * t, f += d * s, g += d * t;
      }
      const double det = a * c - b * b;
      if (!(det > 0)) return std::nullopt;
      p[2] += (f * c - g * b) / det, p[3] += (a * g - b * f) / det;
    }
    const Box3 apart = at - s2_.point(p[2], p[3]);
    const bool is_inside = is_member(p[2], parameter_domain(s1_, s2_, 2)) &&
                           is_member(p[3], parameter_domain(s1_, s2_, 3));
    return is_inside && mag(apart[0]) + mag(apart[1]) + mag(apart[2]) <
                            1e-9 * (1 + width(s1_.hull_of_net(s1_.piece(0, 0))))
               ? std::optional(p)
               : std::nullopt;
  }

  const BSpline<Rational, 2>&first_, &second_;
  const EnclosedSurface &s1_, &s2_;
  const IntersectionOptions& options_;
  SurfaceIntersection out_;
};

}  // namespace

Result<SurfaceIntersection> intersect(const BSpline<Rational, 2>& first,
                                      const BSpline<Rational, 2>& second,
                                      const IntersectionOptions& options) {
  const ScopedUpward upward;
  const auto s1 = prepared(first, "first"), s2 = prepared(second, "second");
  if (!s1) return s1.error();
  if (!s2) return s2.error();
  return Intersector(first, second, *s1, *s2, options).run();
}

}  // namespace veritope
