// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/parameter_text.h: exact parameters of entities as text for messages.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "robust/rational.h"

namespace veritope {

/// "3/8", or "approximately 0.333333" of a number whose fraction is longer than 24 characters.
std::string number_text(const Rational& value);
/// "entity 7".
std::string entity_text(std::uint64_t entity);
/// "(u, v) = (1/2, 1) of entity 7"; three parameters are barycentric coordinates.
std::string place_text(const std::vector<Rational>& parameters, std::uint64_t entity);

}  // namespace veritope
