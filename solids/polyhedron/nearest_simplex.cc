// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/nearest_simplex.h"

#include <algorithm>
#include <limits>

namespace veritope::internal {
namespace {

Vec3d less(const Vec3d& a, const Vec3d& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3d plus_scaled(const Vec3d& a, double t, const Vec3d& d) {
  return {a.x + t * d.x, a.y + t * d.y, a.z + t * d.z};
}
double product(const Vec3d& a, const Vec3d& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
Vec3d cross(const Vec3d& a, const Vec3d& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace

bool NearestSimplex::nearest(Vec3d& out) {
  switch (size_) {
    case 1: out = at_[0]; return true;
    case 2: out = on_edge(0, 1); break;
    case 3: out = on_triangle(0, 1, 2); break;
    default:
      if (!on_tetrahedron(out)) return false;
  }
  keep();
  return true;
}
Vec3d NearestSimplex::on_edge(int i, int j) {
  const Vec3d d = less(at_[j], at_[i]);
  const double len = product(d, d),
               t = len > 0 ? std::clamp(-product(at_[i], d) / len, 0.0, 1.0) : 0.0;
  kept_ = (t < 1 ? 1u << i : 0u) | (t > 0 ? 1u << j : 0u);
  return plus_scaled(at_[i], t, d);
}
Vec3d NearestSimplex::on_triangle(int i, int j, int k) {
  const Vec3d u = less(at_[j], at_[i]), v = less(at_[k], at_[i]), n = cross(u, v);
  const double nn = product(n, n);
  if (nn > 0) {
    const Vec3d a = less({0, 0, 0}, at_[i]);
    const double s = product(cross(a, v), n) / nn, t = product(cross(u, a), n) / nn;
    if (s > 0 && t > 0 && s + t < 1) {
      kept_ = 1u << i | 1u << j | 1u << k;
      return plus_scaled(plus_scaled(at_[i], s, u), t, v);
    }
  }
  Vec3d best{};
  double least = std::numeric_limits<double>::infinity();
  unsigned kept = 0;
  for (const auto& e : {std::array{i, j}, std::array{j, k}, std::array{k, i}}) {
    const Vec3d p = on_edge(e[0], e[1]);
    if (product(p, p) < least) {
      least = product(p, p);
      best = p;
      kept = kept_;
    }
  }
  kept_ = kept;
  return best;
}
bool NearestSimplex::on_tetrahedron(Vec3d& out) {
  double least = std::numeric_limits<double>::infinity();
  unsigned kept = 0;
  for (const auto& f : {std::array{0, 1, 2, 3}, std::array{0, 1, 3, 2}, std::array{0, 2, 3, 1},
                        std::array{1, 2, 3, 0}}) {
    const Vec3d n = cross(less(at_[f[1]], at_[f[0]]), less(at_[f[2]], at_[f[0]]));
    const double origin = -product(n, at_[f[0]]), fourth = product(n, less(at_[f[3]], at_[f[0]]));
    if (origin * fourth > 0) continue;  // the origin is on the inner side of this face
    const Vec3d p = on_triangle(f[0], f[1], f[2]);
    if (product(p, p) < least) {
      least = product(p, p);
      out = p;
      kept = kept_;
    }
  }
  kept_ = kept;
  return kept != 0;
}
void NearestSimplex::keep() {
  int n = 0;
  for (int i = 0; i < size_; ++i)
    if ((kept_ >> i & 1u) != 0) at_[n++] = at_[i];
  size_ = n;
}

}  // namespace veritope::internal
