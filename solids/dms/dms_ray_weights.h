// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_ray_weights.h: for each ray of a grid what the control points contribute to its integral, in doubles,
// with proved bounds.
// Design: docs/design/0096-x-rays.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solids/dms/dms_ray_grid.h"

namespace veritope {

/// The rays of one row. Ray i has the entries first[i] to first[i + 1]: control points, each once, in an order that
/// depends on the model without its control points, and on the ray alone.
struct DmsRayRow {
  std::vector<std::size_t> first;
  std::vector<std::uint32_t> control;
  std::vector<double> weight;
  /// For each ray: the sum over all control points of |weight - exact weight| is at most this; a control point without
  /// an entry has the weight 0. The exact weights are those of DmsLineIntegrator::weights.
  std::vector<double> error;
  std::size_t num_exact = 0;  ///< rays that rationals had to decide
};

class DmsRayWeights {
 public:
  /// Rays whose error would be over `tolerance` are computed exactly; then only the rounding of weights is left.
  static constexpr double kTolerance = 0x1p-21;

  /// The model must outlive this object, which only reads its domain and its control points' vertices.
  /// REQUIRES grid.is_sound(), and what DmsEvaluator::evaluate does of the model; 0 < tolerance.
  /// @cost some 0.2 ms for each tetrahedron of a quadratic model
  DmsRayWeights(const DmsModel& model, const DmsRayGrid& grid, double tolerance = kTolerance);
  ~DmsRayWeights();
  DmsRayWeights(DmsRayWeights&&) noexcept;

  const DmsRayGrid& grid() const;
  /// The order of threads has no influence. REQUIRES j < rows. Any number of threads may call it.
  /// @cost some 20 us a ray through 25 quadratic tetrahedra; some 20 ms for rays that rationals decide
  DmsRayRow row(std::size_t j) const;

  /// Columns and rows, half-open, outside of which no ray has an entry for a control point.
  struct Range {
    std::uint32_t first_column = 0, end_column = 0, first_row = 0, end_row = 0;
  };
  /// The range of each control point.
  std::vector<Range> ranges() const;

 private:
  class Body;
  std::unique_ptr<Body> body_;
};

}  // namespace veritope
