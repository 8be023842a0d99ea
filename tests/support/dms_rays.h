// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/dms_rays.h: sums along the rays of random grids through random solids beside exact integrals: for unit
// tests and for the experiment soak_dms_xray.
#pragma once
#include <cstdint>
#include <string>
#include <utility>

#include "solids/dms/dms_xray.h"
#include "tests/support/dms_laws.h"
#include "tests/support/dms_lines.h"

namespace veritope {

struct DmsRayCounts {
  std::uint64_t models = 0, rays = 0;
  std::uint64_t exact = 0;     ///< rays of all rows that rationals decided
  std::uint64_t computed = 0;  ///< all of these rows
  double worst = 0;            ///< the greatest bound, beside the greatest coefficient of the model
};

namespace internal {

inline Point3d nearest(const DmsPoint& p) {
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}

/// Five times five rays; the middle one goes through a vertex or a point of the domain, up to the rounding of it. One in
/// three grids has rays along an edge of the domain, and so in planes of knots; their neighbours may lie in a face.
inline DmsRayGrid draw_ray_grid(Random& random, const DmsModel& model) {
  for (;;) {
    const auto& t = model.tetrahedra[random.below(model.tetrahedra.size())];
    const Point3d middle = random.below(2) == 0 ? nearest(model.knot(t[0], 0))
                                                : nearest(draw_dms_point(random, model));
    const auto edge = [&](std::size_t to, double factor) {
      Point3d d = nearest(model.knot(t[to], 0));
      const Point3d from = nearest(model.knot(t[0], 0));
      for (std::size_t c = 0; c < 3; ++c) d[c] = factor * (d[c] - from[c]);
      return d;
    };
    DmsRayGrid grid;
    grid.columns = grid.rows = 5;
    grid.right = edge(1, 0.25), grid.down = edge(2, 0.25), grid.along = edge(3, 8);
    if (random.below(3) != 0)
      for (Point3d* d : {&grid.right, &grid.down, &grid.along})
        for (double& x : *d) x += 0.37 * random.unit() * (d == &grid.along ? 8 : 0.25);
    for (std::size_t c = 0; c < 3; ++c)
      grid.origin[c] = middle[c] - 2 * grid.right[c] - 2 * grid.down[c] - 0.5 * grid.along[c];
    if (grid.is_sound()) return grid;
  }
}

}  // namespace internal

/// Empty, or where a sum is farther from the exact integral than its bound. `rays` rays of the model of the seed.
inline std::string check_dms_rays(std::uint64_t seed, int max_degree, int rays,
                                  DmsRayCounts& counts) {
  RandomDms drawn = draw_dms(seed, max_degree);
  if (seed % 4 == 0) drawn.model = internal::separated(drawn.model);
  const DmsModel& model = drawn.model;
  Random random(seed);
  const DmsRayGrid grid = internal::draw_ray_grid(random, model);
  const DmsRayWeights weights(model, grid);
  const DmsCoefficients coefficients(model, 0);
  std::vector<DmsRayRow> rows;
  for (std::size_t j = 0; j < grid.rows; ++j) {
    rows.push_back(weights.row(j));
    counts.exact += rows.back().num_exact;
    counts.computed += grid.columns;
  }
  DmsEvaluator evaluator(model);
  DmsLineIntegrator integrator(evaluator);
  ++counts.models;
  for (int k = 0; k < rays; ++k) {
    const std::size_t i = random.below(grid.columns), j = random.below(grid.rows);
    const DmsRaySum sum = coefficients.sum(rows[j], i);
    const Rational exact = integrator.mean(grid.ray(i, j), 0);
    ++counts.rays;
    counts.worst = std::max(counts.worst, sum.bound);
    if (Rational::from_double(sum.bound) < abs(exact - Rational::from_double(sum.mean)))
      return drawn.text + ", ray " + std::to_string(i) + "," + std::to_string(j) + ": " +
             exact.to_string() + " is farther than " + std::to_string(sum.bound) + " from " +
             std::to_string(sum.mean);
  }
  return "";
}

}  // namespace veritope
