// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/output.h: standard output, and files that appear complete or not at all.
#pragma once
#include <string>
#include <string_view>

#include "report/exit_code.h"
#include "robust/base/result.h"

namespace veritope::cli {

/// Standard output. A pipe that nobody reads any more is no error: the rest is dropped quietly. Any
/// other failure (a full disk) is remembered and reported once, by status().
class StandardOutput {
 public:
  void write(std::string_view text);
  /// kCannotWrite if something was lost.
  Status status() const { return status_; }

 private:
  Status status_ = ok_status();
  bool is_closed_ = false;
};

/// "veritope: <text>" on standard error.
void complain(std::string_view text);

/// Complains about an error of a file or an argument: kExitUsage for kBadArgument, else kExitUnreadable.
report::ExitCode fail(const Error& error);

/// Replaces the file at `path` in one step, or writes to it if it is a device or a pipe; "-" is standard output.
/// @error kCannotWrite
Status write_output(const std::string& path, std::string_view bytes, StandardOutput& out);

/// "-", a device or a pipe: bytes go through it, there is nothing to replace.
bool is_stream(const std::string& path);

/// Whether write_output could write there now, found by trying; nothing is left behind. @error kCannotWrite
Status try_output(const std::string& path);

/// Both name one file: one that exists, under whatever names, or one that does not exist yet. Devices never conflict.
bool same_target(const std::string& a, const std::string& b);

}  // namespace veritope::cli
