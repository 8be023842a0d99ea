// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/control_net.h: the coefficients of a map, what Bezier and BSpline have in common.
#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "splines/ring.h"

namespace veritope {

/// Component by component; in rational maps the last component is the weight w, the others are w times the coordinates.
template <Ring R>
class ControlNet {
 public:
  /// Includes the weight.
  int num_components() const { return num_components_; }
  bool is_rational() const { return is_rational_; }
  /// The dimension of the points, without the weight.
  int dimension() const { return num_components_ - (is_rational_ ? 1 : 0); }
  std::span<const R> coefficients() const { return coefficients_; }
  std::span<R> coefficients() { return coefficients_; }
  std::span<const R> component(int c) const {
    return coefficients().subspan(static_cast<std::size_t>(c) * count_, count_);
  }
  std::span<R> component(int c) {
    return coefficients().subspan(static_cast<std::size_t>(c) * count_, count_);
  }
  friend bool operator==(const ControlNet&, const ControlNet&) = default;

 protected:
  /// REQUIRES coefficients.size() = count * num_components.
  ControlNet(std::size_t count, int num_components, bool is_rational, std::vector<R> coefficients)
      : count_(count),
        num_components_(num_components),
        is_rational_(is_rational),
        coefficients_(std::move(coefficients)) {
    VT_CHECK(coefficients_.size() == count_ * static_cast<std::size_t>(num_components_),
             "a map needs a coefficient for every component and index");
  }

 private:
  std::size_t count_;
  int num_components_;
  bool is_rational_;
  std::vector<R> coefficients_;
};

}  // namespace veritope
