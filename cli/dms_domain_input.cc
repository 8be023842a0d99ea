// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/dms_domain_input.h"

#include <utility>

#include "cli/certification.h"
#include "io/base/source.h"
#include "io/formats.h"
#include "predicates/exact_point.h"

namespace veritope::cli {
namespace {

bool is_of_tetgen(const std::string& path) {
  return path.ends_with(".node") || path.ends_with(".ele");
}

Error with_file(Error error, const std::string& path) {
  error.place.file = path;
  return error;
}

Result<TetrahedraFile> read_tetgen_pair(const std::string& path, const ModelReadOptions& reading) {
  const std::vector<std::string> files = files_of_domain_input(path);
  const Result<ModelBytes> nodes = load_model(files[0], reading);
  if (!nodes) return nodes.error();
  const Result<ModelBytes> elements = load_model(files[1], reading);
  if (!elements) return elements.error();
  return read_tetgen(source_of(nodes->bytes, nodes->name),
                     source_of(elements->bytes, elements->name), reading.limits);
}

}  // namespace

std::vector<std::string> files_of_domain_input(const std::string& path) {
  if (!is_of_tetgen(path)) return {path};
  const std::string stem = path.substr(0, path.rfind('.'));
  return {stem + ".node", stem + ".ele"};
}

Result<DomainInput> kind_of_domain_input(const std::string& path, const ModelReadOptions& reading) {
  if (needs_copy(path)) return DomainInput::kPoints;
  if (is_of_tetgen(path)) return DomainInput::kTetrahedra;
  const Result<ModelBytes> file = load_model(path, reading);
  if (!file) return file.error();
  if (tetrahedra_format_of(source_of(file->bytes, file->name))) return DomainInput::kTetrahedra;
  const bool is_model = format_from_path(path) != nullptr || choose_format(*file, reading);
  return is_model ? DomainInput::kMesh : DomainInput::kPoints;
}

Result<TetrahedraFile> read_tetrahedra(const std::string& path, const ModelReadOptions& reading) {
  if (is_of_tetgen(path)) return read_tetgen_pair(path, reading);
  const Result<ModelBytes> file = load_model(path, reading);
  if (!file) return file.error();
  const veritope::Source source = source_of(file->bytes, file->name);
  Result<TetrahedraFile> read = tetrahedra_format_of(source) == TetrahedraFormat::kMedit
                                    ? read_medit(source, reading.limits)
                                    : read_gmsh(source, reading.limits);
  if (!read && read.error().place.file.empty()) return with_file(read.error(), path);
  return read;
}

void turn_to_positive(const std::vector<std::array<Rational, 3>>& points,
                      std::vector<TetrahedronCorners>& tetrahedra) {
  const std::vector<ExactPoint3> exact(points.begin(), points.end());
  for (TetrahedronCorners& t : tetrahedra)
    if (orient3d(exact[t[0]], exact[t[1]], exact[t[2]], exact[t[3]]) == Sign::kNegative)
      std::swap(t[2], t[3]);
}

}  // namespace veritope::cli
