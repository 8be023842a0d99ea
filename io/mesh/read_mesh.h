// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/read_mesh.h: from the bytes of a mesh to the triangles that they mean, or to an error with its place.
// The rule: docs/certificates/reading-rule-1.md, version 1. The checkers implement the same page on their own.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "io/mesh/mesh_format.h"
#include "robust/base/result.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// Something that the reading rule accepts, but that the author of the file may not have meant.
struct ReadNotice {
  std::string code;     ///< "data-after-end": the file goes on after what its counts announce
  std::string message;  ///< "7 more facets follow the stated 5: the count may be wrong"
};

/// What was read, and what was ignored.
struct ReadReport {
  MeshFormat format = MeshFormat::kStl;  ///< of the copy, if there is one
  /// The name of the file's format, if it is not one of the reading rule: "itd"; else empty.
  std::string container;
  std::string variant;  ///< stl-ascii, stl-binary, obj, ply-ascii, ply-binary-little-endian,
                        ///< ply-binary-big-endian, off; itd
  std::uint64_t bytes = 0;
  bool as_indexed = false;  ///< the file's own vertex indices were kept: requested, and not STL
  std::uint64_t file_vertices =
      0;  ///< vertices that the file lists; for STL the number of distinct positions
  std::uint64_t distinct_vertices = 0;      ///< positions that differ as numbers
  std::uint64_t referenced_vertices = 0;    ///< ids that a triangle uses
  std::uint64_t unreferenced_vertices = 0;  ///< mesh.positions.size() - referenced_vertices
  std::uint64_t polygons_split = 0;         ///< polygons with more than three corners
  std::uint64_t strip_joints = 0;           ///< dropped triangles of strips (two equal indices)
  /// What was ignored, with counts, in a fixed order: {"normals", 12}, {"usemtl lines", 3}, ...
  std::vector<std::pair<std::string, std::uint64_t>> ignored;
  std::vector<ReadNotice> notices;
};

/// The normals of a file, exactly as the decimals and floats that it has: of any length. Reading rule v1 ignores them.
struct MeshNormals {
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<Vec3d> values;  ///< finite
  std::vector<std::array<std::uint32_t, 3>>
      of_face;  ///< for each corner of each face: kNone, or in range
};

/// A mesh file with the mesh of a file that the reading rule does not know: certificates speak of its bytes.
struct MeshCopy {
  std::string bytes;   ///< in the format of the report
  std::string sha256;  ///< 64 lower-case hex digits
  std::string what;    ///< what of the file it has: "its 6 polygons"
};

struct MeshFile {
  static constexpr const char* kTitle = "a mesh";

  TriangleMesh mesh;  ///< at least one face; every id in range; every coordinate finite, none -0
  ReadReport report;
  std::string sha256;  ///< the SHA-256 of the bytes that were read, 64 lower-case hex digits
  /// The polygon (counted from 0 in file order) that a face was cut from; empty if all were triangles.
  std::vector<std::uint32_t> polygon_of_face;
  /// If they were requested, and a face of an OBJ file, or the vertices of a PLY file, have some.
  std::optional<MeshNormals> normals;
  std::optional<MeshCopy> copy;  ///< if report.container is not empty
  double seconds_read = 0;       ///< file to memory
  double seconds_parse = 0;      ///< memory to triangles, merging included
  double seconds_hash = 0;       ///< SHA-256; with jobs >= 2 at the same time as parsing
};

/// Reads the bytes as a file of this format. Does not set sha256 and the seconds. Files are read by io/read_model.h.
/// @param  as_indexed  keep the file's own indices (no effect on STL)
/// @param  with_normals  keep the normals of OBJ (vn) and PLY (nx, ny, nz). What is wrong with them is an error then
/// @error  kEmpty, kSyntax, kTruncated, kNotFinite, kIndexOutOfRange, kOverLimit, with the line of a text or the byte
///         of binary data
/// @cost O(bytes) time; memory at most a constant times the bytes, never the announced counts
Result<MeshFile> read_mesh(MeshFormat format, const Source& source, const ReadLimits& limits,
                           bool as_indexed, bool with_normals = false);

}  // namespace veritope
