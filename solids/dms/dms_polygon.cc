// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "solids/dms/dms_polygon_internal.h"

namespace veritope {
namespace {

using internal::DmsPolygon;
using internal::DmsSegment;

DmsPoint between(const DmsPoint& a, const DmsPoint& b, const Rational& t) {
  DmsPoint out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = a[c] + t * (b[c] - a[c]);
  return out;
}
DmsPoint mean_of(const std::vector<DmsPoint>& points) {
  DmsPoint out;
  for (const DmsPoint& p : points)
    for (std::size_t c = 0; c < 3; ++c) out[c] += p[c];
  for (Rational& x : out) x /= Rational(static_cast<std::int64_t>(points.size()));
  return out;
}

// Heights of points over the line through a in this direction, in the polygon's plane.
class CutLine {
 public:
  CutLine(const DmsPoint& a, const DmsPoint& direction, const DmsPoint& normal)
      : across_(cross_product(normal, direction)), level_(dot_product(across_, a)) {}
  Rational height(const DmsPoint& p) const { return dot_product(across_, p) - level_; }

 private:
  DmsPoint across_;
  Rational level_;
};

// The part of the segment in the closed polygon; nothing if it misses it.
std::optional<DmsSegment> clipped(const DmsPolygon& polygon, DmsSegment segment,
                                  const DmsPoint& normal) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const DmsPoint& a = polygon[i];
    const CutLine side(a, difference(polygon[(i + 1) % polygon.size()], a), normal);
    const Rational first = side.height(segment[0]), second = side.height(segment[1]);
    const bool is_first_out = first.sign() == Sign::kNegative,
               is_second_out = second.sign() == Sign::kNegative;
    if (is_first_out && is_second_out) return std::nullopt;
    if (is_first_out != is_second_out)
      segment[is_first_out ? 0 : 1] = between(segment[0], segment[1], first / (first - second));
  }
  return segment;
}
bool is_inside(const DmsPolygon& polygon, const DmsPoint& p, const DmsPoint& normal) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const DmsPoint& a = polygon[i];
    const CutLine side(a, difference(polygon[(i + 1) % polygon.size()], a), normal);
    if (side.height(p).sign() != Sign::kPositive) return false;
  }
  return true;
}

}  // namespace

std::optional<std::pair<DmsPolygon, DmsPolygon>> internal::cut_polygon(const DmsPolygon& polygon,
                                                                       const DmsSegment& segment,
                                                                       const DmsPoint& normal) {
  const auto part = clipped(polygon, segment, normal);
  if (!part || !is_inside(polygon, mean_of({(*part)[0], (*part)[1]}), normal)) return std::nullopt;
  DmsPoint direction = difference(segment[1], segment[0]);
  if (direction == DmsPoint{}) direction = difference(polygon[0], segment[0]);
  const CutLine line(segment[0], direction, normal);
  DmsPolygon left, right;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const DmsPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Rational here = line.height(a), next = line.height(b);
    if (here.sign() != Sign::kNegative) left.push_back(a);
    if (here.sign() != Sign::kPositive) right.push_back(a);
    const bool is_crossed = (here.sign() == Sign::kNegative && next.sign() == Sign::kPositive) ||
                            (here.sign() == Sign::kPositive && next.sign() == Sign::kNegative);
    if (!is_crossed) continue;
    left.push_back(between(a, b, here / (here - next)));
    right.push_back(left.back());
  }
  return std::pair{std::move(left), std::move(right)};
}

bool internal::is_between(const DmsPoint& a, const DmsPoint& b, const DmsPoint& p) {
  const DmsPoint way = difference(b, a), step = difference(p, a);
  if (cross_product(way, step) != DmsPoint{}) return false;
  const Rational along = dot_product(way, step);
  return along.sign() == Sign::kPositive && along < dot_product(way, way);
}

internal::DmsPolygon internal::with_corners(const DmsPolygon& polygon,
                                            const std::vector<DmsPoint>& points) {
  DmsPolygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const DmsPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const DmsPoint way = difference(b, a);
    std::vector<std::pair<Rational, const DmsPoint*>> inside;
    for (const DmsPoint& p : points)
      if (is_between(a, b, p)) inside.emplace_back(dot_product(way, difference(p, a)), &p);
    std::sort(inside.begin(), inside.end(),
              [](const auto& x, const auto& y) { return x.first < y.first; });
    out.push_back(a);
    for (const auto& [along, p] : inside)
      if (*p != out.back()) out.push_back(*p);
  }
  return out;
}

std::vector<std::array<DmsPoint, 3>> internal::triangles_of(const DmsPolygon& polygon) {
  if (polygon.size() == 3) return {{polygon[0], polygon[1], polygon[2]}};
  const DmsPoint middle = mean_of(polygon);
  std::vector<std::array<DmsPoint, 3>> out;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    out.push_back({polygon[i], polygon[(i + 1) % polygon.size()], middle});
  return out;
}

}  // namespace veritope
