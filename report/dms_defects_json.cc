// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/dms_defects_json.h"

#include <utility>

namespace veritope::report {

Json dms_defects_json(const DmsDefects& defects) {
  Json out = Json::array();
  for (const DmsDefect& defect : defects.first) {
    Json one;
    one["code"] = fault_name(defect.fault);
    one["message"] = to_string(defect);
    one["tetrahedra"] = defect.tetrahedra;
    one["beta"] = defect.has_beta() ? Json(defect.beta) : Json(nullptr);
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace veritope::report
