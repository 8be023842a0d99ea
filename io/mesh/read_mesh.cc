// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/read_mesh.h"

#include <algorithm>

#include "io/mesh/parsed_mesh.h"
#include "io/mesh/vertex_table.h"

namespace veritope {
namespace {

Result<ParsedMesh> parse(MeshFormat format, const Source& source, const ReadLimits& limits,
                         bool with_normals) {
  switch (format) {
    case MeshFormat::kStl: return read_stl(source, limits);
    case MeshFormat::kObj: return read_obj(source, limits, with_normals);
    case MeshFormat::kPly: return read_ply(source, limits, with_normals);
    case MeshFormat::kOff: return read_off(source, limits);
  }
  return error_in_file(*source.name, Code::kBadArgument, "no such format");
}

std::uint64_t count_referenced(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const auto& face : mesh.faces) {
    for (const std::uint32_t v : face) used[v] = true;
  }
  return static_cast<std::uint64_t>(std::count(used.begin(), used.end(), true));
}

void merge_and_count(ParsedMesh& parsed, bool as_indexed) {
  TriangleMesh& mesh = parsed.mesh;
  ReadReport& report = parsed.report;
  if (report.format == MeshFormat::kStl) {
    report.distinct_vertices = mesh.positions.size();
  } else {
    report.distinct_vertices =
        as_indexed ? count_distinct_positions(mesh) : merge_equal_positions(mesh);
  }
  report.referenced_vertices = count_referenced(mesh);
  report.unreferenced_vertices = mesh.positions.size() - report.referenced_vertices;
}

}  // namespace

Result<MeshFile> read_mesh(MeshFormat format, const Source& source, const ReadLimits& limits,
                           bool as_indexed, bool with_normals) {
  Result<ParsedMesh> parsed = parse(format, source, limits, with_normals);
  if (!parsed) return parsed.error();
  parsed->report.format = format;
  parsed->report.bytes = source.size();
  parsed->report.as_indexed = as_indexed && format != MeshFormat::kStl;
  merge_and_count(*parsed, as_indexed);
  MeshFile file;
  file.mesh = std::move(parsed->mesh);
  file.report = std::move(parsed->report);
  file.normals = std::move(parsed->normals);
  file.polygon_of_face = std::move(parsed->polygon_of_face);
  return file;
}

}  // namespace veritope
