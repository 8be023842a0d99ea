// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/sniff.h"

#include <algorithm>
#include <array>

#include "io/base/scan.h"
#include "io/mesh/stl_reader.h"

namespace veritope {
namespace {

using namespace std::string_view_literals;

bool is_off_word(std::string_view word) {
  for (const std::string_view prefix : {"ST", "C", "N"}) {
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  }
  return word == "OFF";
}

bool is_obj_word(std::string_view word) {
  constexpr std::array kWords = {"v"sv, "vn"sv,     "vt"sv,     "f"sv,  "g"sv, "o"sv,
                                 "s"sv, "mtllib"sv, "usemtl"sv, "fo"sv, "l"sv, "p"sv};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

// The first token that is not in a comment.
std::string_view first_word(const Source& source) {
  const char* p = skip_byte_order_mark(source);
  for (;;) {
    p = skip_space(p, source.end);
    if (p >= source.end) return {};
    if (*p != '#') break;
    p = find_eol(p);
  }
  const char* const last = skip_token(p, kTokenEndOrComment);
  return {p, static_cast<std::size_t>(last - p)};
}

// A guess for messages, never for decisions: the file is at least as large as a header and has bytes that no text has.
bool looks_like_binary_stl(const Source& source) {
  if (source.size() < kStlHeader) return false;
  const auto is_no_text = [](unsigned char c) { return c < 9 || (c > 13 && c < 32); };
  const auto size = std::min<std::uint64_t>(source.size(), kStlHeader + kStlFacet);
  return std::any_of(source.begin, source.begin + size, is_no_text);
}

}  // namespace

bool looks_like_stl(const Source& source) {
  const bool has_header = source.size() >= kStlHeader;
  return (has_header && source.size() == stl_binary_size(source)) ||
         is_word(first_word(source), "solid");
}

bool looks_like_obj(const Source& source) { return is_obj_word(first_word(source)); }
bool looks_like_ply(const Source& source) { return first_word(source) == "ply"; }
bool looks_like_off(const Source& source) { return is_off_word(first_word(source)); }

std::string size_as_binary_stl(const Source& source) {
  if (is_stl_binary(source) || !looks_like_binary_stl(source)) return "";
  const std::uint64_t size = stl_binary_size(source);
  return "if it is a binary STL: its header announces " +
         std::to_string((size - kStlHeader) / kStlFacet) + " facets, " + std::to_string(size) +
         " bytes, but it has " + std::to_string(source.size());
}

}  // namespace veritope
