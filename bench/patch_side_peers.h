// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/patch_side_peers.h: Open CASCADE's answers to in or out of a solid of patches; its headers stay in its file.
#pragma once
#include <memory>
#include <span>

#include "bench/side_peers.h"
#include "solids/patches/patch.h"

namespace veritope::bench {

/// BRepClass3d_SolidClassifier on the patches as Bezier faces, sewn into one solid; triangles with a collapsed side.
class OcctSides {
 public:
  explicit OcctSides(std::span<const Patch> patches);
  ~OcctSides();
  OcctSides(const OcctSides&) = delete;
  /// Whether sewing gave a closed solid.
  bool is_closed() const;
  Side operator()(const Vec3d& p) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace veritope::bench
