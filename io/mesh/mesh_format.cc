// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/mesh_format.h"

#include <array>
#include <string>

namespace veritope {
namespace {

constexpr std::array kFormats = {MeshFormat::kStl, MeshFormat::kObj, MeshFormat::kPly,
                                 MeshFormat::kOff};

// ASCII only: file names and options must not depend on the locale.
std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

}  // namespace

const char* mesh_format_name(MeshFormat format) {
  switch (format) {
    case MeshFormat::kStl: return "stl";
    case MeshFormat::kObj: return "obj";
    case MeshFormat::kPly: return "ply";
    case MeshFormat::kOff: return "off";
  }
  return "unknown";
}

std::optional<MeshFormat> mesh_format_from_name(std::string_view name) {
  const std::string word = lower(name);
  for (const MeshFormat format : kFormats) {
    if (word == mesh_format_name(format)) return format;
  }
  return std::nullopt;
}

std::optional<MeshFormat> mesh_format_from_path(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  const std::string_view name = slash == path.npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.rfind('.');
  if (dot == name.npos) return std::nullopt;
  return mesh_format_from_name(name.substr(dot + 1));
}

}  // namespace veritope
