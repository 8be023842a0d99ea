// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/line_reader.h: a text line by line, in constant memory.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/base/byte_buffer.h"
#include "robust/base/result.h"

namespace veritope::cli {

/// Lines end in LF or CR LF; the last one may lack it.
class LineReader {
 public:
  static constexpr std::size_t kMaxLine = std::size_t{1} << 20;  ///< bytes, without the line end

  /// Opens a file, pipe or device; "-" is standard input. @error kCannotOpen
  static Result<LineReader> open(const std::string& path);
  LineReader(LineReader&& other) noexcept;
  ~LineReader();

  /// The next line without its end; nothing after the last one. It is valid until the next call, and 8 bytes after it
  /// may be read (io/base/scan.h). Must not be called after an error.
  /// @error kCannotOpen if reading fails; kOverLimit with the line
  Result<std::optional<std::string_view>> next();

  /// The number of the line that next() returned last, counted from 1.
  std::uint64_t line() const { return line_; }

  /// Whether next() will read from the file, and so may wait for another program.
  bool must_read();

 private:
  LineReader(std::string name, int descriptor);
  std::size_t find_line_feed();
  std::string_view take(std::size_t end, std::size_t next_begin);
  Status refill();
  Error error(Code code, std::string message) const;

  std::string name_;
  int descriptor_;
  ByteBuffer buffer_;
  std::size_t begin_ = 0;    // of the bytes still to come from next(); they end at buffer_.size()
  std::size_t scanned_ = 0;  // no line feed in [begin_, scanned_)
  std::uint64_t line_ = 0;
  bool is_at_end_ = false;
};

}  // namespace veritope::cli
