// SPDX-License-Identifier: LGPL-3.0-or-later
// render/gltf_buffer_internal.h: the binary part of a glTF 2.0 file: accessors into one buffer, which is written as
// base64 into the JSON.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "robust/base/box3d.h"

namespace veritope::internal {

class GltfBuffer {
 public:
  static constexpr int kTriangles = 4, kLineStrip = 3, kLines = 1;

  /// The number of an accessor of these points minus the origin, in binary32. REQUIRES a point; finite results.
  std::size_t add_points(const std::vector<Point3d>& points, const Point3d& origin = {});
  /// A primitive with these indices of points, without its closing brace. REQUIRES an index.
  std::string open_primitive(std::span<const std::uint32_t> indices, std::size_t points, int mode);
  /// `"accessors":[...],"bufferViews":[...],"buffers":[...]`
  std::string json() const;

 private:
  template <typename T>
  void append(T value);
  std::size_t accessor(std::size_t begin, const std::string& rest, int target);

  std::string data_, views_, accessors_;
  std::size_t num_ = 0;
};

}  // namespace veritope::internal
