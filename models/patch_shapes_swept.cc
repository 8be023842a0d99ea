// SPDX-License-Identifier: LGPL-3.0-or-later
// Periodic grids: the knotted tube, tori of triangles and of bilinear patches.
#include <cmath>
#include <functional>

#include "models/patch_shapes.h"
#include "models/patch_shapes_internal.h"
#include "robust/base/check.h"
#include "solids/patches/patch_sources.h"
#include "solids/patches/pn_mesh.h"

namespace veritope::patch_shapes {
namespace {

constexpr double kTurn = 6.283185307179586;

double fraction_of_turn(int i, int n) { return kTurn * i / n; }
// Rounded to a multiple of 2^-bits: the same on every machine except for ties.
Rational rounded_to(double v, int bits) {
  return Rational(std::llround(std::ldexp(v, bits))) / Rational::power_of_two(bits);
}
Point rounded_to(const Vec3d& p, int bits) {
  return {rounded_to(p.x, bits), rounded_to(p.y, bits), rounded_to(p.z, bits)};
}
Vec3d cross(const Vec3d& a, const Vec3d& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec3d normalised(const Vec3d& a) {
  const double length = std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
  return {a.x / length, a.y / length, a.z / length};
}

// Control points of a grid that closes in both directions.
class ClosedGrid {
 public:
  ClosedGrid(int m, int n, const std::function<Point(int, int)>& at) : m_(m), n_(n) {
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j) points_.push_back(at(i, j));
  }
  const Point& at(int i, int j) const {
    return points_[static_cast<std::size_t>((i % m_) * n_ + j % n_)];
  }

  // The biquadratic Bezier pieces of the uniform B-spline, axis 0 along i.
  Patches biquadratic() const {
    Patches out;
    for (int i = 0; i < m_; ++i)
      for (int j = 0; j < n_; ++j) {
        Patch::Tensor map({2, 2}, 3, false);
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b) {
            const Point p = piece_point(i, j, a, b);
            for (std::size_t c = 0; c < 3; ++c)
              map.component(static_cast<int>(c))[static_cast<std::size_t>(3 * a + b)] = p[c];
          }
        internal::add(out, std::move(map));
      }
    return out;
  }
  Patches bilinear() const {
    Patches out;
    for (int i = 0; i < m_; ++i)
      for (int j = 0; j < n_; ++j)
        internal::add(out,
                      internal::bilinear({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}));
    return out;
  }

 private:
  // Control point (a, b) of a piece: along an axis with the points p, q, r they are (p + q) / 2, q, (q + r) / 2.
  Point piece_point(int i, int j, int a, int b) const {
    Point sum;
    for (const int k : {i + (a + 1) / 2, i + (a + 2) / 2})
      for (const int l : {j + (b + 1) / 2, j + (b + 2) / 2})
        for (std::size_t c = 0; c < 3; ++c) sum[c] += at(k, l)[c] / 4;
    return sum;
  }

  int m_, n_;
  std::vector<Point> points_;
};

// The trefoil (2 + cos 3t) (cos 2t, sin 2t), height sin 3t. It lies on a torus, whose normal is `normal`, at right
// angles to the curve.
struct Frame {
  Vec3d centre, normal, binormal;
};
Frame trefoil(double t, bool is_flat) {
  const double c2 = std::cos(2 * t), s2 = std::sin(2 * t), c3 = std::cos(3 * t),
               s3 = std::sin(3 * t);
  const double rho = 2 + c3, height = is_flat ? 0 : 1;
  const Vec3d tangent =
      normalised({-3 * s3 * c2 - 2 * rho * s2, -3 * s3 * s2 + 2 * rho * c2, 3 * c3 * height});
  const Vec3d normal = is_flat ? Vec3d{0, 0, 1} : Vec3d{c3 * c2, c3 * s2, s3};
  return {{rho * c2, rho * s2, s3 * height}, normal, cross(tangent, normal)};
}

Vec3d torus_point(double u, double v, double big_radius, double radius) {
  const double rho = big_radius + radius * std::cos(v);
  return {rho * std::cos(u), rho * std::sin(u), radius * std::sin(v)};
}

}  // namespace

Patches internal::tube(const Rational& radius, int around, int along, bool is_flat) {
  VT_CHECK(around >= 3 && along >= 3, "a closed grid needs three points each way");
  constexpr int kBits = 12;
  const ClosedGrid grid(around, along, [&](int i, int j) {
    const Frame frame = trefoil(fraction_of_turn(j, along), is_flat);
    const double angle = fraction_of_turn(i, around);
    const Rational x = rounded_to(std::cos(angle), kBits), y = rounded_to(std::sin(angle), kBits);
    Point p = rounded_to(frame.centre, kBits);
    const Point n = rounded_to(frame.normal, kBits), b = rounded_to(frame.binormal, kBits);
    for (std::size_t c = 0; c < 3; ++c) p[c] += radius * (x * n[c] + y * b[c]);
    return p;
  });
  return grid.biquadratic();
}

Patches knotted_tube(const Rational& radius, int around, int along) {
  return internal::tube(radius, around, along, false);
}

Patches grid_torus(int m, int n) {
  VT_CHECK(m >= 3 && n >= 3, "a closed grid needs three points each way");
  constexpr int kBits = 30;
  const ClosedGrid grid(m, n, [&](int i, int j) {
    return rounded_to(torus_point(fraction_of_turn(i, m), fraction_of_turn(j, n), 3, 1), kBits);
  });
  return grid.bilinear();
}

Patches pn_torus(int m, int n) { return internal::pn_torus(m, n, 1); }

Patches internal::pn_torus(int m, int n, double radius) {
  VT_CHECK(m >= 3 && n >= 3, "a closed grid needs three points each way");
  const auto coarse = [](const Vec3d& p) {
    const auto at = [](double v) { return std::ldexp(std::round(std::ldexp(v, 20)), -20) + 0.0; };
    return Vec3d{at(p.x), at(p.y), at(p.z)};
  };
  TriangleMesh mesh;
  std::vector<Vec3d> normals;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = fraction_of_turn(i, m), v = fraction_of_turn(j, n);
      mesh.positions.push_back(coarse(torus_point(u, v, 3, radius)));
      normals.push_back(coarse(torus_point(u, v, 0, 1)));
      const auto vertex = [&](int a, int b) {
        return static_cast<std::uint32_t>((a % m) * n + b % n);
      };
      mesh.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return patches_of(rounded(make_pn_mesh(mesh, normals).value()).value());
}

}  // namespace veritope::patch_shapes
