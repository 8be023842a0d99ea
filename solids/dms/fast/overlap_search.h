// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/overlap_search.h: where the image of a solid covers a place twice. The search proves nothing: it
// compares samples in binary64, and shows one place exactly. Design: docs/design/0110-images-that-cover-twice.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "solids/dms/dms_model.h"

namespace veritope {

/// A point of the domain whose image is also that of a point inside of a small tetrahedron, in which it does not lie:
/// DmsCovering says so.
struct DmsCoveredPlace {
  DmsPoint at;
  std::uint32_t tetrahedron_of_point = 0;
  std::uint32_t tetrahedron = 0;  ///< of the domain, with the small one in it
  std::array<DmsPoint, 4> corners;
};

struct OverlapSearchOptions {
  std::size_t max_points = std::size_t{1} << 15;
  /// Points that FastDms evaluates exactly take a thousand times as long; the search ends after so many.
  std::size_t max_exact = std::size_t{1} << 9;
  /// Pairs of samples from which the other preimage is sought.
  std::size_t max_pairs = std::size_t{1} << 14;
  /// Places that are looked at exactly.
  std::size_t max_places = 16;
};

/// Samples the tetrahedra, and seeks the other preimages of their images. The answer does not depend on the machine.
/// Without an answer places may be covered twice all the same; parts that overlap by less than the distance of samples
/// are not found, nor are tetrahedra beyond the number of points sampled.
/// REQUIRES what FastDms requires, and a map to space in the first three components.
std::optional<DmsCoveredPlace> find_overlap(const DmsModel& model,
                                            const OverlapSearchOptions& options = {});

}  // namespace veritope
