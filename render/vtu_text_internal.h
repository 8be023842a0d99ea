// SPDX-License-Identifier: LGPL-3.0-or-later
// render/vtu_text_internal.h: what the writers of VTK's unstructured grids in ASCII share. Version 2.2 of the file
// format: the order of points within a hexahedron is that of VTK 9.1 and later, which older versions do not have.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace veritope::internal {

inline std::string vtu_array(const char* type, std::string_view name, int components,
                             const std::string& values) {
  return std::string("<DataArray type=\"") + type + "\" Name=\"" + std::string(name) +
         "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"ascii\">\n" +
         values + "</DataArray>\n";
}
inline std::string vtu_begin(std::uint64_t num_points, std::uint64_t num_cells) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" "
         "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
         "<Piece NumberOfPoints=\"" +
         std::to_string(num_points) + "\" NumberOfCells=\"" + std::to_string(num_cells) + "\">\n";
}
inline constexpr std::string_view kVtuEnd = "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";

/// Text with the characters that XML reserves replaced by entities, and those that it excludes by "\\x01" and so on.
inline std::string xml_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) {
          out += c;
        } else {
          constexpr const char* kDigits = "0123456789abcdef";
          out += std::string("\\x") + kDigits[c >> 4] + kDigits[c & 15];
        }
    }
  }
  return out;
}

}  // namespace veritope::internal
