// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/atomic_file.h"

#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "io/base/system_reason_internal.h"

namespace veritope {
namespace {

// The registry has static storage, so that a signal handler may read it at any time.
enum SlotState : int { kFree, kTaken, kArmed };
struct Slot {
  std::atomic<int> state{kFree};
  char path[PATH_MAX] = {};
};
constexpr int kNumSlots = 64;
Slot slots[kNumSlots];
static_assert(std::atomic<int>::is_always_lock_free, "needed in signal handlers");

// Takes a slot that unlinks `path` from now on; -1 if all are taken, or if the path is too long.
int arm_slot(const std::string& path) {
  if (path.size() >= PATH_MAX) return -1;
  for (int i = 0; i < kNumSlots; ++i) {
    int expected = kFree;
    if (!slots[i].state.compare_exchange_strong(expected, kTaken)) continue;
    std::memcpy(slots[i].path, path.c_str(), path.size() + 1);
    slots[i].state.store(kArmed);
    return i;
  }
  return -1;
}

void disarm_slot(int slot) { slots[slot].state.store(kFree); }

using internal::reason;

Error cannot_write(const std::string& path, const std::string& why) {
  Error error{Code::kCannotWrite, Place{}, "cannot be written: " + why};
  error.place.file = path;
  return error;
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == path.npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

// Why a file at `path` must not be replaced; nothing if it may be replaced, or if no file exists.
std::optional<std::string> refusal(const std::string& path, const struct stat& status) {
  if (S_ISDIR(status.st_mode)) return "it is a directory";
  if (!S_ISREG(status.st_mode)) return "it is not a regular file";
  if (::access(path.c_str(), W_OK) != 0) return reason(errno);
  return std::nullopt;
}

// The file that `path` names when links are followed.
std::string resolve(const std::string& path) {
  char* const resolved = ::realpath(path.c_str(), nullptr);
  if (resolved == nullptr) return path;
  std::string result = resolved;
  ::free(resolved);
  return result;
}

void sync_folder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);  // the name is there; whether it survives a power cut is up to the system
  ::close(descriptor);
}

// A number that no other temporary file of this process has had.
unsigned next_number() {
  static std::atomic<unsigned> number{0};
  return number++;
}

}  // namespace

AtomicFile::AtomicFile(std::string path, std::string target, std::string temporary, int slot,
                       int descriptor)
    : path_(std::move(path)),
      target_(std::move(target)),
      temporary_(std::move(temporary)),
      slot_(slot),
      descriptor_(descriptor) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::move(other.temporary_)),
      slot_(std::exchange(other.slot_, -1)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AtomicFile::~AtomicFile() { discard(); }

Result<AtomicFile> AtomicFile::create(const std::string& path) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  struct stat link {};
  if (!exists && ::lstat(path.c_str(), &link) == 0) {
    return cannot_write(path, "it is a link to nowhere");
  }
  if (path.empty() || path.back() == '/') return cannot_write(path, "it names no file");
  if (exists) {
    if (const auto why = refusal(path, status)) return cannot_write(path, *why);
  }
  const std::string target = exists ? resolve(path) : path;
  for (int attempt = 0; attempt < 100; ++attempt) {
    const std::string temporary = folder_of(target) + "/.veritope-" + std::to_string(::getpid()) +
                                  "-" + std::to_string(next_number()) + ".tmp";
    const int slot = arm_slot(temporary);
    if (slot < 0) return cannot_write(path, "too many unfinished files, or too long a name");
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    const int open_error = errno;
    if (descriptor >= 0) {
      if (exists) ::fchmod(descriptor, status.st_mode & 0777);
      return AtomicFile(path, target, temporary, slot, descriptor);
    }
    disarm_slot(slot);
    if (open_error != EEXIST) return cannot_write(path, reason(open_error));
  }
  return cannot_write(path, "no free name for a temporary file");
}

Error AtomicFile::error(const std::string& why) const { return cannot_write(path_, why); }

Status AtomicFile::write(std::string_view bytes) {
  if (descriptor_ < 0) return error("the file is closed");
  while (!bytes.empty()) {
    const std::size_t size = std::min<std::size_t>(bytes.size(), std::size_t{1} << 30);
    const ssize_t put = ::write(descriptor_, bytes.data(), size);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) {
      const Error failure = error(put < 0 ? reason(errno) : "the disk takes no more bytes");
      discard();
      return failure;
    }
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return ok_status();
}

Error AtomicFile::give_up() {
  const Error failure = error(reason(errno));
  discard();
  return failure;
}

Status AtomicFile::finish() {
  if (descriptor_ < 0) return error("the file is closed");
  if (::fsync(descriptor_) != 0) return give_up();
  if (::close(std::exchange(descriptor_, -1)) != 0) return give_up();
  return ok_status();
}

Status AtomicFile::commit() {
  if (slot_ < 0) return error("the file is closed");
  if (descriptor_ >= 0)
    if (Status status = finish(); !status) return status;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) return give_up();
  disarm_slot(std::exchange(slot_, -1));
  sync_folder(folder_of(target_));
  return ok_status();
}

void AtomicFile::discard() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (slot_ < 0) return;
  ::unlink(temporary_.c_str());
  disarm_slot(std::exchange(slot_, -1));
}

Status write_files(std::span<const WholeFile> files) {
  std::vector<AtomicFile> unnamed;
  for (const WholeFile& file : files) {
    Result<AtomicFile> next = AtomicFile::create(file.path);
    if (!next) return next.error();
    unnamed.push_back(std::move(*next));
    if (Status status = unnamed.back().write(file.bytes); !status) return status;
    if (Status status = unnamed.back().finish(); !status) return status;
  }
  for (AtomicFile& file : unnamed)
    if (Status status = file.commit(); !status) return status;
  return ok_status();
}

bool remove_unfinished_files() noexcept {
  const int saved = errno;
  bool has_removed = false;
  for (Slot& slot : slots) {
    if (slot.state.load() == kArmed && ::unlink(slot.path) == 0) has_removed = true;
  }
  errno = saved;
  return has_removed;
}

bool same_file(const std::string& a, const std::string& b) {
  struct stat status_a {
  }, status_b{};
  return ::stat(a.c_str(), &status_a) == 0 && ::stat(b.c_str(), &status_b) == 0 &&
         status_a.st_dev == status_b.st_dev && status_a.st_ino == status_b.st_ino;
}

}  // namespace veritope
