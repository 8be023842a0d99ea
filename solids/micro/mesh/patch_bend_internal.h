// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/patch_bend_internal.h: how far a mapped patch may bend away from bilinear parts. Internal to
// solids/micro/mesh.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "interval/box.h"
#include "solids/micro/mesh/cage_cells_internal.h"
#include "solids/micro/micro_tile.h"

namespace veritope::internal {

/// The derivatives of a patch along u and along v. All functions REQUIRE a live ScopedUpward.
class PatchBend {
 public:
  explicit PatchBend(const TilePatch& patch);

  /// Upper bounds of an eighth of the lengths of the second derivatives, along u and along v, of a map after the patch
  /// whose wall has a parameter in t: S -> T(S) has T_ab S_a S_b + T_a S'_a, summed over the axes a, b.
  std::array<double, 2> of(const CellMapBounds& map, const Interval& t) const;

 private:
  // Bernstein coefficients of a derivative: for each of them, those of 1, t, t^2, ...
  struct Derivative {
    std::vector<Box3> coefficients;
  };
  std::array<Interval, 3> bounds_of(const Derivative& d, const Interval& t) const;

  std::size_t num_powers_;
  std::array<Derivative, 2> first_, second_;
};

}  // namespace veritope::internal
