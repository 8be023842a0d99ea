// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/dms_fit.h: a simplex-spline solid whose attributes are those of data, over a domain that is cut where
// the error is. The map stays the identity: positions are parameters.
// Source: [HHQ04], sections 5.1, 5.3, 5.4.  Design: docs/design/0095-fitting.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robust/base/result.h"
#include "solids/dms/dms_region.h"
#include "solids/dms/fit/fit_errors.h"

namespace veritope {

struct DmsFitOptions {
  int degree = 2;
  /// The mean squared error of each attribute is to be at most this. Without it there is no aim.
  std::optional<double> tolerance;
  /// Tetrahedra are cut while there are fewer and the tolerance is not reached. Nothing: those of the domain stay.
  std::optional<std::size_t> max_tetrahedra;
  bool has_free_knots = false;
  std::vector<DmsPlane> features;  ///< vertices of the domain on such a plane stay on it
};

enum class DmsFitEnd {
  kTolerance,  ///< it is reached
  kBudget,     ///< no tetrahedron may be cut any more
  kConflict,   ///< what is left is what data at equal points with other values make unavoidable
  kStalled,    ///< no cut made the errors less any more
  kNoAim,      ///< neither a tolerance nor a budget was given
};
/// "tolerance", "budget", "conflict", "stalled", "no-aim"
const char* fit_end_name(DmsFitEnd end);

/// After a fit of control points, in binary64.
struct DmsFitRound {
  std::size_t tetrahedra = 0, control_points = 0, knots = 0;
  std::vector<double> attribute_mse, max_error;
};

struct DmsFit {
  DmsModel model;
  std::size_t num_points = 0;
  std::vector<std::size_t> outside;         ///< the points outside of the closed domain
  std::vector<std::size_t> conflicts;       ///< the points where another point has other values
  std::vector<std::uint32_t> undetermined;  ///< control points that the data do not determine
  DmsFitErrors errors;                      ///< of the model, after all rounding
  std::vector<DmsFitRound> rounds;
  DmsFitEnd end = DmsFitEnd::kNoAim;

  bool is_reached(double tolerance) const;
};

/// The names of the attributes are those of the domain, as far as it has them, then "a1", "a2", ... by their number.
/// Deterministic. @error kBadArgument as make_dms; for data without a point in the closed domain, or whose numbers
/// binary64 rounds to infinity; kOverLimit for a domain with more tetrahedra than the budget
/// @cost for each round the basis functions at all points, and a sparse factorisation
Result<DmsFit> fit_dms(const DmsModel& domain, const DmsData& data, const DmsFitOptions& options);

}  // namespace veritope
