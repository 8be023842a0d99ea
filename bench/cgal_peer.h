// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/cgal_peer.h: CGAL's decision about the same mesh; CGAL's headers stay in its own file.
#pragma once
#include <memory>

#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::bench {

/// A CGAL Surface_mesh over EPICK, built once.
class CgalMesh {
 public:
  explicit CgalMesh(const TriangleMesh& mesh);
  ~CgalMesh();
  CgalMesh(const CgalMesh&) = delete;
  /// does_self_intersect + is_closed + does_bound_a_volume + is_outward_oriented, one thread.
  bool is_valid_solid() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace veritope::bench
