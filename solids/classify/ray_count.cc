// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/projection.h"
#include "robust/base/check.h"
#include "solids/classify/rational_orient_internal.h"
#include "solids/classify/ray_count_internal.h"
#include "solids/polyhedron/nesting.h"

namespace veritope::internal {
namespace {

constexpr int kAxis = 0;

// The stab rule for rational points: stab_facet has it for binary64.
Stab stab(const std::array<ExactPoint, 3>& t, const ExactPoint& q) {
  bool is_odd = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const ExactPoint &a = t[i], &b = t[(i + 1) % 3];
    const bool is_low = a[2] <= q[2];
    if (is_low == (b[2] <= q[2])) continue;
    const ExactPoint &low = is_low ? a : b, &high = is_low ? b : a;
    is_odd ^= orient2d(low, high, q, kAxis) == Sign::kPositive;
  }
  if (!is_odd) return Stab::kMiss;
  const Sign ahead = -orient3d(t[0], t[1], t[2], q) * orient2d(t[0], t[1], t[2], kAxis);
  if (ahead == Sign::kZero) return Stab::kTouch;
  return ahead == Sign::kPositive ? Stab::kHit : Stab::kMiss;
}
Stab stab(const TriangleMesh& mesh, std::uint32_t f, const ExactPoint& q) {
  const auto& t = mesh.faces[f];
  return stab({to_rational(mesh.positions[t[0]]), to_rational(mesh.positions[t[1]]),
               to_rational(mesh.positions[t[2]])},
              q);
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

WindingChange change_along_ray(const TriangleMesh& mesh, const ExactPoint& q,
                               const MeshShells* shells) {
  return change_to(mesh, q, shells);
}

}  // namespace veritope::internal
