// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/source.h: the bytes that a reader works on, and errors that point into them.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "io/base/byte_buffer.h"
#include "robust/base/result.h"

namespace veritope {

/// A view of a padded buffer under the name that errors show. The buffer and the name must outlive it.
struct Source {
  const std::string* name = nullptr;
  const char* begin = nullptr;
  const char* end = nullptr;  ///< ByteBuffer::kPadding line feeds follow

  std::uint64_t size() const { return static_cast<std::uint64_t>(end - begin); }
  std::uint64_t offset(const char* at) const { return static_cast<std::uint64_t>(at - begin); }
};

Source source_of(const ByteBuffer& buffer, const std::string& name);

/// Where text begins: after a UTF-8 byte order mark, if there is one.
const char* skip_byte_order_mark(const Source& source);

/// An error in a text; its place is the line of `at`. CR LF, LF and CR each end one line. @cost O(at - begin)
Error error_at_line(const Source& source, const char* at, Code code, std::string message);

/// An error in binary data; its place is the offset of `at`.
Error error_at_byte(const Source& source, const char* at, Code code, std::string message);

/// An error about the file as a whole.
Error error_in_file(const std::string& name, Code code, std::string message);

/// The text with bytes other than printable ASCII as \xNN, cut to 40 characters and "..." if it is
/// longer.
std::string escaped(std::string_view text);

/// escaped() between single quotes.
std::string quoted(std::string_view text);

/// quoted() of the token that starts at `at`, or "the end of the line", "the end of the file" (from `end` on).
std::string quoted_token(const char* at, const char* end);

}  // namespace veritope
