// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/contacts.h: what a Boolean function of solids is near a point, along the directions in which
// boundaries of several of them leave it.  Theory: docs/THEORY.md, POINT-8.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solids/expression/directions.h"

namespace veritope {

/// Boundaries that leave a point in one direction, and may pass one another there in ways that are not known.
struct Contact {
  std::vector<std::size_t> cones;
  std::vector<std::uint32_t> sheets;  ///< the number of one sheet of each
};

/// The first direction near which `f` may have another value than `value`; nothing: it has this value at all points
/// near the apex that are on no boundary.
/// @param value  that of f in all directions off the cones: common_value
/// @cost  for each direction in which n cones meet comparisons of sheets in one half-plane, and 2^n values of f unless
///        all boundaries fit along it; if they do not, more than kMostInContact cones in one direction are a contact
std::optional<Contact> find_contact(std::span<const TangentCone> cones, const NearbyFunction& f,
                                    bool value);
inline constexpr std::size_t kMostInContact = 12;

}  // namespace veritope
