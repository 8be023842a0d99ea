// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/mesh_classifier.h: is a point in, on or out of a closed mesh? Exactly, for every point.
// Theory: docs/THEORY.md, exact point classification.  Design: docs/design/0055-points-of-meshes.md.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "predicates/vec.h"
#include "robust/base/box3d.h"
#include "robust/base/result.h"
#include "solids/classify/lookup_size.h"
#include "solids/classify/point_answer.h"
#include "solids/classify/value3.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// The shells of a valid mesh, so that answers can name them.
struct MeshShells {
  std::vector<std::uint32_t> shell_of_face;
  std::vector<std::uint32_t> depth;  ///< for each shell, the number of shells around it
};

/// How finely a look-up divides space. Answers do not depend on it.
enum class LookupDetail {
  kForPoints,  ///< many points: the fastest answers
  kForBoxes,   ///< some thousands of boxes and points: half the time of building
};

/// Answers for points with respect to one mesh. Immutable: threads may share it.
/// The winding number is that of the closed oriented surface; of a mesh that bounds a solid it is 1 inside, 0 outside.
/// Each answer is exact: an octree finds the few facets near the point, and signs of determinants count those between
/// the point and a reference point of the cell.
class MeshClassifier {
 public:
  /// REQUIRES finite coordinates, ids in range, fewer than 2^31 faces; `shells`, if given, of a mesh that bounds a
  /// solid. The mesh must outlive the classifier.
  /// @error kBadArgument if the triangles are no closed chain: an edge is not used equally often in both directions
  /// @cost  near-linear in the facets; approximately 150 bytes a facet
  static Result<MeshClassifier> make(const TriangleMesh& mesh, const MeshShells* shells = nullptr,
                                     LookupDetail detail = LookupDetail::kForPoints);
  /// A temporary mesh would be gone before the first point.
  static Result<MeshClassifier> make(TriangleMesh&&, const MeshShells* = nullptr,
                                     LookupDetail = LookupDetail::kForPoints) = delete;

  MeshClassifier(MeshClassifier&&) noexcept;
  ~MeshClassifier();

  /// REQUIRES finite coordinates.
  PointAnswer classify(const Vec3d& point) const;
  /// For coordinates that binary64 does not have; slower by a factor of a hundred.
  PointAnswer classify(const ExactPoint& point) const;
  /// All at once, by `jobs` threads; the answers do not depend on their number. REQUIRES equal sizes.
  void classify(std::span<const Vec3d> points, std::span<PointAnswer> answers, unsigned jobs) const;

  /// 0 or 1 if no facet meets the closed box and its points have the winding number 0, or another one; otherwise mixed,
  /// also if the surface only touches the box. Exact. REQUIRES a finite box that is not empty.
  /// @cost  the cells of the octree that meet the box, and their facets
  Value3 value(const Box3d& box) const;
  /// All facets that contain the point, in increasing order. REQUIRES finite coordinates.
  std::vector<std::uint32_t> facets_at(const Vec3d& point) const;
  std::vector<std::uint32_t> facets_at(const ExactPoint& point) const;
  /// In increasing order, facets whose boxes meet the closed box: all that meet it themselves, and perhaps others.
  /// REQUIRES a box that is not empty.
  std::vector<std::uint32_t> facets_near(const Box3d& box) const;

  /// The box of the facets.
  const Box3d& box() const;
  LookupSize lookup() const;

  class Body;

 private:
  explicit MeshClassifier(std::unique_ptr<const Body> body);
  std::unique_ptr<const Body> body_;
};

}  // namespace veritope
