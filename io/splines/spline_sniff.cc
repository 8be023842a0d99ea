// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/spline_sniff.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "io/base/scan.h"

namespace veritope {
namespace {

// The first bytes, without a byte order mark.
std::string_view head_of(const Source& source) {
  constexpr std::size_t kHead = 4096;
  const char* const begin = skip_byte_order_mark(source);
  return {begin, std::min<std::size_t>(kHead, static_cast<std::size_t>(source.end - begin))};
}

// The first bytes without the white space before the first word.
std::string_view text_of(const Source& source) {
  const std::string_view head = head_of(source);
  const char* const p = skip_space(head.data(), source.end);
  return head.substr(std::min(head.size(), static_cast<std::size_t>(p - head.data())));
}

// The value of the object's first member, from its quotation mark on, if the key is "format"; else nothing.
std::string_view first_format(std::string_view text) {
  for (const std::string_view token : {"{", "\"format\"", ":"}) {
    text.remove_prefix(std::min(text.size(), text.find_first_not_of(" \t\r\n")));
    if (!text.starts_with(token)) return {};
    text.remove_prefix(token.size());
  }
  text.remove_prefix(std::min(text.size(), text.find_first_not_of(" \t\r\n")));
  return text.starts_with('"') ? text : std::string_view();
}

bool contains(std::string_view text, std::string_view word) { return text.find(word) != text.npos; }

bool is_g2_class(std::string_view word) {
  constexpr std::array<std::string_view, 10> kClasses = {"100", "200", "210", "700", "250",
                                                         "260", "270", "280", "290", "120"};
  return std::find(kClasses.begin(), kClasses.end(), word) != kClasses.end();
}

}  // namespace

bool looks_like_mfem(const Source& source) {
  return text_of(source).starts_with("MFEM NURBS mesh");
}

bool looks_like_spline_json(const Source& source) {
  const std::string_view text = text_of(source);
  const std::string_view first = first_format(text);
  if (!first.empty() && !first.starts_with("\"veritope-spline-1\"")) return false;
  return text.starts_with("{") && contains(text, "veritope-spline-1");
}

bool starts_with_format(const Source& source, std::string_view format) {
  return first_format(text_of(source)).starts_with('"' + std::string(format) + '"');
}

bool looks_like_gismo(const Source& source) {
  const std::string_view text = text_of(source);
  return text.starts_with("<") && (contains(text, "<xml") || contains(text, "<Geometry"));
}

bool looks_like_itd(const Source& source) {
  if (looks_like_mfem(source) || looks_like_spline_json(source) || looks_like_gismo(source))
    return false;
  constexpr std::array<std::string_view, 5> kWords = {"[OBJECT", "[SURFACE", "[CURVE", "[TRIVAR",
                                                      "[TRIMSRF"};
  const std::string_view text = text_of(source);
  return !contains(head_of(source), std::string_view("\0", 1)) &&
         std::any_of(kWords.begin(), kWords.end(),
                     [&](std::string_view word) { return contains(text, word); });
}

bool looks_like_g2(const Source& source) {
  if (contains(head_of(source), std::string_view("\0", 1))) return false;
  const char* const p = skip_space(skip_byte_order_mark(source), source.end);
  if (p >= source.end || !is_digit(*p)) return false;
  const char* const last = skip_token(p, kTokenEnd);
  return is_g2_class({p, static_cast<std::size_t>(last - p)}) && is_digit(*skip_blanks(last));
}

}  // namespace veritope
