// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/volumes/cell_maps.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "splines/bspline_degree.h"
#include "splines/bspline_derivative.h"
#include "splines/bspline_domain.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace internal {

KnotAxis<Rational> common_axis(const std::vector<KnotAxis<Rational>>& axes) {
  int degree = 0;
  for (const auto& axis : axes) degree = std::max(degree, axis.degree);
  const Rational &begin = axes[0].domain_begin(), &end = axes[0].domain_end();
  std::map<Rational, int> times{{begin, degree + 1}, {end, degree + 1}};
  for (const auto& axis : axes) {
    const Rational factor = (end - begin) / (axis.domain_end() - axis.domain_begin());
    for (const Rational& u : breaks_of(axis)) {
      int& most = times[begin + (u - axis.domain_begin()) * factor];
      most = std::max(most, multiplicity(axis, u) + degree - axis.degree);
    }
  }
  KnotAxis<Rational> out{degree, {}, false};
  for (const auto& [u, count] : times)
    out.knots.insert(out.knots.end(), static_cast<std::size_t>(std::min(count, degree + 1)), u);
  return out;
}

template <std::size_t N>
BSpline<Rational, N> brought_to(BSpline<Rational, N> map, std::size_t axis,
                                const KnotAxis<Rational>& target) {
  map = with_domain(clamped(map, axis), axis, target.domain_begin(), target.domain_end()).value();
  map = elevate(std::move(map), axis, target.degree - map.axis(axis).degree);
  const auto& knots = map.axis(axis).knots;
  std::vector<Rational> missing;
  std::set_difference(target.knots.begin(), target.knots.end(), knots.begin(), knots.end(),
                      std::back_inserter(missing));
  return refine(map, axis, missing);
}

Status check_degree(int degree) {
  if (degree <= kMaxCellDegree) return ok_status();
  return Error{Code::kOverLimit,
               {},
               "a degree of " + std::to_string(degree) + " is over the limit of cells, " +
                   std::to_string(kMaxCellDegree)};
}

std::vector<Rational> rising(const KnotAxis<Rational>& axis) {
  const Rational length = axis.domain_end() - axis.domain_begin();
  std::vector<Rational> out;
  for (std::size_t i = 0; i < axis.num_control(); ++i) {
    Rational sum;
    for (int k = 1; k <= axis.degree; ++k) sum += axis.knots[i + static_cast<std::size_t>(k)];
    out.push_back((sum / Rational(axis.degree) - axis.domain_begin()) / length);
  }
  return out;
}

template <std::size_t N>
std::optional<Rational> factor_between(const BSpline<Rational, N>& a,
                                       const BSpline<Rational, N>& b) {
  if (!a.is_rational()) return a == b ? std::optional(Rational(1)) : std::nullopt;
  const Rational factor = a.component(a.dimension())[0] / b.component(b.dimension())[0];
  for (std::size_t i = 0; i < a.coefficients().size(); ++i)
    if (a.coefficients()[i] != factor * b.coefficients()[i]) return std::nullopt;
  return factor;
}

}  // namespace internal

namespace {

Rational determinant4(const std::array<std::vector<Rational>, 4>& m) {
  const auto minor2 = [&](std::size_t r, std::size_t i, std::size_t j) {
    return m[r][i] * m[r + 1][j] - m[r][j] * m[r + 1][i];
  };
  return minor2(0, 0, 1) * minor2(2, 2, 3) - minor2(0, 0, 2) * minor2(2, 1, 3) +
         minor2(0, 0, 3) * minor2(2, 1, 2) + minor2(0, 1, 2) * minor2(2, 0, 3) -
         minor2(0, 1, 3) * minor2(2, 0, 2) + minor2(0, 2, 3) * minor2(2, 0, 1);
}

}  // namespace

template <std::size_t N>
BSpline<Rational, N> homogeneous(const BSpline<Rational, N>& map) {
  if (map.is_rational()) return map;
  std::vector<Rational> all(map.coefficients().begin(), map.coefficients().end());
  all.insert(all.end(), map.grid().count(), Rational(1));
  return {map.axes(), map.num_components() + 1, true, std::move(all)};
}

template <std::size_t N>
Result<std::vector<BSpline<Rational, N>>> in_one_space(std::vector<BSpline<Rational, N>> maps,
                                                       std::size_t most) {
  bool is_rational = false;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    is_rational |= maps[i].is_rational();
    if (maps[i].dimension() != maps[0].dimension())
      return bad_argument("map " + std::to_string(i) + " has " +
                          std::to_string(maps[i].dimension()) + " coordinates, the first has " +
                          std::to_string(maps[0].dimension()));
  }
  std::array<KnotAxis<Rational>, N> axes;
  Grid<N> grid;
  for (std::size_t a = 0; a < N; ++a) {
    std::vector<KnotAxis<Rational>> all;
    for (const auto& map : maps) all.push_back(map.axis(a));
    axes[a] = internal::common_axis(all);
    if (const Status fits = internal::check_degree(axes[a].degree); !fits) return fits.error();
    grid.size[a] = axes[a].num_control();
  }
  const auto components = static_cast<std::size_t>(maps[0].dimension()) + (is_rational ? 1 : 0);
  if (!grid.count_up_to(most / components))
    return Error{
        Code::kOverLimit,
        {},
        "the common knots of the maps need more than " + std::to_string(most) + " coefficients"};
  for (auto& map : maps) {
    if (is_rational) map = homogeneous(map);
    for (std::size_t a = 0; a < N; ++a) map = internal::brought_to(std::move(map), a, axes[a]);
  }
  return maps;
}

