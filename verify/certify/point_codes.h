// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/point_codes.h: what certificates say of a point with respect to one solid: a direction in which little
// stands in the way, or where the point lies.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>

#include "solids/classify/patch_classifier.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "verify/format/points_certificate.h"

namespace veritope {

struct RayDirection {
  std::uint8_t code = 0;    ///< as docs/certificates/points.md, section 3, has it
  std::uint64_t units = 0;  ///< of work of the checkers, as section 5 counts them
};

/// Directions in which few facets of a mesh stand.
class MeshDirections {
 public:
  /// The mesh must outlive this. REQUIRES at least one face.
  MeshDirections(const TriangleMesh& mesh, unsigned jobs);
  MeshDirections(MeshDirections&&) noexcept;
  ~MeshDirections();

  /// The first of six with few boxes on its way; the meaning of few grows until there is one.
  RayDirection from(const Vec3d& point) const;

 private:
  class Boxes;
  std::unique_ptr<const Boxes> boxes_;
};

/// Directions in which patches end soonest: few of them lie there.
class PatchDirections {
 public:
  explicit PatchDirections(const PatchComplex& complex);
  std::uint8_t from(const Vec3d& point) const;

 private:
  Box3d box_;  // approximately
};

struct CertifiedPlace {
  std::variant<certificate::PointOnPatch, certificate::AlgebraicPointOnPatch> code;
  /// Checkers know at which face, edge or vertex of the complex it is: the parameters are rational, or checkers see
  /// that they are in the interior of the patch's domain.
  bool is_located = true;
};

/// Nothing for irrational parameters for which no common generator was found.
std::optional<CertifiedPlace> place_on_patch(const PatchComplex& complex, const OnPatch& where);

}  // namespace veritope
