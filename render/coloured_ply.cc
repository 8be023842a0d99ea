// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/coloured_ply.h"

#include "io/mesh/mesh_encoder.h"
#include "robust/base/check.h"

namespace veritope {

std::string coloured_ply(const TriangleMesh& mesh, std::span<const Colour> colours,
                         const std::vector<std::string>& comments) {
  VT_CHECK(colours.size() == mesh.faces.size(), "one colour a face");
  std::string bytes;
  ChunkedOutput out([&bytes](std::string_view piece) {
    bytes.append(piece);
    return ok_status();
  });
  out.text("ply\nformat binary_little_endian 1.0\n");
  for (const std::string& line : comments) out.text("comment " + line + "\n");
  out.text("element vertex ");
  out.number(mesh.positions.size());
  for (const char axis : {'x', 'y', 'z'}) out.text(std::string("\nproperty double ") + axis);
  out.text("\nelement face ");
  out.number(mesh.faces.size());
  out.text("\nproperty list uchar uint vertex_indices");
  for (const char* name : {"red", "green", "blue"})
    out.text(std::string("\nproperty uchar ") + name);
  out.text("\nend_header\n");
  for (const Vec3d& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) out.binary(p[axis]);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    out.binary(std::uint8_t{3});
    for (const std::uint32_t v : mesh.faces[f]) out.binary(v);
    for (const std::uint8_t c : {colours[f].red, colours[f].green, colours[f].blue}) out.binary(c);
  }
  const Status status = out.finish();
  VT_CHECK(status.has_value(), "memory takes every byte");
  return bytes;
}

}  // namespace veritope
