// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge_front.h: where the wall of a bridge lies on the side to which the bridge leads, and the
// cap there. Section 7 of docs/certificates/microstructure.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "solids/micro/microstructure.h"
#include "solids/micro/tile_analysis.h"
#include "splines/bezier.h"

namespace veritope {

/// The plane x_axis = at in the parameters of `volume`. Beyond it is x_axis > at if it is upward, else x_axis < at.
struct BridgeFront {
  std::uint32_t volume = 0;
  std::size_t axis = 0;
  bool is_upward = true;
  Rational at;
  bool is_in_face = false;  ///< the wall lies in a face of its volume, which is glued

  bool is_beyond(const Rational& x) const { return is_upward ? x > at : x < at; }
};

/// Nothing if the wall lies in a face of its volume that is not glued.
/// REQUIRES a wall of a cell, and that the cage is that of micro.
std::optional<BridgeFront> front_of(const Microstructure& micro, const VModel& cage,
                                    const CapPlace& cap);

/// The cap in the wall, with the numbers of its cell, as a map into the parameters of the front's volume. Nothing
/// unless all patches in the wall make one cap, which is one patch.
/// REQUIRES a cell with a tile, the analysed tiles of micro, and the front of the cap.
std::optional<BezierSurface<Rational>> cap_on_front(const Microstructure& micro, const VModel& cage,
                                                    const std::vector<AnalysedTile>& tiles,
                                                    const CapPlace& cap, const BridgeFront& front);
/// With axes exchanged if its normal does not point beyond the front.
BezierSurface<Rational> turned_beyond(BezierSurface<Rational> cap, const BridgeFront& front);

/// A symmetry s of the parameters' square, from 0 to 7, that makes the first list of the bridge the cap, in whatever
/// degrees: cap(x, y) = b(u, v, 0), where (u, v) is (x, y) with 1 - x for x if s has the bit 2, 1 - y for y if it has
/// the bit 4, then exchanged if it has the bit 1. Nothing if no symmetry does it.
std::optional<unsigned> start_symmetry(const MicroBridge& bridge,
                                       const BezierSurface<Rational>& cap);

}  // namespace veritope
