// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/dms_defects_json.h"

#include <utility>

#include "report/decimal_text.h"

namespace veritope::report {

Json dms_defects_json(const DmsDefects& defects) {
  Json out = Json::array();
  for (const DmsDefect& defect : defects.first) {
    Json one;
    one["code"] = fault_name(defect.fault);
    one["message"] = to_string(defect);
    one["domain"] = defect.is_of_attributes ? "attributes" : "geometry";
    one["tetrahedra"] = defect.tetrahedra;
    one["beta"] = defect.has_beta() ? Json(defect.beta) : Json(nullptr);
    one["point"] = nullptr;
    if (defect.point) {
      Json& point = one["point"] = Json::array();
      for (const Rational& c : *defect.point) point.push_back(fraction_text(c));
    }
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace veritope::report
