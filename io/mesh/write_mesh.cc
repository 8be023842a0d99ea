// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/write_mesh.h"

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "io/base/atomic_file.h"
#include "io/base/source.h"
#include "io/mesh/mesh_encoder.h"

namespace veritope {
namespace {

struct Variant {
  const char* name;
  WriteOptions options;
};

constexpr Variant kVariants[] = {
    {"stl-ascii", {MeshFormat::kStl, MeshEncoding::kAscii, false}},
    {"stl-binary", {MeshFormat::kStl, MeshEncoding::kLittleEndian, false}},
    {"obj", {MeshFormat::kObj, MeshEncoding::kAscii, false}},
    {"ply-ascii", {MeshFormat::kPly, MeshEncoding::kAscii, false}},
    {"ply-binary-little-endian", {MeshFormat::kPly, MeshEncoding::kLittleEndian, false}},
    {"ply-binary-big-endian", {MeshFormat::kPly, MeshEncoding::kBigEndian, false}},
    {"ply-binary-little-endian-float", {MeshFormat::kPly, MeshEncoding::kLittleEndian, true}},
    {"ply-binary-big-endian-float", {MeshFormat::kPly, MeshEncoding::kBigEndian, true}},
    {"off", {MeshFormat::kOff, MeshEncoding::kAscii, false}},
};

bool is_known(const WriteOptions& options) {
  for (const Variant& v : kVariants) {
    const bool same = v.options.format == options.format && v.options.encoding == options.encoding;
    // Binary STL is float whether or not that was requested.
    const bool precision = v.options.single_precision == options.single_precision ||
                           options.format == MeshFormat::kStl;
    if (same && precision && !(options.single_precision && !is_rounding(options))) return true;
  }
  return false;
}

Error refuse(Code code, std::string message) {
  return error_in_file(std::string(), code, std::move(message));
}

Status check(const TriangleMesh& mesh, const WriteOptions& options) {
  if (!is_known(options)) {
    return refuse(Code::kBadArgument, "there is no such encoding of this format");
  }
  if (mesh.faces.size() > 0xFFFFFFFF || mesh.positions.size() > 0xFFFFFFFF) {
    return refuse(Code::kOverLimit, "more than 4294967295 faces or vertices");
  }
  if (!is_rounding(options)) return ok_status();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (to_binary32(mesh.positions[i][axis])) continue;
      Error error = refuse(Code::kNotFinite, "a coordinate is too large for binary32");
      error.place.vertex = i;
      return error;
    }
  }
  return ok_status();
}

Status write_standard_output(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) {
      return error_in_file("-", Code::kCannotWrite, std::generic_category().message(errno));
    }
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return ok_status();
}

}  // namespace

std::optional<WriteOptions> write_options_from_name(std::string_view variant) {
  for (const Variant& v : kVariants) {
    if (variant == v.name) return v.options;
  }
  return std::nullopt;
}

std::vector<std::string> write_variant_names() {
  std::vector<std::string> names;
  for (const Variant& v : kVariants) names.emplace_back(v.name);
  return names;
}

WriteOptions default_write_options(MeshFormat format) {
  const bool is_ply = format == MeshFormat::kPly;
  return {format, is_ply ? MeshEncoding::kLittleEndian : MeshEncoding::kAscii, false};
}

Status write_mesh_file(const std::string& path, const TriangleMesh& mesh,
                       const WriteOptions& options) {
  if (Status status = check(mesh, options); !status) {
    Error error = status.error();
    error.place.file = path;
    return error;
  }
  if (path == "-") {
    ChunkedOutput out(write_standard_output);
    encode_mesh(mesh, options, out);
    return out.finish();
  }
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  ChunkedOutput out([&](std::string_view bytes) { return file->write(bytes); });
  encode_mesh(mesh, options, out);
  if (Status status = out.finish(); !status) return status;
  return file->commit();
}

Result<std::string> mesh_to_bytes(const TriangleMesh& mesh, const WriteOptions& options) {
  if (Status status = check(mesh, options); !status) return status.error();
  std::string bytes;
  ChunkedOutput out([&](std::string_view piece) { return bytes += piece, ok_status(); });
  encode_mesh(mesh, options, out);
  if (Status status = out.finish(); !status) return status.error();
  return bytes;
}

}  // namespace veritope
