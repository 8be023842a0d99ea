// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/occt_intersections.h: Open CASCADE's GeomAPI_IntSS on our surfaces; its headers stay in the .cc file.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "splines/bspline.h"

namespace veritope::bench {

class OcctPair {
 public:
  OcctPair(const BSplineSurface<Rational>& first, const BSplineSurface<Rational>& second);
  ~OcctPair();
  /// Intersects; returns the number of curves.
  int intersect(double tolerance);
  /// Intersects once more, with curves in the parameters, by GeomInt_IntSS: (u, v, s, t) at `points` places of every
  /// curve.
  std::vector<std::vector<std::array<double, 4>>> sample(double tolerance, int points) const;
  double length() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace veritope::bench
