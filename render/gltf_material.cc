// SPDX-License-Identifier: LGPL-3.0-or-later
#include <cstdint>

#include "render/gltf_material_internal.h"

namespace veritope::internal {
namespace {

// The linear intensity of a channel of sRGB [IEC 61966-2-1], which glTF wants. Only +, -, * and / are used, so that
// every compiler gets the same bits: x^2.4 is x^2 times the fifth root of x^2, by Newton's iteration from above.
double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  if (c <= 0.04045) return c / 12.92;
  const double x = (c + 0.055) / 1.055, square = x * x;
  double root = 1;
  for (int i = 0; i < 60; ++i) root = (4 * root + square / (root * root * root * root)) / 5;
  return square * root;
}

// Four digits are enough for 256 intensities.
void append_share(std::string& out, double share) {
  const std::string digits = std::to_string(static_cast<int>(share * 10000 + 0.5));
  out += digits == "10000" ? "1" : "0." + std::string(4 - digits.size(), '0') + digits;
}

}  // namespace

std::string gltf_text(const std::string& name) {
  std::string out = "\"";
  for (const char c : name) out += c < ' ' || c > '~' || c == '"' || c == '\\' ? '_' : c;
  return out + '"';
}

std::string gltf_material(const std::string& name, const Paint& paint) {
  std::string out = "{\"name\":" + gltf_text(name) + ",\"doubleSided\":true,";
  if (paint.opacity != 255) out += "\"alphaMode\":\"BLEND\",";
  out +=
      "\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":1,\"baseColorFactor\":[";
  const auto& [red, green, blue] = paint.colour;
  for (const std::uint8_t channel : {red, green, blue})
    append_share(out, linear(channel)), out += ',';
  append_share(out, paint.opacity / 255.0);
  return out + "]}}";
}

Status check_gltf_size(const Box3d& box) {
  constexpr double kLeast = 0x1p-100, kMost = 0x1p120;
  const double size = extent(box);
  if (size > kMost)
    return Error{Code::kNotFinite, {}, "the model is too large for binary32, which glTF has"};
  if (size > 0 && size < kLeast)
    return Error{Code::kNotFinite, {}, "the model is too small for binary32, which glTF has"};
  return ok_status();
}

}  // namespace veritope::internal
