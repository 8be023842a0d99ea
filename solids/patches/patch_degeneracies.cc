// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_degeneracies.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "solids/patches/common_roots.h"
#include "solids/patches/patch_sides.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_domain.h"
#include "splines/bezier_triangle_algebra.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

constexpr std::size_t kMostExamined = 50'000;  // patches

using Kind = PatchDegeneracy::Kind;
using Row = std::array<Rational, 4>;

bool has_positive_weights(const Patch& patch) {
  if (!patch.is_rational()) return true;
  const auto weights = patch.component(3);
  return std::all_of(weights.begin(), weights.end(),
                     [](const Rational& w) { return w.sign() == Sign::kPositive; });
}

bool is_point(const Patch& patch) {
  const auto all = patch.coefficients();
  const int width = patch.is_rational() ? 4 : 3;
  return is_collapsed(Patch::Curve({static_cast<int>(patch.num_control()) - 1}, width,
                                   patch.is_rational(), {all.begin(), all.end()}));
}

// The homogeneous point with the weight last; `weight` is that of a polynomial map or of its derivatives.
Row row_of(const std::vector<Rational>& values, int weight) {
  Row out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = values[c];
  out[3] = values.size() == 4 ? values[3] : Rational(weight);
  return out;
}

Rational determinant(const std::array<Row, 3>& m, const std::array<std::size_t, 3>& columns) {
  const auto [i, j, k] = columns;
  return m[0][i] * (m[1][j] * m[2][k] - m[1][k] * m[2][j]) -
         m[0][j] * (m[1][i] * m[2][k] - m[1][k] * m[2][i]) +
         m[0][k] * (m[1][i] * m[2][j] - m[1][j] * m[2][i]);
}
// Whether the point and its two derivatives span a plane's worth of directions: then the normal is not zero there.
bool has_rank_three(const std::array<Row, 3>& m) {
  constexpr std::array<std::array<std::size_t, 3>, 4> kColumns = {
      {{0, 1, 3}, {0, 2, 3}, {1, 2, 3}, {0, 1, 2}}};
  return std::any_of(kColumns.begin(), kColumns.end(), [&](const auto& columns) {
    return determinant(m, columns).sign() != Sign::kZero;
  });
}

// The minors have at most three times the degrees of the map: they are zero if they are so on this grid.
bool has_no_normal(const Patch::Tensor& map) {
  const Patch::Tensor along_u = derivative(map, 0), along_v = derivative(map, 1);
  const int nu = 3 * map.degree(0) + 1, nv = 3 * map.degree(1) + 1;
  for (int i = 1; i <= nu; ++i)
    for (int j = 1; j <= nv; ++j) {
      const std::array<Rational, 2> at{Rational(i) / Rational(nu + 1),
                                       Rational(j) / Rational(nv + 1)};
      if (has_rank_three({row_of(evaluate(map, at), 1), row_of(evaluate(along_u, at), 0),
                          row_of(evaluate(along_v, at), 0)}))
        return false;
    }
  return true;
}

// All components as polynomials: derivatives are then those of the homogeneous map.
Patch::Tensor homogeneous(const Patch::Tensor& map) {
  const auto all = map.coefficients();
  return {map.degrees(), map.num_components(), false, {all.begin(), all.end()}};
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  if (a.empty() || b.empty()) return {};
  Polynomial out(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) out[i + j] += a[i] * b[j];
  return out;
}
Polynomial difference(Polynomial a, const Polynomial& b) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] -= b[i];
  while (!a.empty() && a.back().sign() == Sign::kZero) a.pop_back();
  return a;
}

// The control points of the line that fixes `axis`, as functions of the value at which it is fixed: for each the
// components, with the weight 1 for a polynomial map.
std::vector<std::array<Polynomial, 4>> moving_points(const Patch::Tensor& map, std::size_t axis) {
  const auto n = static_cast<std::size_t>(map.degree(axis)) + 1;
  const auto others = static_cast<std::size_t>(map.degree(1 - axis)) + 1;
  std::vector<std::array<Polynomial, 4>> out(others);
  for (std::size_t k = 0; k < others; ++k) {
    out[k][3] = {Rational(1)};
    for (int c = 0; c < map.num_components(); ++c) {
      std::vector<Rational> bernstein;
      for (std::size_t i = 0; i < n; ++i)
        bernstein.push_back(map.component(c)[axis == 0 ? i * others + k : k * n + i]);
      out[k][static_cast<std::size_t>(c)] = polynomial_of(bernstein);
    }
  }
  return out;
}

// A value strictly inside (0, 1) at which all points of the line are one. All weights are positive.
std::optional<std::array<Rational, 2>> singular_value(const Patch::Tensor& map, std::size_t axis) {
  const auto points = moving_points(map, axis);
  std::vector<Polynomial> distances;
  for (std::size_t k = 1; k < points.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      distances.push_back(
          difference(product(points[k][c], points[0][3]), product(points[0][c], points[k][3])));
  if (distances.empty()) return std::nullopt;
  for (const auto& root : common_roots(distances).roots)
    if (Rational(0) < root[1] && root[0] < Rational(1)) return root;
  return std::nullopt;
}

std::optional<PatchDegeneracy> degeneracy_of(const Patch& patch) {
  PatchDegeneracy out;
  if (is_point(patch)) return out;
  const std::size_t lines = patch.is_triangle() ? 3 : 2;
  for (std::size_t k = 0; k < lines; ++k) {
    // Corner k of a triangle becomes the collapsed end of axis 0.
    const Patch::Tensor map =
        patch.is_triangle()
            ? as_tensor_product(turned(patch, static_cast<std::uint32_t>(k)).triangle())
            : patch.tensor();
    if (k == 0 && has_no_normal(homogeneous(map))) {
      out.kind = Kind::kCurve;
      return out;
    }
    const auto value = singular_value(map, patch.is_triangle() ? 0 : k);
    if (!value) continue;
    out.kind = Kind::kSingularLine;
    out.axis = k;
    out.at = *value;
    if (patch.is_triangle()) out.at = {Rational(1) - (*value)[1], Rational(1) - (*value)[0]};
    return out;
  }
  return std::nullopt;
}

}  // namespace

std::vector<PatchDegeneracy> find_degeneracies(std::span<const Patch> patches) {
  std::vector<PatchDegeneracy> out;
  const std::size_t end = std::min(patches.size(), kMostExamined);
  for (std::uint32_t p = 0; p < end; ++p) {
    if (patches[p].max_degree() > kMaxPatchDegree || !has_positive_weights(patches[p])) continue;
    if (auto found = degeneracy_of(patches[p])) {
      found->patch = p;
      out.push_back(std::move(*found));
    }
  }
  return out;
}

}  // namespace veritope
