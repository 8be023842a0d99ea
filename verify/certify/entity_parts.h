// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/entity_parts.h: parts of a complex's patches in the parameters of the file's entities, for reports.
#pragma once
#include <array>
#include <cstdint>
#include <string>
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

  /// The number of the patch's entity in the list of entities: that of certificates.
  std::size_t entity_of(std::uint32_t patch) const;
  /// The number that the file has for it: of a boundary face, that of its volume.
  std::uint64_t number_in_file(std::size_t entity) const;
  /// "entity 7"; of a boundary face "face w = 1 of entity 7".
  std::string name(std::size_t entity) const;
  std::string name_of(std::uint32_t patch) const { return name(entity_of(patch)); }
  /// "side 2 of entity 7"; of a boundary face "edge v = 0, w = 1 of entity 7".
  std::string name_of(PatchSide side) const;
  /// Which of an EntityPart's parameters belongs to an axis of the patch's entity, and its name: "u".
  std::size_t parameter(std::uint32_t patch, std::size_t axis) const;
  std::string parameter_name(std::uint32_t patch, std::size_t axis) const;
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
  /// A point of a side with its exact parameters: "(u, v) = (1/2, 1) of entity 7". `t` as in `along` above.
  std::string point_text(PatchSide side, const Rational& t) const;

 private:
  /// Those of a surface that is a boundary face become the parameters of its volume.
  template <typename Number>
  std::vector<Number> in_volume(const VolumeFace& face, std::vector<Number> parameters,
                                const Number& across) const;
  EntityPart in_file(EntityPart part) const;
  std::vector<Bounds> on_tensor_form(std::uint32_t patch, const Bounds& s, const Bounds& t) const;
  std::vector<Bounds> on_side(PatchSide side, const Bounds& along) const;
  std::vector<Bounds> in_entity(std::uint32_t patch, const Bounds& u, const Bounds& v) const;

  const PatchComplex& complex_;
  const std::vector<StarBoxEntity>& entities_;
};

}  // namespace veritope
