// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/facet_meetings.h: the pairs of facets that a certificate has to speak of, with axes that separate
// most of them.
#pragma once
#include <cstdint>
#include <vector>

#include "solids/polyhedron/broad_phase.h"

namespace veritope {

/// Two facets whose boxes meet and that have no star vertex in common.
struct FacetMeeting {
  static constexpr std::uint8_t kNoAxis = 0xff;
  std::uint32_t first = 0, second = 0;  ///< positions in the order, ascending
  std::uint8_t axis = kNoAxis;  ///< separating_axis of these facets, in this order, if there is one
  friend bool operator==(const FacetMeeting&, const FacetMeeting&) = default;
};

struct FacetMeetings {
  std::vector<std::uint32_t> order;  ///< of facets; empty if nothing is known
  std::vector<FacetMeeting> pairs;   ///< each pair once
};

/// Takes pairs that BoxGroups found, whose boxes are rounded.
class MeetingCollector {
 public:
  /// REQUIRES that `boxes` were made with this order.
  MeetingCollector(const TriangleMesh& mesh, std::vector<std::uint32_t> order,
                   const BoxGroups& boxes);

  /// Calls undecided(f, g) for each pair whose boxes meet and that no axis separates certainly: all others meet in
  /// their common simplex. Calls for different tasks may come from different threads.
  template <typename Undecided>
  void take(std::size_t task, std::span<const FacetPair> pairs, const Undecided& undecided) {
    for (const auto& [f, g] : pairs)
      if (add(task, f, g)) undecided(f, g);
  }
  /// All that were taken; nothing stays.
  FacetMeetings finish();

 private:
  // True if the boxes meet and no axis is certain.
  bool add(std::size_t task, std::uint32_t f, std::uint32_t g);

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> order_, position_;
  std::vector<std::vector<FacetMeeting>> of_task_;
};

/// The pairs among all facets of the mesh, along a Morton curve, as a decision keeps them. REQUIRES the stars and the box
/// of a valid mesh whose report is not long_thin: otherwise there may be too many pairs for the memory.
FacetMeetings find_facet_meetings(const TriangleMesh& mesh, const VertexStars& stars,
                                  const Box3d& box, unsigned jobs, WorkShare* work);

}  // namespace veritope
