// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/epeck_peer.h: CGAL's EPECK constructs the points that ours keep implicit [CGAL55]; compiled
// in a file of its own.
#pragma once
#include <cstddef>
#include <memory>

#include "predicates/vec.h"

namespace veritope::bench {

/// Tuples of 8 points (p, q, a, b, c; a query plane) or of 12 (three planes; a query plane).
class EpeckPoints {
 public:
  EpeckPoints(const Vec3d* points, std::size_t tuples, bool three_planes);
  ~EpeckPoints();
  /// Constructs all points; returns the number of those that exist.
  long construct();
  /// The sum of the orientations of the query planes and the points that construct() made. A point remembers the
  /// answers: only the first call after construct() counts.
  long orient();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace veritope::bench
