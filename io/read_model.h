// SPDX-License-Identifier: LGPL-3.0-or-later
// io/read_model.h: the one way from the bytes of a file to a model, whatever its format and kind.
// What the formats mean: docs/certificates/reading-rule-1.md (meshes), docs/formats/spline-files.md (splines).
#pragma once
#include <span>
#include <string>

#include "io/base/byte_buffer.h"
#include "io/model_file.h"
#include "robust/base/result.h"

namespace veritope {

/// The bytes of a file under the name that errors show; the ending of this name is that of the file.
struct ModelBytes {
  std::string name;
  ByteBuffer bytes;
  double seconds_read = 0;  ///< file to memory
};

/// Reads a regular file, or standard input if `path` is "-"; then options.format is required. The file is opened once.
/// @error  kCannotOpen, kOverLimit; kBadArgument for "-" without a format and for jobs < 1
Result<ModelBytes> load_model(const std::string& path, const ModelReadOptions& options);

/// The format in which read_model reads the bytes: options.format, else that of the name's ending, else the one that
/// the content looks like.
/// @error  kEmpty; kForeignFormat for a content that is known and not read; kUnknownFormat; kBadArgument if
///         options.format is not of options.kind
Result<FormatId> choose_format(const ModelBytes& file, const ModelReadOptions& options);

/// May be called again with other options.
/// @error  as choose_format; kSyntax, kTruncated, kEmpty, kNotFinite, kIndexOutOfRange, kOverLimit, kBadSpline, with
///         the line of a text or the byte of binary data
/// @cost O(bytes) time for meshes; memory at most a constant times the bytes, never an announced count
Result<ModelFile> read_model(const ModelBytes& file, const ModelReadOptions& options);

/// Calls load_model, then read_model.
Result<ModelFile> read_model_file(const std::string& path, const ModelReadOptions& options);

/// Reads bytes in memory by the same rules.
Result<ModelFile> read_model_bytes(std::span<const unsigned char> bytes, const std::string& name,
                                   const ModelReadOptions& options);

/// Reads a file of one kind: sets options.kind. A file of another kind is refused with kUnknownFormat.
Result<MeshFile> read_mesh_file(const std::string& path, const ModelReadOptions& options);
Result<MeshFile> read_mesh_bytes(std::span<const unsigned char> bytes, const std::string& name,
                                 const ModelReadOptions& options);
Result<SplineFile> read_spline_file(const std::string& path, const ModelReadOptions& options);
Result<SplineFile> read_spline_bytes(std::span<const unsigned char> bytes, const std::string& name,
                                     const ModelReadOptions& options);

}  // namespace veritope
