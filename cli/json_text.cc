// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/json_text.h"

#include <charconv>
#include <utility>

namespace veritope::cli {
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

Json fault_json(const std::optional<Fault>& fault) {
  if (!fault) return nullptr;
  const Place& p = fault->place;
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

Json phases_json(const PhaseSeconds& s) {
  return {{"read", seconds_json(s.read)},
          {"decide", seconds_json(s.decide)},
          {"certify", seconds_json(s.certify)},
          {"check", seconds_json(s.check)}};
}

Json certificate_json(const std::optional<CertificateReport>& certificate) {
  if (!certificate) return nullptr;
  return {{"path", optional_json(certificate->path)},
          {"sha256", certificate->sha256},
          {"bytes", certificate->bytes},
          {"checked", certificate->is_checked}};
}

}  // namespace veritope::cli
