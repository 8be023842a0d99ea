// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/entity_error.h: an error that names an entity of a spline file.
#pragma once
#include <cstdint>
#include <string>
#include <utility>

#include "robust/base/result.h"

namespace veritope {

inline Error error_at_entity(Code code, std::uint64_t entity, std::string message) {
  Error error{code, {}, std::move(message)};
  error.place.entity = entity;
  return error;
}

}  // namespace veritope
