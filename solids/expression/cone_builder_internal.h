// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/cone_builder_internal.h: tangent cones, put together from the patches at a point.
#pragma once
#include <array>
#include <optional>

#include "solids/expression/patch_jet_internal.h"
#include "solids/expression/tangent_cone.h"
#include "solids/patches/patch_complex.h"

namespace veritope::internal {

/// Takes one patch after the other. False: the patch has no sector there, since its normal is 0 or not known.
class ConeBuilder {
 public:
  bool add_interior(const Patch& patch, std::uint32_t number, const DomainPlace& at);
  bool add_side(const Patch& patch, std::uint32_t number, std::uint32_t side, const Rational& at);
  bool add_corner(const Patch& patch, std::uint32_t number, std::uint32_t corner);
  /// The apex is a collapsed side: adds the sectors that the next row of control points spans with it, if they all are
  /// in one plane, and turn around the apex in one direction.
  bool add_pole(const Patch& patch, std::uint32_t number, std::uint32_t side);
  /// At irrational parameters: the boxes that hold the place, of a patch that is not flat, and the normal there.
  bool add_enclosed_interior(const Patch& patch, std::uint32_t number,
                             const std::array<ExactInterval, 2>& at);
  /// On a common side of two patches at an irrational parameter: boxes that hold both normals.
  /// @param along  the parameter of the first patch's side in its direction of travel; the other one has 1 - t
  void add_enclosed_edge(const std::array<const Patch*, 2>& patches,
                         const std::array<PatchSide, 2>& sides, const ExactInterval& along);
  /// Places whose parameters are irrational: of flat patches and straight sides only.
  bool add_flat_interior(const Patch& patch, std::uint32_t number);
  bool add_flat_side(const Patch& patch, std::uint32_t number, std::uint32_t side);
  /// Nothing if two sectors have more than rims in common: then they do not tell which directions are inside.
  std::optional<TangentCone> take();

 private:
  ConeSheet& add(Sector sector, const Patch& patch, std::uint32_t number);

  TangentCone out_;
};

}  // namespace veritope::internal
