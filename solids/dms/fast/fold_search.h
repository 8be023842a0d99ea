// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fold_search.h: where the map of a solid turns over. The search proves nothing: it looks for small
// determinants in binary64, and shows one exactly. Design: docs/design/0104-folds-by-samples.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>

#include "robust/rational.h"
#include "solids/dms/dms_model.h"

namespace veritope {

/// A point where the determinant of the derivative is below 0, exactly.
struct DmsFold {
  std::uint32_t tetrahedron = 0;
  DmsPoint at;
  Rational determinant;
};

struct FoldSearchOptions {
  std::size_t max_points = std::size_t{1} << 14;
  /// Points that FastDms evaluates exactly take a thousand times as long; the search ends after so many.
  std::size_t max_exact = std::size_t{1} << 9;
};

/// Samples tetrahedra from number `first` on, near their corners and faces, and goes downhill from the least
/// determinants. The answer does not depend on the machine. Without an answer there may be a fold all the same.
/// REQUIRES what FastDms requires, and a map to space in the first three components.
std::optional<DmsFold> find_fold(const DmsModel& model, std::uint32_t first = 0,
                                 const FoldSearchOptions& options = {});

}  // namespace veritope
