// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/entity_parts.h: parts of a complex's patches in the parameters of the file's entities, for reports.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "solids/base/finding.h"
#include "verify/certify/certificate_entities.h"
#include "verify/certify/cover_question.h"
#include "verify/certify/crossing_witness.h"
#include "verify/certify/meeting_witness.h"
#include "verify/certify/side_witness.h"

namespace veritope {

/// Refers to the complex and to its entities.
class EntityParts {
 public:
  using Bounds = std::array<Rational, 2>;

  EntityParts(const PatchComplex& complex, const std::vector<StarBoxEntity>& entities)
      : complex_(complex), entities_(entities) {}

  std::size_t entity_of(std::uint32_t patch) const;
  bool is_reversed(std::uint32_t patch) const { return entities_[entity_of(patch)].is_reversed; }
  /// The patch as the file has it.
  Patch file_patch(std::uint32_t patch) const;

  /// `where` has the parameters of the file's patch.
  EntityPart of(const PatchRectangle& where) const;
  /// A point, in the parameters of the file's patch.
  EntityPart of(const PatchPlace& where) const;
  /// `along` has the parameters of the complex's patch, in the side's direction of travel.
  EntityPart of(PatchSide side, const Bounds& along) const;
  EntityPart of(const SideArc& arc) const;
  /// `part` has the parameters of the complex's patch.
  EntityPart of(const PatchPart& part) const;
  /// The parameters of a point of a side, exactly: u and v, or barycentric coordinates. `t` as in `along` above.
  std::vector<Rational> point_of(PatchSide side, const Rational& t) const;
  /// Those of a point whose parameters are the file's patch's.
  std::vector<Rational> point_of(const PatchPlace& where) const;

 private:
  std::vector<Bounds> on_tensor_form(std::uint32_t patch, const Bounds& s, const Bounds& t) const;
  std::vector<Bounds> on_side(PatchSide side, const Bounds& along) const;
  std::vector<Bounds> in_entity(std::uint32_t patch, const Bounds& u, const Bounds& v) const;

  const PatchComplex& complex_;
  const std::vector<StarBoxEntity>& entities_;
};

}  // namespace veritope
