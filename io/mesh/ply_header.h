// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/ply_header.h: the header of a PLY file (reading rule v1, section 4) and what it says about the mesh.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/base/source.h"
#include "io/mesh/read_mesh.h"
#include "robust/base/result.h"

namespace veritope {

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

enum class PlyType : std::uint8_t {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kFloat32,
  kFloat64
};
std::size_t ply_type_size(PlyType type);
bool is_ply_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kInt8;
  std::optional<PlyType> count_type;  ///< set: a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  const char* line = nullptr;  ///< where the header announces it

  /// The number of the list, or scalar, with this name; nothing unless there is exactly one.
  std::optional<std::size_t> find(std::string_view property, bool is_list) const;
  /// Bytes of an instance whose lists are empty; in ASCII two for each token.
  std::uint64_t least_size(PlyEncoding encoding) const;
  bool has_lists() const;
};

/// The role of an element in the mesh.
enum class PlyRole { kVertices, kFaces, kStrips, kOther };
PlyRole ply_role(const PlyElement& element);

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::uint64_t comments = 0;  ///< comment and obj_info lines
  const char* body = nullptr;  ///< after the line end of end_header

  // Valid after check_ply_header() returned success.
  std::uint64_t num_vertices = 0;
  std::size_t xyz[3] = {0, 0, 0};  ///< property numbers in element vertex
  /// Those of nx, ny and nz, if they are to be read and all three are there, once each.
  std::optional<std::array<std::size_t, 3>> normal;
};

/// Reads the lines up to end_header. Checks each line, not the whole.
Result<PlyHeader> parse_ply_header(const Source& source);

/// Checks that the elements make a mesh, fit into the bytes after the header and keep to the limits; fills
/// num_vertices and xyz.
Status check_ply_header(const Source& source, const ReadLimits& limits, PlyHeader& header);

/// The number of the list property vertex_indices or vertex_index. REQUIRES a checked element of faces or strips.
std::size_t ply_index_list(const PlyElement& element);

}  // namespace veritope
