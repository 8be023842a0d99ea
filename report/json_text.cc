// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/json_text.h"

#include <charconv>
#include <utility>

namespace veritope::report {
namespace {

// As Json::dump, but floating-point numbers are the shortest that read back as the same: the library's need not be.
void append(std::string& out, const Json& json) {
  const bool is_object = json.is_object();
  if (is_object || json.is_array()) {
    out += is_object ? '{' : '[';
    bool is_first = true;
    for (const auto& [key, value] : json.items()) {
      if (!std::exchange(is_first, false)) out += ',';
      if (is_object) out += Json(key).dump() + ':';
      append(out, value);
    }
    out += is_object ? '}' : ']';
  } else if (json.is_number_float()) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, json.get<double>());
    out.append(digits, end.ptr);
  } else {
    // File names need not be UTF-8: what is not becomes U+FFFD.
    out += json.dump(-1, ' ', false, nlohmann::detail::error_handler_t::replace);
  }
}

}  // namespace

Json interval_json(const Interval& a) {
  return Json::array({number_json(a.lo()), number_json(a.hi())});
}

Json point_json(const Point3d& point) {
  return Json::array({number_json(point[0]), number_json(point[1]), number_json(point[2])});
}

Json box_json(const std::optional<Box3d>& box) {
  if (!box || !is_finite(*box)) return nullptr;
  return {{"min", point_json(box->lo)}, {"max", point_json(box->hi)}};
}

Json fault_json(const std::optional<Finding>& fault) {
  if (!fault) return nullptr;
  const Place& p = fault->place.source;
  return {{"code", fault->code},
          {"message", fault->message},
          {"line", optional_json(p.line)},
          {"byte", optional_json(p.byte)},
          {"face", optional_json(p.face)},
          {"vertex", optional_json(p.vertex)},
          {"entity", optional_json(p.entity)}};
}

std::string dump(const Json& json) {
  std::string out;
  append(out, json);
  return out;
}

Json seconds_json(const std::optional<double>& value) {
  return value ? Json(std::round(*value * 1e6) / 1e6) : Json(nullptr);
}

}  // namespace veritope::report
