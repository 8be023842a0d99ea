// SPDX-License-Identifier: LGPL-3.0-or-later
// render/dms_field.h: what a picture of a simplex-spline solid shows, and where.
// Design: docs/design/0106-pictures-in-the-solid.md.
#pragma once
#include <cstddef>

#include "render/dms_rays.h"
#include "solids/dms/fast/dms_inverse.h"

namespace veritope {

/// A component of a spline: in the domain, or in the solid, where the value at s(u) is that at u. What it points to
/// must outlive it.
struct DmsField {
  const DmsModel* spline = nullptr;  ///< the model, or its attribute domain
  std::size_t component = 0;
  /// The inverse of the map s; null: the picture is of the domain. REQUIRES the component itself in it if `spline` has
  /// coordinates.
  const DmsInverse* solid = nullptr;

  /// @error kNotFinite for coefficients of the component beyond binary64
  Status check() const;
  /// The least box around what can be seen.
  Box3d box() const { return solid != nullptr ? solid->box() : domain_box(*spline); }
};

}  // namespace veritope
