// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/plane_region.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "robust/base/fp_guard.h"

namespace veritope {
namespace {

std::string text_of(const PointIn<2>& p) {
  return "(" + p[0].to_string() + ", " + p[1].to_string() + ")";
}

Error open_at(std::size_t arc, const PointIn<2>& p, bool is_end) {
  Error out = bad_argument(
      "the loops are not closed: the curve " + std::string(is_end ? "ends" : "starts") + " at " +
      text_of(p) +
      (is_end ? ", where fewer curves start than end" : ", where fewer curves end than start"));
  out.place.entity = arc;
  return out;
}

// Counts for each end the curves that start there, minus those that end there.
Status check_closed(const std::vector<PlaneArc>& arcs) {
  std::map<PointIn<2>, std::int64_t> balance;
  for (const PlaneArc& arc : arcs) ++balance[arc.start()], --balance[arc.end()];
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (balance[arcs[i].start()] > 0) return open_at(i, arcs[i].start(), false);
    if (balance[arcs[i].end()] < 0) return open_at(i, arcs[i].end(), true);
  }
  return ok_status();
}

}  // namespace

Result<PlaneRegion> PlaneRegion::make(std::vector<PlaneArc> arcs) {
  if (const Status status = check_closed(arcs); !status) return status.error();
  return PlaneRegion(std::move(arcs));
}

PlaneRegion::PlaneRegion(std::vector<PlaneArc> arcs) : arcs_(std::move(arcs)) {
  std::vector<Box3d> boxes;
  for (const PlaneArc& arc : arcs_) boxes.push_back(arc.box());
  boxes_ = BoxHierarchy(boxes);
}

PlaneAnswer PlaneRegion::classify(const PointIn<2>& point) const {
  const ScopedDefaultFp nearest;
  const ChainPoint<2> q(point);
  Box3d ray = q.box();
  ray.hi[0] = std::numeric_limits<double>::infinity();
  PlaneAnswer out;
  boxes_.visit([&](const Box3d& box) { return meets(box, ray); },
               [&](std::uint32_t i) {
                 const std::optional<int> passes = arcs_[i].passes(q);
                 if (passes)
                   out.winding += *passes;
                 else if (!out.arc || i < *out.arc)
                   out.arc = i;
               });
  if (!out.arc) return out;
  out.winding = 0;
  out.parameter = arcs_[*out.arc].parameter_of(point).value();
  return out;
}

}  // namespace veritope
