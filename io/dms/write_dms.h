// SPDX-License-Identifier: LGPL-3.0-or-later
// io/dms/write_dms.h: the canonical file of a simplex-spline solid (docs/formats/dms-files.md).
#pragma once
#include <string>

#include "solids/dms/dms_model.h"

namespace veritope {

/// Equal models give equal bytes, and what read_dms read from them is the model. REQUIRES a model that validate()
/// accepts.
std::string write_dms(const DmsModel& model);

}  // namespace veritope
