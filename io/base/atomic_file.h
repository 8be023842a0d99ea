// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/atomic_file.h: an output file that appears complete or not at all.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "robust/base/result.h"

namespace veritope {

/// Writes to a temporary file in the same folder; commit() gives it its name. Until then a file of that name
/// stays as it was, and the destructor removes the temporary. Symbolic links are followed, permissions kept.
class AtomicFile {
 public:
  /// @error kCannotWrite: no such folder, no permission, the target is a folder, device or dangling link
  static Result<AtomicFile> create(const std::string& path);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  /// Writes all of the bytes. @error kCannotWrite, for instance on a full disk; then commit()
  /// fails, too
  Status write(std::string_view bytes);

  /// fsync. Afterwards write() fails. @error kCannotWrite; then commit() fails, too
  Status finish();

  /// finish() unless that was done, rename, fsync of the folder. Afterwards write() and commit() fail. @error
  /// kCannotWrite
  Status commit();

 private:
  AtomicFile(std::string path, std::string target, std::string temporary, int slot, int descriptor);
  Error error(const std::string& why) const;
  Error give_up();  // for the reason in errno
  void discard();

  std::string path_;    ///< as given: for errors
  std::string target_;  ///< links followed
  std::string temporary_;
  int slot_;        ///< its slot in the registry of temporaries; -1: not there any more
  int descriptor_;  ///< -1: closed
};

struct WholeFile {
  std::string path;
  std::string_view bytes;
};

/// Writes files as AtomicFile does. No name appears before the bytes of all of them are on the disk.
/// @error kCannotWrite
Status write_files(std::span<const WholeFile> files);

/// Unlinks the temporaries of all uncommitted AtomicFiles, and returns whether there were any. Async-signal-safe: for
/// handlers of SIGINT and SIGTERM, which must end the process afterwards.
bool remove_unfinished_files() noexcept;

/// Whether both exist and are one file (same device and inode), whatever their names. To detect an output that is an
/// input.
bool same_file(const std::string& a, const std::string& b);

}  // namespace veritope
