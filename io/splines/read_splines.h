// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/read_splines.h: from the bytes of a spline file to exact splines, or to an error with its place.
// What each format means here: docs/formats/spline-files.md.
#pragma once
#include <cstdint>
#include <optional>
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
  std::string reason;        ///< empty: it is not part of a spline model
  bool is_geometry = false;  ///< writing the model without it loses a shape
  std::uint64_t count = 0;
};

struct SplineFile {
  static constexpr const char* kTitle = "a file of splines";

  SplineModel model;
  SplineFormat format = SplineFormat::kItd;
  std::uint64_t bytes = 0;
  std::string sha256;             ///< SHA-256 of the bytes read, 64 lower-case hex digits
  double seconds_read = 0;        ///< file to memory
  double seconds_parse = 0;       ///< memory to splines
  double seconds_hash = 0;        ///< SHA-256; with jobs >= 2 at the same time as parsing
  std::vector<LeftOut> left_out;  ///< in the order of their first occurrence
  /// Some entity is no spline in the file but was made into one: a line, plane or extrusion of .g2.
  bool has_converted_shapes = false;
  /// The refusal of the first number that is beyond the default ReadLimits, if wider limits let it in. Certificates are
  /// about numbers within the default limits only.
  std::optional<Error> beyond_default_limits;
};

/// Reads the bytes as a file of this format. Does not set sha256 and the seconds. Files are read by io/read_model.h. A
/// file without any spline is read, too: the model is empty and left_out lists the content.
/// @param  limits  max_faces has no effect
/// @error  kSyntax, kTruncated, kNotFinite, kIndexOutOfRange, kOverLimit, kBadSpline, with the line and, in a spline,
///         its entity
/// @cost memory at most a constant times the bytes (exact numbers: NumberBudget), never an announced count; the stack
///        does not grow with nesting
Result<SplineFile> read_splines(SplineFormat format, const Source& source,
                                const ReadLimits& limits);

}  // namespace veritope
