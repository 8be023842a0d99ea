// SPDX-License-Identifier: LGPL-3.0-or-later
// io/dms/read_dms.h: from the bytes of a file .vdms to a simplex-spline solid, or to an error with its line.
// The format: docs/formats/dms-files.md.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "solids/dms/dms_model.h"

namespace veritope {

enum class DmsFormat { kDms };

struct DmsFile {
  static constexpr const char* kTitle = "a simplex-spline solid";

  DmsModel model;
  DmsFormat format = DmsFormat::kDms;
  std::uint64_t bytes = 0;
  std::string sha256;  ///< of the bytes that were read, 64 lower-case hex digits
  double seconds_read = 0, seconds_parse = 0, seconds_hash = 0;
  /// As in SplineFile: the refusal of the first number that is beyond the default limits.
  std::optional<Error> beyond_default_limits;
};

/// An object whose first member is "format": "veritope-dms-1".
bool looks_like_dms(const Source& source);

/// Leaves sha256 and the seconds open.
/// @return a model that validate() accepts
/// @error  kSyntax, kTruncated, kNotFinite, kUnknownFormat, kIndexOutOfRange, kOverLimit, kBadArgument, with the line
/// @cost   sorts of the control points and of the sets of vertices; memory at most a constant times the bytes, and no
///         count is believed before its items are read
Result<DmsFile> read_dms(DmsFormat format, const Source& source, const ReadLimits& limits);

}  // namespace veritope
