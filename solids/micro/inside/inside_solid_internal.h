// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/inside_solid_internal.h: what the conditions I1 to I4 ask of the solid M, whatever bounds it: its
// surface, where points lie, its shells. Internal to solids/micro/inside.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "predicates/vec.h"
#include "solids/classify/point_answer.h"
#include "solids/classify/value3.h"
#include "solids/micro/inside/micro_inside.h"
#include "solids/micro/surface/solid_surface.h"

namespace veritope::internal {

/// An approximate point of a surface, with a vector that points out of the solid there, of length 1, and a length that
/// the surface has near it.
struct SurfaceSpot {
  Point3d at{}, normal{};
  double size = 0;
};

/// Immutable: threads share it.
class InsideSolid {
 public:
  virtual ~InsideSolid() = default;
  virtual const SolidSurface& surface() const = 0;

  /// One if all points of the box are in the interior of M, zero if they are off M. REQUIRES a finite box that is not
  /// empty.
  virtual Value3 value(const Box3d& box) const = 0;
  /// With the innermost shell around the point.
  virtual PointAnswer classify(const ExactPoint& point) const = 0;

  /// The number of shells around each shell.
  virtual const std::vector<std::uint32_t>& depths() const = 0;
  /// The first triangle or patch of a shell.
  virtual std::uint32_t first_source(std::uint32_t shell) const = 0;
  virtual Box3d box_of_shell(std::uint32_t shell) const = 0;
  /// Spots of a shell, `most` or fewer.
  virtual std::vector<SurfaceSpot> spots(std::uint32_t shell, std::size_t most) const = 0;

  /// "triangle 5", "surface 2, span (0, 1)".
  virtual std::string name(std::uint32_t source) const = 0;
  /// "triangles", "patches of the model".
  virtual const char* sources() const = 0;
};

/// REQUIRES a mesh that bounds a solid. The mesh must outlive it.
std::unique_ptr<const InsideSolid> inside_solid(const InsideModel& model);
/// REQUIRES a complex that bounds a solid. It must outlive it.
std::unique_ptr<const InsideSolid> inside_solid(const PatchComplex& complex);

}  // namespace veritope::internal
