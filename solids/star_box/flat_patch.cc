// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/flat_patch.h"

#include <algorithm>
#include <array>

#include "solids/pieces/surface_form.h"

namespace veritope {
namespace {

using Vec = std::array<Rational, 3>;

Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool is_zero(const Rational& a) { return a.sign() == Sign::kZero; }
bool is_zero(const Vec& a) {
  return std::all_of(a.begin(), a.end(), [](const Rational& x) { return is_zero(x); });
}

Vec point(const Patch& patch, std::size_t at) {
  return {patch.component(0)[at], patch.component(1)[at], patch.component(2)[at]};
}

// Each corner is strictly to the left of the line through any two successive others.
bool is_strictly_convex(const std::vector<Vec>& corners, const Vec& normal) {
  for (std::size_t i = 0, n = corners.size(); i < n; ++i)
    for (std::size_t j = 2; j < n; ++j) {
      const Vec along = minus(corners[(i + 1) % n], corners[i]);
      const Vec to = minus(corners[(i + j) % n], corners[i]);
      if (dot(cross(along, to), normal).sign() != Sign::kPositive) return false;
    }
  return true;
}

bool lies_in_plane(const Patch& patch, const Vec& origin, const Vec& normal) {
  for (std::size_t i = 0; i < patch.num_control(); ++i)
    if (!is_zero(dot(minus(point(patch, i), origin), normal))) return false;
  return true;
}
bool has_straight_sides(const Patch& patch) {
  for (std::uint32_t e = 0; e < patch.num_sides(); ++e) {
    const std::size_t n = patch.side_length(e);
    const Vec from = point(patch, patch.side_index(e, 0));
    const Vec along = minus(point(patch, patch.side_index(e, n - 1)), from);
    for (std::size_t k = 1; k + 1 < n; ++k)
      if (!is_zero(cross(minus(point(patch, patch.side_index(e, k)), from), along))) return false;
  }
  return true;
}

FormShape shape_of(const Patch& patch) {
  if (patch.is_triangle()) return {true, patch.triangle().degree(), 0};
  return {false, patch.tensor().degree(0), patch.tensor().degree(1)};
}

// No Bernstein coefficient of the normal times n0 is negative, and one is positive. Its product form has the
// coefficients times positive binomials.
bool is_turned_to(const Patch& patch, const Vec& n0) {
  using Form = internal::ScaledForm<Rational>;
  const FormShape shape = shape_of(patch);
  std::vector<Form> u, v;
  for (int k = 0; k < 3; ++k) {
    u.push_back(internal::derivative_form(shape, patch.component(k).data(), 0));
    v.push_back(internal::derivative_form(shape, patch.component(k).data(), 1));
  }
  const FormShape product = u[0].shape().is_triangle
                                ? FormShape{true, 2 * shape.p - 2, 0}
                                : FormShape{false, 2 * shape.p - 1, 2 * shape.q - 1};
  Form sum(product);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    Form normal = u[i] * v[j];
    normal -= u[j] * v[i];
    sum += Form::from_bernstein({shape.is_triangle, 0, 0}, &n0[k]) * normal;
  }
  bool has_negative = false, has_positive = false;
  sum.visit([&](int a, int b, std::size_t) {
    const Sign s = sum.at(a, b).sign();
    has_negative = has_negative || s == Sign::kNegative;
    has_positive = has_positive || s == Sign::kPositive;
  });
  return has_positive && !has_negative;
}

}  // namespace

bool is_flat_patch(const Patch& patch) {
  if (patch.is_rational()) return false;
  std::vector<Vec> corners;
  for (std::uint32_t c = 0; c < patch.num_sides(); ++c)
    corners.push_back(point(patch, patch.side_index(c, 0)));
  const Vec n0 = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
  return lies_in_plane(patch, corners[0], n0) && is_strictly_convex(corners, n0) &&
         has_straight_sides(patch) && is_turned_to(patch, n0);
}

bool FlatPatches::contain(std::uint32_t patch) {
  const Patch& one = complex_->patch(patch);
  if (one.is_flat_triangle() && !one.is_rational()) return true;
  if (kind_ == Kind::kTriangles) return false;
  known_.resize(complex_->patches().size());
  if (!known_[patch]) known_[patch] = is_flat_patch(one);
  return *known_[patch];
}

}  // namespace veritope
