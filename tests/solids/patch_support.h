// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/patch_support.h: tessellations of patches, findings as text.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "models/patch_shapes.h"
#include "solids/patches/patch_complex.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "splines/bezier_components.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_triangle.h"
#include "splines/bezier_triangle_algebra.h"
#include "splines/de_casteljau.h"

namespace veritope {

using Patches = std::vector<Patch>;

inline PatchComplex complex_of(Patches patches,
                               PatchOrientation orientation = PatchOrientation::kKeep) {
  return make_patch_complex(std::move(patches), orientation).value();
}

inline Patches unit_box() { return patch_shapes::box({0, 0, 0}, {1, 1, 1}); }

inline Patch with_coefficient(const Patch& patch, int component, std::size_t control,
                              const Rational& value) {
  Patch::Tensor map = patch.tensor();
  map.component(component)[control] = value;
  return make_patch(std::move(map), patch.origin()).value();
}
inline Patch bilinear(const std::array<PatchPoint, 4>& p) {
  Patch::Tensor map({1, 1}, 3, false);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto b = map.component(static_cast<int>(c));
    b[0] = p[0][c], b[2] = p[1][c], b[3] = p[2][c], b[1] = p[3][c];
  }
  return make_patch(std::move(map)).value();
}
inline Patch flat(const PatchPoint& a, const PatchPoint& b, const PatchPoint& c) {
  std::vector<Rational> values;
  for (std::size_t i = 0; i < 3; ++i) values.insert(values.end(), {a[i], b[i], c[i]});
  return make_patch(Patch::Triangle(1, 3, false, std::move(values))).value();
}

/// 0 <= x, y <= 1, 0 <= z <= 1 + x y, with x = g(u), y = g(v) on the patches, g(t) = (t + 3 t^2 - 2 t^3) / 2: most of
/// their rational points have irrational parameters.
inline Patches bent_graph() {
  const auto ratio = [](std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); };
  const std::vector<Rational> g{0, ratio(1, 6), ratio(5, 6), 1};
  Patch::Tensor top({3, 3}, 3, false);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      top.component(0)[4 * i + j] = g[i];
      top.component(1)[4 * i + j] = g[j];
      top.component(2)[4 * i + j] = Rational(1) + g[i] * g[j];
    }
  const auto wall = [&](auto x, auto y) {
    Patch::Tensor map({3, 1}, 3, false);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        map.component(0)[2 * i + j] = x(g[i]);
        map.component(1)[2 * i + j] = y(g[i]);
        map.component(2)[2 * i + j] = j == 0 ? Rational(0) : Rational(1) + x(g[i]) * y(g[i]);
      }
    return make_patch(std::move(map)).value();
  };
  const auto back = [](const Rational& t) { return Rational(1) - t; };
  const auto same = [](const Rational& t) { return t; };
  const auto zero = [](const Rational&) { return Rational(0); };
  const auto one = [](const Rational&) { return Rational(1); };
  Patch::Tensor bottom({3, 3}, 3, false);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      bottom.component(0)[4 * i + j] = g[j];
      bottom.component(1)[4 * i + j] = g[i];
    }
  return {make_patch(std::move(top)).value(),
          make_patch(std::move(bottom)).value(),
          wall(same, zero),
          wall(one, same),
          wall(back, one),
          wall(zero, back)};
}

/// x = (b0 - 1/2) b1, y = (b0 - 1/2) b2: the line b0 = 1/2 is one point.
inline Patch pinched_triangle() {
  Patch::Triangle map(2, 3, false);
  const Rational half = Rational(1) / Rational(2), quarter = half * half;
  map.component(0)[triangle_index(1, 0)] = quarter;
  map.component(0)[triangle_index(2, 0)] = -half;
  map.component(0)[triangle_index(1, 1)] = -quarter;
  map.component(1)[triangle_index(0, 1)] = quarter;
  map.component(1)[triangle_index(0, 2)] = -half;
  map.component(1)[triangle_index(1, 1)] = -quarter;
  return make_patch(std::move(map)).value();
}

