// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/bspline_make.h"

#include <string>
#include <utility>

#include "splines/lines.h"

namespace veritope {
namespace {

template <std::size_t N>
std::string control_point(const Grid<N>& grid, std::size_t offset) {
  std::string text;
  for (const std::size_t i : grid.index_of(offset))
    text += (text.empty() ? "" : ", ") + std::to_string(i);
  return "control point (" + text + ")";
}

template <std::size_t N>
Status check_count(const Grid<N>& grid, int num_components, bool is_rational, std::size_t count) {
  const int least = is_rational ? 2 : 1;
  if (num_components < least)
    return bad_argument(std::to_string(num_components) + " components are too few for a " +
                        (is_rational ? "rational" : "polynomial") + " map, which has at least " +
                        std::to_string(least));
  const auto components = static_cast<std::size_t>(num_components);
  const auto points = grid.count_up_to(count / components);
  if (points && *points * components == count) return ok_status();
  std::string sizes;
  for (const std::size_t s : grid.size) sizes += (sizes.empty() ? "" : " x ") + std::to_string(s);
  return bad_argument(std::to_string(count) + " coefficients for " + sizes + " control points of " +
                      std::to_string(num_components) + " components");
}

template <std::size_t N>
Status check_weights(const BSpline<Rational, N>& map) {
  if (!map.is_rational()) return ok_status();
  const auto weights = map.component(map.dimension());
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i].sign() != Sign::kPositive)
      return bad_argument(control_point(map.grid(), i) + ": the weight " + weights[i].to_string() +
                          " is not positive");
  return ok_status();
}

template <std::size_t N>
Status check_seam(const BSpline<Rational, N>& map, std::size_t axis) {
  const Grid<N> grid = map.grid();
  const auto p = static_cast<std::size_t>(map.axis(axis).degree);
  const std::size_t across = (grid.size[axis] - p) * grid.stride(axis);  // one period
  Status status = ok_status();
  for (int c = 0; c < map.num_components(); ++c) {
    const auto values = map.component(c);
    grid.for_each_line(axis, [&](std::size_t first) {
      for (std::size_t i = 0; status && i < p; ++i) {
        const std::size_t at = first + i * grid.stride(axis), repeated = at + across;
        if (values[at] != values[repeated])
          status = bad_argument("axis " + std::to_string(axis) + " is periodic, but " +
                                control_point(grid, repeated) + " has the component " +
                                std::to_string(c) + " " + values[repeated].to_string() +
                                " where that of the first period, " + control_point(grid, at) +
                                ", has " + values[at].to_string());
      }
    });
  }
  return status;
}

}  // namespace

template <std::size_t N>
Result<BSpline<Rational, N>> make_bspline(std::array<KnotAxis<Rational>, N> axes,
                                          int num_components, bool is_rational,
                                          std::vector<Rational> coefficients) {
  Grid<N> grid;
  for (std::size_t a = 0; a < N; ++a) {
    auto axis = make_knot_axis(axes[a].degree, std::move(axes[a].knots), axes[a].is_periodic);
    if (!axis) {
      Error error = axis.error();
      error.message = "axis " + std::to_string(a) + ": " + error.message;
      return error;
    }
    axes[a] = std::move(axis).value();
    grid.size[a] = axes[a].num_control();
  }
  if (const Status ok = check_count(grid, num_components, is_rational, coefficients.size()); !ok)
    return ok.error();
  BSpline<Rational, N> map(std::move(axes), num_components, is_rational, std::move(coefficients));
  if (const Status ok = check_weights(map); !ok) return ok.error();
  for (std::size_t a = 0; a < N; ++a) {
    if (!map.axis(a).is_periodic) continue;
    if (const Status ok = check_seam(map, a); !ok) return ok.error();
  }
  return map;
}

template Result<BSpline<Rational, 1>> make_bspline(std::array<KnotAxis<Rational>, 1>, int, bool,
                                                   std::vector<Rational>);
template Result<BSpline<Rational, 2>> make_bspline(std::array<KnotAxis<Rational>, 2>, int, bool,
                                                   std::vector<Rational>);
template Result<BSpline<Rational, 3>> make_bspline(std::array<KnotAxis<Rational>, 3>, int, bool,
                                                   std::vector<Rational>);

}  // namespace veritope
