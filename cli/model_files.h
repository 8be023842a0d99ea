// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/model_files.h: the files of models in folders that a command line names.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "robust/base/result.h"

namespace veritope::cli {

/// Whether files_in_folders looks for models in it.
bool is_folder_of_models(const std::string& path);

struct ModelFiles {
  std::vector<std::string> paths;
  /// For the last paths the SHA-256 of the files, which look like copies that certify kept beside certificates
  /// (cli/kept_copy.h). They need not be certified if models with such copies are.
  std::vector<std::string> copies;
};

/// Replaces each folder by the files in it and in its subfolders: those whose names match `glob`, as a shell matches
/// them, or else those whose endings are those of known formats. Files of a folder are sorted by their paths, byte by
/// byte, and copies come after all other paths. Files and folders whose names begin with a dot are left out, and links
/// to folders are not followed. A folder that cannot be read is listed in the place of its files. Other names stay as
/// they are, in their places.
/// @error kBadArgument: a folder without such a file
Result<ModelFiles> files_in_folders(const std::vector<std::string>& paths,
                                    const std::optional<std::string>& glob);

/// The path that a file names, relative to its own folder.
std::string beside(const std::string& file, const std::string& path);

}  // namespace veritope::cli
