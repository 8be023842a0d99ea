// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/mesh_format.h: the four mesh file formats and their names.
#pragma once
#include <optional>
#include <string_view>

namespace veritope {

/// A section of the reading rule (docs/certificates/reading-rule-1.md), not an encoding: ASCII and binary
/// files of one format share a value.
enum class MeshFormat { kStl, kObj, kPly, kOff };

/// "stl", "obj", "ply", "off": the names that certificates and the command line use.
const char* mesh_format_name(MeshFormat format);

/// The inverse of mesh_format_name, in any case; nothing for another word.
std::optional<MeshFormat> mesh_format_from_name(std::string_view name);

/// From the letters behind the last dot of the file name, in any case; nothing if they are none of the four.
std::optional<MeshFormat> mesh_format_from_path(std::string_view path);

}  // namespace veritope
