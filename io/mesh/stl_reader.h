// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/stl_reader.h: the two kinds of STL, and the vertices that both derive from their corners.
#pragma once
#include <cstdint>
#include <vector>

#include "io/mesh/parsed_mesh.h"
#include "io/mesh/vertex_table.h"

namespace veritope {

inline constexpr std::uint64_t kStlHeader = 84, kStlFacet = 50;

/// Decides by the size of the file; if it is not that of a binary STL, by the first word.
bool is_stl_binary(const Source& source);
/// 84 + 50 n. REQUIRES at least 84 bytes.
std::uint64_t stl_binary_size(const Source& source);

Result<ParsedMesh> read_stl_binary(const Source& source, const ReadLimits& limits);
Result<ParsedMesh> read_stl_ascii(const Source& source, const ReadLimits& limits);

/// Turns corners into vertex ids; ids count first occurrences.
class CornerSink {
 public:
  static constexpr std::size_t kBatch = VertexTable::kBatch;  ///< corners, a multiple of three

  void reserve(std::size_t num_facets);
  /// Three corners a facet. REQUIRES corners.size() <= kBatch and divisible by three.
  void add(std::span<const Vec3d> corners);
  /// The triangles so far; the sink is empty afterwards.
  TriangleMesh take();
  std::size_t num_facets() const { return mesh_.faces.size(); }

 private:
  TriangleMesh mesh_;  ///< positions are larger than num_positions() of the table
  VertexTable table_;
};

}  // namespace veritope
