// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/fit_cage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "solids/micro/cage/cage_containment.h"
#include "solids/micro/cage/field_fit_internal.h"
#include "solids/micro/cage/short_numbers_internal.h"

namespace veritope {
namespace {

using internal::FieldData;
using internal::FieldFit;
using internal::Parameters3;

constexpr std::size_t kMostMiddles = 4096;  // parts
constexpr int kMostWidenings = 4;
constexpr double kRadian = 57.29577951308232;

bool is_finite(const Point3d& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

Status check_field(const DirectionField& field) {
  if (field.size() == 0) return bad_argument("a field without vectors has no cage");
  if (field.size() > kMaxFitVectors)
    return Error{
        Code::kOverLimit, {}, "there are more than " + std::to_string(kMaxFitVectors) + " vectors"};
  for (std::size_t i = 0; i < field.size(); ++i) {
    const std::string name = "vector " + std::to_string(i);
    const bool has_thickness = !field.thickness.empty();
    if (!is_finite(field.points[i]) || !is_finite(field.axes[i]) ||
        (has_thickness && !std::isfinite(field.thickness[i])))
      return bad_argument(name + " has a number that is not finite");
    if (field.axes[i] == Point3d{}) return bad_argument(name + " has no direction: it is 0");
  }
  return ok_status();
}

Status check_options(const FitCageOptions& options) {
  if (const Status fits = check_cage_grid(options.grid); !fits) return fits;
  std::uint64_t spans = 1;
  for (const std::uint64_t n : options.grid.spans) spans *= n;
  if (spans > kMaxFitSpans)
    return Error{Code::kOverLimit,
                 {},
                 "spans of a fit are at most " + std::to_string(kMaxFitSpans) +
                     " in all, and there are " + std::to_string(spans)};
  for (const int degree : options.grid.degrees)
    if (degree > kMaxFitDegree)
      return Error{Code::kOverLimit,
                   {},
                   "degrees of a fit are at most " + std::to_string(kMaxFitDegree) +
                       ", and one is " + std::to_string(degree)};
  if (options.margin.sign() == Sign::kPositive) return ok_status();
  return bad_argument("margin must be positive, not " + options.margin.to_string());
}

// The direction has unit length, also where squares of coordinates overflow or vanish.
Point3d direction_of(const Point3d& axis) {
  const double most = std::max({std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2])});
  int exponent = 0;
  std::frexp(most, &exponent);
  Point3d out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = std::ldexp(axis[k], -exponent);
  const double length = std::sqrt(internal::dot(out, out));
  for (double& x : out) x /= length;
  return out;
}

// x = shift + 2^exponent p of the points p of the data.
struct FieldUnits {
  CellPoint shift;
  Rational scale;
  Point3d to_unit(const CellPoint& x) const {
    Point3d out;
    for (std::size_t k = 0; k < 3; ++k) out[k] = nearest_double((x[k] - shift[k]) / scale);
    return out;
  }
};

CellPoint exact(const Point3d& p) {
  return {Rational::from_double(p[0]), Rational::from_double(p[1]), Rational::from_double(p[2])};
}

Result<FieldUnits> units_of(const CageBox& box) {
  FieldUnits out;
  out.scale = internal::power_of_two_below(margin_length(box, Rational(1)));
  const Rational unit = out.scale * Rational::power_of_two(-20);
  for (std::size_t k = 0; k < 3; ++k) {
    for (const Rational& x : {box.min[k], box.max[k]})
      if (abs(x) > out.scale * Rational::power_of_two(30))
        return Error{Code::kOverLimit,
                     {},
                     "vectors in a box of this size are too far from the origin: a coordinate is " +
                         x.to_string()};
    out.shift[k] = internal::multiple_below((box.min[k] + box.max[k]) / Rational(2), unit);
  }
  return out;
}

// The middles of neighbouring corners of a part: where the cage bends, they may be outside when the corners are not.
void add_middles(const CageContent& content, std::size_t part, std::vector<Point3d>& points) {
  const auto corners = content.part(part);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const Point3d a = points[corners[c]], b = points[corners[(c + 1) % corners.size()]];
    points.push_back({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])});
  }
}

