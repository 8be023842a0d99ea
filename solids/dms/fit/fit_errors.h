// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/fit_errors.h: how far the values of a model are from data, enclosed.
#pragma once
#include <vector>

#include "solids/dms/fit/dms_data.h"

namespace veritope {

/// Upper bounds, from enclosures of the model's exact values; over the points in the closed domain.
struct DmsFitErrors {
  double geometry_mse = 0;  ///< mean of the squared distance of the map's point from the data's
  std::vector<double> attribute_mse;  ///< mean of the squared difference, for each attribute
  std::vector<double> max_error;      ///< the greatest difference
};

/// Places by rule H, values in intervals at exact points, control points as they are.
/// REQUIRES a model without defects, with shared control points and as many attributes as the data.
/// @cost some microseconds for each point and tetrahedron whose knots are near it
DmsFitErrors measure_fit_errors(const DmsModel& model, const DmsData& data);

}  // namespace veritope
