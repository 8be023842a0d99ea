// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/json_text.h: what the JSON reports share. Only their .cc files include it.
#pragma once
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/file_report.h"

namespace veritope::cli {

using Json = nlohmann::ordered_json;

template <typename T>
Json optional_json(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// JSON has no infinity: null.
inline Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json fault_json(const std::optional<Fault>& fault);
/// Microseconds are more than enough.
Json seconds_json(const std::optional<double>& value);
Json phases_json(const PhaseSeconds& seconds);
Json certificate_json(const std::optional<CertificateReport>& certificate);

/// One line; floating-point numbers are the shortest that read back as the same; what is no UTF-8 becomes U+FFFD.
std::string dump(const Json& json);

}  // namespace veritope::cli
