// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/spline_builder.h"

#include <algorithm>

namespace veritope {
namespace {

Error bad(std::string message) { return Error{Code::kBadSpline, {}, std::move(message)}; }

constexpr const char* kAxisNames[] = {"u", "v", "w"};

template <std::size_t N>
std::string of_axis(std::size_t axis) {
  return N == 1 ? std::string() : std::string("axis ") + kAxisNames[axis] + ": ";
}

// The axis for `stored` control points. If the points repeat but the knots do not, the axis is only unclamped.
Result<KnotAxis<Rational>> build_axis(int degree, std::vector<Rational> knots, bool is_periodic,
                                      std::uint64_t stored) {
  if (degree < 0 || knots.size() != stored + static_cast<std::uint64_t>(degree) + 1)
    return bad(std::to_string(knots.size()) + " knots for " + std::to_string(stored) +
               " control points of degree " + std::to_string(degree));
  if (is_periodic)
    if (auto axis = make_knot_axis(degree, knots, true)) return axis;
  auto axis = make_knot_axis(degree, std::move(knots));
  if (axis) return axis;
  Error error = axis.error();
  if (error.code == Code::kBadArgument) error.code = Code::kBadSpline;
  return error;
}

template <std::size_t N>
Grid<N> grid_of(const std::array<std::uint64_t, N>& counts) {
  Grid<N> grid;
  for (std::size_t a = 0; a < N; ++a) grid.size[a] = static_cast<std::size_t>(counts[a]);
  return grid;
}

// The offset of an index in the file's order: the first axis fastest; indices after the end start again.
template <std::size_t N>
std::size_t file_offset(const std::array<std::size_t, N>& index, const Grid<N>& counts) {
  std::size_t offset = 0;
  for (std::size_t a = N; a-- > 0;) offset = offset * counts.size[a] + index[a] % counts.size[a];
  return offset;
}

template <std::size_t N>
std::optional<Error> check_weights(const RawSpline<N>& raw) {
  if (!raw.is_rational) return std::nullopt;
  const auto step = static_cast<std::size_t>(raw.num_components);
  for (std::size_t i = step - 1; i < raw.points.size(); i += step)
    if (raw.points[i].sign() != Sign::kPositive)
      return bad("the weight of control point " + std::to_string(i / step) + ", " +
                 raw.points[i].to_string() + ", is not positive");
  return std::nullopt;
}

}  // namespace

template <std::size_t N>
Result<BSpline<Rational, N>> build_spline(RawSpline<N> raw) {
  if (auto error = check_weights(raw)) return std::move(*error);
  std::array<KnotAxis<Rational>, N> axes;
  const Grid<N> given = grid_of<N>(raw.num_control);
  Grid<N> stored = given;
  for (std::size_t a = 0; a < N; ++a) {
    if (raw.degrees[a] >= 0 && given.size[a] <= static_cast<std::size_t>(raw.degrees[a]))
      return bad(of_axis<N>(a) + "the order " + std::to_string(raw.degrees[a] + 1) +
                 " is larger than the number of control points, " + std::to_string(given.size[a]));
    if (raw.is_periodic[a]) stored.size[a] += static_cast<std::size_t>(std::max(raw.degrees[a], 0));
    auto axis =
        build_axis(raw.degrees[a], std::move(raw.knots[a]), raw.is_periodic[a], stored.size[a]);
    if (!axis) {
      Error error = axis.error();
      error.message.insert(0, of_axis<N>(a));
      return error;
    }
    axes[a] = std::move(*axis);
  }
  const auto components = static_cast<std::size_t>(raw.num_components);
  const bool is_repeated = stored.size != given.size;
  std::vector<Rational> coefficients(stored.count() * components);
  for (std::size_t i = 0; i < stored.count(); ++i) {
    std::array<std::size_t, N> index;
    std::size_t rest = i;
    for (std::size_t a = N; a-- > 0; rest /= stored.size[a]) index[a] = rest % stored.size[a];
    const std::size_t from = file_offset(index, given) * components;
    for (std::size_t c = 0; c < components; ++c)
      coefficients[c * stored.count() + i] =
          is_repeated ? raw.points[from + c] : std::move(raw.points[from + c]);
  }
  return BSpline<Rational, N>(std::move(axes), raw.num_components, raw.is_rational,
                              std::move(coefficients));
}

std::vector<Rational> bezier_knots(int degree) {
  const auto n = static_cast<std::size_t>(degree) + 1;
  std::vector<Rational> knots(2 * n);
  std::fill(knots.begin() + static_cast<std::ptrdiff_t>(n), knots.end(), Rational(1));
  return knots;
}

template Result<BSpline<Rational, 1>> build_spline(RawSpline<1>);
template Result<BSpline<Rational, 2>> build_spline(RawSpline<2>);
template Result<BSpline<Rational, 3>> build_spline(RawSpline<3>);

}  // namespace veritope
