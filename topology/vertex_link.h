// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/vertex_link.h: the edges and fans at one vertex. Internal to topology; declared for its tests.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace veritope::internal {

/// Finds the vertices whose faces form one closed, oriented fan, in O(k) for k faces: the usual case.
class FanWalker {
 public:
  explicit FanWalker(std::uint32_t num_vertices) : marks_(num_vertices) {}

  /// True iff the faces at v form exactly one cycle, each edge at v used once in each direction. Adds the number of
  /// edges {v, w} with w > v to `edges` if so. REQUIRES that no v is passed twice to one walker.
  bool is_closed_fan(std::span<const std::array<std::uint32_t, 3>> faces,
                     std::span<const std::uint32_t> corners, std::uint32_t v, std::uint64_t& edges);

 private:
  struct Mark {
    std::uint32_t stamp = 0;  // v + 1 of the vertex that wrote it
    std::uint32_t prev = 0;   // of the face (v, w, prev)
  };
  std::vector<Mark> marks_;
};

/// One use of an edge {v, w} by a face.
struct EdgeUse {
  std::uint32_t other = 0;   ///< w
  std::uint32_t corner = 0;  ///< position of the face's corner in the list at v
  bool outgoing = false;     ///< the face runs from v to w
};

/// All uses of the edges at the vertex of `corners`, by ascending other vertex (then face order).
std::vector<EdgeUse> edge_uses(std::span<const std::array<std::uint32_t, 3>> faces,
                               std::span<const std::uint32_t> corners);

/// The fan (0, 1, ...; numbered by first corner) of each corner at v: faces are in one fan if edges at v connect them.
std::vector<std::uint32_t> fans_of_corners(const std::vector<EdgeUse>& uses, std::size_t num_corners);

}  // namespace veritope::internal
