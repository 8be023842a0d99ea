// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/dms_level_sets.h: attributes of simplex-spline solids that are polynomials, with level sets of known
// topology in a cube or in an affine image of it.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "solids/dms/dms_make.h"
#include "tests/support/random_dms.h"

namespace veritope {

/// The polar form of a polynomial g of degree at most n at n points: its values at the means of all subsets, weighted.
template <typename G>
Rational polar_form(const G& g, const std::vector<DmsPoint>& points) {
  const auto n = static_cast<int>(points.size());
  Rational sum, factorial(1);
  for (int k = 2; k <= n; ++k) factorial *= Rational(k);
  for (unsigned subset = 1; subset < 1u << n; ++subset) {
    int k = 0;
    DmsPoint mean;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((subset >> i & 1u) == 0) continue;
      ++k;
      for (std::size_t c = 0; c < 3; ++c) mean[c] += points[i][c];
    }
    for (Rational& c : mean) c /= Rational(k);
    Rational weight((n - k) % 2 == 0 ? 1 : -1);
    for (int i = 0; i < n; ++i) weight *= Rational(k);
    sum += weight * g(mean);
  }
  return sum / factorial;
}

/// Shared control points: the identity by the Greville rule, and one attribute that is the polynomial g. REQUIRES that
/// its degree is at most the model's.
template <typename G>
void set_polynomial_attribute(DmsModel& model, const G& g) {
  model.attributes = {"a"};
  set_control_by_rule(model, DmsControlRule::kGreville, std::vector<Rational>(model.clouds.size()));
  const auto n = static_cast<std::size_t>(model.degree);
  for (std::size_t c = 0; c < model.num_control(); ++c) {
    std::vector<DmsPoint> knots;
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t v = model.control.at[c * n + i];
      int k = 0;
      while (static_cast<std::size_t>(k) < i &&
             model.control.at[c * n + i - static_cast<std::size_t>(k) - 1] == v)
        ++k;
      knots.push_back(model.knot(v, k));
    }
    model.control.values[4 * c + 3] = polar_form(g, knots);
  }
}

/// Moves the domain and the solid; attributes stay as they are, at the moved points.
inline void move_dms(DmsModel& model, const DmsAffine& affine) {
  for (DmsCloud& cloud : model.clouds)
    for (DmsPoint& knot : cloud) knot = affine(knot);
  for (std::size_t c = 0; c < model.num_control(); ++c) {
    const auto at =
        model.control.values.begin() + static_cast<std::ptrdiff_t>(c * model.num_components());
    const DmsPoint moved = affine({at[0], at[1], at[2]});
    std::copy(moved.begin(), moved.end(), at);
  }
}

enum class LevelSetKind {
  kSphere,
  kEllipsoid,
  kTorus,
  kTwoSpheres,
  kSheets,
  kPlane,
  kOneSheet,
  kTwoSheets,
  kCone,
  kCrossingPlanes,
  kPoint,
  kDoublePlane,
};
inline constexpr int kLevelSetKinds = 12, kFirstSingularKind = 8;

struct LevelSet {
  DmsModel model;
  Rational level;
  std::string text;
  bool is_singular = false;
  std::uint64_t components = 0;
  std::int64_t euler = 0;
};

