// SPDX-License-Identifier: LGPL-3.0-or-later
// io/fields/read_field.h: fields of directions from lines of numbers. The format: docs/cli/cage.md, "Fields".
#pragma once
#include <cstdint>
#include <vector>

#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "robust/base/result.h"
#include "solids/micro/cage/fit_cage.h"

namespace veritope {

struct FieldFile {
  DirectionField field;  ///< coordinates rounded to binary64; axes of tensors are approximate
  std::vector<std::uint64_t> lines;  ///< of each vector, from 1
  bool has_tensors = false;
};

/// Reads all vectors. Empty lines and those that begin with # are left out.
/// @error kSyntax, kOverLimit with line and value, for what is not a number, names of columns that are not known, given
///        twice or missing, and lines of another length; kBadArgument with the line for a direction that is 0, and a
///        tensor without a first principal direction (solids/micro/cage/principal_axes.h); kEmpty without a vector
Result<FieldFile> read_field(const Source& source, const ReadLimits& limits);

}  // namespace veritope
