// SPDX-License-Identifier: LGPL-3.0-or-later
// report/dms_xray_report.h: what veritope dms xray says of segments.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "interval/interval.h"
#include "robust/rational.h"
#include "solids/dms/dms_defects.h"

namespace veritope::report {

struct DmsSegmentReport {
  Rational mean;
  Interval integral, intensity;
};

struct DmsXrayReport {
  std::string path, sha256;
  std::uint64_t bytes = 0;
  int degree = 0;
  std::string attribute;
  DmsDefects defects;  ///< with them there are no segments
  std::vector<DmsSegmentReport> segments;
  double seconds = 0;
};

/// The schema: docs/report.schema.json, dms_xray. One line a segment.
std::string dms_xray_json(const DmsXrayReport& report);

/// One line: the mean, the integral and the intensity, rounded; of enclosures a number between the bounds.
std::string dms_segment_text(const DmsSegmentReport& segment);

}  // namespace veritope::report
