// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/side_peers.h: other libraries' answers to in or out of a closed mesh; their headers stay in their own files.
#pragma once
#include <memory>

#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::bench {

enum class Side { kOut, kOn, kIn };

/// CGAL's Side_of_triangle_mesh over EPICK, built once: exact.
class CgalSides {
 public:
  explicit CgalSides(const TriangleMesh& mesh);
  ~CgalSides();
  CgalSides(const CgalSides&) = delete;
  Side operator()(const Vec3d& p) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Embree's robust rays in single precision: the parity of all hits along one direction. Often wrong near the surface.
class EmbreeSides {
 public:
  explicit EmbreeSides(const TriangleMesh& mesh);
  ~EmbreeSides();
  EmbreeSides(const EmbreeSides&) = delete;
  Side operator()(const Vec3d& p) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace veritope::bench