inline std::string all_findings(const PatchComplex& complex) {
  std::string text;
  for (const PatchFinding& f : complex.findings()) text += describe(complex, f) + "\n";
  return text;
}

/// The point at (i / n, j / n), or at (1 - (i + j) / n, i / n, j / n) of a triangle: exact, then rounded.
inline std::array<double, 3> sample(const Patch& patch, int i, int j, int n) {
  const Rational u = Rational(i) / n, v = Rational(j) / n;
  if (patch.is_triangle())
    return approx_point(
        evaluate(patch.triangle(), Barycentric<Rational>{Rational(1) - u - v, u, v}));
  return approx_point(evaluate(patch.tensor(), std::array<Rational, 2>{u, v}));
}

/// Each patch as 2 n^2 (n^2) triangles. Equal points of one shell are one vertex.
inline TriangleMesh tessellated(const std::vector<Patch>& patches, int n) {
  const PatchComplex complex = make_patch_complex(patches).value();
  TriangleMesh mesh;
  std::map<std::pair<std::uint32_t, std::array<double, 3>>, std::uint32_t> vertices;
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    const auto vertex = [&](int i, int j) {
      const auto at = sample(patches[p], i, j, n);
      const auto next = static_cast<std::uint32_t>(mesh.positions.size());
      const auto [place, is_new] = vertices.try_emplace({complex.shell(p), at}, next);
      if (is_new) mesh.positions.push_back({at[0] + 0.0, at[1] + 0.0, at[2] + 0.0});
      return place->second;
    };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (a != b && b != c && c != a) mesh.faces.push_back({a, b, c});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        if (patches[p].is_triangle() && i + j >= n) continue;
        add(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
        if (patches[p].is_triangle() && i + j + 1 >= n) continue;
        add(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
  }
  return mesh;
}

/// The patch in binary64, at a point of its domain as above.
class RoundedPatch {
 public:
  explicit RoundedPatch(const Patch& patch) : is_triangle_(patch.is_triangle()) {
    std::vector<double> b;
    for (const Rational& v : patch.coefficients()) b.push_back(nearest_double(v));
    const int width = patch.is_rational() ? 4 : 3;
    if (is_triangle_) {
      triangle_ = BezierTriangle<double>(patch.triangle().degree(), width, width == 4, b);
    } else {
      tensor_ = BezierSurface<double>(patch.tensor().degrees(), width, width == 4, b);
    }
  }
  Vec3d at(double u, double v) const {
    const auto h = is_triangle_ ? evaluate(triangle_, Barycentric<double>{1 - u - v, u, v})
                                : evaluate(tensor_, std::array<double, 2>{u, v});
    const double w = h.size() == 4 ? h[3] : 1;
    return {h[0] / w, h[1] / w, h[2] / w};
  }

 private:
  bool is_triangle_;
  BezierTriangle<double> triangle_{0, 3, false};
  BezierSurface<double> tensor_{{0, 0}, 3, false};
};

/// By Gauss, of triangles of which each side of a patch carries n.
inline double approx_volume(const std::vector<Patch>& patches, int n = 8) {
  const auto cone = [](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
            a.z * (b.x * c.y - b.y * c.x)) /
           6;
  };
  double sum = 0;
  for (const Patch& patch : patches) {
    const RoundedPatch map(patch);
    const double h = 1.0 / n;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        if (patch.is_triangle() && i + j >= n) continue;
        const Vec3d b = map.at((i + 1) * h, j * h), c = map.at(i * h, (j + 1) * h);
        sum += cone(map.at(i * h, j * h), b, c);
        if (patch.is_triangle() && i + j + 1 >= n) continue;
        sum += cone(b, map.at((i + 1) * h, (j + 1) * h), c);
      }
  }
  return sum;
}

}  // namespace veritope
