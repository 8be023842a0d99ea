// SPDX-License-Identifier: LGPL-3.0-or-later
// render/ray_caster_internal.h: where a ray meets a solid first, by exact answers about points and boxes alone: the
// points Q with f(Q) = 1 of seed 001 [GRF03], section 6.
#pragma once
#include <optional>

#include "render/value_cells_internal.h"

namespace veritope::internal {

struct RayHit {
  double t = 0;
  bool is_cut = false;   ///< on the side of the box: the solid goes on outside of it
  bool is_thin = false;  ///< found by boxes alone: strides pass over it
};

struct RayAnswer {
  std::optional<RayHit> hit;
  bool met_cells = false;  ///< the ray met a cell that is not 0
};

class RayCaster {
 public:
  /// Lengths are in units of t, which are sides of samples.
  static constexpr double kStride = 3, kThin = 1, kThinnest = 0x1p-5, kTolerance = 0x1p-4;

  /// Keeps references.
  RayCaster(const SolidProbe& solid, const ValueCells& cells) : solid_(solid), cells_(cells) {}

  /// The first hit, looked for first where it is guessed to be; its place depends on the guess, up to the tolerance.
  /// A ray that is in the solid right after it enters the box of the cells hits there.
  /// Claim    The point at the hit's t is in the solid, and one at most kTolerance before it is not; or the solid has
  ///          its own walls (SolidProbe) and may have one within kThinnest of the hit. Points before the hit are off
  ///          the solid, except perhaps in cells whose value is mixed: there for less than kStride of the ray beside
  ///          a hit, or kThinnest elsewhere. All this up to the rounding of points of the ray.
  /// @param with_thin  false: less than kStride elsewhere, too
  RayAnswer first_hit(const ParametricRay& ray, std::optional<double> guess,
                      bool with_thin = true) const;

 private:
  const SolidProbe& solid_;
  const ValueCells& cells_;
};

}  // namespace veritope::internal
