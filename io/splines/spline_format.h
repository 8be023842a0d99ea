// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/spline_format.h: the spline file formats that are read. How a file is recognised: io/formats.h.
#pragma once

namespace veritope {

enum class SplineFormat { kItd, kG2, kMfem, kGismo, kJson };

/// "itd", "g2", "mfem", "gismo", "vjson".
const char* spline_format_name(SplineFormat format);

}  // namespace veritope
