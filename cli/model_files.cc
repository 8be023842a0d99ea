// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/model_files.h"

#include <fnmatch.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/kept_copy.h"
#include "io/formats.h"

namespace veritope::cli {
namespace {

namespace fs = std::filesystem;

bool is_wanted(const std::string& name, const std::optional<std::string>& glob) {
  return glob ? ::fnmatch(glob->c_str(), name.c_str(), 0) == 0 : format_from_path(name) != nullptr;
}

struct FoundFiles {
  std::vector<std::string> paths;
  std::vector<std::pair<std::string, std::string>> copies;  // with their SHA-256
};

// Appends what is in the folder, unsorted; the folder itself if it cannot be read, so that its report says why.
void walk(const std::string& folder, const std::optional<std::string>& glob, FoundFiles& out) {
  std::error_code why;
  fs::directory_iterator entries(folder, why);
  for (; !why && entries != fs::directory_iterator(); entries.increment(why)) {
    const std::string name = entries->path().filename().string();
    if (name.starts_with('.')) continue;
    const std::string path = folder + (folder.ends_with('/') ? "" : "/") + name;
    std::error_code unknown;
    const fs::file_status status = entries->symlink_status(unknown);
    if (unknown) {
      out.paths.push_back(path);
    } else if (fs::is_directory(status)) {
      walk(path, glob, out);
    } else if (is_wanted(name, glob) && !fs::is_directory(path, unknown)) {
      if (auto hash = kept_copy_sha256(path))
        out.copies.push_back({path, std::move(*hash)});
      else
        out.paths.push_back(path);
    }
  }
  if (why) out.paths.push_back(folder);
}

std::string why_empty(const std::string& folder, const std::optional<std::string>& glob) {
  if (glob) return "no file in the folder " + folder + " has a name that matches " + *glob;
  return "no file in the folder " + folder + " has a known extension (" + format_names("or") +
         "); use --glob '*.ext' to select others";
}

}  // namespace

bool is_folder_of_models(const std::string& path) {
  std::error_code none;
  return path != "-" && fs::is_directory(path, none);
}

Result<ModelFiles> files_in_folders(const std::vector<std::string>& paths,
                                    const std::optional<std::string>& glob) {
  FoundFiles found;
  for (const std::string& path : paths) {
    if (!is_folder_of_models(path)) {
      found.paths.push_back(path);
      continue;
    }
    const auto first = static_cast<std::ptrdiff_t>(found.paths.size());
    const std::size_t num_copies = found.copies.size();
    walk(path, glob, found);
    if (found.paths.size() == static_cast<std::size_t>(first) && found.copies.size() == num_copies)
      return bad_argument(why_empty(path, glob));
    std::sort(found.paths.begin() + first, found.paths.end());
  }
  std::sort(found.copies.begin(), found.copies.end());
  ModelFiles out;
  out.paths = std::move(found.paths);
  for (auto& [path, hash] : found.copies) {
    out.paths.push_back(path);
    out.copies.push_back(std::move(hash));
  }
  return out;
}

std::string beside(const std::string& file, const std::string& path) {
  return (fs::path(file).parent_path() / path).string();
}

}  // namespace veritope::cli