/// In a cube of side 2 of 6 or 48 tetrahedra, centred near its middle. `clouds` gives knots apart from each other.
inline LevelSet draw_level_set(std::uint64_t seed, LevelSetKind kind, bool has_clouds,
                               bool is_moved) {
  Random random(seed);
  const auto between = [&](int low, int high, int over) {
    return Rational(random.between(low, high)) / Rational(over);
  };
  LevelSet out;
  const bool is_quartic = kind == LevelSetKind::kTorus || kind == LevelSetKind::kTwoSpheres;
  DmsModel& model = out.model;
  model = kuhn_domain({2, 2, 2});
  model.degree = is_quartic ? 4 : 2;
  if (has_clouds) internal::draw_clouds(model, {Rational(1) / Rational(50), seed});
  const DmsPoint centre{Rational(1) + between(-7, 7, 97), Rational(1) + between(-7, 7, 89),
                        Rational(1) + between(-7, 7, 83)};
  const DmsPoint weight{between(4, 9, 6), between(4, 9, 6), between(4, 9, 6)};
  const DmsPoint slope{between(-9, 9, 50), between(-9, 9, 53), Rational(1)};
  const auto at = [&](const DmsPoint& p) {
    return DmsPoint{p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]};
  };
  const auto squares = [](const DmsPoint& x, const DmsPoint& w) {
    return w[0] * x[0] * x[0] + w[1] * x[1] * x[1] + w[2] * x[2] * x[2];
  };
  const auto along = [&](const DmsPoint& x) {
    return slope[0] * x[0] + slope[1] * x[1] + slope[2] * x[2];
  };
  const DmsPoint ones{Rational(1), Rational(1), Rational(1)};
  const DmsPoint saddle{Rational(1), Rational(1), Rational(-1) / Rational(4)};
  const Rational radius = between(10, 30, 100);  // squared, where one is needed
  const Rational tube = between(15, 25, 100), ring = between(50, 60, 100);
  const auto set = [&](const auto& g, const Rational& level, std::uint64_t components,
                       std::int64_t euler) {
    set_polynomial_attribute(model, [&](const DmsPoint& p) { return g(at(p)); });
    out.level = level;
    out.components = components;
    out.euler = euler;
  };
  using P = const DmsPoint&;
  const auto sphere = [&](P x) { return squares(x, ones); };
  const auto hyperboloid = [&](P x) { return squares(x, saddle); };
  const auto sheets = [&](P x) { return along(x) * along(x); };
  switch (kind) {
    case LevelSetKind::kSphere: set(sphere, radius, 1, 2); break;
    case LevelSetKind::kEllipsoid:
      set([&](P x) { return squares(x, weight); }, radius, 1, 2);
      break;
    case LevelSetKind::kTorus:
      set(
          [&](P x) {
            const Rational s = squares(x, ones) + ring * ring - tube * tube;
            return s * s - Rational(4) * ring * ring * (x[0] * x[0] + x[1] * x[1]);
          },
          Rational(), 1, 0);
      break;
    case LevelSetKind::kTwoSpheres:
      set(
          [&](P x) {
            const Rational r = Rational(16) / Rational(100);
            DmsPoint left = x, right = x;
            left[0] += Rational(9) / Rational(20);
            right[0] -= Rational(9) / Rational(20);
            return (squares(left, ones) - r) * (squares(right, ones) - r);
          },
          Rational(), 2, 4);
      break;
    case LevelSetKind::kSheets: set(sheets, Rational(1) / Rational(4'000'000'000'000), 2, 2); break;
    case LevelSetKind::kPlane: set(along, Rational(1) / Rational(1000), 1, 1); break;
    case LevelSetKind::kOneSheet: set(hyperboloid, radius, 1, 0); break;
    case LevelSetKind::kTwoSheets: set(hyperboloid, -radius / Rational(3), 2, 2); break;
    case LevelSetKind::kCone: set(hyperboloid, Rational(), 0, 0); break;
    case LevelSetKind::kCrossingPlanes:
      set([&](P x) { return along(x) * x[0]; }, Rational(), 0, 0);
      break;
    case LevelSetKind::kPoint: set(sphere, Rational(), 0, 0); break;
    case LevelSetKind::kDoublePlane: set(sheets, Rational(), 0, 0); break;
  }
  out.is_singular = static_cast<int>(kind) >= kFirstSingularKind;
  if (is_moved) move_dms(model, draw_affine(random));
  out.text = "seed " + std::to_string(seed) + ", kind " + std::to_string(static_cast<int>(kind)) +
             (has_clouds ? ", clouds" : "") + (is_moved ? ", moved" : "");
  return out;
}

}  // namespace veritope
