// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/read_mesh.h: from the bytes of a file to the triangles that they mean, or to an error with its place.
// The rule: docs/certificates/reading-rule-1.md, version 1. The checkers implement the same page on their own.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "io/mesh/mesh_format.h"
#include "robust/base/result.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

struct ReadOptions {
  std::optional<MeshFormat> format;  ///< nothing: from the extension, else from the content
  bool as_indexed = false;           ///< keep the file's own indices (no effect on STL)
  ReadLimits limits;
  int jobs = 1;  ///< threads; the result is the same for every value >= 1
};

/// What was read, and what was passed over.
struct ReadReport {
  MeshFormat format = MeshFormat::kStl;
  std::string variant;  ///< stl-ascii, stl-binary, obj, ply-ascii, ply-binary-little-endian,
                        ///< ply-binary-big-endian, off
  std::uint64_t bytes = 0;
  std::uint64_t file_vertices =
      0;  ///< that the file lists; for STL the number of distinct positions
  std::uint64_t distinct_vertices = 0;      ///< positions that differ as numbers
  std::uint64_t referenced_vertices = 0;    ///< ids that a triangle uses
  std::uint64_t unreferenced_vertices = 0;  ///< mesh.positions.size() - referenced_vertices
  std::uint64_t polygons_split = 0;         ///< polygons with more than three corners
  std::uint64_t strip_joints = 0;           ///< dropped triangles of strips (two equal indices)
  /// What was ignored, with counts, in a fixed order: {"normals", 12}, {"usemtl lines", 3}, ...
  std::vector<std::pair<std::string, std::uint64_t>> ignored;
};

struct MeshFile {
  TriangleMesh mesh;  ///< at least one face; every id in range; every coordinate finite, none -0
  ReadReport report;
  std::string sha256;  ///< of the bytes that were read, 64 lower-case hex digits
  /// The polygon (counted from 0 in file order) that a face was cut from; empty if all were triangles.
  std::vector<std::uint32_t> polygon_of_face;
  double seconds_read = 0;   ///< file to memory
  double seconds_parse = 0;  ///< memory to triangles, merging included
  double seconds_hash = 0;   ///< SHA-256; with jobs >= 2 at the same time as parsing
};

/// The bytes as a file of this format; options.format has no effect. Leaves sha256 and the seconds open.
/// @error  as read_mesh_file; kEmpty and what no reader takes are the caller's to refuse
Result<MeshFile> read_mesh(MeshFormat format, const Source& source, const ReadOptions& options);

/// Reads a regular file, or standard input if `path` is "-"; then options.format is required.
/// @error  kCannotOpen, kEmpty, kForeignFormat, kUnknownFormat, kSyntax, kTruncated, kNotFinite,
///         kIndexOutOfRange, kOverLimit; kBadArgument for "-" without a format and for jobs < 1.
///         The place holds the line of a text or the byte of binary data.
/// @cost   O(bytes) time; memory at most a constant times the bytes, never the announced counts
Result<MeshFile> read_mesh_file(const std::string& path, const ReadOptions& options);

/// The same for bytes in memory. `name` stands for the file in errors, and its extension counts as one.
Result<MeshFile> read_mesh_bytes(std::span<const unsigned char> bytes, const std::string& name,
                                 const ReadOptions& options);

}  // namespace veritope
