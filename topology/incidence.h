// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/incidence.h: which faces meet at a vertex.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/buffer.h"

namespace veritope {

/// The corners at each vertex, as one array. A corner is 4 * face + k: the vertex is number k of the face.
/// Faces with a repeated id have no corners here.
class Incidence {
 public:
  /// Largest number of faces that a corner can name.
  static constexpr std::uint64_t kMaxFaces = 1u << 30;

  /// REQUIRES ids < num_vertices, faces.size() <= kMaxFaces. Corners of a vertex ascend. @cost O(F + V) time, 4 bytes
  /// per corner and jobs * 4 bytes per vertex.
  static Incidence build(std::span<const std::array<std::uint32_t, 3>> faces, std::uint32_t num_vertices,
                         unsigned jobs);

  std::uint32_t num_vertices() const { return static_cast<std::uint32_t>(first_.size() - 1); }
  std::span<const std::uint32_t> corners(std::uint32_t v) const {
    return {corners_.data() + first_[v], corners_.data() + first_[v + 1]};
  }

 private:
  Buffer<std::uint32_t> first_;  // V + 1
  Buffer<std::uint32_t> corners_;
};

inline std::uint32_t corner_face(std::uint32_t corner) { return corner >> 2; }
inline std::uint32_t corner_index(std::uint32_t corner) { return corner & 3u; }
inline bool is_collapsed(const std::array<std::uint32_t, 3>& f) {
  return f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
}

}  // namespace veritope
