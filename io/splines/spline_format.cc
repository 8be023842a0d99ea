// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/spline_format.h"

namespace veritope {

const char* spline_format_name(SplineFormat format) {
  switch (format) {
    case SplineFormat::kItd: return "itd";
    case SplineFormat::kG2: return "g2";
    case SplineFormat::kMfem: return "mfem";
    case SplineFormat::kGismo: return "gismo";
    case SplineFormat::kJson: return "vjson";
  }
  return "unknown";
}

}  // namespace veritope
