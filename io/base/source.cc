// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/source.h"

#include <utility>

#include "io/base/scan.h"

namespace veritope {
namespace {

std::uint64_t line_of(const Source& source, const char* at) {
  std::uint64_t line = 1;
  for (const char* p = source.begin; p < at; ++p) {
    const bool crlf = *p == '\r' && p + 1 < source.end && p[1] == '\n';
    line += *p == '\n' || (*p == '\r' && !crlf) ? 1 : 0;
  }
  return line;
}

}  // namespace

Source source_of(const ByteBuffer& buffer, const std::string& name) {
  const char* begin = reinterpret_cast<const char*>(buffer.data());
  return Source{&name, begin, begin + buffer.size()};
}

const char* skip_byte_order_mark(const Source& source) {
  const std::string_view text(source.begin, static_cast<std::size_t>(source.size()));
  return text.starts_with("\xEF\xBB\xBF") ? source.begin + 3 : source.begin;
}

Error error_at_line(const Source& source, const char* at, Code code, std::string message) {
  Error error{code, Place{}, std::move(message)};
  error.place.file = *source.name;
  error.place.line = line_of(source, at);
  return error;
}

Error error_at_byte(const Source& source, const char* at, Code code, std::string message) {
  Error error{code, Place{}, std::move(message)};
  error.place.file = *source.name;
  error.place.byte = source.offset(at);
  return error;
}

Error error_in_file(const std::string& name, Code code, std::string message) {
  Error error{code, Place{}, std::move(message)};
  error.place.file = name;
  return error;
}

std::string escaped(std::string_view text) {
  constexpr std::size_t kMost = 40;
  constexpr char kHex[] = "0123456789abcdef";
  std::string result;
  for (const char c : text) {
    const bool printable = c >= ' ' && c <= '~';
    if (result.size() + (printable ? 1 : 4) > kMost) return result + "...";
    if (printable) {
      result += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      result += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return result;
}

std::string quoted(std::string_view text) {
  std::string result(1, '\'');
  result += escaped(text);
  result += '\'';
  return result;
}

std::string quoted_token(const char* at, const char* end) {
  if (at >= end) return "the end of the file";
  if (is_eol(*at)) return "the end of the line";
  const char* last = at;
  while (last < end && !is_blank(*last) && !is_eol(*last)) ++last;
  return quoted(std::string_view(at, static_cast<std::size_t>(last - at)));
}

}  // namespace veritope
