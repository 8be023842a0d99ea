// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/ply_reader.cc: reading rule v1, section 4: polygons, strips, and the report.
#include "io/mesh/ply_reader.h"

#include "io/base/scan.h"

namespace veritope {
namespace {

const char* variant_name(PlyEncoding encoding) {
  switch (encoding) {
    case PlyEncoding::kAscii: return "ply-ascii";
    case PlyEncoding::kLittleEndian: return "ply-binary-little-endian";
    case PlyEncoding::kBigEndian: return "ply-binary-big-endian";
  }
  return "ply";
}

void count_ignored(const PlyHeader& header, IgnoredCounts& ignored) {
  ignored.add("header comments", header.comments);
  for (const PlyElement& element : header.elements) {
    const PlyRole role = ply_role(element);
    if (role == PlyRole::kOther) ignored.add("element " + element.name, element.count);
    if (role == PlyRole::kOther) continue;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const bool is_used = role == PlyRole::kVertices
                               ? i == header.xyz[0] || i == header.xyz[1] || i == header.xyz[2]
                               : i == ply_index_list(element);
      if (is_used) continue;
      ignored.add("property " + element.name + "." + element.properties[i].name, element.count);
    }
  }
}

void find_normals(PlyHeader& header) {
  for (const PlyElement& element : header.elements) {
    if (ply_role(element) != PlyRole::kVertices) continue;
    const auto x = element.find("nx", false), y = element.find("ny", false),
               z = element.find("nz", false);
    if (x && y && z) header.normal = {*x, *y, *z};
  }
}

}  // namespace

PlyLists::Fault PlyLists::too_many() const {
  return {Code::kOverLimit, over_limit("faces", "--max-faces", limits_.max_faces)};
}

std::optional<PlyLists::Fault> PlyLists::add(PlyRole role, std::span<const std::int64_t> indices) {
  for (const std::int64_t index : indices) {
    if (is_vertex(index) || (index == -1 && role == PlyRole::kStrips)) continue;
    return Fault{Code::kIndexOutOfRange, "vertex index " + std::to_string(index) +
                                             ", but there are " + std::to_string(num_vertices_) +
                                             " vertices"};
  }
  return role == PlyRole::kStrips ? add_strips(indices) : add_polygon(indices);
}

std::optional<PlyLists::Fault> PlyLists::add_polygon(std::span<const std::int64_t> indices) {
  if (indices.size() < 3) {
    return Fault{Code::kSyntax, "a face with " + std::to_string(indices.size()) + " corners"};
  }
  corners_.assign(indices.begin(), indices.end());
  if (!sink_.add_polygon(corners_)) return too_many();
  return std::nullopt;
}

std::optional<PlyLists::Fault> PlyLists::add_strips(std::span<const std::int64_t> indices) {
  std::size_t start = 0;  // the strip's first index
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] == -1) {
      start = i + 1;
      continue;
    }
    if (i < start + 2) continue;
    const auto a = static_cast<std::uint32_t>(indices[i - 2]);
    const auto b = static_cast<std::uint32_t>(indices[i - 1]);
    const auto c = static_cast<std::uint32_t>(indices[i]);
    if (a == b || b == c || c == a) {
      ++strip_joints_;
      continue;
    }
    const bool is_odd = (i - start - 2) % 2 == 1;
    if (!(is_odd ? sink_.add_triangle(b, a, c) : sink_.add_triangle(a, b, c))) return too_many();
  }
  return std::nullopt;
}

Result<ParsedMesh> PlyLists::finish(const Source& source, const PlyHeader& header,
                                    std::vector<Vec3d> positions, std::vector<Vec3d> normals,
                                    const char* end) {
  if (sink_.faces.empty()) {
    const char* const what = "there is no triangle";
    return header.encoding == PlyEncoding::kAscii
               ? error_at_line(source, source.end, Code::kEmpty, what)
               : error_at_byte(source, end, Code::kEmpty, what);
  }
  ParsedMesh parsed;
  parsed.report.variant = variant_name(header.encoding);
  parsed.report.file_vertices = header.num_vertices;
  parsed.report.strip_joints = strip_joints_;
  parsed.mesh.positions = std::move(positions);
  if (header.normal) parsed.normals = MeshNormals{std::move(normals), sink_.faces};
  take_faces(sink_, parsed);
  IgnoredCounts ignored;
  count_ignored(header, ignored);
  if (header.encoding == PlyEncoding::kAscii) end = skip_space(end, source.end);
  ignored.add("bytes behind the last element", static_cast<std::uint64_t>(source.end - end));
  parsed.report.ignored = ignored.take();
  if (end < source.end) {
    const PlyElement& last = header.elements.back();
    notice_rest(static_cast<std::uint64_t>(source.end - end),
                "the stated " + std::to_string(last.count) + " of element " + escaped(last.name),
                parsed.report);
  }
  return parsed;
}

Result<ParsedMesh> read_ply(const Source& source, const ReadLimits& limits, bool with_normals) {
  Result<PlyHeader> header = parse_ply_header(source);
  if (!header) return header.error();
  const Status checked = check_ply_header(source, limits, *header);
  if (!checked) return checked.error();
  if (with_normals) find_normals(*header);
  return header->encoding == PlyEncoding::kAscii ? read_ply_ascii(source, limits, *header)
                                                 : read_ply_binary(source, limits, *header);
}

}  // namespace veritope
