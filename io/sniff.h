// SPDX-License-Identifier: LGPL-3.0-or-later
// io/sniff.h: what the first bytes of a file say: something foreign, or one of the four formats.
#pragma once
#include <optional>

#include "io/mesh_format.h"
#include "io/source.h"

namespace veritope {

/// kEmpty or kForeignFormat with the name of what it is, whatever the format asked for; else nothing.
std::optional<Error> refuse_foreign(const Source& source);

/// From the content alone: `ply`, OFF with its prefixes, `solid`, a line of OBJ, or a binary STL of the exact
/// size. Nothing if none fits.
std::optional<MeshFormat> mesh_format_from_content(const Source& source);

/// Guesses for messages, never for decisions: text of two bytes a character without a mark; bytes that no text has in a file
/// that has the size of a binary STL's header.
bool looks_like_utf16(const Source& source);
bool looks_like_binary_stl(const Source& source);

}  // namespace veritope
