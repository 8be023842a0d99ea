// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/projection_report.h"

#include <algorithm>
#include <utility>

#include "interval/relations.h"

namespace veritope::report {
namespace {

Interval distance_of(const ProjectionTarget& target) {
  return std::visit([](const auto& p) { return p.least_distance; }, target.projection);
}

// Whether what is not the certified nearest point of its own target may be nearer than this.
bool may_be_nearer(const ProjectionTarget& target, double than) {
  return !(distance_of(target).lo() > than);
}

}  // namespace

Interval ProjectionReport::distance() const {
  Interval out = distance_of(targets.front());
  for (const ProjectionTarget& t : targets) out = min(out, distance_of(t));
  return out;
}

std::optional<std::pair<std::size_t, std::size_t>> ProjectionReport::nearest() const {
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const auto point =
        std::visit([](const auto& p) { return p.certified_nearest; }, targets[t].projection);
    if (!point) continue;
    bool is_alone = true;
    for (std::size_t s = 0; s < targets.size(); ++s)
      is_alone = is_alone && (s == t || !may_be_nearer(targets[s], distance_of(targets[t]).hi()));
    if (is_alone) return std::pair(t, *point);
  }
  return std::nullopt;
}

bool ProjectionReport::is_complete() const {
  return std::all_of(targets.begin(), targets.end(), [](const ProjectionTarget& t) {
    return std::visit([](const auto& p) { return p.is_complete(); }, t.projection);
  });
}

}  // namespace veritope::report
