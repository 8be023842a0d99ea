// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/dms_knot_slope.h: the derivative of a DMS spline with respect to a knot, in the form of degree n - 1.
// Source: [HHQ04] eq. 11, which is printed for the form of degree n, so that it holds only where eq. 6 holds. This is
// the derivative of the terms of docs/formats/dms-files.md themselves.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "splines/dms_spline.h"

namespace veritope {

/// Adds one tetrahedron's part of the derivatives, along the axes, of s(u) with respect to knot `index` of a corner:
///   - 1/n sum over γ_p >= l of d(W_γ) L_γ(u) DM(u | V_γ and t_l once more)
///   + sum over γ_p = l of N_γ(u) (μ_p L_γ(u) - λ_p(u) G_γ / n),
/// p the corner, l the index, t_l the knot, |γ| = n - 1, L_γ = the sum of λ_m c(γ + e_m), G_γ / n its linear part, and
/// μ_p(v) the coordinate of a direction. The derivative is one-sided where M is not differentiable. Equal knots have
/// derivatives of their own; that of a point that they share is their sum.
/// REQUIRES 1 <= n <= kMaxDmsDegree, 0 <= index < n, and as add_dms_terms. sums: one row for each component.
template <Ring R, typename Answers, typename Control>
void add_dms_knot_slope(SimplexSplines<R, Answers>& splines, const DmsKnots& knots, int n,
                        std::size_t corner, int index, Control control,
                        std::vector<std::array<R, 3>>& sums) {
  VT_CHECK(0 <= index && index < n, "knot n has no effect");
  const R share = RingNumbers<R>::ratio(-1, n);
  for_each_tetrahedral_index(n - 1, [&](const TetrahedralIndex& gamma) {
    if (gamma[corner] < index) return;
    const KnotSet set = knots.up_to(gamma);
    KnotSet doubled = set;
    doubled.insert(knots.number[corner][static_cast<std::size_t>(index)]);
    const auto w = knots.tetrahedron(gamma);
    const SimplexFrame<R>* const frame = splines.frame(KnotSet{w[0], w[1], w[2], w[3]});
    VT_CHECK(frame != nullptr, "the four last knots of a basis function are independent");
    const std::array<R, 4> lambda = splines.barycentric(*frame);
    const bool is_last = gamma[corner] == index;
    const R basis = is_last ? R(frame->volume * splines.value(set)) : R();
    std::array<R, 3> rise = splines.gradient(doubled);
    for (R& slope : rise) slope = share * frame->volume * slope;
    for (std::size_t c = 0; c < sums.size(); ++c) {
      R affine{};
      std::array<R, 3> linear{};
      for (std::size_t m = 0; m < 4; ++m) {
        const std::span<const R> point = control(raised(gamma, m));
        affine = affine + lambda[m] * point[c];
        for (std::size_t a = 0; a < 3; ++a)
          linear[a] = linear[a] + frame->lambda[m][a + 1] * point[c];
      }
      for (std::size_t a = 0; a < 3; ++a) {
        sums[c][a] = sums[c][a] + affine * rise[a];
        if (is_last)
          sums[c][a] = sums[c][a] +
                       basis * (frame->lambda[corner][a + 1] * affine - lambda[corner] * linear[a]);
      }
    }
  });
}

}  // namespace veritope
