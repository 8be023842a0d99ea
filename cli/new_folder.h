// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/new_folder.h: a folder of files that appears complete or not at all.
#pragma once
#include <span>
#include <string>

#include "robust/base/result.h"

namespace veritope::cli {

struct NamedBytes {
  std::string name;  ///< without a slash
  std::string bytes;
};

/// Tests whether write_folder could write there now; leaves nothing behind.
/// @error kBadArgument: `path` exists and is not an empty folder. kCannotWrite: no folder can be made there
Status try_folder(const std::string& path);

/// Whether both would be the same folder.
bool same_folder(const std::string& a, const std::string& b);

/// Makes the folder `path` with these files, or fills the empty folder `path`, in one step: the files are written into
/// a folder beside it, `.veritope-*.tmp`, which then gets its name. On failure that folder is removed. Signals that end
/// the program wait until the folder is complete or removed. @error as try_folder
Status write_folder(const std::string& path, std::span<const NamedBytes> files);

}  // namespace veritope::cli
