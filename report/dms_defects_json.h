// SPDX-License-Identifier: LGPL-3.0-or-later
// report/dms_defects_json.h: the defects of a simplex-spline solid in the reports of its verbs. Only .cc files include
// it.
#pragma once
#include "report/json_text.h"
#include "solids/dms/dms_defects.h"

namespace veritope::report {

/// The schema: docs/report.schema.json, dms_defect. A list.
Json dms_defects_json(const DmsDefects& defects);

}  // namespace veritope::report
