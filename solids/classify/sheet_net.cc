// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/sheet_net_internal.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "splines/de_casteljau_line.h"

namespace veritope::internal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The least and the greatest of quotients, pushed outward by their roundings.
class Ends {
 public:
  void add(double x, double error, double w, double w_error) {
    if (!(w - w_error > 0)) {
      lo_ = -kInfinity;
      hi_ = kInfinity;
      return;
    }
    const auto ends = hull_ends(x, error, w, w_error);
    lo_ = std::min(lo_, ends[0]);
    hi_ = std::max(hi_, ends[1]);
  }
  std::array<double, 2> outward() const {
    const double slack = hull_slack(lo_, hi_, 0, true);
    return {lo_ - slack, hi_ + slack};
  }

 private:
  double lo_ = kInfinity, hi_ = -kInfinity;
};

}  // namespace

SheetNet::SheetNet(const TensorForm& form) : form_(&form) {
  for (std::size_t k = 0; k < 4; ++k) {
    values_.insert(values_.end(), form.rounded[k].begin(), form.rounded[k].end());
    error_[k] = relative_bound(greatest(k));
  }
}

double SheetNet::greatest(std::size_t k) const {
  double out = 0;
  for (std::size_t i = 0; i < form_->count(); ++i) out = std::max(out, std::abs(component(k)[i]));
  return out;
}

Point3d SheetNet::at(std::size_t i) const {
  const double w = component(3)[i];
  return {component(0)[i] / w, component(1)[i] / w, component(2)[i] / w};
}

Box3d SheetNet::hull() const {
  Box3d out;
  for (std::size_t k = 0; k < 3; ++k) {
    Ends ends;
    for (std::size_t i = 0; i < form_->count(); ++i)
      ends.add(component(k)[i], error_[k], component(3)[i], error_[3]);
    const auto e = ends.outward();
    out.lo[k] = e[0];
    out.hi[k] = e[1];
  }
  return out;
}

std::array<double, 2> SheetNet::range_along(const Point3d& n) const {
  double error = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    error += std::abs(n[k]) * error_[k];
    size += std::abs(n[k]) * greatest(k);
  }
  const double bound = plane_bound(error, size);
  Ends ends;
  for (std::size_t i = 0; i < form_->count(); ++i)
    ends.add(plane_value(n, component(0)[i], component(1)[i], component(2)[i]), bound,
             component(3)[i], error_[3]);
  return ends.outward();
}

Point3d SheetNet::normal() const {
  const PlaneNormal n = mean_normal(*form_, [this](std::size_t i) { return at(i); });
  const double sum = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
  if (sum == 0) return {};
  return {n[0] / sum, n[1] / sum, n[2] / sum};
}

double SheetNet::length(std::size_t axis) const {
  return approx_length(*form_, axis, [this](std::size_t i) { return at(i); });
}

SheetNet SheetNet::halve(std::size_t axis) {
  SheetNet right = *this;
  const int degree = form_->degrees[axis];
  for (std::size_t k = 0; k < 4; ++k) {
    right.error_[k] = error_after_halving(error_[k], greatest(k), degree);
    for (int line = 0; line <= form_->degrees[1 - axis]; ++line) {
      const std::size_t first =
          k * form_->count() + static_cast<std::size_t>(line) * form_->stride(1 - axis);
      split_keeping_left(values_.data() + first, form_->stride(axis), degree,
                         right.values_.data() + first, form_->stride(axis), kHalfBlend);
    }
  }
  error_ = right.error_;
  return right;
}

namespace {

void add_hulls(SheetNet net, int halvings, Box3d& out) {
  const Box3d own = net.hull();
  if (halvings == 0 || is_inside(own, out)) {
    out = hull(out, own);
    return;
  }
  SheetNet right = net.halve(net.length(0) >= net.length(1) ? 0 : 1);
  add_hulls(std::move(net), halvings - 1, out);
  add_hulls(std::move(right), halvings - 1, out);
}

}  // namespace

Box3d tight_hull(const TensorForm& form) {
  constexpr int kHalvings = 6;
  const bool is_flat = form.degrees[0] == 1 && form.degrees[1] == 1;
  Box3d out = empty_box();
  add_hulls(SheetNet(form), is_flat ? 0 : kHalvings, out);
  return out;
}

}  // namespace veritope::internal
