// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/read_mesh.h"

#include <unistd.h>

#include <algorithm>
#include <stop_token>
#include <system_error>
#include <thread>

#include "io/base/file_bytes.h"
#include "io/base/foreign_content.h"
#include "io/base/source.h"
#include "io/mesh/parsed_mesh.h"
#include "io/mesh/sniff.h"
#include "io/mesh/stl_reader.h"
#include "io/mesh/vertex_table.h"
#include "robust/base/stopwatch.h"
#include "verify/format/sha256.h"

namespace veritope {
namespace {

Result<ParsedMesh> parse(MeshFormat format, const Source& source, const ReadOptions& options) {
  switch (format) {
    case MeshFormat::kStl: return read_stl(source, options);
    case MeshFormat::kObj: return read_obj(source, options);
    case MeshFormat::kPly: return read_ply(source, options);
    case MeshFormat::kOff: return read_off(source, options);
  }
  return error_in_file(*source.name, Code::kBadArgument, "no such format");
}

std::uint64_t count_referenced(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const auto& face : mesh.faces) {
    for (const std::uint32_t v : face) used[v] = true;
  }
  return static_cast<std::uint64_t>(std::count(used.begin(), used.end(), true));
}

void merge_and_count(ParsedMesh& parsed, bool as_indexed) {
  TriangleMesh& mesh = parsed.mesh;
  ReadReport& report = parsed.report;
  if (report.format == MeshFormat::kStl) {
    report.distinct_vertices = mesh.positions.size();
  } else {
    report.distinct_vertices =
        as_indexed ? count_distinct_positions(mesh) : merge_equal_positions(mesh);
  }
  report.referenced_vertices = count_referenced(mesh);
  report.unreferenced_vertices = mesh.positions.size() - report.referenced_vertices;
}

Result<MeshFormat> choose_format(const Source& source, const ReadOptions& options) {
  if (options.format) return *options.format;
  if (const auto format = mesh_format_from_path(*source.name)) return *format;
  if (const auto format = mesh_format_from_content(source)) return *format;
  return error_in_file(*source.name, Code::kUnknownFormat,
                       "neither the extension nor the content says whether this is STL, OBJ, PLY "
                       "or OFF (--format)");
}

// What the content looks like, for a refusal by the reader of `format`; empty if that says nothing new.
std::string other_looks(const Source& source, MeshFormat format) {
  if (looks_like_utf16(source)) return "; it looks like UTF-16 text";
  const auto other = mesh_format_from_content(source);
  if (other && *other != format) {
    return std::string("; it looks like ") + mesh_format_name(*other) + " (--format " +
           mesh_format_name(*other) + ")";
  }
  if (format == MeshFormat::kStl && looks_like_binary_stl(source)) {
    return "; if it is a binary STL: its header announces " +
           std::to_string((stl_binary_size(source) - kStlHeader) / kStlFacet) + " facets, " +
           std::to_string(stl_binary_size(source)) + " bytes, but it has " +
           std::to_string(source.size());
  }
  return "";
}

Result<ParsedMesh> parse_and_merge(MeshFormat format, const Source& source,
                                   const ReadOptions& options) {
  Result<ParsedMesh> parsed = parse(format, source, options);
  if (!parsed) {
    Error error = parsed.error();
    const bool is_syntax =
        error.code == Code::kSyntax || error.code == Code::kTruncated || error.code == Code::kEmpty;
    if (is_syntax) error.message += other_looks(source, format);
    return error;
  }
  parsed->report.format = format;
  parsed->report.bytes = source.size();
  merge_and_count(*parsed, options.as_indexed);
  return parsed;
}

Result<MeshFile> read_buffer(const ByteBuffer& buffer, const std::string& name,
                             const ReadOptions& options) {
  MeshFile file;
  // In pieces, so that a refused file need not be hashed to its end.
  const auto hash = [&](std::stop_token stop) {
    Stopwatch watch;
    Sha256 sha;
    std::span<const unsigned char> rest(buffer.data(), buffer.size());
    while (!rest.empty() && !stop.stop_requested()) {
      const std::size_t size = std::min<std::size_t>(rest.size(), std::size_t{1} << 20);
      sha.update(rest.first(size));
      rest = rest.subspan(size);
    }
    file.sha256 = to_hex(sha.finish());
    file.seconds_hash = watch.lap();
  };
  Stopwatch watch;
  std::jthread hashing;
  try {
    if (options.jobs > 1 && buffer.size() > (1 << 16)) hashing = std::jthread(hash);
  } catch (const std::system_error&) {
    // The system refuses another thread: this one hashes afterwards.
  }
  const Source source = source_of(buffer, name);
  if (std::optional<Error> foreign = refuse_foreign(source)) return std::move(*foreign);
  const Result<MeshFormat> format = choose_format(source, options);
  if (!format) return format.error();
  Result<MeshFile> parsed = read_mesh(*format, source, options);
  if (!parsed) return parsed.error();
  parsed->seconds_parse = watch.lap();
  hashing.joinable() ? hashing.join() : hash(std::stop_token());
  parsed->sha256 = std::move(file.sha256);
  parsed->seconds_hash = file.seconds_hash;
  return parsed;
}

std::optional<Error> check_options(const std::string& name, const ReadOptions& options) {
  if (options.jobs >= 1) return std::nullopt;
  return error_in_file(name, Code::kBadArgument,
                       "jobs must be at least 1, not " + std::to_string(options.jobs));
}

}  // namespace

Result<MeshFile> read_mesh(MeshFormat format, const Source& source, const ReadOptions& options) {
  Result<ParsedMesh> parsed = parse_and_merge(format, source, options);
  if (!parsed) return parsed.error();
  MeshFile file;
  file.mesh = std::move(parsed->mesh);
  file.report = std::move(parsed->report);
  file.polygon_of_face = std::move(parsed->polygon_of_face);
  return file;
}

Result<MeshFile> read_mesh_file(const std::string& path, const ReadOptions& options) {
  if (std::optional<Error> error = check_options(path, options)) return std::move(*error);
  if (path == "-" && !options.format) {
    return error_in_file(path, Code::kBadArgument, "standard input needs a format (--format)");
  }
  Stopwatch watch;
  const std::uint64_t max_bytes = options.limits.max_bytes;
  const Result<ByteBuffer> buffer = path == "-" ? read_descriptor(STDIN_FILENO, path, 0, max_bytes)
                                                : read_file_bytes(path, max_bytes);
  if (!buffer) return buffer.error();
  const double seconds = watch.lap();
  Result<MeshFile> file = read_buffer(*buffer, path, options);
  if (file) file->seconds_read = seconds;
  return file;
}

Result<MeshFile> read_mesh_bytes(std::span<const unsigned char> bytes, const std::string& name,
                                 const ReadOptions& options) {
  if (std::optional<Error> error = check_options(name, options)) return std::move(*error);
  if (bytes.size() > options.limits.max_bytes) {
    return error_in_file(name, Code::kOverLimit,
                         over_limit("bytes", "--max-bytes", options.limits.max_bytes));
  }
  return read_buffer(copy_to_buffer(bytes), name, options);
}

}  // namespace veritope
