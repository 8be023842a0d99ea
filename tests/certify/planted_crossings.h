// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/planted_crossings.h: models with two points, of known rational parameters, that have the same image, where the sheets cross transversally.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/patches/patch_transform.h"
#include "splines/bezier_calculus.h"
#include "splines/de_casteljau.h"
#include "verify/certify/crossing_witness.h"

namespace veritope::planted {

using patch_shapes::Patches;

struct PlantedPlace {
  std::size_t patch = 0;
  std::array<Rational, 2> at;  ///< in the tensor form
};
struct PlantedModel {
  std::string name;
  Patches patches;
  std::array<PlantedPlace, 2> places;
};

inline Rational ratio(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

inline PatchPoint image(const Patch& patch, const std::array<Rational, 2>& at) {
  const std::vector<Rational> p = evaluate(tensor_form(patch), at);
  return point_of(std::span<const Rational>(p)).value();
}

/// Its length is approximately 1.
inline std::array<double, 3> approx_normal(const Patch& patch, const std::array<Rational, 2>& at) {
  std::array<std::array<double, 3>, 2> d;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::vector<Rational> slope = evaluate(derivative(tensor_form(patch), axis), at);
    d[axis] = approx_point(std::span<const Rational>(slope));
  }
  std::array<double, 3> n{d[0][1] * d[1][2] - d[0][2] * d[1][1],
                          d[0][2] * d[1][0] - d[0][0] * d[1][2],
                          d[0][0] * d[1][1] - d[0][1] * d[1][0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  for (double& v : n) v /= length;
  return n;
}

/// The sine of the angle of the normals at the two places. NaN where a sheet has none.
inline double crossing_sine(const PlantedModel& m) {
  const auto a = approx_normal(m.patches[m.places[0].patch], m.places[0].at),
             b = approx_normal(m.patches[m.places[1].patch], m.places[1].at);
  return std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                    a[0] * b[1] - a[1] * b[0]);
}

/// With a determinant that is not near 0, of either sign.
inline AffineMap random_map(Random& random) {
  for (;;) {
    AffineMap map{3, 3, {}, {}};
    for (int i = 0; i < 9; ++i)
      map.linear.push_back(ratio(random.between(-4, 4) + (i % 4 == 0 ? 5 : 0), 4));
    for (int i = 0; i < 3; ++i) map.translation.push_back(ratio(random.between(-999, 999), 7));
    const auto& m = map.linear;
    Rational determinant(0);
    for (std::size_t k = 0; k < 3; ++k)
      determinant += m[k] * (m[3 + (k + 1) % 3] * m[6 + (k + 2) % 3] -
                             m[3 + (k + 2) % 3] * m[6 + (k + 1) % 3]);
    if (abs(determinant) > ratio(1, 4)) return map;
  }
}

/// Small embedded models, with and without triangles, weights, poles, inner control points.
inline const std::vector<std::pair<const char*, Patches>>& bases() {
  using namespace patch_shapes;
  static const std::vector<std::pair<const char*, Patches>> all = {
      {"sphere", sphere()},
      {"torus", torus(3, 1)},
      {"one-patch-torus", one_patch_torus(3, 1)},
      {"teapot", teapot()},
      {"pn-torus", pn_torus(12, 8)},
      {"knotted-tube", knotted_tube(ratio(1, 4), 6, 48)},
      {"cubic-box", elevated(box({0, 0, 0}, {1, 2, 3}), 2)},
      // Without inner control points.
      {"box", box({0, 0, 0}, {1, 2, 3})},
      {"octants", octant_sphere()},
      {"cone", frustum(1, 0, 2)},
      {"plate", blocks({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}})}};
  return all;
}
inline constexpr std::size_t kWithInnerPoints = 7;

inline PlantedPlace random_place(const Patches& patches, Random& random) {
  return {static_cast<std::size_t>(random.below(patches.size())),
          {ratio(random.between(1, 96), 97), ratio(random.between(1, 96), 97)}};
}

/// Affine images of two bases, one moved so that a point of one lies on the other.
inline PlantedModel two_shells(Random& random) {
  for (;;) {
    PlantedModel m;
    const auto& [first, a] = bases()[random.below(bases().size())];
    const auto& [second, b] = bases()[random.below(bases().size())];
    m.name = std::string(first) + " and " + second;
    const Patches p = affine_image(a, random_map(random)).value();
    AffineMap map = random_map(random);
    const Patches q = affine_image(b, map).value();
    m.places = {random_place(p, random), random_place(q, random)};
    const PatchPoint to = image(p[m.places[0].patch], m.places[0].at),
                     from = image(q[m.places[1].patch], m.places[1].at);
    m.patches = patch_shapes::joined(
        {p, patch_shapes::placed(q, 1, {to[0] - from[0], to[1] - from[1], to[2] - from[2]})});
    m.places[1].patch += p.size();
    if (crossing_sine(m) > 0.02) return m;
  }
}

/// An inner control point of a patch is moved so that a point of the patch comes to lie on a point of a patch, perhaps of the same one.
inline PlantedModel one_shell(Random& random) {
  for (;;) {
    PlantedModel m;
    const auto& [name, base] = bases()[random.below(kWithInnerPoints)];
    m.name = std::string(name) + " through itself";
    m.patches = affine_image(base, random_map(random)).value();
    m.places = {random_place(m.patches, random), random_place(m.patches, random)};
    if (random.below(3) == 0) m.places[1].patch = m.places[0].patch;
    Patch& patch = m.patches[m.places[0].patch];
    const PatchPoint from = image(patch, m.places[0].at),
                     to = image(m.patches[m.places[1].patch], m.places[1].at);
    // The map with one numerator 1, the others 0: how much a point follows the control point.
    const bool is_triangle = patch.is_triangle();
    const std::size_t columns =
        is_triangle ? 0 : static_cast<std::size_t>(patch.tensor().degree(1)) + 1;
    const std::size_t inner =
        is_triangle
            ? triangle_index(1, 1)
            : static_cast<std::size_t>(random.between(1, patch.tensor().degree(0) - 1)) * columns +
                  static_cast<std::size_t>(random.between(1, patch.tensor().degree(1) - 1));
    std::vector<Rational> c(patch.coefficients().begin(), patch.coefficients().end());
    const std::size_t n = patch.num_control();
    std::vector<Rational> bump = c;
    for (std::size_t i = 0; i < 3 * n; ++i) bump[i] = Rational(i == inner ? 1 : 0);
    const auto with = [&](std::vector<Rational> coefficients) {
      if (is_triangle)
        return make_patch(Patch::Triangle(patch.triangle().degree(), patch.is_rational() ? 4 : 3,
                                          patch.is_rational(), std::move(coefficients)),
                          patch.origin())
            .value();
      return make_patch(Patch::Tensor(patch.tensor().degrees(), patch.is_rational() ? 4 : 3,
                                      patch.is_rational(), std::move(coefficients)),
                        patch.origin())
          .value();
    };
    Rational share = image(with(bump), m.places[0].at)[0];
    if (m.places[0].patch == m.places[1].patch) share -= image(with(bump), m.places[1].at)[0];
    if (share.sign() == Sign::kZero) continue;
    for (std::size_t k = 0; k < 3; ++k) c[k * n + inner] += (to[k] - from[k]) / share;
    patch = with(std::move(c));
    if (crossing_sine(m) > 0.02) return m;
  }
}

}  // namespace veritope::planted
