// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_xray.h: integrals of a component along the rays of a grid, in doubles with proved bounds, and what
// changes when one coefficient does.
// Source: [HHQ04] eq. 12, with exact weights in the place of its formula for them.  Design: docs/design/0096-x-rays.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solids/dms/dms_ray_weights.h"

namespace veritope {

/// The integral over t in [0, 1], over the domain; the exact one (DmsLineIntegrator::mean) differs from it by at most
/// `bound`. `share` is the integral of the constant 1, the sum of the weights.
struct DmsRaySum {
  double mean = 0, bound = 0, share = 0;
};

/// The coefficients of one component as doubles.
class DmsCoefficients {
 public:
  /// REQUIRES component < model.num_components().
  DmsCoefficients(const DmsModel& model, std::size_t component);

  std::size_t size() const { return values_.size(); }
  void set(std::size_t control, const Rational& value);
  /// The sum over the entries of ray i of a row, in their order.
  DmsRaySum sum(const DmsRayRow& row, std::size_t i) const;

 private:
  std::vector<double> values_;
  double most_ = 0;  // of the absolute values; infinite if one is beyond binary64
};

/// The sums of all rays, row after row, computed with at most `jobs` threads and without keeping weights. They do not
/// depend on the number of threads. REQUIRES the model of the rays.
std::vector<DmsRaySum> ray_sums(const DmsRayWeights& rays, const DmsCoefficients& coefficients,
                                unsigned jobs);

/// Keeps the weights of all rays: 12 bytes for each ray and control point that contributes, approximately 100 MB for
/// 256 x 256 rays through 25 quadratic tetrahedra each.
class DmsXray {
 public:
  /// @param jobs  threads, for this constructor. REQUIRES the model of the rays, which may die before this object.
  DmsXray(const DmsRayWeights& rays, DmsCoefficients coefficients, unsigned jobs);

  std::size_t num_rays() const { return means_.size(); }
  /// Ray i of row j has the number j columns + i. The mean is what ray_sums gives for the coefficients as they are now,
  /// to the last bit; the bound is at least that one. @cost the weights of the ray; of `mean` nothing
  DmsRaySum sum(std::size_t ray) const;
  double mean(std::size_t ray) const { return means_[ray]; }

  /// Changes the coefficient of a control point. Returns the rays through it, ascending, whose sums were added up anew,
  /// in the order in which they were added up before. REQUIRES control < the number of control points.
  /// @cost some 10 ns for each weight of the rays in the box of the control point's tetrahedra
  std::vector<std::size_t> change(std::size_t control, const Rational& value);

 private:
  std::size_t columns_;
  std::vector<DmsRayRow> rows_;
  std::vector<DmsRayWeights::Range> ranges_;  // of each control point
  DmsCoefficients coefficients_;
  std::vector<double> means_;
};

}  // namespace veritope
