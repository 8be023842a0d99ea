// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/spline_view.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>

#include "io/base/scan.h"
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

// glTF 2.0: accessors into one buffer.
class GltfWriter {
 public:
  std::string write(const std::vector<Tessellation>& parts) {
    std::string nodes, meshes, roots;
    std::size_t count = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Tessellation& t = parts[i];
      if (t.points.empty() || (t.lines.empty() && t.triangles.empty())) continue;
      const std::string number = std::to_string(count);
      meshes += (count == 0 ? "" : ",\n") + std::string("{\"primitives\":[") + primitives(t) + "]}";
      nodes += (count == 0 ? "" : ",") + std::string("{\"name\":\"entity ") + std::to_string(i) +
               "\",\"mesh\":" + number + "}";
      roots += (count == 0 ? "" : ",") + number;
      ++count;
    }
    std::string out = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"veritope\"}";
    if (count == 0) return out + "}\n";
    return out + ",\n\"scene\":0,\"scenes\":[{\"nodes\":[" + roots + "]}],\n\"nodes\":[" + nodes +
           "],\n\"meshes\":[" + meshes + "],\n\"accessors\":[" + accessors_ +
           "],\n\"bufferViews\":[" + views_ +
           "],\n\"buffers\":[{\"byteLength\":" + std::to_string(data_.size()) +
           ",\"uri\":\"data:application/octet-stream;base64," + base64(data_) + "\"}]}\n";
  }

 private:
  template <typename T>
  void append(T value) {
    static_assert(std::endian::native == std::endian::little);
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    data_.append(bytes, sizeof value);
  }
  std::size_t accessor(std::size_t begin, const std::string& rest, int target) {
    views_ += (num_ == 0 ? "" : ",") + std::string("{\"buffer\":0,\"byteOffset\":") +
              std::to_string(begin) + ",\"byteLength\":" + std::to_string(data_.size() - begin) +
              ",\"target\":" + std::to_string(target) + "}";
    accessors_ += (num_ == 0 ? "" : ",\n") + std::string("{\"bufferView\":") +
                  std::to_string(num_) + "," + rest + "}";
    return num_++;
  }
  std::size_t positions(const Tessellation& t) {
    const std::size_t begin = data_.size();
    std::array<float, 3> lo, hi;
    lo.fill(HUGE_VALF), hi.fill(-HUGE_VALF);
    for (const auto& p : t.points)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto x = static_cast<float>(p[k]);
        lo[k] = std::min(lo[k], x), hi[k] = std::max(hi[k], x);
        append(x);
      }
    std::string rest = "\"componentType\":5126,\"count\":" + std::to_string(t.points.size()) +
                       ",\"type\":\"VEC3\"";
    for (const auto& [name, corner] : {std::pair{"min", lo}, std::pair{"max", hi}}) {
      rest += std::string(",\"") + name + "\":[";
      for (std::size_t k = 0; k < 3; ++k) rest += k == 0 ? "" : ",", append_number(rest, corner[k]);
      rest += ']';
    }
    return accessor(begin, rest, 34962);
  }
  std::string indices(const std::uint32_t* first, std::size_t count, std::size_t position,
                      int mode) {
    const std::size_t begin = data_.size();
    for (std::size_t i = 0; i < count; ++i) append(first[i]);
    const std::size_t n = accessor(
        begin, "\"componentType\":5125,\"count\":" + std::to_string(count) + ",\"type\":\"SCALAR\"",
        34963);
    return "{\"attributes\":{\"POSITION\":" + std::to_string(position) +
           "},\"indices\":" + std::to_string(n) + ",\"mode\":" + std::to_string(mode) + "}";
  }
  std::string primitives(const Tessellation& t) {
    const std::size_t position = positions(t);
    std::string out;
    if (!t.triangles.empty())
      out = indices(t.triangles[0].data(), 3 * t.triangles.size(), position, 4);
    for (const auto& line : t.lines)
      out += (out.empty() ? "" : ",") + indices(line.data(), line.size(), position, 3);
    return out;
  }

  std::string data_, views_, accessors_;
  std::size_t num_ = 0;
};

}  // namespace

std::string gltf_bytes(const std::vector<Tessellation>& parts) { return GltfWriter().write(parts); }

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
