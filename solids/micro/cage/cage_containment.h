// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/cage_containment.h: proves that a cage contains a model.
#pragma once
#include <cstddef>
#include <optional>

#include "robust/base/result.h"
#include "solids/micro/cage/cage_content.h"
#include "solids/vmodel/v_model.h"

namespace veritope {

/// Where a proof that the content lies in the cage ended.
struct CageGap {
  std::size_t part = 0;  ///< of the content
  /// The border face of the cage that the part may meet. Nothing: no point of the part, or of those that share points
  /// with it, was found inside of the cage.
  std::optional<VFaceNumber> face;
};

struct ContainmentOptions {
  int halvings = 14;  ///< in a row, of a patch of the border that is near a part
};

/// Nothing only if all hulls of the content lie in the open union of the cells, and so the content does. The proof: a
/// point of each connected group of parts is the image of a point inside of a cell, up to a short segment; and planes
/// keep each patch of the border, or parts of it, away from each hull and segment. It is a proof if the cells are
/// mapped one to one (THEORY 7), which is not examined here. A closed surface in the cage has its inside there, too, if
/// the border of the cage has one shell.
/// What touches the border, or nearly does, is not proved.
std::optional<CageGap> find_gap(const VModel& cage, const CageContent& content,
                                const ContainmentOptions& options = {});

}  // namespace veritope
