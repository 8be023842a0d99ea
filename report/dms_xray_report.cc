// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/dms_xray_report.h"

#include <cmath>

#include "interval/numeric.h"
#include "report/decimal_text.h"
#include "report/dms_defects_json.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

Json bounds_json(const Interval& a) {
  return {{"lo", number_json(inf(a))}, {"hi", number_json(sup(a))}};
}

std::string segment_json_text(const DmsSegmentReport& segment) {
  Json out;
  out["mean"] = fraction_text(segment.mean);
  out["integral"] = bounds_json(segment.integral);
  out["intensity"] = bounds_json(segment.intensity);
  return dump(out);
}

std::string middle_text(const Interval& a) {
  if (std::isinf(inf(a))) return "-inf";  // beyond binary64
  if (std::isinf(sup(a))) return "inf";
  return scientific_text(Rational::from_double(mid(a)));
}

}  // namespace

std::string dms_xray_json(const DmsXrayReport& report) {
  Json out;
  out["schema"] = "veritope-dms-xray-1";
  out["tool"] = tool_name();
  out["model"] = {{"path", report.path}, {"sha256", report.sha256}, {"bytes", report.bytes}};
  out["degree"] = report.degree;
  out["attribute"] = report.attribute;
  out["defects"] = dms_defects_json(report.defects);
  out["seconds"] = seconds_json(report.seconds);
  std::string text = dump(out);
  text.pop_back();  // the brace
  text += ", \"segments\": [";
  bool is_first = true;
  for (const DmsSegmentReport& segment : report.segments) {
    text += (is_first ? "\n" : ",\n") + segment_json_text(segment);
    is_first = false;
  }
  return text + "]}\n";
}

std::string dms_segment_text(const DmsSegmentReport& segment) {
  return scientific_text(segment.mean) + " " + middle_text(segment.integral) + " " +
         middle_text(segment.intensity) + "\n";
}

}  // namespace veritope::report
