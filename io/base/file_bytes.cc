// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/file_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "io/base/source.h"
#include "io/base/system_reason_internal.h"

namespace veritope {
namespace {

using internal::reason;

Error cannot_open(const std::string& path, std::string why) {
  return error_in_file(path, Code::kCannotOpen, "cannot be read: " + std::move(why));
}

Error too_large(const std::string& name, std::uint64_t max_bytes) {
  const std::string limit = std::to_string(max_bytes);
  return error_in_file(name, Code::kOverLimit,
                       "more than " + limit + " bytes (--max-bytes " + limit + ")");
}

// A word for the kind of file; null for a regular file.
const char* kind_of(mode_t mode) {
  if (S_ISREG(mode)) return nullptr;
  if (S_ISDIR(mode)) return "it is a directory";
  if (S_ISFIFO(mode)) return "it is a FIFO (use - for standard input)";
  if (S_ISSOCK(mode)) return "it is a socket";
  if (S_ISCHR(mode)) return "it is a character device (use - for standard input)";
  return "it is a block device";
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

// One byte more than the limit is enough to see that it is exceeded.
std::size_t capacity_for(std::uint64_t bytes, std::uint64_t max_bytes) {
  return static_cast<std::size_t>(std::min<std::uint64_t>(bytes, max_bytes)) + 1;
}

}  // namespace

Result<ByteBuffer> read_descriptor(int descriptor, const std::string& name, std::uint64_t size_hint,
                                   std::uint64_t max_bytes) {
  max_bytes = std::min<std::uint64_t>(max_bytes, SIZE_MAX / 4);
  ByteBuffer buffer(capacity_for(size_hint > 0 ? size_hint : 1 << 16, max_bytes));
  for (std::size_t size = 0;;) {
    if (size == buffer.capacity()) buffer.grow(capacity_for(2 * size, max_bytes));
    constexpr std::size_t kMost = std::size_t{1} << 30;  // less than what Linux reads at once
    const ssize_t got =
        ::read(descriptor, buffer.data() + size, std::min(buffer.capacity() - size, kMost));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return cannot_open(name, reason(errno));
    size += static_cast<std::size_t>(got);
    if (size > max_bytes) return too_large(name, max_bytes);
    buffer.set_size(size);
    if (got == 0) return buffer;
  }
}

Result<ByteBuffer> read_file_bytes(const std::string& path, std::uint64_t max_bytes) {
  // Opens without blocking: opening a FIFO would wait for a writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (file.number() < 0) return cannot_open(path, reason(errno));
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) return cannot_open(path, reason(errno));
  if (const char* kind = kind_of(status.st_mode)) return cannot_open(path, kind);
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > max_bytes) return too_large(path, max_bytes);
  return read_descriptor(file.number(), path, size, max_bytes);
}

}  // namespace veritope
