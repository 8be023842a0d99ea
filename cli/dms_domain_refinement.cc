// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/dms_domain_refinement.h"

#include <string>
#include <utility>

#include "io/base/exact_number.h"

namespace veritope::cli {
namespace {

std::string take_limit(const std::string& text, const Rational& least, bool may_be_least,
                       const std::string& what, std::optional<Rational>& target) {
  Rational number;
  if (read_exact_number(text, {}, number) != DecimalFault::kNone || number < least ||
      (number == least && !may_be_least))
    return "must be " + what + ", not " + text;
  target = std::move(number);
  return "";
}

}  // namespace

bool has_limit(const RefineLimits& limits) {
  return limits.max_volume.has_value() || limits.max_radius_edge.has_value();
}

void declare_refinement(OptionSet& set, RefineLimits& limits,
                        std::optional<std::uint64_t>& max_points) {
  set.option(
      "--max-volume", "V",
      [&limits](const std::string& t) {
        return take_limit(t, Rational(0), false, "a positive number", limits.max_volume);
      },
      "add vertices until no tetrahedron has more volume");
  set.option(
      "--max-radius-edge", "B",
      [&limits](const std::string& t) {
        return take_limit(t, Rational(1), true, "a number of at least 1", limits.max_radius_edge);
      },
      "the same for circumradius over shortest edge, >= 1");
  set.number("--max-points", max_points, {0, kMaxDmsVertices},
             "limit: vertices that may be added (100000)");
}

report::DmsDomainRefinement describe_refinement(const RefineLimits& limits,
                                                const RefinedDomain& refined) {
  const auto text = [](const std::optional<Rational>& r) {
    return r ? std::optional(r->to_string()) : std::nullopt;
  };
  report::DmsDomainRefinement out;
  out.max_volume = text(limits.max_volume);
  out.max_radius_edge = text(limits.max_radius_edge);
  out.max_points = limits.max_points;
  out.inserted = refined.on_boundary + refined.inside;
  out.taken_away = refined.removed;
  out.end = refine_end_name(refined.end);
  out.over_volume = refined.over_volume;
  out.over_radius_edge = refined.over_radius_edge;
  out.largest_volume = refined.largest_volume;
  out.largest_radius_edge = refined.largest_radius_edge;
  out.protected_tetrahedra = refined.protected_tetrahedra;
  for (const SmallAngle& a : refined.small_angles)
    out.small_angles.push_back({a.vertices, a.is_dihedral, a.degrees});
  return out;
}

}  // namespace veritope::cli
