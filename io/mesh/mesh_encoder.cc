// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/mesh_encoder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "robust/base/check.h"

namespace veritope {
namespace {

static_assert(std::endian::native == std::endian::little, "binary() reverses for big-endian files");

using Face = std::array<std::uint32_t, 3>;

void put_position(const Vec3d& p, ChunkedOutput& out) {
  out.number(p.x);
  out.text(" ");
  out.number(p.y);
  out.text(" ");
  out.number(p.z);
  out.text("\n");
}

// Writes three ids plus `base`, each after a blank, and a line end.
void put_corners(const Face& face, std::uint64_t base, ChunkedOutput& out) {
  for (const std::uint32_t v : face) {
    out.text(" ");
    out.number(v + base);
  }
  out.text("\n");
}

// A unit normal for programs that want one: rounded, zero if it cannot be computed; our readers ignore it.
Vec3d approx_normal(const TriangleMesh& mesh, const Face& face) {
  const Vec3d &a = mesh.positions[face[0]], &b = mesh.positions[face[1]],
              &c = mesh.positions[face[2]];
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
  if (!(length > 0 && length <= 1e300)) return {};
  return {nx / length + 0.0, ny / length + 0.0, nz / length + 0.0};
}

void encode_obj(const TriangleMesh& mesh, ChunkedOutput& out) {
  for (const Vec3d& p : mesh.positions) {
    out.text("v ");
    put_position(p, out);
  }
  for (const Face& face : mesh.faces) {
    out.text("f");
    put_corners(face, 1, out);
  }
}

void encode_off(const TriangleMesh& mesh, ChunkedOutput& out) {
  out.text("OFF\n");
  out.number(mesh.positions.size());
  out.text(" ");
  out.number(mesh.faces.size());
  out.text(" 0\n");
  for (const Vec3d& p : mesh.positions) put_position(p, out);
  for (const Face& face : mesh.faces) {
    out.text("3");
    put_corners(face, 0, out);
  }
}

void encode_stl_ascii(const TriangleMesh& mesh, ChunkedOutput& out) {
  out.text("solid veritope\n");
  for (const Face& face : mesh.faces) {
    const Vec3d normal = approx_normal(mesh, face);
    out.text("facet normal ");
    out.number(static_cast<float>(normal.x));
    out.text(" ");
    out.number(static_cast<float>(normal.y));
    out.text(" ");
    out.number(static_cast<float>(normal.z));
    out.text("\nouter loop\n");
    for (const std::uint32_t v : face) {
      out.text("vertex ");
      put_position(mesh.positions[v], out);
    }
    out.text("endloop\nendfacet\n");
  }
  out.text("endsolid veritope\n");
}

// REQUIRES three coordinates that to_binary32 accepts.
void put_floats(const Vec3d& p, bool is_big_endian, ChunkedOutput& out) {
  out.binary(to_binary32(p.x).value(), is_big_endian);
  out.binary(to_binary32(p.y).value(), is_big_endian);
  out.binary(to_binary32(p.z).value(), is_big_endian);
}

void encode_stl_binary(const TriangleMesh& mesh, ChunkedOutput& out) {
  std::string header = "binary STL, written by veritope";  // must not begin with "solid"
  header.resize(80, ' ');
  out.text(header);
  out.binary(static_cast<std::uint32_t>(mesh.faces.size()));
  for (const Face& face : mesh.faces) {
    put_floats(approx_normal(mesh, face), false, out);
    for (const std::uint32_t v : face) put_floats(mesh.positions[v], false, out);
    out.binary(std::uint16_t{0});
  }
}

void put_ply_header(const TriangleMesh& mesh, const WriteOptions& options, ChunkedOutput& out) {
  const char* const encoding = options.encoding == MeshEncoding::kAscii ? "ascii"
                               : options.encoding == MeshEncoding::kLittleEndian
                                   ? "binary_little_endian"
                                   : "binary_big_endian";
  const std::string type = is_rounding(options) ? "float" : "double";
  out.text(std::string("ply\nformat ") + encoding + " 1.0\nelement vertex ");
  out.number(mesh.positions.size());
  for (const char axis : {'x', 'y', 'z'}) out.text("\nproperty " + type + " " + axis);
  out.text("\nelement face ");
  out.number(mesh.faces.size());
  out.text("\nproperty list uchar uint vertex_indices\nend_header\n");
}

// The bytes of the arrays, many vertices and faces at once.
void put_little_endian(const TriangleMesh& mesh, ChunkedOutput& out) {
  constexpr std::size_t kVertices = 2048, kFaces = 4096, kFaceBytes = 13;
  static_assert(sizeof(Vec3d) == 3 * sizeof(double) && sizeof(Face) == kFaceBytes - 1);
  for (std::size_t v = 0; v < mesh.positions.size(); v += kVertices) {
    const std::size_t count = std::min(kVertices, mesh.positions.size() - v);
    out.text({reinterpret_cast<const char*>(mesh.positions.data() + v), count * sizeof(Vec3d)});
  }
  std::string some(kFaces * kFaceBytes, '\3');
  for (std::size_t f = 0; f < mesh.faces.size(); f += kFaces) {
    const std::size_t count = std::min(kFaces, mesh.faces.size() - f);
    for (std::size_t k = 0; k < count; ++k)
      std::memcpy(some.data() + k * kFaceBytes + 1, mesh.faces[f + k].data(), sizeof(Face));
    out.text({some.data(), count * kFaceBytes});
  }
}

void encode_ply(const TriangleMesh& mesh, const WriteOptions& options, ChunkedOutput& out) {
  put_ply_header(mesh, options, out);
  const bool is_text = options.encoding == MeshEncoding::kAscii;
  const bool is_big = options.encoding == MeshEncoding::kBigEndian;
  if (!is_text && !is_big && !is_rounding(options)) return put_little_endian(mesh, out);
  for (const Vec3d& p : mesh.positions) {
    if (is_text) {
      put_position(p, out);
    } else if (is_rounding(options)) {
      put_floats(p, is_big, out);
    } else {
      for (int axis = 0; axis < 3; ++axis) out.binary(p[axis], is_big);
    }
  }
  for (const Face& face : mesh.faces) {
    if (is_text) {
      out.text("3");
      put_corners(face, 0, out);
    } else {
      out.binary(std::uint8_t{3});
      for (const std::uint32_t v : face) out.binary(v, is_big);
    }
  }
}

}  // namespace

std::optional<float> to_binary32(double value) {
  // Values from half an ulp above the largest binary32 on round to infinity.
  if (!(std::abs(value) < 0x1.ffffffp127)) return std::nullopt;
  return static_cast<float>(value) + 0.0f;
}

bool is_rounding(const WriteOptions& options) {
  if (options.encoding == MeshEncoding::kAscii) return false;
  return options.format == MeshFormat::kStl || options.single_precision;
}

void encode_mesh(const TriangleMesh& mesh, const WriteOptions& options, ChunkedOutput& out) {
  const bool is_text = options.encoding == MeshEncoding::kAscii;
  switch (options.format) {
    case MeshFormat::kStl:
      return is_text ? encode_stl_ascii(mesh, out) : encode_stl_binary(mesh, out);
    case MeshFormat::kObj: return encode_obj(mesh, out);
    case MeshFormat::kPly: return encode_ply(mesh, options, out);
    case MeshFormat::kOff: return encode_off(mesh, out);
  }
}

}  // namespace veritope
