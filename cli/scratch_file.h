// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/scratch_file.h: bytes that another process can read under a name, without a file that could be left behind.
#pragma once
#include <string>
#include <string_view>

#include "robust/base/result.h"

namespace veritope::cli {

/// A file in $TMPDIR (else /tmp) that has no name in any folder: it vanishes when the last process that has it open
/// ends, however it ends.
class ScratchFile {
 public:
  /// @error kCannotWrite: no such folder, no permission, a full disk
  static Result<ScratchFile> with(std::string_view bytes);

  ScratchFile(ScratchFile&& other) noexcept;
  ScratchFile& operator=(ScratchFile&&) = delete;
  ~ScratchFile();

  /// A path that names it in this process and in children that inherit descriptor().
  std::string path() const;
  int descriptor() const { return descriptor_; }

 private:
  explicit ScratchFile(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace veritope::cli
