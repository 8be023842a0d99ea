// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/origin_cost.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "robust/base/fp_guard.h"
#include "solids/chain/free_form_cell.h"

namespace veritope {
namespace {

void add_rounded(const PatchPoint& p, Box3d& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = std::min(box.lo[k], round_down(p[k]));
    box.hi[k] = std::max(box.hi[k], round_up(p[k]));
  }
}

Box3d box_of_control(const Patch& patch) {
  Box3d out = empty_box();
  for (std::size_t i = 0; i < patch.num_control(); ++i) {
    PatchPoint p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = patch.component(static_cast<int>(k))[i];
      if (patch.is_rational()) p[k] /= patch.component(3)[i];
    }
    add_rounded(p, out);
  }
  return out;
}

}  // namespace

OriginCosts::OriginCosts(const PatchComplex& complex) : model_(empty_box()) {
  const ScopedDefaultFp nearest;
  std::vector<Box3d> cells;
  for (const Patch& patch : complex.patches()) {
    const Box3d all = box_of_control(patch);
    model_ = hull(model_, all);
    if (!patch.is_flat_triangle()) cells.push_back(all);
    for (const BaseTriangle& base : base_triangles(patch)) {
      Box3d box = empty_box();
      for (const PatchPoint& p : base) add_rounded(p, box);
      bases_.push_back(box);
    }
  }
  num_cells_ = cells.size();
  for (const Box3d& box : cells) {
    double part = 1;
    for (std::size_t k = 0; k < 3; ++k) part *= share(k, box.lo[k], box.hi[k]);
    cells_ += part;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    order_[k].resize(2 * bases_.size());
    std::iota(order_[k].begin(), order_[k].end(), 0u);
    const auto bound = [&](std::uint32_t i) {
      return i % 2 == 0 ? bases_[i / 2].lo[k] : bases_[i / 2].hi[k];
    };
    std::sort(order_[k].begin(), order_[k].end(), [&](std::uint32_t a, std::uint32_t b) {
      return bound(a) != bound(b) ? bound(a) < bound(b) : a < b;
    });
  }
}

// Where coordinates along an axis are so large that their differences may overflow, quarters are taken.
double OriginCosts::share(std::size_t axis, double lo, double hi) const {
  const double far = std::max(std::abs(model_.lo[axis]), std::abs(model_.hi[axis])),
               unit = far >= 0x1p1022 ? 0.25 : 1;
  return (unit * hi - unit * lo) / (unit * model_.hi[axis] - unit * model_.lo[axis]);
}

// Claim   each part has a relative error of less than 14u, u = 2^-53: two differences, which are exact below 2^-1022,
//         and a quotient of at most 1, for three axes, and two products; and an absolute error below 2^-1000 where
//         these underflow. Quarters are exact but for bounds below 2^-1020, by
//         2^-1074, beside a length over 2^900. A sum of n parts that are not negative adds less than n u of the sum.
CellTests OriginCosts::at(const ExactPoint& origin) const {
  const ScopedDefaultFp nearest;
  Box3d from = empty_box();
  add_rounded(origin, from);
  CellTests out;
  for (const Box3d& base : bases_) {
    double part = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double lo = std::max(model_.lo[k], std::min(base.lo[k], from.lo[k])),
                   hi = std::min(model_.hi[k], std::max(base.hi[k], from.hi[k]));
      part *= share(k, lo, hi);
    }
    out.value += part;
  }
  out.value += cells_;
  out.error = (out.value + 1) * 0x1p-52 * static_cast<double>(16 + bases_.size() + num_cells_);
  return out;
}

// Along an axis the sum is sum_j w_j (max(hi_j, x) - min(lo_j, x)) with the shares w_j along the other two axes. Its
// slope is the sum of the w_j with hi_j < x minus the sum of those with x < lo_j: it changes its sign where the bounds
// up to x have half of the weight of all bounds.
double OriginCosts::best_along(std::size_t axis, const Point3d& at) const {
  std::vector<double> weights(bases_.size(), 1);
  double all = 0;
  for (std::size_t j = 0; j < bases_.size(); ++j) {
    for (std::size_t k = 0; k < 3; ++k)
      if (k != axis)
        weights[j] *= share(k, std::min(bases_[j].lo[k], at[k]), std::max(bases_[j].hi[k], at[k]));
    all += weights[j];
  }
  double below = 0;
  for (const std::uint32_t i : order_[axis]) {
    below += weights[i / 2];
    if (below >= all) return i % 2 == 0 ? bases_[i / 2].lo[axis] : bases_[i / 2].hi[axis];
  }
  return at[axis];
}

Point3d OriginCosts::descended(Point3d at) const {
  constexpr int kMostRounds = 16;
  for (int round = 0; round < kMostRounds; ++round) {
    const Point3d before = at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = best_along(k, at);
    if (at == before) break;
  }
  return at;
}

Point3d OriginCosts::median() const {
  Point3d out;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t i = order_[k][bases_.size()];
    out[k] = i % 2 == 0 ? bases_[i / 2].lo[k] : bases_[i / 2].hi[k];
  }
  return out;
}

OriginCost OriginCosts::best() const {
  const ScopedDefaultFp nearest;
  std::vector<Point3d> candidates;
  const Point3d zero{};
  if (is_inside({zero, zero}, model_)) candidates.push_back(zero);
  candidates.push_back(approx_centre(model_));
  candidates.push_back(median());
  for (unsigned octant = 0; octant < 8; ++octant) {
    Point3d p;
    for (std::size_t k = 0; k < 3; ++k) {
      const double t = (octant >> k & 1u) != 0 ? 0.75 : 0.25;
      p[k] = (1 - t) * model_.lo[k] + t * model_.hi[k];
    }
    candidates.push_back(p);
  }
  const std::size_t num_starts = candidates.size();
  for (std::size_t i = 0; i < num_starts; ++i) candidates.push_back(descended(candidates[i]));
  OriginCost out;
  bool is_first = true;
  for (const Point3d& p : candidates) {
    ExactPoint origin;
    for (std::size_t k = 0; k < 3; ++k) origin[k] = Rational::from_double(p[k]);
    const CellTests tests = at(origin);
    if (is_first || tests.value + tests.error < out.tests.value - out.tests.error)
      out = {origin, tests};
    is_first = false;
  }
  return out;
}

}  // namespace veritope
