// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/dms_verbs.h: the verbs of veritope dms.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "io/read_model.h"
#include "solids/dms/dms_defects.h"

namespace veritope::cli {

RunCommand declare_dms_eval(OptionSet& set);
RunCommand declare_dms_fit(OptionSet& set);
RunCommand declare_dms_iso(OptionSet& set);
RunCommand declare_dms_make(OptionSet& set);
RunCommand declare_dms_domain(OptionSet& set);
RunCommand declare_dms_xray(OptionSet& set);
RunCommand declare_dms_refine(OptionSet& set);
RunCommand declare_dms_boundary(OptionSet& set);
RunCommand declare_dms_edit(OptionSet& set);

/// Reads a model. @error as read_model_file, and kUnknownFormat for a file of another kind
Result<DmsFile> read_dms_file(const std::string& path, ModelReadOptions reading);

/// Tests by trying whether the outputs can be written; "-" among the inputs is standard input.
/// @error kBadArgument: two of the files are one; kCannotWrite
Status try_dms_outputs(std::vector<std::string> inputs, const std::optional<std::string>& output,
                       const std::optional<std::string>& json);

/// The component that has the name of an attribute, of the model or of its attribute domain; the model must outlive it.
/// @error kBadArgument for another name
Result<DmsComponent> dms_component(const DmsModel& model, const std::string& attribute);

/// "PATH: CODE: where; 3 more defects". REQUIRES a defect.
std::string dms_refusal(const std::string& path, const DmsDefects& defects);

/// An error about a model, with the path, and with the tetrahedron that is its entity in words.
Error in_dms_model(Error error, const std::string& path);

/// Reads "x,y,z", exactly; "" or why not.
std::string take_dms_point(std::string_view text, DmsPoint& point);

}  // namespace veritope::cli
