// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <optional>
#include <system_error>

#include "io/base/atomic_file.h"
#include "report/text_style.h"

namespace veritope::cli {
namespace {

// 0, or an error number.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t size = std::min<std::size_t>(bytes.size(), std::size_t{1} << 30);
    const ssize_t put = ::write(descriptor, bytes.data(), size);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return put < 0 ? errno : ENOSPC;
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return 0;
}

Error cannot_write(const std::string& path, int number) {
  Error error{Code::kCannotWrite, Place{},
              "cannot be written: " + std::generic_category().message(number)};
  error.place.file = path;
  return error;
}

// The number of the open stream of this process that a path such as /dev/stdout or /dev/fd/3 names; nothing for other
// paths. Opened again, a redirected stream would be written from its start.
std::optional<int> own_descriptor(std::string_view path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    int number = -1;
    const std::string_view digits = path.substr(folder.size());
    const auto [stop, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error == std::errc() && stop == digits.data() + digits.size()) return number;
  }
  return std::nullopt;
}

Status write_through(const std::string& path, std::string_view bytes) {
  const std::optional<int> own = own_descriptor(path);
  const int descriptor = own ? *own : ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) return cannot_write(path, errno);
  const int error = write_all(descriptor, bytes);
  if (!own) ::close(descriptor);
  if (error != 0) return cannot_write(path, error);
  return ok_status();
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == path.npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

std::string output_name(const std::string& path) {
  return own_descriptor(path) == STDOUT_FILENO ? "-" : path;
}

bool is_stream(const std::string& path) {
  if (path == "-" || own_descriptor(path)) return true;
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 &&
         (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode));
}

void StandardOutput::write(std::string_view text) {
  if (is_closed_) return;
  const int error = write_all(STDOUT_FILENO, text);
  if (error == 0) return;
  is_closed_ = true;
  if (error != EPIPE) status_ = cannot_write("standard output", error);
}

void complain(std::string_view text) {
  // Nothing can be done if standard error takes no bytes.
  [[maybe_unused]] const int error =
      write_all(STDERR_FILENO,
                report::fold("veritope: " + std::string(text), report::message_width()) + "\n");
}

report::ExitCode fail(const Error& error) {
  complain(report::harmless(to_string(error)));
  return error.code == Code::kBadArgument ? report::kExitUsage : report::kExitUnreadable;
}

Status write_output(const std::string& path, std::string_view bytes, StandardOutput& out) {
  if (path == "-") return out.write(bytes), out.status();
  if (is_stream(path)) return write_through(path, bytes);
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  if (Status status = file->write(bytes); !status) return status;
  return file->commit();
}

Status try_output(const std::string& path) {
  if (const auto own = own_descriptor(path); own && ::fcntl(*own, F_GETFL) < 0)
    return cannot_write(path, errno);
  if (is_stream(path)) return ok_status();
  const Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  return ok_status();
}

bool same_target(const std::string& a, const std::string& b) {
  if (is_stream(a)) return false;  // /dev/null may take everything
  if (same_file(a, b)) return true;
  const auto name = [](const std::string& path) { return path.substr(path.rfind('/') + 1); };
  return name(a) == name(b) && same_file(folder_of(a), folder_of(b));
}

}  // namespace veritope::cli
