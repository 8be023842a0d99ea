// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/mesh_format.h: the four mesh file formats. How a file is recognised: io/formats.h.
#pragma once

namespace veritope {

/// A section of the reading rule (docs/certificates/reading-rule-1.md), not an encoding: ASCII and binary
/// files of one format share a value.
enum class MeshFormat { kStl, kObj, kPly, kOff };

/// "stl", "obj", "ply", "off": the names that certificates and the command line use.
const char* mesh_format_name(MeshFormat format);

}  // namespace veritope
