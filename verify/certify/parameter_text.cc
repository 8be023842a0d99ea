// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/parameter_text.h"

#include <cstdio>

#include "robust/binary64.h"

namespace veritope {
namespace {

constexpr std::size_t kMostDigits = 24;

}  // namespace

std::string number_text(const Rational& value) {
  std::string exact = value.to_string();
  if (exact.size() <= kMostDigits) return exact;
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", nearest_double(value));
  return std::string("approximately ") + text;
}
std::string entity_text(std::uint64_t entity) { return "entity " + std::to_string(entity); }

}  // namespace veritope
