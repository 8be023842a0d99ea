// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/half_spaces.h"

#include <algorithm>
#include <cmath>

#include "solids/pieces/exact_piece.h"
#include "verify/certify/sheet_tangents_internal.h"

namespace veritope {
namespace {
// Whether for_each_kept visits all coefficients, in the order in which they are stored.
bool has_all_in_order(const PieceForest::Form& form) {
  return form.collapsed == 0 && !form.shape.is_triangle;
}
}  // namespace

bool append_half_spaces(PieceForest& forest, PieceForest::Id id, const CentreCoordinates& in,
                        std::size_t most, std::vector<HalfSpace>* out) {
  const PieceForest::Node& node = forest.node(id);
  const PieceForest::Form& form = forest.form(node.patch);
  const std::size_t n = form.determinant.count(), step = 1 + (n - 1) / most;
  const double* const g = forest.approx_determinants(id);
  const Point3d& m = in.middle;
  double error = 0;
  for (std::size_t k = 1; k < 4; ++k) error += forest.determinant_error(id, k);
  // a.(c - m) + b > 0.
  const auto add = [&](Point3d a, double b) {
    for (std::size_t k = 0; k < 3; ++k) a[k] *= in.scale[k];
    const double length = internal::length_of(a);
    if (!(length > 0)) {
      out->push_back({{0, 0, 0}, -1});
      return;
    }
    const double factor = 1 / length;
    out->push_back({{a[0] * factor, a[1] * factor, a[2] * factor}, b * factor});
  };
  const auto add_one = [&](std::size_t i) {
    const Point3d a{g[n + i], g[2 * n + i], g[3 * n + i]};
    // A normal shorter than its error has no meaningful direction.
    if (std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]) <= error)
      if (const ExactPiece* const exact = forest.exact_determinants(id)) {
        const std::array<double, 4> h = exact->approx_half_space(i, m);
        return add({h[0], h[1], h[2]}, h[3]);
      }
    double b = g[i];
    for (std::size_t k = 0; k < 3; ++k) b += a[k] * (m[k] - form.origin[k]);
    add(a, b);
  };
  std::size_t left = 0;
  if (has_all_in_order(form))
    for (std::size_t i = 0; i < n; i += step) add_one(i);
  else
    forest.for_each_kept(node, [&](std::size_t i) {
      if (left-- != 0) return;
      left = step - 1;
      add_one(i);
    });
  return step == 1;
}

void append_half_spaces_in_steps(PieceForest& forest, PieceForest::Id id, const CentreSteps& in,
                                 std::size_t most, std::vector<HalfSpace>* out) {
  const PieceForest::Node& node = forest.node(id);
  const PieceForest::Form& form = forest.form(node.patch);
  const std::size_t n = form.determinant.count(), step = 1 + (n - 1) / most;
  const double* const g = forest.approx_determinants(id);
  double error = 0;
  for (std::size_t k = 1; k < 4; ++k) error += forest.determinant_error(id, k);
  Point3d x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = in.middle[k] - form.origin[k];
  const Point3d &s0 = in.steps[0], &s1 = in.steps[1], &s2 = in.steps[2];
  // Conditions side by side: the compiler makes vectors of them.
  constexpr std::size_t kBlock = 8;
  double a0[kBlock], a1[kBlock], a2[kBlock], b[kBlock], square[kBlock], size[kBlock];
  const auto fill = [&](std::size_t first, std::size_t stride, std::size_t count) {
    for (std::size_t j = 0; j < count; ++j) {
      const double* const at = g + first + j * stride;
      const double u = at[n], v = at[2 * n], w = at[3 * n];
      a0[j] = u * s0[0] + v * s0[1] + w * s0[2];
      a1[j] = u * s1[0] + v * s1[1] + w * s1[2];
      a2[j] = u * s2[0] + v * s2[1] + w * s2[2];
      b[j] = at[0] + u * x[0] + v * x[1] + w * x[2];
      square[j] = a0[j] * a0[j] + a1[j] * a1[j] + a2[j] * a2[j];
      size[j] = std::abs(u) + std::abs(v) + std::abs(w);
    }
  };
  const auto add = [&](std::size_t j) {
    if (size[j] <= error) return;
    const double length = internal::length_of({a0[j], a1[j], a2[j]}, square[j]);
    if (!(length > 0)) return out->push_back({{0, 0, 0}, -1});
    const double factor = 1 / length;
    out->push_back({{a0[j] * factor, a1[j] * factor, a2[j] * factor}, b[j] * factor});
  };
  if (has_all_in_order(form)) {
    for (std::size_t first = 0; first < n; first += kBlock * step) {
      const std::size_t count = std::min(kBlock, 1 + (n - 1 - first) / step);
      if (step == 1 && count == kBlock)
        fill(first, 1, kBlock);
      else
        fill(first, step, count);
      for (std::size_t j = 0; j < count; ++j) add(j);
    }
    return;
  }
  forest.for_each_kept(node, [&](std::size_t i) {
    if (i % step != 0) return;
    fill(i, 1, 1);
    add(0);
  });
}

}  // namespace veritope
