// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "io/mesh/stl_reader.h"

namespace veritope {

void CornerSink::reserve(std::size_t num_facets) {
  mesh_.faces.reserve(num_facets);
  // A closed surface has approximately half as many vertices as facets.
  table_.reserve(num_facets / 2 + 3);
  mesh_.positions.resize(num_facets / 2 + 3 + kBatch);
}

void CornerSink::add(std::span<const Vec3d> corners) {
  const std::size_t room = table_.num_positions() + corners.size();
  if (mesh_.positions.size() < room) {
    mesh_.positions.resize(std::max(room, mesh_.positions.size() * 2));
  }
  std::uint32_t ids[kBatch];
  table_.insert(corners, mesh_.positions.data(), ids);
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    mesh_.faces.push_back({ids[i], ids[i + 1], ids[i + 2]});
  }
}

TriangleMesh CornerSink::take() {
  mesh_.positions.resize(table_.num_positions());
  return std::move(mesh_);
}

}  // namespace veritope
