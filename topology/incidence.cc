// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/incidence.h"

#include "robust/base/check.h"
#include "robust/base/parallel.h"

namespace veritope {
namespace {

using Faces = std::span<const std::array<std::uint32_t, 3>>;

// Block j of the faces counts into its own row, so that the corners of a vertex come out in ascending order.
void count_corners(Faces faces, std::vector<std::uint32_t>& row) {
  for (const auto& f : faces) {
    if (is_collapsed(f)) continue;
    ++row[f[0]];
    ++row[f[1]];
    ++row[f[2]];
  }
}

void place_corners(Faces faces, std::uint32_t first_face, std::vector<std::uint32_t>& next,
                   std::uint32_t* corners) {
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    const auto& f = faces[i];
    if (is_collapsed(f)) continue;
    const std::uint32_t c = 4 * (first_face + i);
    corners[next[f[0]]++] = c;
    corners[next[f[1]]++] = c + 1;
    corners[next[f[2]]++] = c + 2;
  }
}

}  // namespace

Incidence Incidence::build(Faces faces, std::uint32_t num_vertices, unsigned jobs) {
  VT_CHECK(faces.size() <= kMaxFaces, "more faces than a corner can name");
  const std::size_t blocks = jobs == 0 ? 1 : jobs;
  const auto block = [&](std::size_t j) { return faces.size() * j / blocks; };
  std::vector<std::vector<std::uint32_t>> rows(blocks);
  parallel_for(blocks, 1, jobs, [&](std::size_t j, std::size_t, std::size_t) {
    rows[j].assign(num_vertices, 0);
    count_corners(faces.subspan(block(j), block(j + 1) - block(j)), rows[j]);
  });
  Incidence out;
  out.first_ = Buffer<std::uint32_t>(std::size_t{num_vertices} + 1);
  std::uint32_t sum = 0;
  for (std::uint32_t v = 0; v < num_vertices; ++v) {
    out.first_[v] = sum;
    for (auto& row : rows) {
      const std::uint32_t n = row[v];
      row[v] = sum;
      sum += n;
    }
  }
  out.first_[num_vertices] = sum;
  out.corners_ = Buffer<std::uint32_t>(sum);
  parallel_for(blocks, 1, jobs, [&](std::size_t j, std::size_t, std::size_t) {
    place_corners(faces.subspan(block(j), block(j + 1) - block(j)),
                  static_cast<std::uint32_t>(block(j)), rows[j], out.corners_.data());
  });
  return out;
}

}  // namespace veritope
