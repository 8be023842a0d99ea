// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/nef_solid.h: solids as CGAL's Nef polyhedra, exact; CGAL's headers stay in nef_solid.cc.
#pragma once
#include <memory>

#include "bench/side_peers.h"
#include "interval/exact_box.h"
#include "solids/classify/point_answer.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::bench {

/// A set of points that Boolean operations made of closed solids. Copies share it.
class NefSolid {
 public:
  /// REQUIRES a valid mesh with one shell.
  explicit NefSolid(const TriangleMesh& mesh);
  explicit NefSolid(const ExactBox<3>& box);

  NefSolid united(const NefSolid& other) const;
  NefSolid intersected(const NefSolid& other) const;
  NefSolid without(const NefSolid& other) const;
  /// The closure of the interior.
  NefSolid regularized() const;
  /// In the interior of the set, on its boundary, or off it. REQUIRES a regularized solid.
  Side side(const ExactPoint& point) const;

 private:
  struct Impl;
  explicit NefSolid(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace veritope::bench
