// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/tangent_cone.h: how the boundary of a solid leaves one of its points: in which directions, and
// along which surfaces.  Theory: docs/THEORY.md, POINT-7 and POINT-8.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "robust/base/sign.h"
#include "solids/expression/flat_cone.h"
#include "solids/patches/patch.h"

namespace veritope {

/// What bounds a sheet along a rim of its sector.
struct SheetRim {
  bool is_straight = true;
  bool is_cut = false;           ///< nothing: the sheet continues in the next sector
  const Patch* patch = nullptr;  ///< unless straight or cut: the curve is a side of this patch
  std::uint32_t side = 0;
  Rational at;  ///< where on the side the apex is, in the direction of travel
};

/// A part of a patch around the apex, or of a plane.
struct ConeSheet {
  bool is_flat = true;
  std::uint32_t number = 0;      ///< of the facet or patch
  const Patch* patch = nullptr;  ///< unless flat
  /// The parameters of the apex: a point of the domain, if it is regular and rational.
  std::array<Rational, 2> at;
  std::optional<std::uint32_t> pole;  ///< the collapsed side
  std::array<Rational, 2> pole_part;  ///< the part of that side whose directions the sector has
  std::array<SheetRim, 2> rims;  ///< along the first and the last ray of the sector, if it has rims
};

/// The directions in which the boundary leaves one of its points: the sectors of all patches at the face, edge or
/// vertex that holds the point. They meet in rims only.
struct TangentCone {
  FlatCone sectors;
  std::vector<ConeSheet> sheets;  ///< of each sector
  bool is_flat = true;            ///< near the point the boundary is the cone itself
  /// Inside a patch at irrational parameters there is one sheet, and no sector but these boxes, which hold the
  /// parameters and the normal.
  struct Enclosure {
    std::array<ExactInterval, 2> at;
    std::array<ExactInterval, 3> normal;
  };
  std::optional<Enclosure> enclosure;
  /// On the common side of two patches, at an irrational parameter, there is no sector either, but boxes that hold
  /// positive multiples of their normals.
  struct EnclosedEdge {
    std::array<std::array<ExactInterval, 3>, 2> normals;
    /// Positive: the solid has less than a half turn there; negative: more; zero: that is not known.
    Sign convexity = Sign::kZero;
    /// The whole plane of a patch that is flat, which holds the edge. With less than a half turn the solid is behind it
    /// near the apex, with more all points behind it are in the solid.
    std::optional<Sector> plane;
  };
  std::optional<EnclosedEdge> edge;
  bool is_enclosed() const { return enclosure || edge; }
  /// The parameters at which a patch of this solid has a point, if that is found and rational. Set by solids with
  /// patches.
  std::function<std::optional<std::array<Rational, 2>>(const Patch&, const ExactPoint&)> place_of;
};

/// The cone of a solid that is flat at the point, with straight rims.
TangentCone flat_tangent_cone(FlatCone sectors);

}  // namespace veritope
