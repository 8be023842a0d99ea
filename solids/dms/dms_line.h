// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_line.h: exact integrals of a simplex-spline solid's components along segments of its domain.
// Design: docs/design/0096-x-rays.md.
#pragma once
#include <cstddef>
#include <vector>

#include "interval/interval.h"
#include "solids/dms/dms_evaluator.h"

namespace veritope {

/// x(t) = from + t (to - from), 0 <= t <= 1. It may be a point.
struct DmsLine {
  DmsPoint from, to;
};

/// The segment's part from t = begin to t = end lies in the domain, and rule H enters it everywhere by paths of one
/// kind: the path at one of its points.
struct DmsStretch {
  Rational begin, end;
  EntryPath path;
};

/// What one control point contributes to an integral: its value times the weight.
struct DmsWeight {
  std::size_t control = 0;
  Rational weight;
};

class DmsLineIntegrator {
 public:
  /// The evaluator must outlive the integrator, and both keep tables of it; so one thread at a time. REQUIRES what
  /// DmsEvaluator::evaluate does of the model.
  explicit DmsLineIntegrator(DmsEvaluator& evaluator) : evaluator_(evaluator) {}

  /// The parts of the segment in the closed domain, ascending, without those of length 0; of a point all or nothing.
  std::vector<DmsStretch> stretches(const DmsLine& line) const;

  /// The weights that are not zero, ascending by control point: the integral over t in [0, 1], over the closed domain,
  /// of any component of the map is the sum of weight times control point. The values are those that rule H gives
  /// (`DmsEvaluator::evaluate`), also where the segment lies in a plane of knots or in the boundary. They do not depend
  /// on the coefficients.
  /// @cost for each tetrahedron whose knots' box meets the segment, the moments of its sets of knots, exactly
  std::vector<DmsWeight> weights(const DmsLine& line);

  /// The integral of one component. REQUIRES component < model.num_components().
  Rational mean(const DmsLine& line, std::size_t component);

 private:
  DmsEvaluator& evaluator_;
};

/// The integral by length, the mean times the length of the segment, and what [HHQ04] eq. 12 calls the intensity,
/// exp(-integral): the share of light that passes a body that absorbs as much as the component is high. Enclosures.
struct DmsAbsorption {
  Interval integral, intensity;
};
DmsAbsorption absorption(const DmsLine& line, const Rational& mean);

}  // namespace veritope
