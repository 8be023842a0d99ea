// SPDX-License-Identifier: LGPL-3.0-or-later
// Curves that more than two sides of the border pass: sides that are equal, and sides that have a part in common.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robust/base/box3d.h"
#include "robust/simplest.h"
#include "solids/base/box_hierarchy.h"
#include "solids/vmodel/v_border_internal.h"
#include "splines/bezier_domain.h"
#include "splines/convert.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace internal {
namespace {

constexpr std::uint64_t kMostBitsOfEnds = 60;  // of arcs, in a knot span
constexpr int kArcLevels = 10;

bool is_dyadic(const Rational& t) {
  const Integer& d = t.denominator();
  return d.bit_length() <= kMostBitsOfEnds && d.trailing_zeros() + 1 == d.bit_length();
}

// Where on the axis of its cell a part of a side is, as a function of a parameter from 0 to 1 along the part.
struct PartOnSpan {
  CellSide where;
  std::size_t span = 0;
  std::array<Rational, 2> ends;  // in the knot span, of the parameters 0 and 1

  Rational at(const Rational& t) const { return ends[0] + (ends[1] - ends[0]) * t; }
  Rational inverse(const Rational& x) const { return (x - ends[0]) / (ends[1] - ends[0]); }
};

std::optional<PartOnSpan> on_span(const BorderPatches& border, const SidePart& part) {
  const std::optional<CellSide> where = border.cell_side(part.side);
  if (!where || border.is_repeated(static_cast<VFaceNumber>(6 * where->cell + where->face)))
    return std::nullopt;
  PartOnSpan out;
  out.where = *where;
  const std::vector<Rational> knots = breaks_of(border.model().cell(where->cell).axis(where->axis));
  const Rational& lower = std::min(where->ends[0], where->ends[1]);
  const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, lower);
  out.span = static_cast<std::size_t>(after - knots.begin()) - 1;
  for (std::size_t e = 0; e < 2; ++e) {
    const Rational t = where->ends[0] + (where->ends[1] - where->ends[0]) * part.at[e];
    out.ends[e] = (t - *(after - 1)) / (*after - *(after - 1));
  }
  return out;
}

// Parameters of all parts at which each is at a dyadic place of its span, as far apart as possible.
std::optional<std::array<Rational, 2>> dyadic_range(const std::array<PartOnSpan, 3>& parts) {
  std::optional<Rational> least, greatest;
  const auto note = [&](const Rational& t) {
    if (t < Rational(0) || Rational(1) < t) return;
    for (const PartOnSpan& p : parts)
      if (!is_dyadic(p.at(t))) return;
    if (!least || t < *least) least = t;
    if (!greatest || *greatest < t) greatest = t;
  };
  note(Rational(0));
  note(Rational(1));
  for (const PartOnSpan& p : parts)
    for (int i = 0; i <= 1 << kArcLevels; ++i)
      note(p.inverse(Rational(Integer(i), Integer(1 << kArcLevels))));
  if (!least || !(*least < *greatest)) return std::nullopt;
  return std::array<Rational, 2>{*least, *greatest};
}

VArc arc_on(const PartOnSpan& part, const std::array<Rational, 2>& range) {
  VArc out;
  out.cell = static_cast<std::uint32_t>(part.where.cell);
  out.face = part.where.face;
  out.side = part.where.side;
  out.span = part.span;
  out.at = {part.at(range[0]), part.at(range[1])};
  if (out.at[1] < out.at[0]) std::swap(out.at[0], out.at[1]);
  return out;
}
// C1, more strictly.
bool are_different(const VArc& a, const VArc& b) {
  return a.cell != b.cell || a.face != b.face || a.side != b.side || a.span != b.span ||
         a.at[1] <= b.at[0] || b.at[1] <= a.at[0];
}

std::array<Rational, 3> point_at(const Patch::Curve& curve, const Rational& t) {
  std::vector<Rational> p = point(curve, std::array<Rational, 1>{t});
  return {std::move(p[0]), std::move(p[1]), std::move(p[2])};
}

}  // namespace

std::optional<VCrowdedCurve> crowded_by(const BorderPatches& border,
                                        const std::array<SidePart, 3>& parts) {
  std::array<PartOnSpan, 3> on;
  for (std::size_t i = 0; i < 3; ++i) {
    auto part = on_span(border, parts[i]);
    if (!part) return std::nullopt;
    on[i] = std::move(*part);
  }
  const auto range = dyadic_range(on);
  if (!range) return std::nullopt;
  VCrowdedCurve out;
  for (std::size_t i = 0; i < 3; ++i) out.arcs[i] = arc_on(on[i], *range);
  if (!are_different(out.arcs[0], out.arcs[1]) || !are_different(out.arcs[0], out.arcs[2]) ||
      !are_different(out.arcs[1], out.arcs[2]))
    return std::nullopt;
  const Rational t = ((*range)[0] + (*range)[1]) / Rational(2);
  const SidePart& first = parts[0];
  out.middle = point_at(border.complex().patch(first.side.patch).side(first.side.side),
                        first.at[0] + (first.at[1] - first.at[0]) * t);
  if (border.is_spoilt(out.middle)) return std::nullopt;
  return out;
}

