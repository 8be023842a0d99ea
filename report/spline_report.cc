// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/spline_report.h"

#include <algorithm>
#include <utility>

namespace veritope::report {
namespace {

// By the control points of a spline or triangle.
template <typename Map>
void grow(ControlBox& box, const Map& s) {
  for (std::size_t i = 0; i < s.component(0).size(); ++i)
    for (int c = 0; c < s.dimension(); ++c) {
      const auto k = static_cast<std::size_t>(c);
      Rational x = s.component(c)[i];
      if (s.is_rational()) x /= s.component(s.dimension())[i];
      if (k == box.lo.size()) {
        box.lo.push_back(x);
        box.hi.push_back(std::move(x));
      } else {
        if (x < box.lo[k]) box.lo[k] = x;
        if (box.hi[k] < x) box.hi[k] = std::move(x);
      }
    }
}

}  // namespace

ControlBox control_box(const SplineEntity& entity) {
  ControlBox box;
  if (const auto* t = std::get_if<TrimmedSurface>(&entity.shape)) {
    grow(box, t->surface);
  } else if (const auto* b = std::get_if<SplineBrep>(&entity.shape)) {
    for (const BrepFace& face : b->faces) grow(box, face.surface);
  } else if (const auto* triangle = std::get_if<ExactTriangle>(&entity.shape)) {
    grow(box, *triangle);
  } else {
    for_each_spline(entity, [&](const auto& s) { grow(box, s); });
  }
  return box;
}

void unite(ControlBox& box, const ControlBox& other) {
  for (std::size_t k = 0; k < other.lo.size(); ++k)
    if (k == box.lo.size()) {
      box.lo.push_back(other.lo[k]);
      box.hi.push_back(other.hi[k]);
    } else {
      box.lo[k] = std::min(box.lo[k], other.lo[k]);
      box.hi[k] = std::max(box.hi[k], other.hi[k]);
    }
}

}  // namespace veritope::report
