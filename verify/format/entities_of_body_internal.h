// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/entities_of_body_internal.h: the entities with which bodies about patches begin. Internal to
// verify/format.
#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "verify/format/byte_stream.h"
#include "verify/format/claims.h"
#include "verify/format/patch_entities.h"

namespace veritope::certificate::internal {

/// A reader positioned after the breaks of this many surfaces.
struct AfterEntities {
  std::uint32_t surfaces = 0;
  ByteReader rest;
};

/// For version 1 only: a body does not say which of its entities are surfaces, so without the model their number must
/// be guessed. Returns the numbers with which the body has as many patches as its statement says, at most kMostGuesses
/// of them, the greatest first: the roots of patches can be read as the breaks of a few more surfaces, but hardly of
/// fewer.
/// @param body  at the number of entities
/// Bodies of later versions begin with their counts and kinds (docs/certificates/versions.md) and never come here.
inline constexpr std::size_t kMostGuesses = 16;
std::vector<AfterEntities> guess_surfaces_of_version_1(ByteReader body, std::uint64_t patches);

/// The number of patches of these entities.
std::uint64_t num_patches(const std::vector<PatchEntity>& entities);

/// Reads entities, then calls rest(reader, number of patches); tries guesses until the whole body
/// is read.
/// @param model    null: its kinds are guessed
/// @param patches  the number in the statement; with a model the patches are counted instead
template <class Rest>
std::optional<std::vector<PatchEntity>> read_after_entities(ByteReader body, std::uint64_t patches,
                                                            const ModelKinds* model, Rest rest) {
  std::vector<PatchEntity> entities;
  if (model != nullptr) {
    if (!read(body, model->is_surface, entities)) return std::nullopt;
    rest(body, num_patches(entities));
    return body.at_end() ? std::optional(std::move(entities)) : std::nullopt;
  }
  for (AfterEntities& guess : guess_surfaces_of_version_1(body, patches)) {
    rest(guess.rest, patches);
    if (!guess.rest.at_end()) continue;
    ByteReader again = body;
    std::vector<bool> is_surface(again.count(1), false);
    std::fill_n(is_surface.begin(), guess.surfaces, true);
    again = body;
    if (read(again, is_surface, entities)) return entities;
  }
  return std::nullopt;
}

}  // namespace veritope::certificate::internal
