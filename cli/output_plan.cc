// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/output_plan.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include "cli/output.h"
#include "io/base/atomic_file.h"
#include "verify/certify/certify_file.h"

namespace veritope::cli {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

bool exists(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0;
}

std::string name_of(const std::string& input) {
  const std::string name = input == "-" ? "stdin" : input.substr(input.rfind('/') + 1);
  return name + ".cert";
}

std::string without_slashes(std::string path) {
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  return path;
}

Status check_new_folder(const std::string& folder) {
  const std::size_t slash = folder.rfind('/');
  const std::string parent =
      slash == folder.npos ? "." : (slash == 0 ? "/" : folder.substr(0, slash));
  if (::access(parent.c_str(), W_OK | X_OK) == 0) return ok_status();
  Error error{Code::kCannotWrite, Place{},
              "the folder cannot be made: " + std::generic_category().message(errno)};
  error.place.file = folder;
  return error;
}

// The folder below which all of the paths lie.
fs::path common_folder(const std::vector<fs::path>& paths) {
  fs::path out = paths.front().parent_path();
  for (const fs::path& path : paths) {
    const auto leaves = [&] { return *path.lexically_relative(out).begin() == ".."; };
    while (leaves()) out = out.parent_path();
  }
  return out;
}

// Where certificates go below their folder: the names of the inputs; if two are equal, their paths below the folder
// that all of them share.
std::vector<std::string> names_below(const std::vector<std::string>& inputs) {
  std::vector<std::string> names;
  std::vector<fs::path> paths;
  for (const std::string& input : inputs) {
    names.push_back(name_of(input));
    std::error_code none;
    if (input != "-") paths.push_back(fs::absolute(input, none).lexically_normal());
  }
  const std::set<std::string> different(names.begin(), names.end());
  if (different.size() == names.size()) return names;
  const fs::path common = common_folder(paths);
  for (std::size_t i = 0, next = 0; i < names.size(); ++i)
    if (inputs[i] != "-") names[i] = paths[next++].lexically_relative(common).string() + ".cert";
  return names;
}

Status check_distinct(const std::vector<std::string>& inputs,
                      const std::vector<std::string>& certificates) {
  std::map<std::string, std::string> taken;
  for (std::size_t i = 0; i < certificates.size(); ++i) {
    const auto [entry, is_new] = taken.emplace(certificates[i], inputs[i]);
    if (is_new) continue;
    return bad_argument(entry->second + " and " + inputs[i] + " would have one certificate, " +
                        certificates[i]);
  }
  return ok_status();
}

// A subfolder that does not exist will be made.
Status try_certificate(const std::string& path, const OutputPlan& plan) {
  fs::path folder = fs::path(path).parent_path();
  if (!plan.has_folder || exists(folder)) return try_output(path);
  while (!exists(folder.parent_path())) folder = folder.parent_path();
  return check_new_folder(folder);
}

// The certificate, and whatever may be kept beside it.
std::vector<std::string> with_copies(const std::string& certificate) {
  std::vector<std::string> out = {certificate};
  for (const char* const format : kCopyFormats) out.push_back(copy_path(certificate, format));
  return out;
}

Status check_targets(const std::vector<std::string>& inputs, const OutputPlan& plan,
                     const std::optional<std::string>& json) {
  for (const std::string& path : plan.certificates) {
    for (const std::string& output : with_copies(path)) {
      if (Status status = refuse_same(inputs, output); !status) return status;
      if (json && *json != "-" && same_target(*json, output))
        return bad_argument("--json and --certificate would both write " + output);
    }
  }
  if (!json || *json == "-") return ok_status();
  if (plan.new_folder && same_target(*json, *plan.new_folder)) {
    return bad_argument("--json and --certificate would both make " + *json);
  }
  return refuse_same(inputs, *json);
}

// The text before the last slash.
std::string folder_text(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == path.npos ? "" : without_slashes(path.substr(0, slash + 1));
}

}  // namespace

Status refuse_same(const std::vector<std::string>& inputs, const std::string& output) {
  for (const std::string& input : inputs) {
    if (input != "-" && same_file(input, output)) {
      return bad_argument("the output " + output + " is the input " + input);
    }
  }
  return ok_status();
}

Status check_output(const std::string& option, const std::string& path,
                    const std::vector<std::string>& inputs, const OutputPlan& plan,
                    const std::optional<std::string>& json) {
  if (Status status = refuse_same(inputs, path); !status) return status;
  const bool is_in_new_folder = is_in_new(plan, path);
  const auto is_taken = [&](const std::string& other) {
    return is_in_new_folder ? path == other : same_target(path, other);
  };
  if (json && *json != "-" && is_taken(*json))
    return bad_argument(option + " and --json would both write " + path);
  for (const std::string& certificate : plan.certificates) {
    const std::vector<std::string> taken = with_copies(certificate);
    if (std::any_of(taken.begin(), taken.end(), is_taken))
      return bad_argument(option + " and --certificate would both write " + path);
  }
  if (plan.new_folder && without_slashes(path) == *plan.new_folder)
    return bad_argument(option + " and --certificate would both make " + path);
  return ok_status();
}

Status try_outputs(const OutputPlan& plan, const std::vector<std::optional<std::string>>& others) {
  if (plan.new_folder)
    if (Status status = check_new_folder(*plan.new_folder); !status) return status;
  for (const std::string& path : plan.certificates) {
    if (plan.new_folder) break;
    if (Status status = try_certificate(path, plan); !status) return status;
  }
  for (const std::optional<std::string>& path : others) {
    if (!path || *path == "-" || is_in_new(plan, *path)) continue;
    if (Status status = try_output(*path); !status) return status;
  }
  return ok_status();
}

bool is_in_new(const OutputPlan& plan, const std::string& path) {
  return plan.new_folder && folder_text(path) == *plan.new_folder;
}

Result<OutputPlan> plan_outputs(const std::vector<std::string>& inputs,
                                const std::optional<std::string>& certificate,
                                const std::optional<std::string>& json, bool needs_folder) {
  OutputPlan plan;
  if (certificate && (needs_folder || inputs.size() > 1 || certificate->ends_with('/') ||
                      is_folder(*certificate))) {
    const std::string folder = without_slashes(*certificate);
    if (exists(folder) && !is_folder(folder)) {
      return bad_argument("--certificate " + folder + " is a file; several inputs need a folder");
    }
    if (!exists(folder)) plan.new_folder = folder;
    plan.has_folder = true;
    for (const std::string& name : names_below(inputs))
      plan.certificates.push_back(folder + "/" + name);
  } else if (certificate) {
    plan.certificates = {*certificate};
  }
  if (Status status = check_distinct(inputs, plan.certificates); !status) return status.error();
  if (Status status = check_targets(inputs, plan, json); !status) return status.error();
  return plan;
}

}  // namespace veritope::cli
