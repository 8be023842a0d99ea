// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/curve_bridges.h: algorithms 3 and 4 of [HPE22] for tiles of curves: each free end of a curve is
// continued to the surface of the solid by a quadratic curve in space. Design: docs/design/0086-bridges-of-curves.md.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/bridge/build_bridges.h"
#include "solids/micro/bridge/skin_foot.h"
#include "solids/micro/curve_ends.h"
#include "solids/micro/filter/tile_filter.h"

namespace veritope {

/// A quadratic Bezier curve in space. points[0] is the end of the curve, and points[1] lies on the curve's tangent
/// there, exactly.
struct CurveBridge {
  CurveEnd end;
  std::array<std::array<Rational, 3>, 3> points;
};

struct CurveBridges {
  std::vector<CurveBridge> bridges;  ///< by ascending ends
  /// caps counts free ends. Dropped are those without a tangent (kFolded), and those of which no try was proved
  /// (kSkin); there is no other reason. `kink` is 0, since tangents are exact. Neither `without` nor tries are noted.
  BridgeReport report;
};

/// Adds nothing to the microstructure. Each bridge is proved to lie in the interior of the solid, and to end within
/// `skin` of its surface: q is the end p moved by alpha times its distance from the surface along the tangent, where
/// the paper takes the normal of a face; r is the point of the surface nearest to q, drawn back towards q. If that is
/// not proved, up to 7 others are tried, nearer and deeper. Bridges may cross each other and the tiles' curves: curves
/// bound nothing.
/// REQUIRES open tiles that are proved to lie in the interior of the solid of the filter, whose surface the feet are
/// on; what free_curve_ends requires; 0 < alpha <= 1, skin > 0.
/// @error kOverLimit: more than kMaxMicroBridges free ends
/// @cost  some tenths of a millisecond for each end
Result<CurveBridges> build_curve_bridges(const TileFilter& filter, const SkinFeet& feet,
                                         const Microstructure& micro, const BridgeOptions& options);
/// True only if the Bezier curve with these control points lies in the interior of the filter's solid. REQUIRES as
/// TileFilter::find, with 2 to 16 points.
bool is_curve_inside(const TileFilter& filter, const std::vector<std::array<Rational, 3>>& points);

}  // namespace veritope
