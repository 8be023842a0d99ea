// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/intersection_report.h"

namespace veritope::report {

std::vector<NamedSurface> surfaces_of(const SplineModel& model) {
  std::vector<NamedSurface> out;
  for (std::size_t e = 0; e < model.entities.size(); ++e) {
    const auto& shape = model.entities[e].shape;
    if (const auto* s = std::get_if<ExactSurface>(&shape)) out.push_back({e, {}, s, false});
    if (const auto* t = std::get_if<TrimmedSurface>(&shape))
      out.push_back({e, {}, &t->surface, !t->loops.empty()});
    if (const auto* m = std::get_if<SplineBrep>(&shape))
      for (std::size_t f = 0; f < m->faces.size(); ++f)
        out.push_back({e, f, &m->faces[f].surface, !m->faces[f].loops.empty()});
  }
  return out;
}

bool IntersectionReport::is_complete() const {
  for (const PairIntersection& p : pairs)
    if (!p.found.is_complete()) return false;
  return true;
}

const char* shape_name(IntersectionContact::Shape shape) {
  switch (shape) {
    case IntersectionContact::Shape::kElliptic: return "elliptic";
    case IntersectionContact::Shape::kHyperbolic: return "hyperbolic";
    case IntersectionContact::Shape::kUnknown: return "unknown";
  }
  return "unknown";
}

}  // namespace veritope::report
