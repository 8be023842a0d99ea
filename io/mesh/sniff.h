// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/sniff.h: whether the bytes of a file look like one of the mesh formats.
#pragma once
#include <string>

#include "io/base/source.h"

namespace veritope {

/// Recognises the word `solid`, or a binary STL of the exact size.
bool looks_like_stl(const Source& source);
/// Each recognises its first word: a keyword of OBJ, `ply`, OFF with its prefixes.
bool looks_like_obj(const Source& source);
bool looks_like_ply(const Source& source);
bool looks_like_off(const Source& source);

/// For messages about a file that was read as ASCII STL: the size that it would have as the binary STL that its bytes
/// may mean. Empty for a text, and for a file that was read as binary: its own message says this.
std::string size_as_binary_stl(const Source& source);

}  // namespace veritope
