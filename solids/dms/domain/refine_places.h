// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/refine_places.h: places for new vertices, chosen in binary64; the chosen points are exact. No
// decision depends on these choices, only how many vertices are needed.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "predicates/exact_point.h"
#include "predicates/vec.h"
#include "solids/dms/domain/refine_mesh.h"

namespace veritope {

struct ApproxSphere {
  Vec3d centre;
  double radius = 0;
};
/// Not finite for what is flat.
ApproxSphere approx_circumsphere(const std::array<Vec3d, 4>& tetrahedron);
ApproxSphere approx_circumcircle(const std::array<Vec3d, 3>& triangle);
double approx_volume(const std::array<const ExactPoint3*, 4>& tetrahedron);
double approx_distance(const Vec3d& a, const Vec3d& b);
/// Whether the sphere with the diameter a b contains c.
bool is_in_diametral_sphere(const Vec3d& c, const Vec3d& a, const Vec3d& b);

/// A point with short binary64 coordinates nearer to `at` than size / 256. REQUIRES finite arguments, size > 0.
ExactPoint3 short_point(const Vec3d& at, double size);
/// A point exactly in the plane of the frame, nearer to the foot of `at` than about size / 256; nothing if it cannot be
/// found in binary64.
std::optional<ExactPoint3> short_point_in_plane(const std::array<ExactPoint3, 3>& frame,
                                                const Vec3d& at, double size);
/// a + (b - a) times `part`, a number of ten binary digits after the point, exactly.
ExactPoint3 point_between(const ExactPoint3& a, const ExactPoint3& b, double part);

/// Where the way from a tetrahedron straight to a point ends.
struct RefineWalk {
  enum class End { kInside, kBlocked, kLost } end = End::kLost;
  std::uint32_t at =
      0;  ///< the closed tetrahedron that contains the point, or the face of the boundary in the way
};
RefineWalk walk_to(const RefineMesh& mesh, std::uint32_t from, const ExactPoint3& to);

}  // namespace veritope
