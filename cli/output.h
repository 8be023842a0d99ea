// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/output.h: standard output, and files that appear complete or not at all.
#pragma once
#include <string>
#include <string_view>

#include "report/exit_code.h"
#include "robust/base/result.h"

namespace veritope::cli {

/// Standard output. If nobody reads a pipe any more, that is no error: the rest is dropped
/// silently. Any other failure (a full disk) is remembered and reported once, by status().
class StandardOutput {
 public:
  void write(std::string_view text);
  /// kCannotWrite if something was lost.
  Status status() const { return status_; }

 private:
  Status status_ = ok_status();
  bool is_closed_ = false;
};

/// "veritope: <text>" on standard error, in lines that fit a terminal.
void complain(std::string_view text);

/// Complains about an error of a file or an argument: kExitUsage for kBadArgument, else kExitUnreadable.
report::ExitCode fail(const Error& error);

/// "-" for the names that the system has for standard output (/dev/stdout, /dev/fd/1, /proc/self/fd/1), else the path.
std::string output_name(const std::string& path);

/// Replaces the file at `path` in one step, or writes to it if it is a device, a pipe or the name of an open stream of
/// this process (/dev/stderr, /dev/fd/N); "-" is standard output.
/// @error kCannotWrite
Status write_output(const std::string& path, std::string_view bytes, StandardOutput& out);

/// Whether the path is "-", a device, a pipe or the name of an open stream of this process: bytes are written through
/// it, and no file is replaced.
bool is_stream(const std::string& path);

/// Tests by trying whether write_output could write there now; leaves nothing behind. @error kCannotWrite
Status try_output(const std::string& path);

/// Whether both name one file: one that exists, under whatever names, or one that does not exist yet. Devices never
/// conflict.
bool same_target(const std::string& a, const std::string& b);

}  // namespace veritope::cli
