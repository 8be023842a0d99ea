// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/intersection_picture.h: the curves of veritope intersect, to look at.
#pragma once
#include <string>

#include "report/intersection_report.h"

namespace veritope::cli {

/// VTK polygons, 8 pieces a segment, with points on the first surfaces in binary64.
std::string curves_vtu(const report::IntersectionReport& report);

}  // namespace veritope::cli
