// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/streamed_output.h: an output that is written in parts, and appears complete or not at all.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cli/output.h"
#include "io/base/atomic_file.h"
#include "verify/format/sha256.h"

namespace veritope::cli {

/// A file is written beside its place, and moved there by commit(); without it nothing is left. "-", devices and pipes
/// get all bytes from commit(), which are kept until then.
class StreamedOutput {
 public:
  /// @error kCannotWrite
  static Result<StreamedOutput> open(const std::string& path);

  /// @error kCannotWrite
  Status write(std::string_view bytes);
  /// @error kCannotWrite
  Status commit(StandardOutput& out);

  const std::string& path() const { return path_; }
  std::uint64_t num_bytes() const { return num_bytes_; }
  /// 64 hexadecimal digits. REQUIRES that it was not called before, and that nothing is written afterwards.
  std::string sha256() { return to_hex(digest_.finish()); }

 private:
  explicit StreamedOutput(std::string path) : path_(std::move(path)) {}

  std::string path_, kept_;
  std::optional<AtomicFile> file_;
  Sha256 digest_;
  std::uint64_t num_bytes_ = 0;
};

}  // namespace veritope::cli
