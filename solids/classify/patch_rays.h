// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/patch_rays.h: the winding number of a closed patch complex around a point, by a ray along a
// coordinate axis: in doubles where they decide, else in integers. Theory: docs/THEORY.md, POINT-3.
#pragma once
#include <span>
#include <vector>

#include "solids/classify/axis_ray.h"
#include "solids/classify/ray_point.h"
#include "solids/classify/tensor_form.h"
#include "solids/base/box_hierarchy.h"

namespace veritope {

/// What a ray found.
struct RayCount {
  enum class State {
    kCounted,
    kOpen,  ///< pieces remain on which the point may lie
    kLost   ///< the numbers, or the limit of work, did not suffice
  };
  State state = State::kLost;
  ShellWindings windings;       ///< kCounted: those that are not 0
  std::vector<OpenPiece> open;  ///< kOpen
};

class PatchRays {
 public:
  /// REQUIRES a closed oriented surface with weights > 0.
  explicit PatchRays(const PatchComplex& complex);
  /// A closed chain of patches, whose coordinates were divided by 2^scale; numbers of edges are below 2^31.
  PatchRays(std::vector<TensorForm> forms, int scale);

  int scale() const { return scale_; }
  const TensorForm& form(std::uint32_t patch) const { return forms_[patch]; }
  std::size_t num_patches() const { return forms_.size(); }
  const Box3d& hull() const { return hull_; }
  /// Contains all points of a patch, divided as the nets.
  const Box3d& box(std::uint32_t patch) const { return boxes_of_patches_[patch]; }
  std::uint64_t bytes() const;

  /// Whether hulls of pieces, cut until they are small beside the box, all miss it; the box is divided as the nets.
  bool misses(const Box3d& box) const;
  /// Whether this holds for patches first, ..., last - 1, each of which is looked at.
  bool misses(const Box3d& box, std::uint32_t first, std::uint32_t last) const;

  /// The windings that patches first, ..., last - 1, a closed chain, have around the point, along ray_from; in doubles,
  /// then in integers, down to pieces of 2^-levels of a patch. Open if the point may be on one of them.
  RayCount count_some(const RayPoint& point, std::uint32_t first, std::uint32_t last,
                      int levels) const;

  /// The ray along which the point is nearest to the end of the hull; among those that pass through all planes of
  /// `off`, if there are any.
  AxisRay ray_from(const RayPoint& point, std::span<const std::uint32_t> off = {}) const;
  /// @param shell  patches of other shells are ignored; PatchComplex::kNone: none is
  RayCount count_rounded(const RayPoint& point, const AxisRay& ray,
                         std::uint32_t shell = PatchComplex::kNone) const;
  /// Pieces are halved `levels` times along an axis, then they are open; those of flat patches only if the point is in
  /// the plane.
  /// @param off  flat patches that the point is known to be off, although it is in their planes
  RayCount count_exactly(const RayPoint& point, const AxisRay& ray, int levels,
                         std::uint32_t shell = PatchComplex::kNone,
                         std::span<const std::uint32_t> off = {}) const;

 private:
  PatchRays(const PatchComplex& complex, int scale);
  template <typename Visit>
  void visit_patches(const RayPoint& point, const AxisRay& ray, std::uint32_t shell,
                     Visit visit) const;

  int scale_;
  std::vector<TensorForm> forms_;
  std::vector<Box3d> boxes_of_patches_;
  Box3d hull_;
  BoxHierarchy boxes_;
};

}  // namespace veritope
