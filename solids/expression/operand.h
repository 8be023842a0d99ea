// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/operand.h: what an expression needs to know of a solid.
#pragma once
#include <memory>
#include <optional>
#include <utility>

#include "interval/exact_box.h"
#include "robust/base/box3d.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/classify/patch_classifier.h"
#include "solids/expression/tangent_cone.h"
#include "solids/patches/patch_complex.h"

namespace veritope {

/// What a solid was made from. Null pointers of what it was not made from; a box has none.
struct OperandParts {
  const TriangleMesh* mesh = nullptr;
  const MeshClassifier* mesh_classifier = nullptr;
  const PatchComplex* patches = nullptr;
  const PatchClassifier* patch_classifier = nullptr;
};

/// A solid: the closure of its interior. Immutable: threads may share it.
class Operand {
 public:
  virtual ~Operand() = default;

  /// 1 inside, 0 off the solid, mixed on its boundary, or if it is open. REQUIRES finite coordinates.
  virtual Value3 value(const Vec3d& point) const = 0;
  virtual Value3 value(const ExactPoint& point) const = 0;
  /// The value on a closed box; mixed also where the boundary only touches it.
  virtual Value3 value(const Box3d& box) const = 0;
  /// Whether it is open if a point, whose value is mixed, is on the boundary.
  virtual bool is_open(const ExactPoint&) const { return false; }
  /// At a point of the boundary; nothing if the directions are not known as exact numbers, or at a singular point.
  virtual std::optional<TangentCone> tangent_cone(const ExactPoint& point) const = 0;
  /// A box around the solid.
  virtual ExactBox<3> box() const = 0;
  virtual LookupSize lookup() const { return {}; }
  virtual OperandParts parts() const { return {}; }
};

/// A mesh that bounds a solid, which is moved in. REQUIRES what MeshClassifier does, and a valid mesh.
std::unique_ptr<const Operand> mesh_operand(TriangleMesh mesh);
/// Patches that bound a solid. REQUIRES a valid complex of patches.
std::unique_ptr<const Operand> patch_operand(std::unique_ptr<const PatchComplex> patches);
/// A box along the axes. REQUIRES positive sides.
std::unique_ptr<const Operand> box_operand(const ExactBox<3>& box);

}  // namespace veritope
