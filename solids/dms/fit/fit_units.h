// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/fit_units.h: units in which the numbers of a fit are near 1, so that binary64 resolves them.
#pragma once
#include <cstdint>

#include "solids/dms/dms_similarity.h"
#include "solids/dms/fit/dms_fit.h"

namespace veritope {

/// Coordinates are moved and scaled, attributes scaled, by powers of two and exactly.
class FitUnits {
 public:
  /// REQUIRES a domain with vertices.
  FitUnits(const DmsModel& domain, const DmsData& data);

  /// Whether nothing is changed: domains near the origin, and numbers that are neither huge nor tiny.
  bool are_those_of_the_data() const { return places_.is_identity() && exponent_ == 0; }
  DmsModel to_unit(const DmsModel& domain) const { return places_.to_unit(domain); }
  DmsData to_unit(const DmsData& data) const;
  DmsFitOptions to_unit(const DmsFitOptions& options) const;
  /// Changes a result in these units to one in those of the data.
  void restore(DmsFit& fit) const;

 private:
  DmsSimilarity places_;
  std::int64_t exponent_ = 0;  // attributes are multiples of its power of two
};

}  // namespace veritope
