// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_bridges.h: what the conditions of bridges share; docs/certificates/microstructure.md, section 7.
#pragma once
#include "micro_double.h"
#include "micro_meet.h"

// The other side of the wall where a bridge starts. Coordinate k there is placed[k] of coordinate source[k] in the
// cell's unit cube; the one across the front, `axis`, is `front`.
struct OtherSide {
  uint64_t volume = 0;
  size_t axis = 0;
  Ratio front;
  bool is_upward = false;  // beyond the front the coordinate is greater
  bool is_face = false;    // the wall lies in a face of the cell's volume
  size_t source[3];
  Placement placed[3];
};

struct RatioBox {
  Ratio lo[3], hi[3];
};
// The box of slice j of a bridge.
RatioBox box_of_slice(const MicroBridge& bridge, size_t j);
// Whether the ends of closed intervals or boxes have common points.
inline bool meet(const RatioBox& a, const RatioBox& b) {
  for (size_t k = 0; k < 3; ++k)
    if (compare(a.hi[k], b.lo[k]) < 0 || compare(b.hi[k], a.lo[k]) < 0) return false;
  return true;
}
inline DoubleBox outer(const RatioBox& b) {
  DoubleBox r;
  for (size_t k = 0; k < 3; ++k) r.lo[k] = span_of(b.lo[k]).lo, r.hi[k] = span_of(b.hi[k]).hi;
  return r;
}

// R3 for the slices, bridge by bridge; R4.
class Slices {
 public:
  explicit Slices(const MicroFile& file);
  void check_cells(const MicroBridge& bridge, const OtherSide& other);
  void check_pairs();

 private:
  struct Slice {
    uint32_t bridge, number;
  };
  void add_pairs(uint64_t pairs, const char* id) {
    require((pairs_ += pairs) <= most_pairs_, id, "this checker has a limit of pairs of slices");
  }
  void check_grid(const MicroGrid& grid, const RatioBox& box, uint64_t own, uint64_t bridge);

  const MicroFile& file_;
  std::vector<Slice> slices_;
  std::vector<DoubleBox> boxes_;  // contain those of the slices
  uint64_t pairs_ = 0;
  const uint64_t most_pairs_, most_slices_;
};
