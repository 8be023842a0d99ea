// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/write_mesh.h: a mesh as a file, and what the file would lose.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/mesh_format.h"
#include "robust/base/result.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

enum class MeshEncoding { kAscii, kLittleEndian, kBigEndian };

/// A format and how to write it. Texts hold the shortest decimals that read back as the same binary64.
struct WriteOptions {
  MeshFormat format = MeshFormat::kPly;
  MeshEncoding encoding = MeshEncoding::kAscii;  ///< OBJ, OFF: kAscii only; STL: not kBigEndian
  bool single_precision =
      false;  ///< binary PLY: float instead of double; binary STL is float anyway
};

/// "stl-ascii", "stl-binary", "obj", "ply-ascii", "ply-binary-little-endian", "ply-binary-big-endian", the last
/// two also with "-float", "off": every combination that can be written. Nothing for another name.
std::optional<WriteOptions> write_options_from_name(std::string_view variant);
std::vector<std::string> write_variant_names();

/// The default options of a format: STL in ASCII, PLY little-endian double (both keep the coordinates).
WriteOptions default_write_options(MeshFormat format);

/// What reading the file back would change. Exact: no tolerance.
struct LossReport {
  bool coordinates_change = false;
  /// Other vertex ids or triangles would be read: STL keeps no indices, and positions may become equal.
  bool indexing_changes = false;
  std::uint64_t moved_vertices = 0;   ///< vertices whose coordinates change
  std::uint64_t merged_vertices = 0;  ///< distinct positions before rounding, minus those after it
  double max_displacement =
      0;  ///< Euclidean, rounded up; infinity if a coordinate is too large for binary32
  std::uint32_t vertex = 0;  ///< the lowest id that moves that far, if any moves

  bool is_lossless() const { return !coordinates_change && !indexing_changes; }
};

/// REQUIRES finite coordinates, ids in range, and options that write_options_from_name could return.
LossReport loss_of(const TriangleMesh& mesh, const WriteOptions& options);

/// Replaces the file at `path` in one step (io/base/atomic_file.h); "-" is standard output.
/// REQUIRES finite coordinates and ids in range.
/// @error  kBadArgument for a combination that does not exist; kNotFinite with the vertex if a coordinate is too
///         large for binary32; kOverLimit for 2^32 faces or more; kCannotWrite
Status write_mesh_file(const std::string& path, const TriangleMesh& mesh,
                       const WriteOptions& options);

/// Returns these bytes instead of writing them.
Result<std::string> mesh_to_bytes(const TriangleMesh& mesh, const WriteOptions& options);

}  // namespace veritope