namespace {

const std::array<Rational, 2> kForward = {Rational(0), Rational(1)};
const std::array<Rational, 2> kBackward = {Rational(1), Rational(0)};

// Sides that are one curve from end to end.
std::optional<VCrowdedCurve> among_equal_sides(const BorderPatches& border) {
  const PatchComplex& complex = border.complex();
  for (std::uint32_t e = 0; e < complex.num_edges(); ++e) {
    std::vector<SidePart> parts;
    const auto sides = complex.sides(e);
    if (sides.size() < 3) continue;
    for (const PatchSide& side : sides)
      if (border.cell_side(side))
        parts.push_back(
            {side, complex.travel(side) == complex.travel(sides.front()) ? kForward : kBackward});
    for (std::size_t i = 0; i + 2 < parts.size(); ++i)
      if (auto found = crowded_by(border, {parts[i], parts[i + 1], parts[i + 2]})) return found;
  }
  return std::nullopt;
}

// ---- sides of which only parts are equal

class PartSearch {
 public:
  explicit PartSearch(const BorderPatches& border) : border_(border), complex_(border.complex()) {
    std::vector<Box3d> boxes;
    at_vertex_.resize(complex_.num_vertices());
    for (std::uint32_t e = 0; e < complex_.num_edges(); ++e) {
      const PatchSide side = complex_.sides(e).front();
      if (!border_.cell_side(side)) continue;
      edges_.push_back(e);
      const Patch::Curve curve = complex_.patch(side.patch).side(side.side);
      boxes.push_back(box_of(curve));
      for (std::uint32_t end = 0; end < 2; ++end)
        at_vertex_[vertex_of(side, end)].push_back({e, end});
    }
    boxes_ = BoxHierarchy(boxes);
  }

  std::optional<VCrowdedCurve> run() const {
    std::vector<bool> is_seen(complex_.num_vertices());
    for (const std::uint32_t e : edges_)
      for (std::uint32_t end = 0; end < 2; ++end) {
        const PatchSide side = complex_.sides(e).front();
        const std::uint32_t vertex = vertex_of(side, end);
        if (is_seen[vertex]) continue;
        is_seen[vertex] = true;
        if (auto found = at(vertex, point_at(curve_of(e), Rational(end == 0 ? 0 : 1))))
          return found;
      }
    return std::nullopt;
  }

 private:
  struct EdgeEnd {
    std::uint32_t edge, end;
  };

  std::uint32_t vertex_of(PatchSide side, std::uint32_t end) const {
    return complex_.vertex({side.patch, (side.side + end) % 4});
  }
  Patch::Curve curve_of(std::uint32_t edge) const {
    const PatchSide side = complex_.sides(edge).front();
    return complex_.patch(side.patch).side(side.side);
  }
  static Box3d box_of(const Patch::Curve& curve) {
    Box3d out = empty_box();
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < curve.grid().count(); ++i) {
        const Rational& x = curve.component(static_cast<int>(c))[i];
        const Rational at = curve.is_rational() ? x / curve.component(3)[i] : x;
        out.lo[c] = std::min(out.lo[c], round_down(at));
        out.hi[c] = std::max(out.hi[c], round_up(at));
      }
    return out;
  }

