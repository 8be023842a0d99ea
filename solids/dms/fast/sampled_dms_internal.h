// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/sampled_dms_internal.h: images and derivatives of a solid's map at many points in binary64, for
// searches.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/dms/fast/fast_dms.h"
#include "solids/dms/plain_matrix.h"

namespace veritope::internal {

/// REQUIRES what FastDms requires, and a map to space in the first three components.
class SampledDms {
 public:
  explicit SampledDms(const DmsModel& model) : fast_(model, with_tables_at_once()) {}

  /// At these points; not a number outside of the domain.
  void evaluate(std::span<const Vec3d> points) {
    const std::size_t width = fast_.num_components();
    values_.resize(points.size() * width);
    gradients_.resize(3 * points.size() * width);
    FastDmsOutput out;
    out.value = values_.data();
    out.gradient = gradients_.data();
    fast_.evaluate(points, out);
  }
  Point3d image(std::size_t i) const {
    const double* const x = values_.data() + i * fast_.num_components();
    return {x[0], x[1], x[2]};
  }
  PlainMatrix derivative(std::size_t i) const {
    const double* const g = gradients_.data() + 3 * i * fast_.num_components();
    return {g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8]};
  }

  /// Points so far that were evaluated exactly: they take a thousand times as long.
  std::uint64_t num_exact() const { return fast_.counts().exact(); }

 private:
  static FastDmsOptions with_tables_at_once() {
    FastDmsOptions out;
    out.with_gradient = true;
    out.exact_first = 0;
    return out;
  }

  FastDms fast_;
  std::vector<double> values_, gradients_;
};

}  // namespace veritope::internal
