// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/classify/curve_crossings.h"

namespace veritope {

namespace {

ExactPoint step_to(const ExactPoint& a, const ExactPoint& b) {
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}
ExactPoint cross_of(const ExactPoint& a, const ExactPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational scalar_of(const ExactPoint& a, const ExactPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct TimeRange {
  Rational begin{0}, end{1};
  bool is_empty = false;
};

// Keeps the t with a + t (b - a) >= 0.
void keep_nonnegative(const Rational& a, const Rational& b, TimeRange* range) {
  const bool is_first = a.sign() != Sign::kNegative, is_last = b.sign() != Sign::kNegative;
  if (is_first && is_last) return;
  if (!is_first && !is_last) {
    range->is_empty = true;
    return;
  }
  const Rational t = a / (a - b);
  if (is_first)
    range->end = std::min(range->end, t);
  else
    range->begin = std::max(range->begin, t);
  range->is_empty = range->is_empty || range->begin > range->end;
}

// The part of the segment in the triangle: on both sides of its plane, and inside of its three sides.
TimeRange part_in(const ExactPoint& p, const ExactPoint& q, const std::array<ExactPoint, 3>& t) {
  const ExactPoint n = cross_of(step_to(t[0], t[1]), step_to(t[0], t[2]));
  const Rational a = scalar_of(n, step_to(t[0], p)), b = scalar_of(n, step_to(t[0], q));
  TimeRange out;
  keep_nonnegative(a, b, &out);
  keep_nonnegative(-a, -b, &out);
  for (std::size_t i = 0; i < 3 && !out.is_empty; ++i) {
    const ExactPoint m = cross_of(n, step_to(t[i], t[(i + 1) % 3]));
    keep_nonnegative(scalar_of(m, step_to(t[i], p)), scalar_of(m, step_to(t[i], q)), &out);
  }
  if (p == q) out.end = out.begin;
  return out;
}

Box3d box_around(const ExactPoint& p, const ExactPoint& q) {
  Box3d out = empty_box();
  for (const ExactPoint& x : {p, q})
    for (std::size_t c = 0; c < 3; ++c) {
      const Interval at = enclose(x[c]);
      out.lo[c] = std::min(out.lo[c], at.lo());
      out.hi[c] = std::max(out.hi[c], at.hi());
    }
  return out;
}

}  // namespace

MeshCrossings::MeshCrossings(const TriangleMesh& mesh) : mesh_(&mesh) {
  std::vector<Box3d> boxes;
  boxes.reserve(mesh.faces.size());
  for (const auto& t : mesh.faces) {
    boxes.push_back(empty_box());
    for (const std::uint32_t v : t) add(to_point(mesh.positions[v]), &boxes.back());
  }
  tree_ = BoxHierarchy(boxes);
}

std::vector<PolygonCrossing> MeshCrossings::find(std::span<const ExactPoint> polygon) const {
  const ScopedUpward upward;
  std::vector<PolygonCrossing> out;
  for (std::uint32_t s = 0; s + 1 < polygon.size(); ++s) {
    const ExactPoint &p = polygon[s], &q = polygon[s + 1];
    const Box3d box = box_around(p, q);
    tree_.visit([&](const Box3d& b) { return meets(b, box); },
                [&](std::uint32_t f) {
                  std::array<ExactPoint, 3> t;
                  for (std::size_t i = 0; i < 3; ++i) {
                    const Point3d at = to_point(mesh_->positions[mesh_->faces[f][i]]);
                    for (std::size_t c = 0; c < 3; ++c) t[i][c] = Rational::from_double(at[c]);
                  }
                  TimeRange part = part_in(p, q, t);
                  if (!part.is_empty)
                    out.push_back({s, f, std::move(part.begin), std::move(part.end)});
                });
  }
  std::sort(out.begin(), out.end(), [](const PolygonCrossing& a, const PolygonCrossing& b) {
    return std::tie(a.segment, a.begin, a.facet) < std::tie(b.segment, b.begin, b.facet);
  });
  return out;
}

}  // namespace veritope
