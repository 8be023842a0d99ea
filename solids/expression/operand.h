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

/// What a solid says of a point: everything that depends on whether, and where, the point is on its boundary.
struct OperandPlace {
  Value3 value =
      Value3::kZero;     ///< 1 inside, 0 off the solid, mixed on its boundary, or if it is open
  bool is_open = false;  ///< whether the point is on the boundary
  std::optional<OnPatch> on_patch;  ///< on the boundary of a solid with patches

  static OperandPlace with(Value3 value) { return {value, false, std::nullopt}; }
};

/// A solid: the closure of its interior. Immutable: threads may share it.
class Operand {
 public:
  virtual ~Operand() = default;

  /// REQUIRES finite coordinates. @cost of solids with patches up to seconds where it is open: ask once
  virtual OperandPlace place(const Vec3d& point) const = 0;
  virtual OperandPlace place(const ExactPoint& point) const = 0;
  /// That of the place. @cost less than place on the boundary of a solid with patches
  virtual Value3 value(const Vec3d& point) const = 0;
  virtual Value3 value(const ExactPoint& point) const = 0;
  /// The value on a closed box; mixed also where the boundary only touches it.
  virtual Value3 value(const Box3d& box) const = 0;
  /// At a point of the boundary; nothing if the directions are not known as exact numbers, at a singular point, or if
  /// the place is open.
  /// @param place  that of the point
  virtual std::optional<TangentCone> tangent_cone(const ExactPoint& point,
                                                  const OperandPlace& place) const = 0;
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
