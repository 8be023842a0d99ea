// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/line_reader.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace veritope::cli {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::string cannot_read(int number) {
  return "cannot be read: " + (number == EISDIR ? std::string("it is a directory")
                                                : std::generic_category().message(number));
}

}  // namespace

Result<LineReader> LineReader::open(const std::string& path) {
  if (path == "-") return LineReader("standard input", STDIN_FILENO);
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
  const int number = errno;
  LineReader reader(path, descriptor);
  if (descriptor < 0) return reader.error(Code::kCannotOpen, cannot_read(number));
  return reader;
}

LineReader::LineReader(std::string name, int descriptor)
    : name_(std::move(name)), descriptor_(descriptor), buffer_(kMaxLine + kPiece) {}

LineReader::LineReader(LineReader&& other) noexcept
    : name_(std::move(other.name_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      buffer_(std::move(other.buffer_)),
      begin_(other.begin_),
      scanned_(other.scanned_),
      line_(other.line_),
      is_at_end_(other.is_at_end_) {}

LineReader::~LineReader() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
}

bool LineReader::must_read() { return !is_at_end_ && find_line_feed() == kNone; }

// The position of the next line feed, or kNone.
std::size_t LineReader::find_line_feed() {
  const unsigned char* const data = buffer_.data();
  const std::size_t rest = buffer_.size() - scanned_;
  if (rest == 0) return kNone;
  const void* const found = std::memchr(data + scanned_, '\n', rest);
  scanned_ = found == nullptr
                 ? buffer_.size()
                 : static_cast<std::size_t>(static_cast<const unsigned char*>(found) - data);
  return found == nullptr ? kNone : scanned_;
}

Result<std::optional<std::string_view>> LineReader::next() {
  ++line_;
  std::size_t end = find_line_feed();
  // Reads one byte more than a line may have: that byte may be the CR of CR LF.
  while (end == kNone && !is_at_end_ && buffer_.size() - begin_ <= kMaxLine + 1) {
    if (Status status = refill(); !status) return status.error();
    end = find_line_feed();
  }
  if (end == kNone && begin_ == buffer_.size()) return std::optional<std::string_view>();
  const std::string_view line =
      end == kNone ? take(buffer_.size(), buffer_.size()) : take(end, end + 1);
  if (line.size() <= kMaxLine) return std::optional(line);
  return error(Code::kOverLimit, "more than " + std::to_string(kMaxLine) + " bytes in a line");
}

std::string_view LineReader::take(std::size_t end, std::size_t next_begin) {
  const char* const text = reinterpret_cast<const char*>(buffer_.data());
  std::string_view line(text + begin_, end - begin_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  begin_ = scanned_ = next_begin;
  return line;
}

Status LineReader::refill() {
  const std::size_t kept = buffer_.size() - begin_;
  if (begin_ > 0) std::memmove(buffer_.data(), buffer_.data() + begin_, kept);
  scanned_ -= std::exchange(begin_, 0);
  ssize_t got = -1;
  do {
    got = ::read(descriptor_, buffer_.data() + kept, buffer_.capacity() - kept);
  } while (got < 0 && errno == EINTR);
  const int number = errno;
  buffer_.set_size(kept + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  is_at_end_ = got == 0;
  return got < 0 ? error(Code::kCannotOpen, cannot_read(number)) : ok_status();
}

Error LineReader::error(Code code, std::string message) const {
  Error error{code, Place{}, std::move(message)};
  error.place.file = name_;
  if (code == Code::kOverLimit) error.place.line = line_;
  return error;
}

}  // namespace veritope::cli