FieldData data_of(const DirectionField& field, const CageContent& content, const FieldUnits& units,
                  const Rational& margin) {
  FieldData out;
  for (const Point3d& p : field.points) out.points.push_back(units.to_unit(exact(p)));
  for (const Point3d& d : field.axes) out.directions.push_back(direction_of(d));
  for (const CellPoint& p : content.points) out.corners.push_back(units.to_unit(p));
  for (std::size_t i = 0; i < content.num_parts() && content.num_parts() <= kMostMiddles; ++i)
    add_middles(content, i, out.corners);
  out.margin = nearest_double(margin / units.scale);
  return out;
}

std::vector<double> angles_of(const FieldFit& fit, const FieldData& data) {
  std::vector<double> out;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Point3d w = fit.net().jet(fit.net().weights(fit.places()[i])).along[2];
    const Point3d c = internal::cross(w, data.directions[i]);
    out.push_back(
        std::atan2(std::sqrt(internal::dot(c, c)), std::abs(internal::dot(w, data.directions[i]))) *
        kRadian);
  }
  return out;
}

// The cell with the thickness as fourth coordinate.
CellVolume with_thickness(const CellVolume& cell, const FieldFit& fit, const DirectionField& field,
                          FitCage& out) {
  const auto [low, high] = std::minmax_element(field.thickness.begin(), field.thickness.end());
  const double most = std::max(std::abs(*low), std::abs(*high));
  int exponent = 0;
  std::frexp(most, &exponent);
  std::vector<double> values;
  for (const double t : field.thickness) values.push_back(std::ldexp(t, -exponent));
  const auto net = internal::solve_scalar(fit.net(), fit.places(), values, fit.smoothness(),
                                          std::min(fit.smooth(), 1e-6));
  std::vector<Rational> all(cell.coefficients().begin(), cell.coefficients().end());
  internal::FieldNet rounded = fit.net();
  for (std::size_t n = 0; n < net.size(); ++n) {
    const double x = std::nearbyint(net[n][0] * 0x1p20) * 0x1p-20;
    rounded.points[n] = {x, 0, 0};
    all.push_back(Rational::from_double(x) * Rational::power_of_two(exponent));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double at = rounded.jet(rounded.weights(fit.places()[i])).point[0];
    out.approx_thickness_errors.push_back(std::ldexp(std::abs(at - values[i]), exponent));
  }
  return CellVolume(cell.axes(), 4, false, std::move(all));
}

}  // namespace

CageBox box_of(const DirectionField& field, const CageContent& content) {
  Point3d low = field.points.front(), high = low;
  for (const Point3d& p : field.points)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  CageBox box{exact(low), exact(high)};
  if (content.num_parts() == 0) return box;
  const CageBox other = box_of(content);
  for (std::size_t k = 0; k < 3; ++k) {
    if (other.min[k] < box.min[k]) box.min[k] = other.min[k];
    if (box.max[k] < other.max[k]) box.max[k] = other.max[k];
  }
  return box;
}

Result<FitCage> fit_cage(const DirectionField& field, const CageContent& content,
                         const FitCageOptions& options) {
  if (const Status fits = check_options(options); !fits) return fits.error();
  if (const Status fits = check_field(field); !fits) return fits.error();
  const CageBox box = box_of(field, content);
  const Result<FieldUnits> units = units_of(grown(box, options.margin));
  if (!units) return units.error();
  const FieldData data = data_of(field, content, *units, options.margin);
  FieldFit fit(data, options.grid, options.jobs);
  fit.run();
  for (int tries = 0; tries < kMostWidenings && content.num_parts() > 0; ++tries) {
    const auto model = make_v_model({fit.net().cell(options.grid, units->scale, units->shift)},
                                    VOrientation::kKeep);
    if (!model || !find_gap(*model, content)) break;
    fit.widen();
  }
  FitCage out{fit.net().cell(options.grid, units->scale, units->shift),
              fit.steps(),
              fit.shortened(),
              fit.stop(),
              fit.smooth(),
              angles_of(fit, data),
              {}};
  if (out.stop)
    for (std::size_t k = 0; k < 3; ++k)
      out.stop->near[k] =
          nearest_double(Rational::from_double(out.stop->near[k]) * units->scale + units->shift[k]);
  if (!field.thickness.empty()) out.cell = with_thickness(out.cell, fit, field, out);
  return out;
}

}  // namespace veritope
