// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/spline_sniff.h: whether the first bytes of a file look like one of the spline formats.
#pragma once
#include <string_view>

#include "io/base/source.h"

namespace veritope {

/// Recognises a group or a spline in brackets, in a text that is none of the three formats with a first word of their
/// own.
bool looks_like_itd(const Source& source);
/// Recognises the number of a class of GoTools, followed by another number.
bool looks_like_g2(const Source& source);
bool looks_like_mfem(const Source& source);
bool looks_like_gismo(const Source& source);
/// Recognises an object that names the format, unless its first member names another one.
bool looks_like_spline_json(const Source& source);
/// Whether the text is an object whose first member is "format": "<format>".
bool starts_with_format(const Source& source, std::string_view format);

}  // namespace veritope
