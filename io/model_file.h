// SPDX-License-Identifier: LGPL-3.0-or-later
// io/model_file.h: what the file of a model can hold, and how to read it. Design: docs/design/0020-one-front-door.md.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "io/base/read_limits.h"
#include "io/dms/read_dms.h"
#include "io/mesh/read_mesh.h"
#include "io/micro/read_micro.h"
#include "io/splines/read_splines.h"

namespace veritope {

// The table of kinds: a new kind is one enumerator and one alternative of each of the two types below it, in the same
// order, and nothing else in this file or in io/model_file.cc (docs/how-to/add-a-solid.md).

/// What a file holds.
enum class ModelKind { kMesh, kSplines, kMicro, kDms };

/// The content of a file of a model. Each alternative has
///  - kTitle, the kind in sentences: "a mesh";
///  - format and bytes, the number of bytes that were read (meshes have both in their ReadReport);
///  - sha256, seconds_read, seconds_parse and seconds_hash, which the front door fills.
using ModelFile = std::variant<MeshFile, SplineFile, MicroFile, DmsFile>;

/// A format, typed by its kind.
using FormatId = std::variant<MeshFormat, SplineFormat, MicroFormat, DmsFormat>;

/// The kind in sentences: "a mesh", "a file of splines".
const char* title_of(ModelKind kind);

inline ModelKind kind_of(const FormatId& format) { return static_cast<ModelKind>(format.index()); }
inline ModelKind kind_of(const ModelFile& file) { return static_cast<ModelKind>(file.index()); }

FormatId format_of(const ModelFile& file);
std::uint64_t num_bytes(const ModelFile& file);
/// The digest of the bytes that were read: 64 lower-case hexadecimal digits.
const std::string& sha256_of(const ModelFile& file);

struct ModelReadOptions {
  std::optional<FormatId> format;  ///< nothing: from the ending of the name, else from the content
  std::optional<ModelKind> kind;   ///< nothing: any; else only formats of this kind are considered
  bool as_indexed = false;         ///< meshes: keep the file's own indices (no effect on STL)
  bool with_normals = false;       ///< meshes: keep the normals of OBJ and PLY files
  ReadLimits limits;               ///< max_faces has an effect on meshes only
  int jobs = 1;                    ///< threads; the result is the same for every value >= 1
};

}  // namespace veritope
