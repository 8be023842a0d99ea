// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_xray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robust/base/check.h"
#include "robust/base/fp_guard.h"
#include "robust/base/parallel.h"

namespace veritope {
namespace {

constexpr double kHalfUlp = 0x1p-53;

double finite(const Rational& value) {
  constexpr double kMost = std::numeric_limits<double>::max();
  return std::clamp(nearest_double(value), -kMost, kMost);
}

}  // namespace

DmsCoefficients::DmsCoefficients(const DmsModel& model, std::size_t component) {
  VT_CHECK(component < model.num_components(), "a component of the model");
  values_.resize(model.num_control());
  for (std::size_t c = 0; c < values_.size(); ++c) set(c, model.value(c)[component]);
}

void DmsCoefficients::set(std::size_t control, const Rational& value) {
  values_[control] = finite(value);
  // The greatest of all that the control points ever had: a bound, too.
  most_ = std::max(most_, std::abs(nearest_double(value)));
}

DmsRaySum DmsCoefficients::sum(const DmsRayRow& row, std::size_t i) const {
  const ScopedDefaultFp fp;
  DmsRaySum out;
  double size = 0;
  for (std::size_t k = row.first[i]; k < row.first[i + 1]; ++k) {
    const double term = row.weight[k] * values_[row.control[k]];
    out.mean += term;
    out.share += row.weight[k];
    size += std::abs(term);
  }
  const std::size_t count = row.first[i + 1] - row.first[i];
  // Rounding the coefficient, the product, and at most as many sums as there are terms.
  const double roundings = static_cast<double>(count + 3) * kHalfUlp;
  out.bound = 1.0000001 * (row.error[i] * most_ + roundings * size) +
              0x1p-1000 * static_cast<double>(count);
  return out;
}

std::vector<DmsRaySum> ray_sums(const DmsRayWeights& rays, const DmsCoefficients& coefficients,
                                unsigned jobs) {
  const std::size_t columns = rays.grid().columns, rows = rays.grid().rows;
  std::vector<DmsRaySum> out(columns * rows);
  parallel_for(rows, 1, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      const DmsRayRow row = rays.row(j);
      for (std::size_t i = 0; i < columns; ++i) out[j * columns + i] = coefficients.sum(row, i);
    }
  });
  return out;
}

DmsXray::DmsXray(const DmsRayWeights& rays, DmsCoefficients coefficients, unsigned jobs)
    : columns_(rays.grid().columns),
      rows_(rays.grid().rows),
      ranges_(rays.ranges()),
      coefficients_(std::move(coefficients)),
      means_(columns_ * rows_.size()) {
  parallel_for(rows_.size(), 1, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      rows_[j] = rays.row(j);
      for (std::size_t i = 0; i < columns_; ++i)
        means_[j * columns_ + i] = sum(j * columns_ + i).mean;
    }
  });
}

DmsRaySum DmsXray::sum(std::size_t ray) const {
  return coefficients_.sum(rows_[ray / columns_], ray % columns_);
}

std::vector<std::size_t> DmsXray::change(std::size_t control, const Rational& value) {
  VT_CHECK(control < coefficients_.size(), "a control point of the model");
  coefficients_.set(control, value);
  std::vector<std::size_t> changed;
  const DmsRayWeights::Range& range = ranges_[control];
  for (std::size_t j = range.first_row; j < range.end_row; ++j) {
    const DmsRayRow& row = rows_[j];
    for (std::size_t i = range.first_column; i < range.end_column; ++i) {
      const auto first = row.control.begin() + static_cast<std::ptrdiff_t>(row.first[i]),
                 last = row.control.begin() + static_cast<std::ptrdiff_t>(row.first[i + 1]);
      if (std::find(first, last, static_cast<std::uint32_t>(control)) == last) continue;
      const std::size_t ray = j * columns_ + i;
      means_[ray] = sum(ray).mean;
      changed.push_back(ray);
    }
  }
  return changed;
}

}  // namespace veritope