namespace {

template <std::size_t N>
Status check_in_space(const BSpline<Rational, N>& map, const std::string& kind) {
  if (map.dimension() < 3)
    return bad_argument("a " + kind + " with " + std::to_string(map.dimension()) +
                        " coordinates is not in space");
  for (const auto& axis : map.axes())
    if (const Status fits = internal::check_degree(axis.degree); !fits) return fits.error();
  return ok_status();
}

}  // namespace

Status check_cell_surface(const CellSurface& surface) { return check_in_space(surface, "surface"); }
Status check_cell_volume(const CellVolume& volume) { return check_in_space(volume, "volume"); }

CellVolume stacked(std::span<const CellSurface> rows, KnotAxis<Rational> axis) {
  const std::size_t count = rows[0].coefficients().size(), depth = rows.size();
  VT_CHECK(axis.num_control() == depth, "as many rows as the axis has control points");
  std::vector<Rational> all(count * depth);
  for (std::size_t k = 0; k < depth; ++k) {
    VT_CHECK(rows[k].axes() == rows[0].axes() && rows[k].coefficients().size() == count,
             "rows of one volume lie in one space");
    for (std::size_t i = 0; i < count; ++i) all[i * depth + k] = rows[k].coefficients()[i];
  }
  return CellVolume({rows[0].axis(0), rows[0].axis(1), std::move(axis)}, rows[0].num_components(),
                    rows[0].is_rational(), std::move(all));
}

KnotAxis<Rational> unit_axis(int degree) {
  KnotAxis<Rational> axis{degree, {}, false};
  const auto order = static_cast<std::size_t>(degree) + 1;
  axis.knots.assign(order, Rational(0));
  axis.knots.insert(axis.knots.end(), order, Rational(1));
  return axis;
}

Result<CellVolume> with_positive_weights(CellVolume volume) {
  if (!volume.is_rational()) return volume;
  const auto weights = volume.component(volume.dimension());
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i].sign() != Sign::kPositive) {
      const auto at = volume.grid().index_of(i);
      return bad_argument("the weight of control point (" + std::to_string(at[0]) + ", " +
                          std::to_string(at[1]) + ", " + std::to_string(at[2]) + ") would be " +
                          weights[i].to_string() + ", which is not positive");
    }
  return volume;
}

template <std::size_t N>
requires(N > 1) BSpline<Rational, N - 1> side_of(const BSpline<Rational, N>& map, std::size_t axis,
                                                 std::size_t end) {
  const std::size_t at = end == 0 ? 0 : map.axis(axis).num_control() - 1;
  return {internal::without_axis(map.axes(), axis), map.num_components(), map.is_rational(),
          internal::map_lines(map, axis, 1, [at](auto from, auto to) { to[0] = from[at]; })};
}

Sign hand_in_the_middle(const CellVolume& volume) {
  const CellVolume h = homogeneous(volume);
  const std::size_t count = h.grid().count();
  std::vector<Rational> four;  // three coordinates and the weight, as a polynomial map
  for (const int c : {0, 1, 2, h.dimension()})
    four.insert(four.end(), h.component(c).begin(), h.component(c).end());
  VT_CHECK(four.size() == 4 * count, "a map in space has four homogeneous components");
  const CellVolume f(h.axes(), 4, false, std::move(four));
  std::array<Rational, 3> middle;
  for (std::size_t a = 0; a < 3; ++a)
    middle[a] = (f.axis(a).domain_begin() + f.axis(a).domain_end()) / Rational(2);
  std::array<std::vector<Rational>, 4> rows{evaluate(f, middle).value()};
  for (std::size_t a = 0; a < 3; ++a) rows[a + 1] = evaluate(derivative(f, a), middle).value();
  return (-determinant4(rows)).sign();
}

template BSpline<Rational, 1> homogeneous(const BSpline<Rational, 1>&);
template BSpline<Rational, 2> homogeneous(const BSpline<Rational, 2>&);
template BSpline<Rational, 3> homogeneous(const BSpline<Rational, 3>&);
template Result<std::vector<CellCurve>> in_one_space(std::vector<CellCurve>, std::size_t);
template Result<std::vector<CellSurface>> in_one_space(std::vector<CellSurface>, std::size_t);
namespace internal {
template CellCurve brought_to(CellCurve, std::size_t, const KnotAxis<Rational>&);
template CellSurface brought_to(CellSurface, std::size_t, const KnotAxis<Rational>&);
template std::optional<Rational> factor_between(const CellCurve&, const CellCurve&);
template std::optional<Rational> factor_between(const CellSurface&, const CellSurface&);
}  // namespace internal
template BSpline<Rational, 1> side_of(const BSpline<Rational, 2>&, std::size_t, std::size_t);
template BSpline<Rational, 2> side_of(const BSpline<Rational, 3>&, std::size_t, std::size_t);

}  // namespace veritope
