// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/curve_intersection.h: where curves meet curves of the plane and surfaces of space, and where two
// curves of any dimension are nearest. Design: docs/design/0012-certified-solvers.md.
#pragma once
#include <vector>

#include "interval/ring_numbers.h"
#include "interval/solvers/root_report.h"
#include "robust/base/result.h"
#include "splines/bspline.h"

namespace veritope {

/// All (s, t) with a(s) = b(t), for two curves in the plane. Transversal solutions are isolated, each with a proof;
/// touching and overlapping ones end in clusters. The maps are continuous except at torn knots (multiplicity degree +
/// 1), where each side counts for itself.
/// @error kBadArgument: not of dimension 2, a weight that is not positive, bad options; kOverLimit
Result<RootReport<2>> intersect_curves(const BSpline<Rational, 1>& a, const BSpline<Rational, 1>& b,
                                       const SolverOptions& options = {});

/// All (t, u, v) with curve(t) = surface(u, v), in space. Transversal and touching solutions and errors are as above,
/// with dimension 3.
Result<RootReport<3>> intersect_curve_surface(const BSpline<Rational, 1>& curve,
                                              const BSpline<Rational, 2>& surface,
                                              const SolverOptions& options = {});

/// A chord that is normal to both curves, the only one in the box of its root, and its length.
struct NormalChord {
  IsolatedRoot<2> parameters;
  Interval gap;
};
struct NormalChords {
  std::vector<NormalChord> chords;
  std::vector<RootCluster<2>> clusters;
  SolverEffort effort;

  bool is_complete() const { return clusters.empty(); }
};

/// All (s, t) with (a(s) - b(t)) . a'(s) = 0 = (a(s) - b(t)) . b'(t), which includes those where the curves meet. In
/// space two curves meet only if three equations in two unknowns hold, which intervals cannot prove: what is certified
/// is that these are all the places, and how wide each gap is; where its enclosure excludes 0, the curves do not meet.
/// At knots of multiplicity >= degree, the critical points of either side are reported.
/// @error kBadArgument: different dimensions, a weight that is not positive, bad options; kOverLimit
Result<NormalChords> normal_chords(const BSpline<Rational, 1>& a, const BSpline<Rational, 1>& b,
                                   const SolverOptions& options = {});

}  // namespace veritope
