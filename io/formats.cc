// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/formats.h"

#include <algorithm>

#include "io/base/scan.h"
#include "io/dms/write_dms.h"
#include "io/foreign_content.h"
#include "io/itd_polygons.h"
#include "io/mesh/sniff.h"
#include "io/mesh/write_mesh.h"
#include "io/micro/write_micro.h"
#include "io/splines/spline_sniff.h"
#include "io/splines/write_splines.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

using LooksLike = bool (*)(const Source&);
using SecondGuess = std::string (*)(const Source&);

template <MeshFormat kFormat>
Result<ModelFile> read_as_mesh(const Source& source, const ModelReadOptions& options) {
  Result<MeshFile> file =
      read_mesh(kFormat, source, options.limits, options.as_indexed, options.with_normals);
  if (!file) return file.error();
  return ModelFile(std::move(*file));
}

// For kinds whose reader takes the format, the bytes and the limits.
template <auto kFormat, auto kRead>
Result<ModelFile> read_with(const Source& source, const ModelReadOptions& options) {
  auto file = kRead(kFormat, source, options.limits);
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
ModelFormat mesh(std::vector<std::string_view> endings, LooksLike looks_like,
                 SecondGuess second_guess = nullptr) {
  return {kFormat,       mesh_format_name(kFormat), std::move(endings),
          looks_like,    read_as_mesh<kFormat>,     second_guess,
          write<kFormat>};
}

template <SplineFormat kFormat>
ModelFormat splines(std::vector<std::string_view> endings, LooksLike looks_like) {
  return {kFormat,
          spline_format_name(kFormat),
          std::move(endings),
          looks_like,
          read_with<kFormat, read_splines>,
          binary_guess,
          can_write(kFormat) ? write<kFormat> : nullptr};
}

// A file whose only shapes are polygons is a mesh, unless splines are required.
Result<ModelFile> read_itd_file(const Source& source, const ModelReadOptions& options) {
  Result<SplineFile> splines = read_splines(SplineFormat::kItd, source, options.limits);
  if (!splines) return splines.error();
  if (options.kind == ModelKind::kSplines || !holds_only_polygons(*splines))
    return ModelFile(std::move(*splines));
  Result<MeshFile> mesh = read_itd_polygons(source, *splines, options.limits);
  if (!mesh) return mesh.error();
  return ModelFile(std::move(*mesh));
}

ModelFormat itd() {
  ModelFormat row = splines<SplineFormat::kItd>({"itd"}, looks_like_itd);
  row.read = read_itd_file;
  return row;
}

ModelFormat micro() {
  const auto write_file = [](const ModelFile& file, const ReadLimits&) -> Result<std::string> {
    return write_micro(std::get<MicroFile>(file).micro);
  };
  return {MicroFormat::kMicro,
          "vmicro",
          {"vmicro"},
          looks_like_micro,
          read_with<MicroFormat::kMicro, read_micro>,
          binary_guess,
          write_file};
}

ModelFormat dms() {
  const auto write_file = [](const ModelFile& file, const ReadLimits&) -> Result<std::string> {
    return write_dms(std::get<DmsFile>(file).model);
  };
  return {
      DmsFormat::kDms, "vdms",    {"vdms"}, looks_like_dms, read_with<DmsFormat::kDms, read_dms>,
      binary_guess,    write_file};
}

// The table. Meshes come first: content that looks like both a mesh and splines is read as a mesh.
const std::vector<ModelFormat>& rows() {
  static const std::vector<ModelFormat> table = {
      mesh<MeshFormat::kStl>({"stl"}, looks_like_stl, size_as_binary_stl),
      mesh<MeshFormat::kObj>({"obj"}, looks_like_obj, binary_guess),
      mesh<MeshFormat::kPly>({"ply"}, looks_like_ply),
      mesh<MeshFormat::kOff>({"off"}, looks_like_off, binary_guess),
      itd(),
      splines<SplineFormat::kG2>({"g2"}, looks_like_g2),
      splines<SplineFormat::kMfem>({"mfem", "mesh"}, looks_like_mfem),
      splines<SplineFormat::kGismo>({"gismo", "xml"}, looks_like_gismo),
      splines<SplineFormat::kJson>({"vjson", "json"}, looks_like_spline_json),
      micro(),
      dms(),
  };
  return table;
}

bool is_called(const ModelFormat& row, std::string_view word) {
  return is_word(word, row.name) ||
         std::any_of(row.endings.begin(), row.endings.end(),
                     [&](std::string_view ending) { return is_word(word, ending); });
}

// The letters after the last dot of the file name; nothing if there is no dot.
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

}  // namespace

std::span<const ModelFormat> model_formats() { return rows(); }

const ModelFormat& model_format(const FormatId& id) {
  const ModelFormat* const found =
      first(std::nullopt, [&](const ModelFormat& row) { return row.id == id; });
  VT_CHECK(found != nullptr, "every format has a row");
  return *found;
}

const ModelFormat* format_from_name(std::string_view name, std::optional<ModelKind> kind) {
  return first(kind, [&](const ModelFormat& row) { return is_called(row, name); });
}

const ModelFormat* format_from_path(std::string_view path, std::optional<ModelKind> kind) {
  const auto ending = ending_of(path);
  return ending ? format_from_name(*ending, kind) : nullptr;
}

const ModelFormat* format_from_content(const Source& source, std::optional<ModelKind> kind) {
  return first(kind, [&](const ModelFormat& row) { return row.looks_like(source); });
}

std::string format_names(std::string_view conjunction, std::optional<ModelKind> kind) {
  std::vector<std::string_view> names;
  for (const ModelFormat& row : rows())
    if (!kind || row.kind() == *kind) names.push_back(row.name);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " " + std::string(conjunction) + " ";
    text += names[i];
  }
  return text;
}

}  // namespace veritope
