// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/model_file.h"

namespace veritope {
namespace {

FormatId format_in(const MeshFile& file) { return file.report.format; }
FormatId format_in(const SplineFile& file) { return file.format; }
std::uint64_t bytes_in(const MeshFile& file) { return file.report.bytes; }
std::uint64_t bytes_in(const SplineFile& file) { return file.bytes; }

}  // namespace

const char* title_of(ModelKind kind) {
  switch (kind) {
    case ModelKind::kMesh: return "a mesh";
    case ModelKind::kSplines: return "a file of splines";
  }
  return "unknown";
}

FormatId format_of(const ModelFile& file) {
  return std::visit([](const auto& f) { return format_in(f); }, file);
}

std::uint64_t num_bytes(const ModelFile& file) {
  return std::visit([](const auto& f) { return bytes_in(f); }, file);
}

const std::string& sha256_of(const ModelFile& file) {
  return std::visit([](const auto& f) -> const std::string& { return f.sha256; }, file);
}

}  // namespace veritope
