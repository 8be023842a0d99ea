// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "interval/upward.h"
#include "solids/micro/bridge/cage_space_internal.h"
#include "splines/knot_insertion.h"

namespace veritope::internal {
namespace {

constexpr int kNewtonSteps = 40;
constexpr std::size_t kMostSpans = 64;

Point3d minus(const Point3d& a, const Point3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double length_of(const Point3d& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }
double det_of(const Point3d& a, const Point3d& b, const Point3d& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// Replaces Bernstein coefficients along a line by those on [lo, hi]. REQUIRES a live ScopedUpward, 0 <= lo <= hi <= 1.
void restrict_line(Interval* first, std::size_t stride, int degree, double lo, double hi) {
  const auto n = static_cast<std::size_t>(degree);
  if (hi < 1) {
    const Interval t(hi), s = Interval(1.0) - t;
    for (std::size_t r = 1; r <= n; ++r)
      for (std::size_t i = n; i >= r; --i)
        first[i * stride] = s * first[(i - 1) * stride] + t * first[i * stride];
  }
  if (lo > 0) {
    const Interval t = Interval(lo) / Interval(hi), s = Interval(1.0) - t;
    for (std::size_t r = 1; r <= n; ++r)
      for (std::size_t i = 0; i + r <= n; ++i)
        first[i * stride] = s * first[i * stride] + t * first[(i + 1) * stride];
  }
}

}  // namespace

Result<VolumeSpace> VolumeSpace::make(const VVolume& volume) {
  Result<FastSpline<3>> fast = FastSpline<3>::prepare(volume);
  if (!fast) return fast.error();
  VolumeSpace out(std::move(*fast));
  const ScopedUpward upward;
  const auto pieces = bezier_pieces(volume);
  out.spans_ = pieces.grid();
  for (std::size_t a = 0; a < 3; ++a) {
    for (const Rational& x : pieces.breaks[a]) out.axes_[a].breaks.push_back(enclose(x));
    const auto [begin, end] = out.fast_.domain(a);
    out.axes_[a].begin = begin;
    out.axes_[a].end = end;
  }
  for (const BezierVolume<Rational>& piece : pieces.pieces) {
    std::vector<Interval> c;
    for (const Rational& x : piece.coefficients()) c.push_back(enclose(x));
    out.pieces_.emplace_back(piece.degrees(), piece.num_components(), piece.is_rational(),
                             std::move(c));
  }
  return out;
}

std::optional<ApproxPlace> VolumeSpace::place(const Point3d& at) const {
  ApproxPlace out;
  out.at = at;
  std::array<double, 9> partial{};
  FastSplineOutput to;
  to.value = out.image.data();
  to.partial = partial.data();
  fast_.evaluate({at.data(), &at[1], &at[2]}, 1, to);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t c = 0; c < 3; ++c) out.partial[a][c] = partial[3 * a + c];
  for (const double x : out.image)
    if (!std::isfinite(x)) return std::nullopt;
  return out;
}

std::optional<ApproxPlace> VolumeSpace::preimage(const Point3d& goal, const Point3d& start) const {
  std::optional<ApproxPlace> here = place(start);
  if (!here) return std::nullopt;
  double off = length_of(minus(goal, here->image));
  const double scale = off;
  for (int step = 0; step < kNewtonSteps; ++step) {
    if (off <= 1e-7 * scale) return here;
    const Point3d right = minus(goal, here->image);
    const auto& p = here->partial;
    const double whole = det_of(p[0], p[1], p[2]);
    const Point3d move = {det_of(right, p[1], p[2]) / whole, det_of(p[0], right, p[2]) / whole,
                          det_of(p[0], p[1], right) / whole};
    bool is_better = false;
    for (double part = 1; part > 0.01 && !is_better; part /= 2) {
      Point3d to;
      for (std::size_t a = 0; a < 3; ++a) {
        const Axis& axis = axes_[a];
        // At most nine tenths of the way to the end of the domain.
        to[a] = std::clamp(here->at[a] + part * move[a], 0.1 * here->at[a] + 0.9 * axis.begin,
                           0.1 * here->at[a] + 0.9 * axis.end);
      }
      std::optional<ApproxPlace> next = place(to);
      if (!next) continue;
      const double new_off = length_of(minus(goal, next->image));
      if (!(new_off < off)) continue;
      is_better = true;
      off = new_off;
      here = next;
    }
    if (!is_better) break;
  }
  if (off <= 1e-4 * scale) return here;
  return std::nullopt;
}

bool VolumeSpace::hull_in_span(std::size_t piece, const std::array<Part, 3>& part,
                               HullPoints* out) const {
  BezierVolume<Interval> net = pieces_[piece];
  const Grid<3> grid = net.grid();
  for (int c = 0; c < net.num_components(); ++c)
    for (std::size_t axis = 0; axis < 3; ++axis)
      grid.for_each_line(axis, [&](std::size_t first) {
        restrict_line(net.component(c).data() + first, grid.stride(axis), net.degree(axis),
                      part[axis][0], part[axis][1]);
      });
  for (std::size_t i = 0; i < grid.count(); ++i) {
    Box3 p(net.component(0)[i], net.component(1)[i], net.component(2)[i]);
    if (net.is_rational()) {
      const Interval& w = net.component(3)[i];
      if (w.sign() != Sign3::kPositive) return false;
      for (std::size_t c = 0; c < 3; ++c) p[c] = p[c] / w;
    }
    out->push_back(p);
  }
  return true;
}

std::vector<VolumeSpace::SpanPart> VolumeSpace::parts_of(const Box3d& box, std::size_t axis) const {
  std::vector<SpanPart> out;
  const auto& breaks = axes_[axis].breaks;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (breaks[i + 1].hi() < box.lo[axis] || box.hi[axis] < breaks[i].lo()) continue;
    const Interval length = breaks[i + 1] - breaks[i];
    const double lo = ((Interval(box.lo[axis]) - breaks[i]) / length).lo(),
                 hi = ((Interval(box.hi[axis]) - breaks[i]) / length).hi();
    out.push_back({i, {std::clamp(lo, 0.0, 1.0), std::clamp(hi, 0.0, 1.0)}});
  }
  return out;
}

bool VolumeSpace::hulls(const Box3d& box, std::vector<HullPoints>* out) const {
  std::array<std::vector<SpanPart>, 3> parts;
  std::size_t count = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    parts[a] = parts_of(box, a);
    count *= parts[a].size();
  }
  if (count > kMostSpans) return false;
  for (const auto& [i, u] : parts[0])
    for (const auto& [j, v] : parts[1])
      for (const auto& [k, w] : parts[2])
        if (!hull_in_span(spans_.at({i, j, k}), {u, v, w}, &out->emplace_back())) return false;
  return true;
}

