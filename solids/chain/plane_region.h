// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/plane_region.h: is a point in, on or out of a region of the plane that closed loops of curves bound?
// Theory: docs/THEORY.md, CHAIN-5.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/chain/plane_arc.h"
#include "solids/base/box_hierarchy.h"

namespace veritope {

/// Where a point lies with respect to the loops.
struct PlaneAnswer {
  /// A curve that contains the point, the first of several, and a parameter of it.
  std::optional<std::uint32_t> arc;
  ArcParameter parameter{};
  std::int32_t winding = 0;  ///< of the loops around a point off them

  bool is_on() const { return arc.has_value(); }
  /// Definition 4 of seed 001: f != 0. The loops may cross, and need not be oriented alike.
  bool is_in() const { return winding != 0; }
};

/// Closed loops of curves: as many of them end at each point as start there. They are not certified to bound anything:
/// f is their winding number. Immutable: threads may share it. Every answer is exact and decided.
class PlaneRegion {
 public:
  /// @error kBadArgument if the loops are not closed: names the first curve with an end at which they are open, by
  ///        Place::entity, its number
  static Result<PlaneRegion> make(std::vector<PlaneArc> arcs);

  const std::vector<PlaneArc>& arcs() const { return arcs_; }
  PlaneAnswer classify(const PointIn<2>& q) const;

 private:
  explicit PlaneRegion(std::vector<PlaneArc> arcs);

  std::vector<PlaneArc> arcs_;
  BoxHierarchy boxes_;
};

}  // namespace veritope
