// SPDX-License-Identifier: LGPL-3.0-or-later
// render/dms_sampler_internal.h: values of a field at many points, for pictures.
#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "render/dms_field.h"
#include "robust/base/parallel.h"
#include "solids/dms/fast/fast_dms.h"

namespace veritope::internal {

/// The values do not depend on which points are asked together, so that threads may share a picture. One thread at a
/// time.
class DmsSampler {
 public:
  /// The field must outlive this. @param sharers  of the memory for tables: the number of samplers
  DmsSampler(const DmsField& field, std::size_t sharers);
  /// NaN outside of the domain or the solid. They stay until the next call.
  std::span<const double> values(std::span<const Vec3d> points);

 private:
  void evaluate(std::span<const Vec3d> points, std::span<const std::size_t> to);
  void evaluate_in_solid(std::span<const Vec3d> points);

  const DmsField& field_;
  std::optional<FastDms> fast_;  // not where the inverse has the component
  std::vector<double> all_, values_;
};

/// origin + i right + j down + t along, as pictures round it.
Vec3d point_of(const DmsRayGrid& grid, double i, double j, double t);

/// Rows in as many parts as there are threads, each with a sampler of its own: draw(sampler, first, last).
template <typename Draw>
void draw_rows(const DmsField& field, std::size_t rows, unsigned jobs, Draw draw) {
  const std::size_t parts = std::min<std::size_t>(rows, jobs == 0 ? hardware_jobs() : jobs);
  parallel_for(rows, (rows + parts - 1) / parts, jobs,
               [&](std::size_t, std::size_t first, std::size_t last) {
                 DmsSampler sampler(field, parts);
                 draw(sampler, first, last);
               });
}

}  // namespace veritope::internal
