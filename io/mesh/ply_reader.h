// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/ply_reader.h: what the binary and the ASCII reader of PLY bodies share.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/mesh/parsed_mesh.h"
#include "io/mesh/ply_header.h"

namespace veritope {

/// Turns index lists into triangles.
class PlyLists {
 public:
  PlyLists(const ReadLimits& limits, std::uint64_t num_vertices)
      : sink_(limits.max_faces), limits_(limits), num_vertices_(num_vertices) {}

  /// The reason why a list was refused; kEmpty: it was accepted.
  struct Fault {
    Code code = Code::kEmpty;
    std::string message;
  };
  /// A polygon or a strip, as the role says. @return nothing, or what is wrong with it
  std::optional<Fault> add(PlyRole role, std::span<const std::int64_t> indices);

  bool is_vertex(std::int64_t index) const {
    return index >= 0 && static_cast<std::uint64_t>(index) < num_vertices_;
  }
  /// A fast version of add() for the usual case: returns false and does nothing if add() would find
  /// a fault.
  bool add_triangle(const std::array<std::int64_t, 3>& v) {
    if (!(is_vertex(v[0]) && is_vertex(v[1]) && is_vertex(v[2]))) return false;
    return sink_.add_triangle(static_cast<std::uint32_t>(v[0]), static_cast<std::uint32_t>(v[1]),
                              static_cast<std::uint32_t>(v[2]));
  }
  void reserve(std::size_t faces) { sink_.faces.reserve(faces); }

  /// Combines positions and lists to the mesh of the file. `end`: after the last instance.
  /// `normals`: one for each vertex if the header has them.
  Result<ParsedMesh> finish(const Source& source, const PlyHeader& header,
                            std::vector<Vec3d> positions, std::vector<Vec3d> normals,
                            const char* end);

 private:
  std::optional<Fault> add_polygon(std::span<const std::int64_t> indices);
  std::optional<Fault> add_strips(std::span<const std::int64_t> indices);
  Fault too_many() const;

  FaceSink sink_;
  const ReadLimits& limits_;
  std::uint64_t num_vertices_;
  std::uint64_t strip_joints_ = 0;
  std::vector<std::uint32_t> corners_;
};

Result<ParsedMesh> read_ply_ascii(const Source& source, const ReadLimits& limits,
                                  const PlyHeader& header);
Result<ParsedMesh> read_ply_binary(const Source& source, const ReadLimits& limits,
                                   const PlyHeader& header);

}  // namespace veritope
