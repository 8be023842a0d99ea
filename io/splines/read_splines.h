// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/read_splines.h: from the bytes of a spline file to exact splines, or to an error with its place.
// What each format means here: docs/formats/spline-files.md.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "io/splines/spline_format.h"
#include "io/splines/spline_model.h"

namespace veritope {

/// Something in the file that the model does not hold.
struct LeftOut {
  std::string what;          ///< "polygons", "matrices", "trimmed cylinder", ...
  std::string reason;        ///< empty: it is no part of a spline model
  bool is_geometry = false;  ///< writing the model without it loses a shape
  std::uint64_t count = 0;
};

struct SplineFile {
  SplineModel model;
  SplineFormat format = SplineFormat::kItd;
  std::uint64_t bytes = 0;
  std::string sha256;        ///< of the bytes that were read, 64 lower-case hex digits
  double seconds_read = 0;   ///< file to memory
  double seconds_parse = 0;  ///< memory to splines
  double seconds_hash = 0;   ///< SHA-256; with jobs >= 2 at the same time as parsing
  std::vector<LeftOut> left_out;  ///< in the order of their first occurrence
};

struct SplineReadOptions {
  std::optional<SplineFormat> format;  ///< nothing: from the extension, else from the content
  ReadLimits limits;                   ///< max_faces has no effect
};

/// The bytes as a file of this format. Leaves sha256 and the seconds open.
/// @error  as read_spline_file; what no reader takes is the caller's to refuse
Result<SplineFile> read_splines(SplineFormat format, const Source& source,
                                const ReadLimits& limits);

/// Reads a regular file, or standard input if `path` is "-"; then options.format is required. A file without any
/// spline is read, too: the model is empty and left_out says what there is.
/// @error  kCannotOpen, kEmpty, kForeignFormat, kUnknownFormat, kSyntax, kTruncated, kNotFinite, kIndexOutOfRange,
///         kOverLimit, kBadSpline, with the line and, in a spline, its entity; kBadArgument for "-" without a format
/// @cost   memory at most a constant times the bytes (exact numbers: NumberBudget), never an announced count; the stack does not grow with nesting
Result<SplineFile> read_spline_file(const std::string& path, const SplineReadOptions& options);

/// The same for bytes in memory. `name` stands for the file in errors, and its extension counts as one.
Result<SplineFile> read_spline_bytes(std::span<const unsigned char> bytes, const std::string& name,
                                     const SplineReadOptions& options);

}  // namespace veritope
