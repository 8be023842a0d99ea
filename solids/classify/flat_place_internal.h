// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/flat_place_internal.h: where a point lies with respect to a patch in one plane: by the sign of the
// plane and, of points in it, by the winding number of the border.  Theory: docs/THEORY.md, POINT-4.
// Internal to solids/classify.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "robust/dyadic.h"
#include "solids/classify/algebraic_number.h"
#include "solids/classify/axis_ray.h"
#include "solids/classify/ray_descent_internal.h"
#include "solids/classify/ray_point.h"
#include "solids/classify/tensor_form.h"

namespace veritope::internal {

/// Positive on the side to which the normal points.
Sign side_of(const FormPlane& plane, const RayPoint::Fractions& q);

/// How a patch in a plane that the point is off lies to a ray from the point.
RayPlace place_beside(const FormPlane& plane, Sign side, const AxisRay& ray);
/// Whether the ray leaves the plane at once.
bool passes_through(const FormPlane& plane, const AxisRay& ray);

/// The control points of a flat patch relative to a point of its plane, seen along an axis that passes through it.
class FlatPlace {
 public:
  /// REQUIRES form.plane, and that it holds the point.
  FlatPlace(const TensorForm& form, const RayPoint& point);

  struct OfBorder {
    std::optional<AlgebraicPair> parameters;  ///< if the border passes through the point
    int winding = 0;                          ///< otherwise, of the border around the point
  };
  /// What the image of the border of the square says.
  OfBorder border() const;

  /// Whether the image of the border of [lo, hi], a part of the square, misses the point and has a winding number
  /// around it other than 0: then the patch has the point at parameters inside of the part.
  bool is_inside(const std::array<Dyadic, 2>& lo, const std::array<Dyadic, 2>& hi) const;

 private:
  /// The line of parameters where that of `across` is `at`, from `from` to `to`.
  std::array<std::vector<Integer>, 2> line_at(std::size_t across, const Dyadic& at,
                                              const Dyadic& from, const Dyadic& to) const;

  const TensorForm& form_;
  std::array<std::vector<Integer>, 2> net_;
};

}  // namespace veritope::internal
