// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_maps.h: the maps of the cage's volumes, in the boxes that their knots cut.
#pragma once
#include <array>

#include "micro.h"
#include "micro_net.h"

class VolumeMaps {
 public:
  explicit VolumeMaps(const std::vector<Entity>& cage);

  // The different knots of an axis.
  const std::vector<Ratio>& knots(uint64_t volume, size_t axis) const {
    return cells_[volume].breaks[axis];
  }
  // These knots where the domain is brought to [0, 1].
  const std::vector<Span>& unit_knots(uint64_t volume, size_t axis) const {
    return units_[volume].knots[axis];
  }
  // The map in box i of the volume, whose parameters are brought to [0, 1]. It is kept until the next call.
  const DoubleNet& net(uint64_t volume, const size_t* i);
  // The point at these parameters of the volume, X, Y, Z, W; W > 0.
  std::vector<Big> point(uint64_t volume, const Ratio* x);

 private:
  struct Unit {
    std::vector<Span> knots[3];
  };
  VPiece piece(uint64_t volume, const size_t* i);

  std::vector<VCell> cells_;
  std::vector<Unit> units_;
  std::vector<std::unique_ptr<PieceCutter>> cutters_;
  Units work_;  // not limited here; the part about the cage has its own limit
  std::map<std::array<uint64_t, 4>, DoubleNet> known_;
  size_t numbers_ = 0;  // of these nets
};

// X / Y for numbers, Y > 0.
inline Ratio ratio_quotient(const Ratio& x, const Ratio& y) {
  return lowest(Ratio(x.n * y.d, x.d * y.n));
}
// Intervals of rising numbers that have a common point with [lo, hi]: first <= i < last.
struct IndexRange {
  size_t first, last;
};
