// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/spline_format.h: the spline file formats that are read, and their names.
#pragma once
#include <optional>
#include <string_view>

#include "io/base/source.h"

namespace veritope {

enum class SplineFormat { kItd, kG2, kMfem, kGismo, kJson };

/// "itd", "g2", "mfem", "gismo", "vjson".
const char* spline_format_name(SplineFormat format);

/// The inverse, in any case, and the extensions "mesh", "xml", "json"; nothing for another word.
std::optional<SplineFormat> spline_format_from_name(std::string_view name);

/// From the letters behind the last dot of the file name, in any case.
std::optional<SplineFormat> spline_format_from_path(std::string_view path);

/// From the content alone; nothing if no format is recognised. Looks at the first bytes only.
std::optional<SplineFormat> spline_format_from_content(const Source& source);

}  // namespace veritope
