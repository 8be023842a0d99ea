// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/dms_data.h: points with attributes, exactly as they were given.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solids/dms/dms_model.h"

namespace veritope {

struct DmsData {
  std::size_t num_attributes = 1;
  std::vector<DmsPoint> points;
  std::vector<Rational> values;  ///< num_attributes for each point

  const Rational& value(std::size_t point, std::size_t attribute) const {
    return values[point * num_attributes + attribute];
  }
};

/// The points that lie where another point has other values, ascending: no function agrees with all of them.
std::vector<std::size_t> find_conflicts(const DmsData& data);

}  // namespace veritope
