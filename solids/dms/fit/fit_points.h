// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/fit_points.h: the points of data that lie in the domain, with a tetrahedron for each, while the
// tetrahedra change. Nothing depends on which one it is where several hold a point: the map is continuous.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solids/dms/fit/dms_data.h"

namespace veritope {

struct FitPoints {
  const DmsData* data = nullptr;
  std::vector<std::size_t> number;         ///< of the points in the data, ascending
  std::vector<std::array<double, 3>> at;   ///< rounded
  std::vector<double> values;              ///< of the attributes, rounded
  std::vector<std::uint32_t> tetrahedron;  ///< that holds the point, up to rounding
  std::vector<bool> needs_target;          ///< rule H does not enter the domain along the axes
  std::vector<std::size_t> outside;        ///< numbers of points outside of the closed domain

  std::size_t size() const { return number.size(); }
};

/// Rule H decides which points are in the closed domain of the model. The data must outlive the result.
FitPoints find_fit_points(const DmsModel& model, const DmsData& data);

/// Finds tetrahedra again after these have changed, by walks from those that held the points before.
/// REQUIRES the same domain as a set.
void move_fit_points(const DmsModel& model, FitPoints& points);

}  // namespace veritope
