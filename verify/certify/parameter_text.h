// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/parameter_text.h: exact parameters of entities as text for messages.
#pragma once
#include <cstdint>
#include <string>

#include "robust/rational.h"

namespace veritope {

/// "3/8", or "approximately 0.333333" of a number whose fraction is longer than 24 characters.
std::string number_text(const Rational& value);
/// "entity 7".
std::string entity_text(std::uint64_t entity);

}  // namespace veritope
