// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/spline_json_maps.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace veritope {

bool SplineJsonMaps::read_points(RawNet& raw) {
  return read_list([&] {
    const std::size_t before = raw.points.size();
    if (!read_list([&] { return read_exact(raw.points.emplace_back()); })) return false;
    const std::size_t numbers = raw.points.size() - before;
    if (raw.num_points++ == 0) raw.per_point = numbers;
    raw.is_even = raw.is_even && numbers == raw.per_point;
    return true;
  });
}

bool SplineJsonMaps::check_components(const RawNet& raw) {
  const std::int64_t least = raw.is_rational ? 2 : 1;
  const auto components = static_cast<std::uint64_t>(raw.components);
  const bool fits = raw.num_points == 0 || (raw.is_even && raw.per_point == components);
  if (raw.components >= least && raw.components <= 1001 && fits) return true;
  return fail(raw.at, Code::kBadSpline,
              "every point must have as many numbers as there are components, " +
                  std::to_string(raw.components));
}

// Component by component. REQUIRES check_components(raw); leaves it without points.
std::vector<Rational> SplineJsonMaps::take_coefficients(RawNet& raw) {
  const auto components = static_cast<std::size_t>(raw.components);
  std::vector<Rational> coefficients(raw.points.size());
  for (std::size_t i = 0; i < raw.num_points; ++i)
    for (std::size_t c = 0; c < components; ++c)
      coefficients[c * raw.num_points + i] = std::move(raw.points[i * components + c]);
  raw.points.clear();
  return coefficients;
}

bool SplineJsonMaps::check_weights(const RawNet& raw, std::span<const Rational> weights) {
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i].sign() != Sign::kPositive)
      return fail(raw.at, Code::kBadSpline,
                  "the weight of control point " + std::to_string(i) + ", " +
                      weights[i].to_string() + ", is not positive");
  return true;
}

bool SplineJsonMaps::read_raw(RawMap& raw) {
  skip();
  raw.at = p_;
  return read_object(
      {"degrees", "periodic", "knots", "rational", "components", "points"}, [&](std::size_t key) {
        switch (key) {
          case 0:
            return read_list([&] { return read_integer("a degree", raw.degrees.emplace_back()); });
          case 1:
            return read_list([&] {
              bool value = false;
              const bool ok = read_bool(value);
              raw.periodic.push_back(value);
              return ok;
            });
          case 2:
            return read_list([&] {
              auto& knots = raw.knots.emplace_back();
              return read_list([&] { return read_exact(knots.emplace_back()); });
            });
          case 3: return read_bool(raw.is_rational);
          case 4: return read_integer("a number of components", raw.components);
          default: return read_points(raw);
        }
      });
}

template <std::size_t N>
bool SplineJsonMaps::finish(RawMap& raw, std::optional<BSpline<Rational, N>>& spline) {
  if (raw.degrees.size() != N || raw.knots.size() != N || raw.periodic.size() != N)
    return fail(raw.at, Code::kBadSpline,
                "degrees, periodic and knots must have " + std::to_string(N) + " entries");
  if (!check_components(raw)) return false;
  std::array<KnotAxis<Rational>, N> axes;
  Grid<N> grid;
  std::uint64_t total = 1;
  for (std::size_t a = 0; a < N; ++a) {
    const std::int64_t degree = std::clamp<std::int64_t>(raw.degrees[a], -1, kMaxSplineDegree + 1);
    auto axis = make_knot_axis(static_cast<int>(degree), std::move(raw.knots[a]), raw.periodic[a]);
    if (!axis) {
      Error error = axis.error();
      if (error.code == Code::kBadArgument) error.code = Code::kBadSpline;
      return fail_with(raw.at, error);
    }
    axes[a] = std::move(*axis);
    grid.size[a] = axes[a].num_control();
    total = grid.size[a] > source_.size() / total ? source_.size() + 1 : total * grid.size[a];
    if (total > source_.size()) break;
  }
  if (total != raw.num_points)
    return fail(raw.at, Code::kBadSpline,
                std::to_string(raw.num_points) + " points do not fit the knots");
  BSpline<Rational, N> built(std::move(axes), static_cast<int>(raw.components), raw.is_rational,
                             take_coefficients(raw));
  if (raw.is_rational && !check_weights(raw, built.component(built.num_components() - 1)))
    return false;
  for (std::size_t a = 0; a < N; ++a) {
    if (!built.axis(a).is_periodic) continue;
    const std::size_t n = grid.size[a], p = static_cast<std::size_t>(built.axis(a).degree),
                      stride = grid.stride(a);
    bool repeats = n >= p;
    for (int c = 0; c < built.num_components(); ++c)
      grid.for_each_line(a, [&](std::size_t first) {
        for (std::size_t i = 0; repeats && i < p; ++i)
          repeats = built.component(c)[first + i * stride] ==
                    built.component(c)[first + (n - p + i) * stride];
      });
    if (!repeats)
      return fail(raw.at, Code::kBadSpline, "the control points of a periodic axis do not repeat");
  }
  spline = std::move(built);
  return true;
}

template <std::size_t N>
bool SplineJsonMaps::read_map(std::optional<BSpline<Rational, N>>& spline) {
  RawMap raw;
  return read_raw(raw) && finish(raw, spline);
}

bool SplineJsonMaps::read_triangle(std::optional<ExactTriangle>& triangle) {
  RawNet raw;
  std::int64_t degree = 0;
  skip();
  raw.at = p_;
  const bool ok = read_object({"degree", "rational", "components", "points"}, [&](std::size_t key) {
    switch (key) {
      case 0: return read_integer("a degree", degree);
      case 1: return read_bool(raw.is_rational);
      case 2: return read_integer("a number of components", raw.components);
      default: return read_points(raw);
    }
  });
  if (!ok || !check_components(raw)) return false;
  if (degree < 1 || degree > kMaxSplineDegree)
    return fail(raw.at, degree < 1 ? Code::kBadSpline : Code::kOverLimit,
                "a triangle's degree must be from 1 to " + std::to_string(kMaxSplineDegree) +
                    ", not " + std::to_string(degree));
  const std::size_t needed = num_triangle_coefficients(static_cast<int>(degree));
  if (raw.num_points != needed)
    return fail(raw.at, Code::kBadSpline,
                "a triangle of degree " + std::to_string(degree) + " has " +
                    std::to_string(needed) + " points, not " + std::to_string(raw.num_points));
  ExactTriangle built(static_cast<int>(degree), static_cast<int>(raw.components), raw.is_rational,
                      take_coefficients(raw));
  if (built.is_rational() && !check_weights(raw, built.component(built.num_components() - 1)))
    return false;
  triangle = std::move(built);
  return true;
}

bool SplineJsonMaps::read_optional_curve(std::optional<ExactCurve>& curve) {
  return take_null() || read_map(curve);
}

template bool SplineJsonMaps::read_map(std::optional<ExactCurve>& curve);
template bool SplineJsonMaps::read_map(std::optional<ExactSurface>& surface);
template bool SplineJsonMaps::read_map(std::optional<ExactVolume>& volume);

}  // namespace veritope
