// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/sniff.h: which of the four mesh formats the bytes of a file look like.
#pragma once
#include <optional>

#include "io/base/source.h"
#include "io/mesh/mesh_format.h"

namespace veritope {

/// From the content alone: `ply`, OFF with its prefixes, `solid`, a line of OBJ, or a binary STL of the exact
/// size. Nothing if none fits.
std::optional<MeshFormat> mesh_format_from_content(const Source& source);

/// A guess for messages, never for decisions: bytes that no text has in a file that has the size of a binary STL's header.
bool looks_like_binary_stl(const Source& source);

}  // namespace veritope
