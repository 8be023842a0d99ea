// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/refutation_facts.h: what a refutation says of a model, in the file's entities, parameters and units, for reports.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verify/certify/certificate_entities.h"
#include "verify/certify/patch_decision.h"

namespace veritope {

/// A part of an entity: bounds of its parameters, rounded outward: u and v of a surface, the three barycentric coordinates of a triangle.
struct RefutedPart {
  std::uint64_t entity = 0;
  std::optional<std::uint8_t>
      side;  ///< of the entity, in its own direction, if the part lies in a side
  std::vector<std::array<double, 2>> parameters;
};

struct RefutationFacts {
  std::string
      code;  ///< "patches-crossing", "side-open", "side-direction", "side-overused", "shell-turned"
  std::string message;  ///< one sentence
  std::vector<RefutedPart> parts;
  std::optional<std::array<double, 3>>
      point;                 ///< about the common point; a point of the sides, rounded
  std::optional<Box3d> box;  ///< of a crossing: contains the proved common point
  std::optional<std::uint32_t> shell;
  std::optional<int> winding;
};

/// REQUIRES the entities of the complex in order.
RefutationFacts facts_of(const PatchComplex& complex, const std::vector<StarBoxEntity>& entities,
                         const PatchRefutation& refutation);

}  // namespace veritope
