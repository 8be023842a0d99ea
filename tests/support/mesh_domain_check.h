// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/mesh_domain_check.h: whether a domain fills a mesh, by other means than the program's: equalities of
// fractions modulo a prime of 61 bits, which false ones pass with a probability of about 2^-60, and for small models the
// fractions themselves.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "robust/base/int128.h"
#include "robust/integer.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_model.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

/// Numbers modulo 2^61 - 1.
class Residue {
 public:
  static constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61) - 1;

  Residue() = default;
  explicit Residue(std::uint64_t v) : v_(v % kPrime) {}
  /// REQUIRES a denominator that the prime does not divide.
  static Residue of(const Rational& r) {
    const Residue n(floor_remainder(r.numerator(), kPrime));
    const std::uint64_t d = floor_remainder(r.denominator(), kPrime);
    return d == 1 ? n : n * Residue(d).inverse();
  }
  friend Residue operator+(Residue a, Residue b) { return Residue(a.v_ + b.v_); }
  friend Residue operator-(Residue a, Residue b) { return Residue(a.v_ + kPrime - b.v_); }
  friend Residue operator*(Residue a, Residue b) {
    return Residue(static_cast<std::uint64_t>(static_cast<uint128>(a.v_) * b.v_ % kPrime));
  }
  Residue inverse() const {
    Residue power = *this, out(1);
    for (std::uint64_t e = kPrime - 2; e != 0; e >>= 1) {
      if ((e & 1) != 0) out = out * power;
      power = power * power;
    }
    return out;
  }
  bool is_zero() const { return v_ == 0; }
  friend auto operator<=>(const Residue&, const Residue&) = default;

 private:
  std::uint64_t v_ = 0;
};

template <typename T>
std::array<T, 3> minus(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <typename T>
std::array<T, 3> cross(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <typename T>
T dot(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline DmsPoint exact_place(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}
inline std::array<Residue, 3> residues(const DmsPoint& p) {
  return {Residue::of(p[0]), Residue::of(p[1]), Residue::of(p[2])};
}

/// For each plane that triangles lie in, the sum of their vector areas, twice: planes by their coefficients over the
/// first one that is not 0.
using PlaneAreas = std::map<std::array<Residue, 4>, std::array<Residue, 3>>;
inline void add_area(const std::array<std::array<Residue, 3>, 3>& t, PlaneAreas& out) {
  const std::array<Residue, 3> n = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  const auto lead = std::find_if(n.begin(), n.end(), [](Residue r) { return !r.is_zero(); });
  const Residue scale = lead == n.end() ? Residue(1) : lead->inverse();
  std::array<Residue, 3>& sum =
      out[{n[0] * scale, n[1] * scale, n[2] * scale, dot(n, t[0]) * scale}];
  for (std::size_t k = 0; k < 3; ++k) sum[k] = sum[k] + n[k];
}

/// What is wrong; empty: nothing. Every tetrahedron has d > 0, faces fit, the boundary has in each plane the mesh's
/// area and orientation, the volume is the mesh's.
inline std::string mesh_domain_fault(const TriangleMesh& mesh, const DmsModel& domain) {
  if (const Status status = validate(domain); !status) return to_string(status.error());
  const DmsDefects defects = find_dms_defects(domain);
  if (defects.count != 0) return to_string(defects.first[0]);
  std::vector<std::array<Residue, 3>> at, mesh_at;
  for (const DmsCloud& cloud : domain.clouds) at.push_back(residues(cloud[0]));
  for (const Vec3d& p : mesh.positions) mesh_at.push_back(residues(exact_place(p)));
  Residue volume, mesh_volume;
  for (const TetrahedronCorners& t : domain.tetrahedra)
    volume = volume + dot(minus(at[t[1]], at[t[0]]),
                          cross(minus(at[t[2]], at[t[0]]), minus(at[t[3]], at[t[0]])));
  PlaneAreas areas, mesh_areas;
  for (const auto& f : mesh.faces) {
    mesh_volume = mesh_volume + dot(mesh_at[f[0]], cross(mesh_at[f[1]], mesh_at[f[2]]));
    add_area({mesh_at[f[0]], mesh_at[f[1]], mesh_at[f[2]]}, mesh_areas);
  }
  if (volume != mesh_volume) return "the volume is not the mesh's";
  const TetrahedralComplex complex(domain.tetrahedra,
                                   static_cast<std::uint32_t>(domain.clouds.size()));
  for (const TetrahedronFace f : complex.boundary()) {
    const auto v = complex.vertices(f);
    add_area({at[v[0]], at[v[1]], at[v[2]]}, areas);
  }
  if (areas != mesh_areas) return "the boundary is not the mesh";
  return "";
}

/// Six times the volume, by fractions.
inline Rational six_volumes(const DmsModel& domain) {
  Rational sum;
  for (const TetrahedronCorners& t : domain.tetrahedra) {
    const auto at = [&](std::size_t k) { return domain.clouds[t[k]][0]; };
    sum += dot(minus(at(1), at(0)), cross(minus(at(2), at(0)), minus(at(3), at(0))));
  }
  return sum;
}
inline Rational six_volumes(const TriangleMesh& mesh) {
  Rational sum;
  for (const auto& f : mesh.faces)
    sum += dot(exact_place(mesh.positions[f[0]]),
               cross(exact_place(mesh.positions[f[1]]), exact_place(mesh.positions[f[2]])));
  return sum;
}

/// Whether a point of a triangle's plane is in the closed triangle.
inline bool is_in_triangle(const DmsPoint& p, const std::array<DmsPoint, 3>& t) {
  const DmsPoint n = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  if (dot(n, minus(p, t[0])).sign() != Sign::kZero) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (dot(n, cross(minus(t[(k + 1) % 3], t[k]), minus(p, t[k]))).sign() == Sign::kNegative)
      return false;
  return true;
}
/// Whether each vertex and the centre of each triangle of the boundary lie on the mesh, by fractions.
inline bool is_boundary_on_mesh(const TriangleMesh& mesh, const DmsModel& domain) {
  std::vector<std::array<DmsPoint, 3>> triangles;
  for (const auto& f : mesh.faces)
    triangles.push_back({exact_place(mesh.positions[f[0]]), exact_place(mesh.positions[f[1]]),
                         exact_place(mesh.positions[f[2]])});
  const auto is_on_mesh = [&](const DmsPoint& p) {
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](const auto& t) { return is_in_triangle(p, t); });
  };
  const TetrahedralComplex complex(domain.tetrahedra,
                                   static_cast<std::uint32_t>(domain.clouds.size()));
  return std::all_of(complex.boundary().begin(), complex.boundary().end(), [&](TetrahedronFace f) {
    DmsPoint centre;
    for (const std::uint32_t v : complex.vertices(f)) {
      const DmsPoint& p = domain.clouds[v][0];
      if (!is_on_mesh(p)) return false;
      for (std::size_t k = 0; k < 3; ++k) centre[k] += p[k];
    }
    for (Rational& x : centre) x /= Rational(3);
    return is_on_mesh(centre);
  });
}

}  // namespace veritope
