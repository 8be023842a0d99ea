// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/dms_verbs.h: the verbs of veritope dms.
#pragma once
#include <string>

#include "cli/commands.h"
#include "io/read_model.h"

namespace veritope::cli {

RunCommand declare_dms_eval(OptionSet& set);
RunCommand declare_dms_make(OptionSet& set);
RunCommand declare_dms_domain(OptionSet& set);

/// Reads a model. @error as read_model_file, and kUnknownFormat for a file of another kind
Result<DmsFile> read_dms_file(const std::string& path, ModelReadOptions reading);

}  // namespace veritope::cli
