// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/dms_blossom.h: the blossom of a B-patch: the symmetric map of n points, affine in each, whose value for n
// equal points is the polynomial of a tetrahedron's control points.
// Source: [DMS92], section 3; the recursion is de Boor's over the frames of W_γ.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "splines/dms_spline.h"

namespace veritope {

/// A polynomial map of degree n on a tetrahedron with clouds of knots: c(β), |β| = n, is its blossom at the knots p_0
/// to p_(i-1), q_0 to q_(j-1), r_0 to r_(k-1), s_0 to s_(l-1).
template <Ring R>
class BPatch {
 public:
  /// frame(γ) is the frame of W_γ, for each |γ| < n. The control points lie in the order of tetrahedral_index, each
  /// with num_components numbers. REQUIRES 1 <= degree <= kMaxDmsDegree.
  template <typename Frame>
  BPatch(int degree, std::size_t num_components, std::vector<R> control, Frame frame)
      : degree_(degree), num_components_(num_components), control_(std::move(control)) {
    VT_CHECK(control_.size() == num_tetrahedral_indices(degree) * num_components,
             "a B-patch has a control point for every index");
    frames_.resize(static_cast<std::size_t>(degree));
    for (int sum = 0; sum < degree; ++sum)
      for_each_tetrahedral_index(sum, [&](const TetrahedralIndex& gamma) {
        frames_[static_cast<std::size_t>(sum)].push_back(frame(gamma));
      });
  }

  /// The blossom: one number for each component. Its order of points does not change the value.
  /// REQUIRES as many points as the degree. @cost four products for each γ and component, and the barycentric
  /// coordinates of a point for each γ
  std::vector<R> blossom(std::span<const std::array<R, 3>> points) const {
    VT_CHECK(points.size() == static_cast<std::size_t>(degree_),
             "a blossom has as many points as the degree");
    std::vector<R> net = control_;
    for (int sum = degree_ - 1; sum >= 0; --sum)
      net = step(net, sum, points[static_cast<std::size_t>(degree_ - 1 - sum)]);
    return net;
  }
  /// The polynomial.
  std::vector<R> value(const std::array<R, 3>& u) const {
    return blossom(std::vector<std::array<R, 3>>(static_cast<std::size_t>(degree_), u));
  }

 private:
  // From the points of the indices of sum + 1 to those of sum.
  std::vector<R> step(const std::vector<R>& net, int sum, const std::array<R, 3>& u) const {
    std::vector<R> out;
    out.reserve(num_tetrahedral_indices(sum) * num_components_);
    for_each_tetrahedral_index(sum, [&](const TetrahedralIndex& gamma) {
      const SimplexFrame<R>& frame =
          frames_[static_cast<std::size_t>(sum)][tetrahedral_index(gamma)];
      const std::array<R, 4> lambda = frame.barycentric(u);
      std::array<std::size_t, 4> at{};
      for (std::size_t m = 0; m < 4; ++m)
        at[m] = tetrahedral_index(raised(gamma, m)) * num_components_;
      for (std::size_t c = 0; c < num_components_; ++c)
        out.push_back(lambda[0] * net[at[0] + c] + lambda[1] * net[at[1] + c] +
                      lambda[2] * net[at[2] + c] + lambda[3] * net[at[3] + c]);
    });
    return out;
  }

  int degree_;
  std::size_t num_components_;
  std::vector<R> control_;
  std::vector<std::vector<SimplexFrame<R>>> frames_;  // of each sum, in the order of its indices
};

}  // namespace veritope
