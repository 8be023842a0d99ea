// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/spline_report.h"

namespace veritope::report {
namespace {

// The box grows to hold the control points of a spline or triangle.
template <typename Map>
void grow(std::vector<ExactInterval>& box, const Map& s) {
  for (std::size_t i = 0; i < s.component(0).size(); ++i)
    for (int c = 0; c < s.dimension(); ++c) {
      const auto k = static_cast<std::size_t>(c);
      Rational x = s.component(c)[i];
      if (s.is_rational()) x /= s.component(s.dimension())[i];
      if (k == box.size())
        box.push_back({x, x});
      else
        box[k] = hull(box[k], {x, x});
    }
}

}  // namespace

std::vector<ExactInterval> control_box(const SplineEntity& entity) {
  std::vector<ExactInterval> box;
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

void unite(std::vector<ExactInterval>& box, const std::vector<ExactInterval>& other) {
  for (std::size_t k = 0; k < other.size(); ++k)
    if (k == box.size())
      box.push_back(other[k]);
    else
      box[k] = hull(box[k], other[k]);
}

}  // namespace veritope::report
