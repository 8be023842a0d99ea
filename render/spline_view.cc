// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/spline_view.h"

#include <charconv>

#include "io/base/scan.h"
#include "render/gltf_buffer_internal.h"
#include "render/spline_view_internal.h"

namespace veritope {
namespace internal {

void append_number(std::string& out, double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  out.append(digits, end.ptr);
}

std::string obj_bytes(const std::vector<Tessellation>& parts) {
  std::string out;
  std::uint64_t first = 1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Tessellation& t = parts[i];
    std::string name;
    for (const char c : t.name)
      name += static_cast<unsigned char>(c) <= ' ' || c == 0x7F || c == '\\' ? '_' : c;
    out += "o entity_" + std::to_string(i) + (name.empty() ? "" : "_" + name) + "\n";
    for (const auto& p : t.points) {
      out += 'v';
      for (const double x : p) out += ' ', append_number(out, x);
      out += '\n';
    }
    for (const auto& line : t.lines) {
      out += 'l';
      for (const std::uint32_t v : line) out += ' ' + std::to_string(first + v);
      out += '\n';
    }
    for (const auto& f : t.triangles) {
      out += 'f';
      for (const std::uint32_t v : f) out += ' ' + std::to_string(first + v);
      out += '\n';
    }
    first += t.points.size();
  }
  return out;
}

namespace {

std::string primitives_of(const Tessellation& t, GltfBuffer& buffer) {
  const std::size_t points = buffer.add_points(t.points);
  std::string out;
  if (!t.triangles.empty())
    out = buffer.open_primitive({t.triangles[0].data(), 3 * t.triangles.size()}, points,
                                GltfBuffer::kTriangles) +
          "}";
  for (const auto& line : t.lines)
    out += (out.empty() ? "" : ",") + buffer.open_primitive(line, points, GltfBuffer::kLineStrip) +
           "}";
  return out;
}

}  // namespace

std::string gltf_bytes(const std::vector<Tessellation>& parts) {
  GltfBuffer buffer;
  std::string nodes, meshes, roots;
  std::size_t count = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Tessellation& t = parts[i];
    if (t.points.empty() || (t.lines.empty() && t.triangles.empty())) continue;
    const std::string number = std::to_string(count);
    meshes += (count == 0 ? "" : ",\n") + std::string("{\"primitives\":[") +
              primitives_of(t, buffer) + "]}";
    nodes += (count == 0 ? "" : ",") + std::string("{\"name\":\"entity ") + std::to_string(i) +
             "\",\"mesh\":" + number + "}";
    roots += (count == 0 ? "" : ",") + number;
    ++count;
  }
  const std::string out = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"veritope\"}";
  if (count == 0) return out + "}\n";
  return out + ",\n\"scene\":0,\"scenes\":[{\"nodes\":[" + roots + "]}],\n\"nodes\":[" + nodes +
         "],\n\"meshes\":[" + meshes + "],\n" + buffer.json() + "}\n";
}

}  // namespace internal

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k > bytes.size() ? '=' : kLetters[word >> (18 - 6 * k) & 63];
  }
  return out;
}

std::optional<ViewFormat> view_format_from_name(std::string_view name) {
  if (is_word(name, "vtu")) return ViewFormat::kVtu;
  if (is_word(name, "obj")) return ViewFormat::kObj;
  if (is_word(name, "gltf")) return ViewFormat::kGltf;
  return std::nullopt;
}

Result<std::string> view_bytes(const SplineModel& model, ViewFormat format,
                               const ViewOptions& options) {
  if (format == ViewFormat::kVtu) return internal::vtu_bytes(model);
  const auto parts = tessellate(model, options);
  if (!parts) return parts.error();
  if (format == ViewFormat::kObj) return internal::obj_bytes(*parts);
  for (std::size_t i = 0; i < parts->size(); ++i)
    for (const auto& p : (*parts)[i].points)
      for (const double x : p)
        if (!std::isfinite(static_cast<float>(x)))
          return internal::view_error(Code::kNotFinite, i,
                                      "a coordinate is too large for binary32, which glTF has");
  return internal::gltf_bytes(*parts);
}

}  // namespace veritope
