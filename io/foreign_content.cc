// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/foreign_content.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "io/base/scan.h"

namespace veritope {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  const char* name;
};

// The four-byte marks precede the two-byte ones with which they begin.
constexpr std::array kForeign = {
    Signature{"\xFF\xFE\0\0"sv, "UTF-32 text"},
    Signature{"\0\0\xFE\xFF"sv, "UTF-32 text"},
    Signature{"\xFF\xFE"sv, "UTF-16 text"},
    Signature{"\xFE\xFF"sv, "UTF-16 text"},
    Signature{"\x1F\x8B"sv, "gzip data"},
    Signature{"PK\x03\x04"sv, "a zip archive"},
    Signature{"PK\x05\x06"sv, "a zip archive"},
    Signature{"BZh"sv, "bzip2 data"},
    Signature{"\xFD"
              "7zXZ"sv,
              "xz data"},
    Signature{"\x28\xB5\x2F\xFD"sv, "zstd data"},
    Signature{"version https://git-lfs"sv, "a git-lfs pointer (run: git lfs pull)"},
};

std::string_view all_of(const Source& source) {
  return {source.begin, static_cast<std::size_t>(source.size())};
}

bool contains(std::string_view text, std::string_view word) { return text.find(word) != text.npos; }

// The text from the first word on.
std::string_view text_of(const Source& source) {
  const char* const p = skip_space(skip_byte_order_mark(source), source.end);
  return {p, static_cast<std::size_t>(source.end - p)};
}

std::string_view head_of(const Source& source) {
  constexpr std::size_t kHead = 4096;
  return text_of(source).substr(0, kHead);
}

bool is_step(const Source& source) { return text_of(source).starts_with("ISO-10303-21"); }

// The first line has 72 columns, the letter of the start section, and 1 in seven columns.
bool is_iges(const Source& source) {
  const std::string_view text = all_of(source);
  constexpr std::size_t kLetter = 72, kLine = 80;
  if (text.size() < kLine) return false;
  const std::string_view line = text.substr(0, kLine), number = line.substr(kLetter + 1);
  const auto is_part = [](char c) { return c == ' ' || c == '0'; };
  return !contains(line, "\n") && line[kLetter] == 'S' && number.back() == '1' &&
         std::all_of(number.begin(), number.end() - 1, is_part);
}

bool is_brep(const Source& source) {
  const std::string_view text = text_of(source);
  return text.starts_with("DBRep_DrawableShape") || text.starts_with("CASCADE Topology V") ||
         text.starts_with("Open CASCADE Topology V");
}

bool is_gltf(const Source& source) {
  if (all_of(source).starts_with(std::string_view("glTF\2\0\0\0", 8))) return true;
  const std::string_view text = text_of(source);
  return text.starts_with("{") && contains(text, "\"asset\"") && contains(text, "\"version\"") &&
         (contains(text, "\"meshes\"") || contains(text, "\"scenes\"") ||
          contains(text, "\"nodes\""));
}

bool is_collada(const Source& source) {
  const std::string_view head = head_of(source);
  return head.starts_with("<") && contains(head, "<COLLADA");
}

// A zip archive with the part that every 3MF package has. The names of parts are also listed at the
// end of the archive.
bool is_3mf(const Source& source) {
  const std::string_view text = all_of(source);
  return text.starts_with("PK\3\4") && contains(text, "3D/3dmodel.model");
}

}  // namespace

std::optional<Error> refuse_foreign(const Source& source) {
  if (source.size() == 0) {
    return error_at_byte(source, source.begin, Code::kEmpty, "the file is empty");
  }
  for (const Signature& signature : kForeign) {
    if (!all_of(source).starts_with(signature.bytes)) continue;
    const std::string what = is_3mf(source)
                                 ? unread_format(source) + ", a zip archive: not read yet"
                                 : std::string(signature.name) + ", not a model";
    return error_at_byte(source, source.begin, Code::kForeignFormat, "this is " + what);
  }
  return std::nullopt;
}

std::string unread_format(const Source& source) {
  if (is_step(source)) return "a STEP file";
  if (is_iges(source)) return "an IGES file";
  if (is_brep(source)) return "a BREP file of Open CASCADE";
  if (is_3mf(source)) return "a 3MF file";
  if (is_gltf(source)) return "a glTF file";
  if (is_collada(source)) return "a COLLADA file";
  return "";
}

bool looks_like_utf16(const Source& source) {
  const char* const p = source.begin;
  return source.size() >= 4 && ((p[0] == 0) != (p[1] == 0)) && ((p[2] == 0) != (p[3] == 0)) &&
         (p[0] == 0) == (p[2] == 0);
}

std::string binary_guess(const Source& source) {
  constexpr std::size_t kHead = 4096;
  const std::size_t zero = all_of(source).substr(0, kHead).find('\0');
  if (zero == std::string_view::npos) return "";
  return "it looks like binary data: byte " + std::to_string(zero) + " is 0";
}

}  // namespace veritope
