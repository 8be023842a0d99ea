// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "render/gltf_buffer_internal.h"
#include "render/spline_view_internal.h"

namespace veritope::internal {

template <typename T>
void GltfBuffer::append(T value) {
  static_assert(std::endian::native == std::endian::little);
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  data_.append(bytes, sizeof value);
}

std::size_t GltfBuffer::accessor(std::size_t begin, const std::string& rest, int target) {
  views_ += (num_ == 0 ? "" : ",") + std::string("{\"buffer\":0,\"byteOffset\":") +
            std::to_string(begin) + ",\"byteLength\":" + std::to_string(data_.size() - begin) +
            ",\"target\":" + std::to_string(target) + "}";
  accessors_ += (num_ == 0 ? "" : ",\n") + std::string("{\"bufferView\":") + std::to_string(num_) +
                "," + rest + "}";
  return num_++;
}

std::size_t GltfBuffer::add_points(const std::vector<Point3d>& points, const Point3d& origin) {
  const std::size_t begin = data_.size();
  std::array<float, 3> lo, hi;
  lo.fill(HUGE_VALF), hi.fill(-HUGE_VALF);
  for (const Point3d& p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto x = static_cast<float>(p[k] - origin[k]);
      lo[k] = std::min(lo[k], x), hi[k] = std::max(hi[k], x);
      append(x);
    }
  std::string rest =
      "\"componentType\":5126,\"count\":" + std::to_string(points.size()) + ",\"type\":\"VEC3\"";
  for (const auto& [name, corner] : {std::pair{"min", lo}, std::pair{"max", hi}}) {
    rest += std::string(",\"") + name + "\":[";
    for (std::size_t k = 0; k < 3; ++k)
      rest += k == 0 ? "" : ",", append_number(rest, static_cast<double>(corner[k]));
    rest += ']';
  }
  return accessor(begin, rest, 34962);
}

std::string GltfBuffer::open_primitive(std::span<const std::uint32_t> indices, std::size_t points,
                                       int mode) {
  const std::size_t begin = data_.size();
  for (const std::uint32_t i : indices) append(i);
  const std::size_t n = accessor(
      begin,
      "\"componentType\":5125,\"count\":" + std::to_string(indices.size()) + ",\"type\":\"SCALAR\"",
      34963);
  return "{\"attributes\":{\"POSITION\":" + std::to_string(points) +
         "},\"indices\":" + std::to_string(n) + ",\"mode\":" + std::to_string(mode);
}

std::string GltfBuffer::json() const {
  return "\"accessors\":[" + accessors_ + "],\n\"bufferViews\":[" + views_ +
         "],\n\"buffers\":[{\"byteLength\":" + std::to_string(data_.size()) +
         ",\"uri\":\"data:application/octet-stream;base64," + base64(data_) + "\"}]";
}

}  // namespace veritope::internal
