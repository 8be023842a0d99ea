// SPDX-License-Identifier: LGPL-3.0-or-later
// render/dms_surface_scene.h: surfaces of a simplex-spline solid as scenes: its boundary, and where an attribute has a
// value.
// Source: [HHQ04] section 6.2.  Design: docs/design/0101-pictures-of-simplex-spline-solids.md.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "render/scene.h"
#include "robust/base/result.h"
#include "solids/dms/dms_iso.h"
#include "solids/dms/dms_model.h"
#include "solids/dms/dms_surface.h"

namespace veritope {

struct DmsSurfaceOptions {
  bool in_solid = true;                  ///< else in the domain
  std::optional<std::size_t> component;  ///< that colours show; nothing: one colour
  std::optional<std::array<double, 2>>
      range;  ///< of colours; nothing: all values of points that are drawn
  std::uint8_t opacity = 255;
};

struct DmsSurfaceView {
  SceneSurface surface;
  std::array<double, 2> range{};  ///< of the colours, if they show a component
};

/// Each piece of the boundary cut into K^2 triangles, where K is the same for all: at most 24, and so that there are at
/// most approximately 2^18 triangles; 1 if the drawn components are linear. Points lie on the surface, up to rounding;
/// normals are those of the map.
/// @error kNotFinite for coordinates or values beyond binary64; kEmpty without a piece
Result<DmsSurfaceView> view_of_boundary(const std::vector<DmsBoundaryPiece>& pieces,
                                        const DmsSurfaceOptions& options);

/// The mesh of find_dms_iso in the domain, or its image, with normals from the gradient of the component. A vertex that
/// rounding moves outside of the domain has the image and the normal of its exact place.
/// REQUIRES a model without defects, component < model.num_components(), and an `iso` in the domain that has places.
/// @error kNotFinite for images beyond binary64
Result<SceneSurface> view_of_iso(const DmsModel& model, std::size_t component, const DmsIso& iso,
                                 bool in_solid);

}  // namespace veritope
