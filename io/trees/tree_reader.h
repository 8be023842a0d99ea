// SPDX-License-Identifier: LGPL-3.0-or-later
// io/trees/tree_reader.h: from the bytes of a tree of volumes to its nodes. Format: docs/formats/trees.md.
#pragma once
#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "io/trees/tree_node.h"
#include "robust/base/result.h"

namespace veritope {

/// The deepest nesting of nodes.
inline constexpr std::size_t kMaxTreeDepth = 100;

/// Reads the nodes; nothing is built, and no file but this one is read.
/// @param  limits  max_faces has no effect
/// @error  kSyntax, kTruncated, kOverLimit, kBadSpline with the line; the message begins with the JSON pointer (RFC
///         6901) of the value, once the file is found to be JSON
/// @cost   near-linear in the bytes; memory at most a constant times the bytes
Result<TreeFile> read_tree(const Source& source, const ReadLimits& limits);

}  // namespace veritope
