// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/foreign_content.h"

#include <array>
#include <string>
#include <string_view>

namespace veritope {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  const char* name;
};

// The four-byte marks stand before the two-byte ones that they begin with.
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

}  // namespace

std::optional<Error> refuse_foreign(const Source& source) {
  if (source.size() == 0) {
    return error_at_byte(source, source.begin, Code::kEmpty, "the file is empty");
  }
  const std::string_view text(source.begin, static_cast<std::size_t>(source.size()));
  for (const Signature& signature : kForeign) {
    if (text.starts_with(signature.bytes)) {
      return error_at_byte(source, source.begin, Code::kForeignFormat,
                           std::string("this is ") + signature.name + ", not a mesh");
    }
  }
  return std::nullopt;
}

bool looks_like_utf16(const Source& source) {
  const char* const p = source.begin;
  return source.size() >= 4 && ((p[0] == 0) != (p[1] == 0)) && ((p[2] == 0) != (p[3] == 0)) &&
         (p[0] == 0) == (p[2] == 0);
}

}  // namespace veritope
