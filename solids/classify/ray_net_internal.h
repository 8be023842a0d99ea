// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/ray_net_internal.h: the control net of a piece of a patch relative to a point, and the curves of its
// sides, in doubles with bounds and in integers. Both have the same members, so that one descent serves both. Internal
// to solids/classify.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "robust/dyadic.h"
#include "solids/classify/ray_bounds.h"
#include "solids/classify/ray_point.h"
#include "solids/classify/tensor_form.h"
#include "splines/de_casteljau_line.h"

namespace veritope::internal {

/// A direction in integers below 2^21, as doubles.
using PlaneNormal = std::array<double, 3>;

/// The direction of a x b in such integers; zeros if a and b are parallel.
PlaneNormal normal_of(const Point3d& a, const Point3d& b);
/// That of the mean tangents of a net along both axes, approximately. at(i): control point i of the form's order.
template <typename At>
PlaneNormal mean_normal(const TensorForm& form, const At& at);
/// The greatest length of three lines of the net along the axis, approximately.
template <typename At>
double approx_length(const TensorForm& form, std::size_t axis, const At& at);

/// The cut at 1/2: what error_after_halving bounds.
inline constexpr HalfBlend<double> kHalfBlend{0.5};

constexpr std::size_t kMostCoefficients = 16;  // of a side: kMaxPatchDegree + 1

/// Memory for nets that come and go in the order of a stack.
class NetPool {
 public:
  double* take(std::size_t size) {
    if (size > size_) blocks_.clear(), free_.clear(), size_ = size;
    if (free_.empty()) {
      blocks_.push_back(std::make_unique<double[]>(size_));
      return blocks_.back().get();
    }
    double* const out = free_.back();
    free_.pop_back();
    return out;
  }
  void give(double* block) { free_.push_back(block); }

 private:
  std::size_t size_ = 0;
  std::vector<std::unique_ptr<double[]>> blocks_;
  std::vector<double*> free_;
};

/// The net in doubles. Coordinates are those of TensorForm::rounded, relative to the point, times the weights.
class RoundedNet {
 public:
  using Parameter = std::uint64_t;  ///< in units of 2^-kBits
  static constexpr int kBits = 48;
  static Parameter parameter_one() { return Parameter{1} << kBits; }
  static Parameter middle(Parameter a, Parameter b) { return a + (b - a) / 2; }
  static double to_double(Parameter t) { return static_cast<double>(t) * 0x1p-48; }

  /// A side, seen along an axis: the coordinates of the two axes after it in cyclic order.
  struct Curve {
    int degree = 0;
    std::array<std::array<double, kMostCoefficients>, 2> at;
    std::array<double, 2> error{};
  };
  /// The winding of the part [from, to] of the curve on [begin, end] around the point; nothing if doubles do not
  /// decide.
  static std::optional<int> winding(Curve curve, Parameter begin, Parameter end, Parameter from,
                                    Parameter to, const std::array<double, 2>& turn);

  RoundedNet(const TensorForm& form, const RayPoint& point, NetPool& pool);
  RoundedNet(RoundedNet&& net) noexcept
      : form_(net.form_),
        pool_(net.pool_),
        values_(net.values_),
        error_(net.error_),
        ends_(net.ends_) {
    net.values_ = nullptr;
  }
  RoundedNet& operator=(RoundedNet&&) = delete;
  ~RoundedNet() {
    if (values_ != nullptr) pool_.give(values_);
  }

  const TensorForm& form() const { return form_; }
  /// The sign of a coordinate.
  CommonSign sign(std::size_t k) const { return common_sign(ends_[k][0], ends_[k][1], error_[k]); }
  CommonSign side(const PlaneNormal& n) const;
  /// Approximate.
  PlaneNormal normal() const;
  double length(std::size_t axis) const;
  /// Whether the errors are so large that smaller pieces would tell nothing.
  bool is_exhausted() const;
  /// This becomes the first half, the result is the second.
  RoundedNet halve(std::size_t axis);
  Curve curve(std::uint32_t side, std::size_t along, bool is_reversed) const;

