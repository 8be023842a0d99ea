// SPDX-License-Identifier: LGPL-3.0-or-later
#include "models/plane_shapes.h"

#include "models/patch_shapes_internal.h"
#include "robust/base/check.h"

namespace veritope::plane_shapes {

Loop circle() {
  Loop out;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const auto q = patch_shapes::internal::quarter_circle(quarter);
    std::vector<Rational> all = q.x;
    all.insert(all.end(), q.y.begin(), q.y.end());
    all.insert(all.end(), q.w.begin(), q.w.end());
    out.emplace_back(std::array<int, 1>{2}, 3, true, std::move(all));
  }
  return out;
}

BezierCurve<Rational> bezier(const std::vector<Point>& control) {
  VT_CHECK(control.size() >= 2, "a curve with one control point");
  std::vector<Rational> all;
  for (std::size_t k = 0; k < 2; ++k)
    for (const Point& p : control) all.push_back(p[k]);
  return {{static_cast<int>(control.size()) - 1}, 2, false, std::move(all)};
}

Loop polygon(const std::vector<Point>& corners) {
  VT_CHECK(corners.size() >= 3, "a polygon with fewer than three corners");
  Loop out;
  for (std::size_t i = 0; i < corners.size(); ++i)
    out.push_back(bezier({corners[i], corners[(i + 1) % corners.size()]}));
  return out;
}

Loop placed(const Loop& loop, const Rational& factor, const Point& shift) {
  Loop out;
  for (const auto& c : loop) {
    const auto n = c.component(0).size();
    std::vector<Rational> all;
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t i = 0; i < n; ++i)
        all.push_back(factor * c.component(static_cast<int>(k))[i] +
                      (c.is_rational() ? shift[k] * c.component(2)[i] : shift[k]));
    if (c.is_rational())
      for (std::size_t i = 0; i < n; ++i) all.push_back(c.component(2)[i]);
    out.emplace_back(c.degrees(), c.num_components(), c.is_rational(), std::move(all));
  }
  return out;
}

Loop reversed(const Loop& loop) {
  Loop out;
  for (auto it = loop.rbegin(); it != loop.rend(); ++it) {
    const auto n = it->component(0).size();
    std::vector<Rational> all;
    for (int k = 0; k < it->num_components(); ++k)
      for (std::size_t i = n; i-- > 0;) all.push_back(it->component(k)[i]);
    out.emplace_back(it->degrees(), it->num_components(), it->is_rational(), std::move(all));
  }
  return out;
}

}  // namespace veritope::plane_shapes