// In Bernstein form the curve along the axis leaves its first point towards the second one; so does a rational curve
// with positive weights.
bool VolumeSpace::directions(const Box3d& wall, std::size_t axis, bool is_upward,
                             HullPoints* out) const {
  const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
  const auto& breaks = axes_[axis].breaks;
  std::size_t span = 0;
  while (span < breaks.size() && breaks[span].hi() < wall.lo[axis]) ++span;
  if (!is_upward) --span;
  if (span + 1 >= breaks.size()) return false;
  HullPoints points;
  for (const auto& [i, u] : parts_of(wall, b))
    for (const auto& [j, v] : parts_of(wall, c)) {
      std::array<std::size_t, 3> at{};
      std::array<Part, 3> part;
      at[axis] = span, at[b] = i, at[c] = j;
      part[axis] = {0, 1}, part[b] = u, part[c] = v;
      points.clear();
      const std::size_t piece = spans_.at(at);
      if (!hull_in_span(piece, part, &points)) return false;
      const Grid<3> grid = pieces_[piece].grid();
      const std::size_t n = grid.size[axis], step = grid.stride(axis);
      const std::size_t first = is_upward ? 0 : (n - 1) * step,
                        second = is_upward ? step : (n - 2) * step;
      Box3 from = Box3::empty(), to = from;
      grid.for_each_line(axis, [&](std::size_t line) {
        const Box3 &p = points[line + first], &q = points[line + second];
        if (!pieces_[piece].is_rational()) out->push_back(q - p);
        from = hull(from, p);
        to = hull(to, q);
      });
      if (pieces_[piece].is_rational()) out->push_back(to - from);
    }
  return true;
}

}  // namespace veritope::internal