 private:
  RoundedNet(const TensorForm& form, NetPool& pool);
  std::size_t count() const { return form_.count(); }
  const double* component(std::size_t k) const { return values_ + k * count(); }
  double size(std::size_t k) const { return std::max(-ends_[k][0], ends_[k][1]); }
  Point3d at(std::size_t i) const { return {component(0)[i], component(1)[i], component(2)[i]}; }
  void find_ends();

  const TensorForm& form_;
  NetPool& pool_;
  double* values_;
  std::array<double, 3> error_{};
  std::array<std::array<double, 2>, 3> ends_{};  // least and greatest
};

/// Times a positive number: the Bernstein coefficients on [from, to], which lies in [begin, end], of a polynomial with
/// these coefficients on [begin, end].
void restrict_to(std::vector<Integer>& line, const Dyadic& begin, const Dyadic& end,
                 const Dyadic& from, const Dyadic& to);

/// The coordinates of all control points relative to the point, times the weights and one positive number.
std::array<std::vector<Integer>, 3> relative_coefficients(const TensorForm& form,
                                                          const RayPoint& point);

/// The net in integers: coordinates relative to the point, times the weights and one positive number.
class ExactNet {
 public:
  using Parameter = Dyadic;
  static Parameter parameter_one() { return Dyadic(1); }
  static Parameter middle(const Parameter& a, const Parameter& b) {
    return (a + b) * Dyadic(1, -1);
  }
  static double to_double(const Parameter& t) { return nearest_double(t.to_rational()); }

  struct Curve {
    std::array<std::vector<Integer>, 2> at;
  };
  static std::optional<int> winding(const Curve& curve, const Parameter& begin,
                                    const Parameter& end, const Parameter& from,
                                    const Parameter& to, const std::array<double, 2>& turn);

  ExactNet(const TensorForm& form, const RayPoint& point);
  ExactNet(ExactNet&&) noexcept = default;

  const TensorForm& form() const { return form_; }
  CommonSign sign(std::size_t k) const;
  CommonSign side(const PlaneNormal& n) const;
  PlaneNormal normal() const;
  double length(std::size_t axis) const;
  static bool is_exhausted() { return false; }
  ExactNet halve(std::size_t axis);
  Curve curve(std::uint32_t side, std::size_t along, bool is_reversed) const;

 private:
  explicit ExactNet(const TensorForm& form) : form_(form) {}
  /// The control points relative to the first one, in a unit that all have in common: leading digits that all points
  /// of a small piece have are gone.
  const std::vector<Point3d>& shape() const;

  const TensorForm& form_;
  std::array<std::vector<Integer>, 3> values_;
  mutable std::vector<Point3d> shape_;  // empty: not yet made
};

template <typename At>
PlaneNormal mean_normal(const TensorForm& form, const At& at) {
  const std::size_t row = form.first_of_side(1), last = form.first_of_side(2);
  const Point3d a = at(0), b = at(row), c = at(last), d = at(row + last);
  Point3d u, v;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = (b[k] - a[k]) + (d[k] - c[k]);
    v[k] = (c[k] - a[k]) + (d[k] - b[k]);
  }
  return normal_of(u, v);
}

template <typename At>
double approx_length(const TensorForm& form, std::size_t axis, const At& at) {
  const auto n = static_cast<std::size_t>(form.degrees[axis]),
             lines = static_cast<std::size_t>(form.degrees[1 - axis]);
  const std::size_t stride = form.stride(axis), across = form.stride(1 - axis);
  double most = 0;
  for (const std::size_t line : {std::size_t{0}, lines / 2, lines}) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Point3d p = at(line * across + i * stride), q = at(line * across + (i + 1) * stride);
      sum += std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]);
    }
    most = std::max(most, sum);
  }
  return most;
}

}  // namespace veritope::internal
