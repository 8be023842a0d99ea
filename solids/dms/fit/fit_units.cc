// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/fit_units.h"

#include <algorithm>
#include <utility>

namespace veritope {
namespace {

constexpr std::int64_t kModerate = 200;  // the exponent of attributes that are left as they are

std::vector<DmsPoint> vertices_of(const DmsModel& domain) {
  std::vector<DmsPoint> out;
  for (const DmsCloud& cloud : domain.clouds) out.push_back(cloud[0]);
  return out;
}

void scale_up(std::vector<double>& numbers, std::int64_t exponent) {
  for (double& x : numbers) x = scaled_up(x, exponent);
}

}  // namespace

FitUnits::FitUnits(const DmsModel& domain, const DmsData& data)
    : places_(similarity_of(vertices_of(domain))) {
  Rational most;
  for (const Rational& value : data.values) most = std::max(most, abs(value));
  if (most.sign() == Sign::kZero) return;
  const std::int64_t exponent = exponent_of(most);
  if (exponent < -kModerate || exponent > kModerate) exponent_ = exponent;
}

DmsData FitUnits::to_unit(const DmsData& data) const {
  DmsData out = data;
  for (DmsPoint& p : out.points) p = places_.to_unit(std::move(p));
  const Rational factor = Rational::power_of_two(-exponent_);
  for (Rational& value : out.values) value *= factor;
  return out;
}

DmsFitOptions FitUnits::to_unit(const DmsFitOptions& options) const {
  DmsFitOptions out = options;
  if (out.tolerance) out.tolerance = scaled_up(*out.tolerance, -2 * exponent_);
  for (DmsPlane& plane : out.features) plane = places_.to_unit(plane);
  return out;
}

void FitUnits::restore(DmsFit& fit) const {
  fit.model = places_.from_unit(std::move(fit.model));
  const std::size_t components = fit.model.num_components();
  const Rational factor = Rational::power_of_two(exponent_);
  for (std::size_t i = 0; i < fit.model.control.values.size(); ++i)
    if (i % components >= fit.model.num_coordinates) fit.model.control.values[i] *= factor;
  fit.errors.geometry_mse = scaled_up(fit.errors.geometry_mse, 2 * places_.exponent);
  scale_up(fit.errors.attribute_mse, 2 * exponent_);
  scale_up(fit.errors.max_error, exponent_);
  for (DmsFitRound& round : fit.rounds) {
    scale_up(round.attribute_mse, 2 * exponent_);
    scale_up(round.max_error, exponent_);
  }
}

}  // namespace veritope
