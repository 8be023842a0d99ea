// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/patch_facts.h: what certify says of a model of patches beside its verdict.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interval/interval.h"
#include "solids/patches/open_borders.h"
#include "verify/certify/patch_collar.h"
#include "verify/certify/patch_decision.h"
#include "verify/certify/vmodel_facts.h"

namespace veritope {

/// The coarsest collar that was found around the surface, or the reason why none was found.
struct CollarFacts {
  std::optional<Finding> open;  ///< iff none was found
  std::uint64_t cells = 0;
  /// The edge of a cell of level l is 2^-l of the root's edge; lengths are in the model's units.
  unsigned coarsest_level = 0, finest_level = 0;
  double longest_edge = 0, shortest_edge = 0;
};
/// REQUIRES the forest that was searched.
CollarFacts collar_facts(const PatchCollarSearch& search, const PieceForest& forest);

/// An open side of the complex as a part of its entity: see OpenSide.
struct OpenSideFacts {
  EntityPart part;
  OpenSide side;
  std::optional<EntityPart> near;
};

struct PatchFacts {
  std::uint64_t patches = 0, edges = 0, vertices = 0, shells = 0;  ///< 0 patches: none were made
  std::vector<std::uint64_t>
      reversed;  ///< entities that PatchOrientation::kAuto reversed, ascending
  /// The model is wrong, or not decided, because patches or shells face the wrong way, and PatchOrientation::kAuto,
  /// which was not requested, reverses them; nothing else is known to be wrong then. In a file of volumes:
  /// cells are left-handed.
  bool auto_helps = false;
  std::uint64_t boxes_tried = 0;
  OpenBorders open;
  std::vector<OpenSideFacts> open_sides;  ///< the longest, at most CertifyOptions::max_findings
  // Facts of a valid model; otherwise 0, or nothing.
  std::uint64_t bodies = 0, genus = 0, boxes = 0;
  std::vector<PatchShellFacts> shell_facts;
  std::optional<Interval> volume;     ///< an enclosure, not part of the certificate
  std::optional<CollarFacts> collar;  ///< if it was requested
  /// Set for a file of volumes whose cells were looked at. Patches, shells and boxes are then those of its boundary.
  std::optional<VModelFacts> vmodel;
};

}  // namespace veritope
