// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/dms_spline.h: DMS splines on one tetrahedron: their basis functions and their terms, in the form of degree
// n - 1 and in that of degree n. What a term means: docs/formats/dms-files.md, "The map".
// Source: [DMS92], [HHQ04] eq. 4 to 6.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/check.h"
#include "splines/simplex_spline.h"

namespace veritope {

inline constexpr int kMaxDmsDegree = 9;

/// The numbers (i, j, k, l) >= 0, one for each corner of a tetrahedron.
using TetrahedralIndex = std::array<int, 4>;

/// How many indices have this sum.
inline std::size_t num_tetrahedral_indices(int sum) {
  const auto n = static_cast<std::size_t>(sum);
  return (n + 1) * (n + 2) * (n + 3) / 6;
}
/// The place of (i, j, k, l) among the indices of its sum in descending order: i falls, then j, then k.
inline std::size_t tetrahedral_index(const TetrahedralIndex& index) {
  const auto row = static_cast<std::size_t>(index[1] + index[2] + index[3]),
             rest = static_cast<std::size_t>(index[2] + index[3]),
             last = static_cast<std::size_t>(index[3]);
  return row * (row + 1) * (row + 2) / 6 + rest * (rest + 1) / 2 + last;
}
/// visit(index) for all indices of a sum, in that order.
template <typename Visit>
void for_each_tetrahedral_index(int sum, Visit visit) {
  for (int row = 0; row <= sum; ++row)
    for (int rest = 0; rest <= row; ++rest)
      for (int last = 0; last <= rest; ++last)
        visit(TetrahedralIndex{sum - row, row - rest, rest - last, last});
}
/// The index with the number of corner m higher by one.
inline TetrahedralIndex raised(TetrahedralIndex index, std::size_t m) {
  ++index[m];
  return index;
}

/// The numbers of the knots of a tetrahedron's corners: number[m][i] is that of knot i of corner m. Knots of one corner
/// that are one point may have one number; those of a corner are less than those of the next.
struct DmsKnots {
  std::array<std::array<KnotNumber, kMaxDmsDegree + 1>, 4> number{};

  /// W: knot index[m] of each corner m.
  std::array<KnotNumber, 4> tetrahedron(const TetrahedralIndex& index) const {
    std::array<KnotNumber, 4> knots{};
    for (std::size_t m = 0; m < 4; ++m) knots[m] = number[m][static_cast<std::size_t>(index[m])];
    return knots;
  }
  /// V: the knots 0 to index[m] of each corner m.
  KnotSet up_to(const TetrahedralIndex& index) const {
    KnotSet set;
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t i = 0; i <= static_cast<std::size_t>(index[m]); ++i)
        set.insert(number[m][i]);
    return set;
  }
};

/// The sums over some tetrahedra: one value for each component, and its derivatives along the axes.
template <Ring R>
struct DmsSums {
  explicit DmsSums(std::size_t num_components) : value(num_components), gradient(num_components) {}
  std::vector<R> value;
  std::vector<std::array<R, 3>> gradient;
};

/// visit(γ, frame of W_γ, N_γ(u)) for all γ of the sum whose N_γ is not off its support at u; N_γ = d(W_γ) M(u|V_γ).
/// REQUIRES d(W_γ) != 0, and sum <= kMaxDmsDegree.
template <Ring R, typename Answers, typename Visit>
void for_each_dms_basis(SimplexSplines<R, Answers>& splines, const DmsKnots& knots, int sum,
                        Visit visit) {
  for_each_tetrahedral_index(sum, [&](const TetrahedralIndex& gamma) {
    const KnotSet set = knots.up_to(gamma);
    if (splines.is_off_support(set)) return;
    const auto w = knots.tetrahedron(gamma);
    const SimplexFrame<R>* const frame = splines.frame(KnotSet{w[0], w[1], w[2], w[3]});
    VT_CHECK(frame != nullptr, "the four last knots of a basis function are independent");
    visit(gamma, *frame, R(frame->volume * splines.value(set)));
  });
}

/// Adds the tetrahedron's terms of the form of degree n - 1: N_γ(u) times the sum of λ_m(u|W_γ) c(γ + e_m), |γ| = n -
/// 1. control(β) is the control point of β, a span of as many numbers as `sums` has components.
/// REQUIRES 1 <= n <= kMaxDmsDegree. @source docs/formats/dms-files.md, shared control points
template <Ring R, typename Answers, typename Control>
void add_dms_terms(SimplexSplines<R, Answers>& splines, const DmsKnots& knots, int n,
                   Control control, DmsSums<R>& sums) {
  const R degree = RingNumbers<R>::ratio(n, 1);
  for_each_dms_basis(
      splines, knots, n - 1,
      [&](const TetrahedralIndex& gamma, const SimplexFrame<R>& frame, const R& basis) {
        const std::array<R, 4>& lambda = splines.barycentric(frame);
        for (std::size_t m = 0; m < 4; ++m) {
          const std::span<const R> point = control(raised(gamma, m));
          const R factor = basis * lambda[m];
          if (sums.gradient.empty()) {
            for (std::size_t c = 0; c < sums.value.size(); ++c)
              sums.value[c] = sums.value[c] + factor * point[c];
            continue;
          }
          const R slope = degree * basis;
          std::array<R, 3> along;
          for (std::size_t a = 0; a < 3; ++a) along[a] = slope * frame.lambda[m][a + 1];
          for (std::size_t c = 0; c < sums.value.size(); ++c) {
            sums.value[c] = sums.value[c] + factor * point[c];
            for (std::size_t a = 0; a < 3; ++a)
              sums.gradient[c][a] = sums.gradient[c][a] + along[a] * point[c];
          }
        }
      });
}

/// Adds the tetrahedron's terms of the form of degree n, eq. 6: N_β(u) c(β), |β| = n. Their gradient is by eq. 2.
/// REQUIRES 1 <= n <= kMaxDmsDegree. @source docs/formats/dms-files.md, separate control points
template <Ring R, typename Answers, typename Control>
void add_dms_terms_of_degree_n(SimplexSplines<R, Answers>& splines, const DmsKnots& knots, int n,
                               Control control, DmsSums<R>& sums) {
  for_each_dms_basis(
      splines, knots, n,
      [&](const TetrahedralIndex& beta, const SimplexFrame<R>& frame, const R& basis) {
        const std::span<const R> point = control(beta);
        for (std::size_t c = 0; c < sums.value.size(); ++c)
          sums.value[c] = sums.value[c] + basis * point[c];
        if (sums.gradient.empty()) return;
        std::array<R, 3> slope = splines.gradient(knots.up_to(beta));
        for (R& s : slope) s = s * frame.volume;
        for (std::size_t c = 0; c < sums.value.size(); ++c) {
          for (std::size_t a = 0; a < 3; ++a)
            sums.gradient[c][a] = sums.gradient[c][a] + slope[a] * point[c];
        }
      });
}

}  // namespace veritope
