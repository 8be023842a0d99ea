// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/spline_format.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "io/base/scan.h"

namespace veritope {
namespace {

constexpr std::array<std::pair<std::string_view, SplineFormat>, 8> kNames = {{
    {"itd", SplineFormat::kItd},
    {"g2", SplineFormat::kG2},
    {"mfem", SplineFormat::kMfem},
    {"gismo", SplineFormat::kGismo},
    {"vjson", SplineFormat::kJson},
    {"mesh", SplineFormat::kMfem},
    {"xml", SplineFormat::kGismo},
    {"json", SplineFormat::kJson},
}};

bool is_g2_class(std::string_view word) {
  constexpr std::array<std::string_view, 10> kClasses = {"100", "200", "210", "700", "250",
                                                         "260", "270", "280", "290", "120"};
  return std::find(kClasses.begin(), kClasses.end(), word) != kClasses.end();
}

}  // namespace

const char* spline_format_name(SplineFormat format) {
  for (const auto& [name, value] : kNames)
    if (value == format) return name.data();
  return "unknown";
}

std::optional<SplineFormat> spline_format_from_name(std::string_view name) {
  for (const auto& [known, value] : kNames)
    if (is_word(name, known)) return value;
  return std::nullopt;
}

std::optional<SplineFormat> spline_format_from_path(std::string_view path) {
  const std::size_t dot = path.rfind('.'), slash = path.rfind('/');
  if (dot == path.npos || (slash != path.npos && dot < slash)) return std::nullopt;
  return spline_format_from_name(path.substr(dot + 1));
}

std::optional<SplineFormat> spline_format_from_content(const Source& source) {
  constexpr std::size_t kHead = 4096;
  const char* const begin = skip_byte_order_mark(source);
  const std::string_view head(
      begin, std::min<std::size_t>(kHead, static_cast<std::size_t>(source.end - begin)));
  const char* p = skip_space(begin, source.end);
  const std::string_view text =
      head.substr(std::min(head.size(), static_cast<std::size_t>(p - begin)));
  if (text.starts_with("MFEM NURBS mesh")) return SplineFormat::kMfem;
  if (text.starts_with("{") && text.find("veritope-spline-1") != text.npos)
    return SplineFormat::kJson;
  if (text.starts_with("<") &&
      (text.find("<xml") != text.npos || text.find("<Geometry") != text.npos))
    return SplineFormat::kGismo;
  if (head.find('\0') != head.npos) return std::nullopt;
  for (const std::string_view word : {"[OBJECT", "[SURFACE", "[CURVE", "[TRIVAR", "[TRIMSRF"})
    if (text.find(word) != text.npos) return SplineFormat::kItd;
  if (p < source.end && is_digit(*p)) {
    const char* const last = skip_token(p, kTokenEnd);
    const char* q = skip_blanks(last);
    if (is_g2_class({p, static_cast<std::size_t>(last - p)}) && is_digit(*q))
      return SplineFormat::kG2;
  }
  return std::nullopt;
}

}  // namespace veritope
