// SPDX-License-Identifier: LGPL-3.0-or-later
// io/micro/read_micro.h: from the bytes of a file .vmicro to a microstructure, or to an error with its line.
// The format: docs/formats/micro-files.md.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "solids/micro/microstructure.h"

namespace veritope {

enum class MicroFormat { kMicro };

struct MicroFile {
  static constexpr const char* kTitle = "a microstructure";

  Microstructure micro;
  MicroFormat format = MicroFormat::kMicro;
  std::uint64_t bytes = 0;
  std::string sha256;  ///< of the bytes that were read, 64 lower-case hex digits
  double seconds_read = 0, seconds_parse = 0, seconds_hash = 0;
  /// The cage has groups or attributes, which the microstructure does not keep.
  bool has_names_in_cage = false;
  /// As in SplineFile: the refusal of the first number that is beyond the default limits.
  std::optional<Error> beyond_default_limits;
};

/// An object whose first member is "format": "veritope-micro-1".
bool looks_like_micro(const Source& source);

/// Keeps no names, groups and attributes of the cage. Leaves sha256 and the seconds open.
/// @return a microstructure that validate() accepts
/// @error  kSyntax, kTruncated, kUnknownFormat, kIndexOutOfRange, kOverLimit, kBadArgument, with the line; in the cage
///         also those of read_splines
/// @cost   linear in the bytes, but for overlapping_grids; memory at most a constant times the bytes: 13 bytes a cell,
///         and no announced count is believed
Result<MicroFile> read_micro(MicroFormat format, const Source& source, const ReadLimits& limits);

}  // namespace veritope
