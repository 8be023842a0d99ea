// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_meet.h: how the caps of two walls that meet lie to each other: T4 of docs/certificates/microstructure.md.
#pragma once
#include "micro.h"

struct Placement {  // of a coordinate of one wall in the other one: shift + factor x, factor > 0
  Ratio shift, factor;
};
struct EqualCaps {
  uint32_t caps[2];                                   // of the two tiles
  std::vector<std::pair<uint32_t, uint32_t>> pieces;  // that meet across their rims
};
struct MeetingCaps {
  bool is_known = true;     // every two caps are equal or apart
  bool needs_same = false;  // that holds where both walls have the same number only
  std::vector<EqualCaps> equal;
};
struct MeetingWalls {
  const MicroTile* tile[2];
  size_t wall[2];
  unsigned symmetry;  // takes the parameters of the first one's face to those of the second one's
  const Placement* place[2];  // of the second one's, after the symmetry, in the first one's
};
// For all numbers of the tiles' ranges at once. *work: the coefficients that are looked at.
MeetingCaps meeting_of_families(const MeetingWalls& walls, uint64_t* work);
// For these numbers of the six walls of either cell; or T4 fails.
MeetingCaps meeting_at_numbers(const MeetingWalls& walls, const uint32_t (*numbers)[6],
                               uint64_t* work);
