// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/surface/solid_surface.h: the surface of a solid M, whatever it is made of, as parts that may be proved
// apart from nodes of a microstructure, or near all points of one: docs/certificates/micro-inside.md, sections 3, 6, 8.
// Design: docs/design/0089-microstructures-in-solids-of-patches.md.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solids/micro/surface/node_points.h"

namespace veritope {

/// Numbers of parts of a surface: triangles, or nodes of patches. They are those of one view.
using PartNumbers = std::vector<std::uint32_t>;

/// The surface as one thread sees it. All functions REQUIRE a live ScopedUpward.
class SurfaceView {
 public:
  virtual ~SurfaceView() = default;

  /// Parts that cover what the surface has in the box: those whose boxes meet it.
  virtual PartNumbers near(const Box3d& box) = 0;
  /// Removes the parts that are apart from the node with these points, which has one list for each part of the cage
  /// that it meets; may replace others by smaller ones.
  /// @return  how many parts were compared with it whose boxes meet its own
  virtual std::uint64_t keep_close(std::span<const NodePoints> node, PartNumbers* parts) = 0;
  /// A bound of the distances of all these points from one part: no point of their hull is farther from it. Infinite if
  /// none is found that is at most `most`. The search is for one that is close to the least, or at most `enough`.
  virtual double reach(std::span<const Box3> points, double most, double enough = 0) = 0;
  /// The triangle or the patch that the part belongs to.
  virtual std::uint32_t source(std::uint32_t part) const = 0;
};

/// Immutable: threads may share it.
class SolidSurface {
 public:
  virtual ~SolidSurface() = default;
  virtual std::unique_ptr<SurfaceView> view() const = 0;
  /// Contains the surface.
  virtual const Box3d& box() const = 0;
};

}  // namespace veritope
