// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_weld.h: makes faces of cells equal that nearly are.
// Design: docs/design/0066-welded-volumes.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "robust/base/result.h"
#include "solids/vmodel/v_model.h"

namespace veritope {

/// All control points of cells that change.
inline constexpr std::uint64_t kMaxWeldControlPoints = std::uint64_t{1} << 24;
/// Pairs of faces whose middles are near, beside 4 for each face that is not glued.
inline constexpr std::uint64_t kMaxWeldCandidates = std::uint64_t{1} << 17;

/// Two faces that are glued now and were not. They were near, or all of their sides became equal through other faces.
struct VWeldedPair {
  VFaceNumber winner = 0, loser = 0;
  std::uint8_t symmetry = 0;  ///< takes the parameters of the winner to those of the loser
  Rational distance;          ///< before: see near faces
  Rational displacement;      ///< the longest way of a control point of the two faces
};

/// Why two faces whose corners are near stay apart.
enum class VApartReason : std::uint8_t {
  kControlPoints,  ///< other control points are not near
  kWeights,        ///< their weights are not proportional
  kSeveral,        ///< one of them is near to more than one face
  kGlued,          ///< they are near, but the second is equal to another face
  kTooFar,         ///< a control point would have to move too far: faces that are near in a chain
  kCollapse        ///< an edge or a face would collapse, or a face would be turned
};
/// The stable name, for reports: "control-points", "weights", "several", "glued", "too-far", "collapse".
const char* v_apart_reason_name(VApartReason reason);

struct VApartPair {
  VFaceNumber first = 0, second = 0;
  VApartReason reason = VApartReason::kControlPoints;
  std::optional<Rational> distance;  ///< of all control points; nothing for kWeights
};

struct VWeld {
  std::vector<VVolume> cells;  ///< all of them; the maps of those that are not changed are as given
  std::vector<std::uint32_t> changed;  ///< ascending
  std::vector<VWeldedPair> welded;     ///< by the lesser of their faces
  /// By their faces; of many faces that are near to each other only so many pairs that each has two.
  std::vector<VApartPair> apart;
  Rational largest_displacement;  ///< of all control points of all cells
  std::optional<std::uint32_t>
      farthest;  ///< a cell with that displacement; nothing if nothing moves
  std::uint64_t glued_before = 0, glued_after = 0;  ///< pairs
};

/// Makes faces equal that are near, so that make_v_model glues them (left-handed cells reversed).
///
/// Two faces that are not collapsed and are not glued are *near* if a symmetry that glues them (see make_v_model) takes
/// the one to the other so that, in their common function space, weights agree up to one factor, and no coordinate of
/// two control points with one number differs by more than eps. That largest difference is their *distance*; so no two
/// points of the faces with the same parameters are farther apart in a coordinate. A pair is welded if both are near to
/// no other face, those that are glued included. Then
///  1. corners that are one through equal or welded faces, and those that are equal already, become one point;
///  2. edges that are one in the same way become one curve with these ends;
///  3. faces that are welded or equal become one surface with these sides.
/// The simpler face wins: the lower sum of degrees, then fewer control points, then constant weights, then the lower
/// number. So do its edges and corners; if one of those is too far from another one of its class, the middle of all
/// takes its place. The other face takes the exact image in its cell's function space, which grows where it has to; the
/// map inside of a cell changes only by the control points on its border. Weights and attributes are never changed.
///
/// Pairs are taken in the order of their distance. A pair stays apart if otherwise a control point would move by more
/// than eps in a coordinate, or an edge or face would collapse. So no point of a cell moves by more than eps in a
/// coordinate.
/// The result is checked before it is returned: each welded pair is glued, and what was glued still is. Without a near
/// pair nothing changes.
/// @param eps  in model units, > 0 (REQUIRES)
/// @error as make_v_model; kOverLimit for more than kMaxWeldCandidates pairs of faces that may be near each other (eps
///        is large for the model), and where welded cells would have more than kMaxWeldControlPoints
/// @cost  near-linear in the control points, if few pairs of faces have near corners and few pairs are refused
Result<VWeld> weld(std::vector<VVolume> cells, const Rational& eps);

}  // namespace veritope
