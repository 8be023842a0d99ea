// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/scratch_file.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "cli/signals.h"

namespace veritope::cli {
namespace {

std::string scratch_folder() {
  const char* const folder = ::getenv("TMPDIR");
  return folder != nullptr && *folder != '\0' ? folder : "/tmp";
}

// A descriptor; -1, and errno, on failure.
int open_nameless(const std::string& folder) {
#ifdef O_TMPFILE
  const int nameless = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (nameless >= 0) return nameless;
#endif
  // Some file systems cannot make nameless files: there the file has a name for a moment.
  const SignalsBlocked blocked;
  std::string name = folder + "/veritope-XXXXXX";
  const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor >= 0) ::unlink(name.c_str());
  return descriptor;
}

Error cannot_write_in(const std::string& folder, int number) {
  Error error{Code::kCannotWrite, Place{},
              "a temporary file cannot be written in " + folder +
                  " (TMPDIR chooses the folder): " + std::generic_category().message(number)};
  error.place.file = folder;
  return error;
}

}  // namespace

Result<ScratchFile> ScratchFile::with(std::string_view bytes) {
  const std::string folder = scratch_folder();
  const int descriptor = open_nameless(folder);
  if (descriptor < 0) return cannot_write_in(folder, errno);
  ScratchFile file(descriptor);
  while (!bytes.empty()) {
    const std::size_t size = std::min<std::size_t>(bytes.size(), std::size_t{1} << 30);
    const ssize_t put = ::write(descriptor, bytes.data(), size);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return cannot_write_in(folder, put < 0 ? errno : ENOSPC);
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return file;
}

ScratchFile::ScratchFile(ScratchFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

ScratchFile::~ScratchFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string ScratchFile::path() const { return "/dev/fd/" + std::to_string(descriptor_); }

}  // namespace veritope::cli
