// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/projection.h"
#include "robust/base/check.h"
#include "solids/classify/ray_count_internal.h"
#include "solids/polyhedron/nesting.h"

namespace veritope::internal {
namespace {

constexpr int kAxis = 0;

// The stab rule for points that binary64 does not have: stab_facet has it for those that it has.
Stab stab(const TriangleMesh& mesh, std::uint32_t f, const ScaledPoint& q) {
  const auto& face = mesh.faces[f];
  const std::array<Vec3d, 3> t{mesh.positions[face[0]], mesh.positions[face[1]],
                               mesh.positions[face[2]]};
  bool is_odd = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d &a = t[i], &b = t[(i + 1) % 3];
    const bool is_low = q.compare(2, a.z) >= 0;
    if (is_low == (q.compare(2, b.z) >= 0)) continue;
    const Vec3d &low = is_low ? a : b, &high = is_low ? b : a;
    is_odd ^= orient2d(low, high, q, kAxis) == Sign::kPositive;
  }
  if (!is_odd) return Stab::kMiss;
  const Sign ahead = -orient3d(t[0], t[1], t[2], q) * orient2d(t[0], t[1], t[2], kAxis);
  if (ahead == Sign::kZero) return Stab::kTouch;
  return ahead == Sign::kPositive ? Stab::kHit : Stab::kMiss;
}
Stab stab(const TriangleMesh& mesh, std::uint32_t f, const Vec3d& q) {
  return stab_facet(mesh, f, q, kAxis, true);
}

template <typename Point>
WindingChange change_to(const TriangleMesh& mesh, const Point& q, const MeshShells* shells) {
  WindingChange out;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& t = mesh.faces[f];
    const Sign normal =
        orient2d(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], kAxis);
    if (normal == Sign::kZero) continue;
    const Stab s = stab(mesh, f, q);
    VT_CHECK(s != Stab::kTouch, "a point with a ray lies on a facet");
    if (s == Stab::kHit) out.cross(f, normal, shells);
  }
  return out;
}

}  // namespace

WindingChange change_along_ray(const TriangleMesh& mesh, const Vec3d& q, const MeshShells* shells) {
  return change_to(mesh, q, shells);
}

WindingChange change_along_ray(const TriangleMesh& mesh, const ScaledPoint& q,
                               const MeshShells* shells) {
  return change_to(mesh, q, shells);
}

}  // namespace veritope::internal
