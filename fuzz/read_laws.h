// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_laws.h: laws that must hold whatever bytes a reader gets. A broken law throws InternalError. Used by the
// fuzz targets of the readers and by tests/io/fuzz_corpus_test.cc.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "io/mesh/write_mesh.h"
#include "io/read_model.h"
#include "robust/base/check.h"

namespace veritope::fuzz {

inline bool same_bits(const Vec3d& a, const Vec3d& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::bit_cast<std::uint64_t>(a[axis]) != std::bit_cast<std::uint64_t>(b[axis]))
      return false;
  }
  return true;
}

/// Law 1: a refusal has a file, a sentence in printable ASCII, and a place unless it is about the whole file.
inline void check_error(const Error& error) {
  VT_CHECK(error.place.file == "fuzz", "an error without its file");
  VT_CHECK(!error.message.empty() && error.message.size() < 300, "a message of a wrong length");
  for (const char c : error.message) VT_CHECK(c >= ' ' && c <= '~', "a message with raw bytes");
  const bool has_place = error.place.line.has_value() || error.place.byte.has_value();
  VT_CHECK(has_place || error.code == Code::kOverLimit, "a refusal without a place");
}

/// Law 2: the result is a mesh, and the report's counts are right.
inline void check_mesh(const MeshFile& file) {
  const TriangleMesh& mesh = file.mesh;
  VT_CHECK(!mesh.faces.empty(), "no face");
  for (const auto& face : mesh.faces) {
    for (const std::uint32_t v : face) VT_CHECK(v < mesh.positions.size(), "id out of range");
  }
  for (const Vec3d& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      VT_CHECK(std::isfinite(p[axis]), "a coordinate that is not finite");
      VT_CHECK(p[axis] != 0 || !std::signbit(p[axis]), "-0");
    }
  }
  const ReadReport& r = file.report;
  VT_CHECK(r.referenced_vertices + r.unreferenced_vertices == mesh.positions.size(), "counts");
  VT_CHECK(r.distinct_vertices <= r.file_vertices, "more positions than the file lists");
  VT_CHECK(file.polygon_of_face.size() == (r.polygons_split > 0 ? mesh.faces.size() : 0),
           "polygons");
  VT_CHECK(file.sha256.size() == 64, "hash");
}

/// Law 3: keeping the indices changes no triangle as points, and merged ids count first occurrences.
inline void check_merging(const MeshFile& merged, const MeshFile& indexed) {
  const TriangleMesh &a = merged.mesh, &b = indexed.mesh;
  VT_CHECK(merged.report.distinct_vertices == a.positions.size(), "merged, yet equal positions");
  VT_CHECK(a.faces.size() == b.faces.size(), "merging changed the number of faces");
  for (std::size_t f = 0; f < a.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      VT_CHECK(same_bits(a.positions[a.faces[f][k]], b.positions[b.faces[f][k]]),
               "merging moved a corner");
      VT_CHECK(a.faces[f][k] <= b.faces[f][k], "a merged id above the file's");
    }
  }
}

/// Law 4: reading any lossless file of the mesh gives the mesh again, bit for bit.
inline void check_round_trips(const TriangleMesh& mesh) {
  for (const std::string& name : write_variant_names()) {
    const WriteOptions how = write_options_from_name(name).value();
    if (!loss_of(mesh, how).is_lossless()) continue;
    const Result<std::string> bytes = mesh_to_bytes(mesh, how);
    VT_CHECK(bytes.has_value(), "a lossless file that cannot be written");
    ModelReadOptions options;
    options.format = how.format;
    options.as_indexed = true;
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.value().data());
    const Result<MeshFile> back = read_mesh_bytes({data, bytes.value().size()}, "fuzz", options);
    VT_CHECK(back.has_value(), "our own file is refused");
    VT_CHECK(back.value().mesh.faces == mesh.faces, "the faces changed");
    VT_CHECK(back.value().mesh.positions.size() == mesh.positions.size(), "the vertices changed");
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      VT_CHECK(same_bits(back.value().mesh.positions[i], mesh.positions[i]), "a vertex moved");
    }
  }
}

inline void check_reader(MeshFormat format, std::span<const std::uint8_t> bytes) {
  ModelReadOptions options;
  options.format = format;
  options.limits.max_bytes = 1 << 16;
  options.limits.max_faces = 4000;
  const Result<MeshFile> merged = read_mesh_bytes(bytes, "fuzz", options);
  options.as_indexed = true;
  const Result<MeshFile> indexed = read_mesh_bytes(bytes, "fuzz", options);
  VT_CHECK(merged.has_value() == indexed.has_value(), "as_indexed decides whether a file is read");
  if (!merged) {
    check_error(merged.error());
    VT_CHECK(to_string(merged.error()) == to_string(indexed.error()),
             "as_indexed changes the error");
    return;
  }
  check_mesh(merged.value());
  check_mesh(indexed.value());
  check_merging(merged.value(), indexed.value());
  check_round_trips(indexed.value().mesh);
}

}  // namespace veritope::fuzz
