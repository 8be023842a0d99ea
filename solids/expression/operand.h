// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/operand.h: what an expression needs to know of a solid.
#pragma once
#include <memory>
#include <optional>
#include <utility>

#include "interval/exact_box.h"
#include "robust/base/box3d.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/expression/flat_cone.h"

namespace veritope {

/// A solid: the closure of its interior. Immutable: threads may share it. A kind of solid whose boundary is not flat
/// has no flat cones where it is curved; points there are decided only if no other operand matters.
class Operand {
 public:
  virtual ~Operand() = default;

  /// 1 inside, 0 off the solid, mixed on its boundary. REQUIRES finite coordinates.
  virtual Value3 value(const Vec3d& point) const = 0;
  virtual Value3 value(const ExactPoint& point) const = 0;
  /// The value on a closed box; mixed also where the boundary only touches it.
  virtual Value3 value(const Box3d& box) const = 0;
  /// The sectors of all patches at the face, edge or vertex that holds a point of the boundary; nothing: they are not
  /// flat.
  virtual std::optional<FlatCone> flat_cone(const ExactPoint& point) const = 0;
  /// A box around the solid.
  virtual ExactBox<3> box() const = 0;
  virtual LookupSize lookup() const { return {}; }
};

/// A mesh that bounds a solid, which is moved in. REQUIRES what MeshClassifier does, and a valid mesh.
std::unique_ptr<const Operand> mesh_operand(TriangleMesh mesh);
/// A box along the axes. REQUIRES positive sides.
std::unique_ptr<const Operand> box_operand(const ExactBox<3>& box);

}  // namespace veritope
