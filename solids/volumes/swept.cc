// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/volumes/swept.h"

#include <algorithm>
#include <string>
#include <utility>

#include "splines/de_boor.h"

namespace veritope {
namespace {

// [PT97] (9.8).
KnotAxis<Rational> axis_of_means(std::span<const Rational> parameters, int degree) {
  const auto p = static_cast<std::size_t>(degree);
  KnotAxis<Rational> axis{degree, {}, false};
  axis.knots.assign(p + 1, parameters.front());
  for (std::size_t j = 1; j + p < parameters.size(); ++j) {
    Rational sum;
    for (std::size_t i = j; i < j + p; ++i) sum += parameters[i];
    axis.knots.push_back(sum / Rational(degree));
  }
  axis.knots.insert(axis.knots.end(), p + 1, parameters.back());
  return axis;
}

using Matrix = std::vector<std::vector<Rational>>;

Matrix collocation(const KnotAxis<Rational>& axis, std::span<const Rational> parameters) {
  Matrix rows;
  for (const Rational& w : parameters) {
    const std::size_t span = internal::find_span(axis, w);
    const std::vector<Rational> values = internal::basis_values(axis, span, w);
    auto& row = rows.emplace_back(axis.num_control());
    std::copy(
        values.begin(), values.end(),
        row.begin() + static_cast<std::ptrdiff_t>(span - static_cast<std::size_t>(axis.degree)));
  }
  return rows;
}

// Solves matrix * x = rows in place. The matrix is totally positive and, as each parameter lies inside of its basis
// function's support, not singular: elimination needs no exchange of rows ([dB01] XIII).
void solve(Matrix matrix, std::vector<CellSurface>& rows) {
  const std::size_t n = matrix.size();
  const auto subtract = [&](std::size_t to, std::size_t from, const Rational& factor) {
    const auto source = std::as_const(rows[from]).coefficients();
    const auto target = rows[to].coefficients();
    for (std::size_t i = 0; i < target.size(); ++i) target[i] -= factor * source[i];
  };
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n && matrix[i][k].sign() != Sign::kZero; ++i) {
      const Rational factor = matrix[i][k] / matrix[k][k];
      for (std::size_t j = k; j < n; ++j)
        if (matrix[k][j].sign() != Sign::kZero) matrix[i][j] -= factor * matrix[k][j];
      subtract(i, k, factor);
    }
  for (std::size_t k = n; k-- > 0;) {
    const Rational inverse = Rational(1) / matrix[k][k];
    for (Rational& x : rows[k].coefficients()) x *= inverse;
    for (std::size_t i = 0; i < k; ++i)
      if (matrix[i][k].sign() != Sign::kZero) subtract(i, k, matrix[i][k]);
  }
}

std::uint64_t bits_of(const Rational& x) {
  return x.numerator().bit_length() + x.denominator().bit_length();
}

// The sum of the longest numbers of the rows, and those of the matrix: determinants of it have as many bits as all its
// rows, `degree` + 1 factors each.
Status check_interpolation(const std::vector<CellSurface>& sections,
                           std::span<const Rational> parameters, int degree) {
  if (sections.size() > kMaxInterpolatedSections)
    return Error{Code::kOverLimit,
                 {},
                 "sections to interpolate must be at most " +
                     std::to_string(kMaxInterpolatedSections) + ", not " +
                     std::to_string(sections.size())};
  std::uint64_t longest = 0, sum = 0;
  for (const Rational& w : parameters) longest = std::max(longest, bits_of(w));
  for (const CellSurface& s : sections) {
    std::uint64_t most = 0;
    for (const Rational& x : s.coefficients()) most = std::max(most, bits_of(x));
    sum += most + longest * static_cast<std::uint64_t>(degree + 1);
  }
  if (sum <= kMaxInterpolatedBits) return ok_status();
  return Error{Code::kOverLimit, {}, "sections have numbers that are too long to be interpolated"};
}

Status check_parameters(std::size_t sections, std::span<const Rational> parameters, int degree) {
  if (degree < 1) return bad_argument("degree must be at least 1, not " + std::to_string(degree));
  if (const Status fits = internal::check_degree(degree); !fits) return fits;
  if (sections < static_cast<std::size_t>(degree) + 1)
    return bad_argument("sections of a sweep of degree " + std::to_string(degree) +
                        " must be at least " + std::to_string(degree + 1) + ", not " +
                        std::to_string(sections));
  if (parameters.size() != sections)
    return bad_argument("parameters must be as many as the sections, " + std::to_string(sections) +
                        ", not " + std::to_string(parameters.size()));
  for (std::size_t i = 1; i < sections; ++i)
    if (!(parameters[i - 1] < parameters[i]))
      return bad_argument("parameters do not increase: " + parameters[i].to_string() + " follows " +
                          parameters[i - 1].to_string());
  return ok_status();
}

}  // namespace

Result<CellVolume> swept(std::vector<CellSurface> sections, std::span<const Rational> parameters,
                         int degree, SweepMode mode) {
  if (const Status fits = check_parameters(sections.size(), parameters, degree); !fits)
    return fits.error();
  for (const CellSurface& s : sections)
    if (const Status in = check_cell_surface(s); !in) return in.error();
  if (mode == SweepMode::kInterpolate)
    if (const Status fits = check_interpolation(sections, parameters, degree); !fits)
      return fits.error();
  const std::size_t most = kMaxCellNumbers / sections.size();
  auto rows = in_one_space<2>(std::move(sections), most);
  if (!rows) return rows.error();
  const KnotAxis<Rational> axis = axis_of_means(parameters, degree);
  if (mode == SweepMode::kInterpolate) solve(collocation(axis, parameters), *rows);
  return with_positive_weights(stacked(*rows, axis));
}

}  // namespace veritope
