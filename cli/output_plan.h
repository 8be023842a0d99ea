// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/output_plan.h: where each output goes; refuses before any work if two outputs, or an output
// and an input, are one file.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "robust/base/result.h"

namespace veritope::cli {

struct OutputPlan {
  /// One for each input: where its certificate goes. Empty: no certificates are kept. A copy of the model may go beside
  /// each (copy_path).
  std::vector<std::string> certificates;
  std::optional<std::string> new_folder;  ///< for the certificates; does not exist yet
  bool has_folder =
      false;  ///< certificates go into a folder, maybe into subfolders that do not exist yet
};

/// `certificate`: a file for one input, a folder (possibly new) for several; for one input a folder, too, if it exists
/// or the name ends in "/", or if `needs_folder`. Files in the folder have the names of the inputs followed by ".cert".
/// If two inputs have one name, the folder gets the subfolders that tell them apart: a/part.stl.cert, b/part.stl.cert.
/// @error kBadArgument: two outputs, or an output and an input, are one file; a file where a folder is needed
Result<OutputPlan> plan_outputs(const std::vector<std::string>& inputs,
                                const std::optional<std::string>& certificate,
                                const std::optional<std::string>& json, bool needs_folder = false);

/// Checks one more output, named by `option`, against those of the plan. @error as plan_outputs
Status check_output(const std::string& option, const std::string& path,
                    const std::vector<std::string>& inputs, const OutputPlan& plan,
                    const std::optional<std::string>& json);

/// Tests by trying whether the certificates and these outputs could be written now; leaves nothing behind.
/// @error kCannotWrite for the first one that could not
Status try_outputs(const OutputPlan& plan, const std::vector<std::optional<std::string>>& others);

/// Whether the path is that of a file in the folder that will be made for the certificates.
bool is_in_new(const OutputPlan& plan, const std::string& path);

/// kBadArgument if `output` is one of the inputs.
Status refuse_same(const std::vector<std::string>& inputs, const std::string& output);

}  // namespace veritope::cli
