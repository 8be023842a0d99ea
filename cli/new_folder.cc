// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/new_folder.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "cli/output.h"
#include "cli/signals.h"
#include "io/base/atomic_file.h"

namespace veritope::cli {
namespace {

namespace fs = std::filesystem;

Error folder_error(Code code, const std::string& path, const std::string& why) {
  Error error{code, Place{}, why};
  error.place.file = path;
  return error;
}
Error cannot_write_folder(const std::string& path, int number) {
  return folder_error(Code::kCannotWrite, path,
                      "cannot be written: " + std::generic_category().message(number));
}

// Where the folder goes: links followed, without slashes at the end.
std::string folder_target_of(const std::string& path) {
  std::error_code ignored;
  const fs::path real = fs::canonical(path, ignored);
  if (!ignored) return real.string();
  std::string out = path;
  while (out.size() > 1 && out.back() == '/') out.pop_back();
  return out;
}

// Why nothing may be written there; nothing if it is a new name or an empty folder.
std::optional<std::string> occupied(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return std::nullopt;
  if (::stat(path.c_str(), &status) != 0) return "it is a link to nowhere";
  if (!S_ISDIR(status.st_mode)) return "it exists and is not a folder";
  std::error_code error;
  const bool is_empty = fs::is_empty(path, error);
  if (error) return error.message();
  if (!is_empty) return "the folder is not empty: name a new one";
  // It would be replaced below the feet of the shell that is in it.
  if (same_file(path, ".")) return "it is the current folder: name a new one";
  return std::nullopt;
}

// A folder beside the target that is removed with its files unless it gets the target's name.
class UnfinishedFolder {
 public:
  /// @error kCannotWrite
  static Result<UnfinishedFolder> beside(const std::string& path, const std::string& target) {
    const std::size_t slash = target.rfind('/');
    std::string name = slash == target.npos ? "" : target.substr(0, slash + 1);
    name += ".veritope-" + std::to_string(::getpid()) + ".tmp";
    if (::mkdir(name.c_str(), 0777) != 0) return cannot_write_folder(path, errno);
    return UnfinishedFolder(std::move(name));
  }
  UnfinishedFolder(UnfinishedFolder&& other) noexcept : name_(std::exchange(other.name_, "")) {}
  UnfinishedFolder& operator=(UnfinishedFolder&&) = delete;
  ~UnfinishedFolder() {
    if (name_.empty()) return;
    std::error_code ignored;  // what cannot be removed is named by .veritope-*.tmp
    fs::remove_all(name_, ignored);
  }

  const std::string& name() const { return name_; }
  // 0, or an error number.
  int rename_to(const std::string& target) {
    if (::rename(name_.c_str(), target.c_str()) != 0) return errno;
    name_.clear();
    return 0;
  }

 private:
  explicit UnfinishedFolder(std::string name) : name_(std::move(name)) {}
  std::string name_;
};

Status write_file_in_folder(const std::string& path, const std::string& bytes) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  if (Status status = file->write(bytes); !status) return status;
  return file->commit();
}

}  // namespace

Status try_folder(const std::string& path) {
  if (path.empty()) return bad_argument("a folder's name must not be empty");
  if (const auto why = occupied(path)) return folder_error(Code::kBadArgument, path, *why);
  const SignalsBlocked blocked;
  const Result<UnfinishedFolder> folder = UnfinishedFolder::beside(path, folder_target_of(path));
  if (!folder) return folder.error();
  return ok_status();
}

bool same_folder(const std::string& a, const std::string& b) {
  const std::string target = folder_target_of(a), other = folder_target_of(b);
  return target == other || same_target(target, other);
}

Status write_folder(const std::string& path, std::span<const NamedBytes> files) {
  if (Status status = try_folder(path); !status) return status;
  const std::string target = folder_target_of(path);
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  const SignalsBlocked blocked;
  Result<UnfinishedFolder> folder = UnfinishedFolder::beside(path, target);
  if (!folder) return folder.error();
  for (const NamedBytes& file : files) {
    if (Status status = write_file_in_folder(folder->name() + "/" + file.name, file.bytes);
        !status) {
      Error error = status.error();
      error.place.file = path + "/" + file.name;  // the name it would have got
      return error;
    }
  }
  if (exists && ::chmod(folder->name().c_str(), old.st_mode & 07777) != 0)
    return cannot_write_folder(path, errno);
  if (const int error = folder->rename_to(target); error != 0)
    return cannot_write_folder(path, error);
  return ok_status();
}

}  // namespace veritope::cli
