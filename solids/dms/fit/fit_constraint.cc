// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/fit_constraint.h"

#include "robust/base/check.h"
#include "solids/dms/dms_knots.h"

namespace veritope {
namespace {

std::size_t largest_axis(const DmsPoint& v) {
  std::size_t axis = 0;
  for (std::size_t c = 1; c < 3; ++c)
    if (abs(v[axis]) < abs(v[c])) axis = c;
  return axis;
}

}  // namespace

void FitConstraint::add_normal(const DmsPoint& normal) {
  if (rank_ == 3) return;
  if (rank_ == 0) {
    rank_ = 1, vector_ = normal;
  } else if (rank_ == 1) {
    const DmsPoint line = cross_product(vector_, normal);
    if (line == DmsPoint{}) return;
    rank_ = 2, vector_ = line;
  } else if (dot_product(vector_, normal).sign() != Sign::kZero) {
    rank_ = 3;
  }
  axis_ = largest_axis(vector_);
}

std::array<double, 3> FitConstraint::direction(std::size_t i) const {
  VT_CHECK(i < num_directions(), "a direction of the constraint");
  std::array<double, 3> out{};
  if (rank_ == 0) {
    out[i] = 1;
  } else if (rank_ == 1) {
    const std::size_t c = (axis_ + 1 + i) % 3;
    out[c] = 1;
    out[axis_] = -nearest_double(vector_[c] / vector_[axis_]);
  } else {
    for (std::size_t c = 0; c < 3; ++c) out[c] = nearest_double(vector_[c] / vector_[axis_]);
  }
  return out;
}

DmsPoint FitConstraint::moved(const DmsPoint& from, std::span<const double> steps) const {
  VT_CHECK(steps.size() == num_directions(), "a step for each direction");
  DmsPoint to = from;
  const auto step = [&](std::size_t c, double by) {
    if (by != 0) to[c] = Rational::from_double(nearest_double(from[c]) + by);
    return to[c] - from[c];
  };
  if (rank_ == 0) {
    for (std::size_t c = 0; c < 3; ++c) step(c, steps[c]);
  } else if (rank_ == 1) {
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t c = (axis_ + 1 + i) % 3;
      to[axis_] -= step(c, steps[i]) * vector_[c] / vector_[axis_];
    }
  } else if (rank_ == 2) {
    const Rational along = step(axis_, steps[0]) / vector_[axis_];
    for (std::size_t c = 0; c < 3; ++c)
      if (c != axis_) to[c] += along * vector_[c];
  }
  return to;
}

std::vector<FitConstraint> fit_constraints(const DmsModel& model, const TetrahedralComplex& complex,
                                           std::span<const DmsPlane> features) {
  std::vector<FitConstraint> out(model.clouds.size());
  for (const TetrahedronFace f : complex.boundary()) {
    const auto v = complex.vertices(f);
    const DmsPoint& a = model.clouds[v[0]][0];
    const DmsPoint normal =
        cross_product(difference(model.clouds[v[1]][0], a), difference(model.clouds[v[2]][0], a));
    for (const std::uint32_t w : v) out[w].add_normal(normal);
  }
  for (std::size_t v = 0; v < out.size(); ++v)
    for (const DmsPlane& plane : features)
      if (dot_product(plane.vector, model.clouds[v][0]) == plane.number)
        out[v].add_normal(plane.vector);
  return out;
}

}  // namespace veritope
