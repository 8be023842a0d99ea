// SPDX-License-Identifier: LGPL-3.0-or-later
// report/json_text.h: what the JSON reports share. Only .cc files include it.
#pragma once
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "interval/interval.h"
#include "robust/base/box3d.h"
#include "solids/base/finding.h"

namespace veritope::report {

using Json = nlohmann::ordered_json;

template <typename T>
Json optional_json(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Null if it is empty.
inline Json text_json(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

/// JSON has no infinity: null.
inline Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// [least, greatest]
Json interval_json(const Interval& a);
Json point_json(const Point3d& point);
/// Null without a box, or if the box has bounds beyond binary64.
Json box_json(const std::optional<Box3d>& box);
/// What went wrong with a file: a code, a sentence, and the place in the file.
Json fault_json(const std::optional<Finding>& fault);
/// Microseconds are more than enough.
Json seconds_json(const std::optional<double>& value);

/// One line; floating-point numbers are the shortest that read back as the same; what is no UTF-8 becomes U+FFFD.
std::string dump(const Json& json);

}  // namespace veritope::report