  std::optional<VCrowdedCurve> at(std::uint32_t vertex, const std::array<Rational, 3>& p) const {
    const Point3d near = {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
    std::optional<VCrowdedCurve> found;
    const Box3d point{near, near};
    boxes_.visit([&](const Box3d& b) { return !found && is_inside(point, b); },
                 [&](std::uint32_t number) { found = on_edge(edges_[number], vertex, p); });
    return found;
  }
  // The vertex, which is at p, inside of a side that does not end there.
  std::optional<VCrowdedCurve> on_edge(std::uint32_t e, std::uint32_t vertex,
                                       const std::array<Rational, 3>& p) const {
    const PatchSide side = complex_.sides(e).front();
    if (vertex_of(side, 0) == vertex || vertex_of(side, 1) == vertex) return std::nullopt;
    const auto t = parameter_on(curve_of(e), p);
    if (!t || !(Rational(0) < *t) || !(*t < Rational(1))) return std::nullopt;
    for (const EdgeEnd& other : at_vertex_[vertex])
      for (const bool is_up : {false, true})
        if (auto found = along(e, *t, is_up, other)) return found;
    return std::nullopt;
  }

  // The side of edge e from t on, upward or downward, and another one from its end.
  std::optional<VCrowdedCurve> along(std::uint32_t e, const Rational& t, bool is_up,
                                     const EdgeEnd& other) const {
    if (other.edge == e) return std::nullopt;
    const Patch::Curve mine = curve_of(e), theirs = curve_of(other.edge);
    const Rational begin(other.end == 0 ? 0 : 1), far = Rational(1) - begin;
    const Rational last(is_up ? 1 : 0);
    std::array<Rational, 2> of_mine = {t, last}, of_theirs = {begin, far};
    if (const auto reached = parameter_on(mine, point_at(theirs, far));
        reached && (is_up ? t < *reached : *reached < t))
      of_mine[1] = *reached;
    else if (const auto at_end = parameter_on(theirs, point_at(mine, last));
             at_end && *at_end != begin)
      of_theirs[1] = *at_end;
    else
      return std::nullopt;
    if (!are_equal(mine, of_mine, theirs, of_theirs)) return std::nullopt;
    return crowd(e, of_mine, other.edge, of_theirs);
  }
  static CanonicalCurve part_of(const Patch::Curve& curve, const std::array<Rational, 2>& at) {
    if (at[0] < at[1]) return directed_form(restricted(curve, 0, at[0], at[1]));
    return run_backwards(directed_form(restricted(curve, 0, at[1], at[0])));
  }
  static bool are_equal(const Patch::Curve& a, const std::array<Rational, 2>& on_a,
                        const Patch::Curve& b, const std::array<Rational, 2>& on_b) {
    return part_of(a, on_a) == part_of(b, on_b);
  }

  void add_parts(std::uint32_t e, const std::array<Rational, 2>& at,
                 std::vector<SidePart>& to) const {
    const auto sides = complex_.sides(e);
    for (const PatchSide& side : sides) {
      if (!border_.cell_side(side)) continue;
      const bool is_same = complex_.travel(side) == complex_.travel(sides.front());
      to.push_back(
          {side, is_same ? at : std::array<Rational, 2>{Rational(1) - at[0], Rational(1) - at[1]}});
    }
  }
  std::optional<VCrowdedCurve> crowd(std::uint32_t a, const std::array<Rational, 2>& on_a,
                                     std::uint32_t b, const std::array<Rational, 2>& on_b) const {
    std::vector<SidePart> parts;
    add_parts(a, on_a, parts);
    add_parts(b, on_b, parts);
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t j = i + 1; j < parts.size(); ++j)
        for (std::size_t k = j + 1; k < parts.size(); ++k)
          if (auto found = crowded_by(border_, {parts[i], parts[j], parts[k]})) return found;
    return std::nullopt;
  }

  // The parameter of the point on the curve, exactly, if there is one and it is simple or the curve is a line that is
  // passed evenly.
  static std::optional<Rational> parameter_on(const Patch::Curve& curve,
                                              const std::array<Rational, 3>& p) {
    for (const Rational& t : guesses(curve, p))
      if (Rational(0) <= t && t <= Rational(1) && point_at(curve, t) == p) return t;
    return std::nullopt;
  }
  static std::vector<Rational> guesses(const Patch::Curve& curve,
                                       const std::array<Rational, 3>& p) {
    const auto a = point_at(curve, Rational(0)), b = point_at(curve, Rational(1));
    std::vector<Rational> out;
    for (std::size_t c = 0; c < 3; ++c)
      if (a[c] != b[c]) {
        out.push_back((p[c] - a[c]) / (b[c] - a[c]));
        break;
      }
    const auto rounded = nearest_double(curve);
    if (!rounded) return out;
    const double t = nearest_parameter(
        rounded.value(), {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])});
    const Rational at = Rational::from_double(t), margin = Rational::power_of_two(-26);
    out.push_back(simplest_between(at - margin, at + margin));
    return out;
  }
  static double nearest_parameter(const BezierCurve<double>& curve, const Point3d& p) {
    const auto distance = [&](double t) {
      const std::vector<double> q = point(curve, std::array<double, 1>{t});
      return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    };
    double best = 0, least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 32; ++i)
      if (const double d = distance(i / 32.0); d < least) least = d, best = i / 32.0;
    for (double step = 1.0 / 32; step > 1e-10; step /= 2)
      for (const double t : {std::max(0.0, best - step), std::min(1.0, best + step)})
        if (const double d = distance(t); d < least) least = d, best = t;
    return best;
  }

  const BorderPatches& border_;
  const PatchComplex& complex_;
  std::vector<std::uint32_t> edges_;
  std::vector<std::vector<EdgeEnd>> at_vertex_;
  BoxHierarchy boxes_;
};

}  // namespace

}  // namespace internal

std::optional<VCrowdedCurve> find_crowded_curve(const VModel& model, const VFaces& faces,
                                                const PatchComplex& complex) {
  const internal::BorderPatches border(model, faces, complex);
  if (auto found = internal::among_equal_sides(border)) return found;
  return internal::PartSearch(border).run();
}

}  // namespace veritope
