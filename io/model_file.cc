// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/model_file.h"

#include <array>
#include <cstddef>
#include <utility>

namespace veritope {
namespace {

// What every kind has; a mesh keeps it in the report of its reader.
template <typename File>
const auto& facts_of(const File& file) {
  if constexpr (requires { file.report; }) {
    return file.report;
  } else {
    return file;
  }
}

template <std::size_t... kKinds>
constexpr auto titles(std::index_sequence<kKinds...>) {
  return std::array{std::variant_alternative_t<kKinds, ModelFile>::kTitle...};
}

constexpr std::size_t kNumKinds = std::variant_size_v<ModelFile>;
static_assert(std::variant_size_v<FormatId> == kNumKinds, "each kind has formats of its own");

}  // namespace

const char* title_of(ModelKind kind) {
  return titles(std::make_index_sequence<kNumKinds>()).at(static_cast<std::size_t>(kind));
}

FormatId format_of(const ModelFile& file) {
  const auto* const mesh = std::get_if<MeshFile>(&file);
  if (mesh != nullptr && mesh->copy) return SplineFormat::kItd;  // its polygons
  return std::visit([](const auto& f) -> FormatId { return facts_of(f).format; }, file);
}

std::uint64_t num_bytes(const ModelFile& file) {
  return std::visit([](const auto& f) -> std::uint64_t { return facts_of(f).bytes; }, file);
}

const std::string& sha256_of(const ModelFile& file) {
  return std::visit([](const auto& f) -> const std::string& { return f.sha256; }, file);
}

}  // namespace veritope
