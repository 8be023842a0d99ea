// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/formats.h"

#include <algorithm>

#include "io/base/scan.h"
#include "io/mesh/sniff.h"
#include "io/mesh/write_mesh.h"
#include "io/splines/write_splines.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

template <MeshFormat kFormat>
bool looks_like(const Source& source) {
  return mesh_format_from_content(source) == kFormat;
}

template <SplineFormat kFormat>
bool looks_like(const Source& source) {
  return spline_format_from_content(source) == kFormat;
}

template <MeshFormat kFormat>
Result<ModelFile> read(const Source& source, const ModelReadOptions& options) {
  ReadOptions mesh_options;
  mesh_options.as_indexed = options.as_indexed;
  mesh_options.limits = options.limits;
  mesh_options.jobs = options.jobs;
  Result<MeshFile> file = read_mesh(kFormat, source, mesh_options);
  if (!file) return file.error();
  return ModelFile(std::move(*file));
}

template <SplineFormat kFormat>
Result<ModelFile> read(const Source& source, const ModelReadOptions& options) {
  Result<SplineFile> file = read_splines(kFormat, source, options.limits);
  if (!file) return file.error();
  return ModelFile(std::move(*file));
}

template <MeshFormat kFormat>
Result<std::string> write(const ModelFile& file, const ReadLimits&) {
  return mesh_to_bytes(std::get<MeshFile>(file).mesh, default_write_options(kFormat));
}

template <SplineFormat kFormat>
Result<std::string> write(const ModelFile& file, const ReadLimits& limits) {
  return spline_bytes(std::get<SplineFile>(file).model, kFormat, limits);
}

template <MeshFormat kFormat>
ModelFormat row(std::vector<std::string_view> endings) {
  return {kFormat,
          mesh_format_name(kFormat),
          std::move(endings),
          looks_like<kFormat>,
          read<kFormat>,
          write<kFormat>};
}

template <SplineFormat kFormat>
ModelFormat row(std::vector<std::string_view> endings) {
  return {kFormat,
          spline_format_name(kFormat),
          std::move(endings),
          looks_like<kFormat>,
          read<kFormat>,
          can_write(kFormat) ? write<kFormat> : nullptr};
}

// The table.
const std::vector<ModelFormat>& rows() {
  static const std::vector<ModelFormat> table = {
      row<MeshFormat::kStl>({"stl"}),
      row<MeshFormat::kObj>({"obj"}),
      row<MeshFormat::kPly>({"ply"}),
      row<MeshFormat::kOff>({"off"}),
      row<SplineFormat::kItd>({"itd"}),
      row<SplineFormat::kG2>({"g2"}),
      row<SplineFormat::kMfem>({"mfem", "mesh"}),
      row<SplineFormat::kGismo>({"gismo", "xml"}),
      row<SplineFormat::kJson>({"vjson", "json"}),
  };
  return table;
}

bool is_called(const ModelFormat& row, std::string_view word) {
  return is_word(word, row.name) ||
         std::any_of(row.endings.begin(), row.endings.end(),
                     [&](std::string_view ending) { return is_word(word, ending); });
}

// The letters behind the last dot of the file name; nothing if there is no dot.
std::optional<std::string_view> ending_of(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  const std::string_view name = slash == path.npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.rfind('.');
  if (dot == name.npos) return std::nullopt;
  return name.substr(dot + 1);
}

template <typename Fits>
const ModelFormat* first(std::optional<ModelKind> kind, Fits fits) {
  for (const ModelFormat& row : rows())
    if ((!kind || row.kind() == *kind) && fits(row)) return &row;
  return nullptr;
}

const ModelFormat* from_name(std::string_view name, std::optional<ModelKind> kind) {
  return first(kind, [&](const ModelFormat& row) { return is_called(row, name); });
}

const ModelFormat* from_path(std::string_view path, std::optional<ModelKind> kind) {
  const auto ending = ending_of(path);
  return ending ? from_name(*ending, kind) : nullptr;
}

const ModelFormat* from_content(const Source& source, std::optional<ModelKind> kind) {
  return first(kind, [&](const ModelFormat& row) { return row.looks_like(source); });
}

}  // namespace

std::span<const ModelFormat> model_formats() { return rows(); }

const ModelFormat& model_format(const FormatId& id) {
  const ModelFormat* const found =
      first(std::nullopt, [&](const ModelFormat& row) { return row.id == id; });
  VT_CHECK(found != nullptr, "every format has a row");
  return *found;
}

const ModelFormat* format_from_name(std::string_view name) { return from_name(name, std::nullopt); }
const ModelFormat* format_from_path(std::string_view path) { return from_path(path, std::nullopt); }
const ModelFormat* format_from_content(const Source& source) {
  return from_content(source, std::nullopt);
}
const ModelFormat* format_from_name(std::string_view name, ModelKind kind) {
  return from_name(name, std::optional(kind));
}
const ModelFormat* format_from_path(std::string_view path, ModelKind kind) {
  return from_path(path, std::optional(kind));
}
const ModelFormat* format_from_content(const Source& source, ModelKind kind) {
  return from_content(source, std::optional(kind));
}

std::string format_names(std::optional<ModelKind> kind) {
  std::vector<std::string> names;
  for (const ModelFormat& row : rows())
    if (!kind || row.kind() == *kind) names.emplace_back(row.name);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  return text;
}

}  // namespace veritope
