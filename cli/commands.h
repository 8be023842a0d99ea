// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/commands.h: the table of commands. A command is one file, command_NAME.cc, with its options, and one row here.
#pragma once
#include <functional>
#include <span>

#include "cli/option_groups.h"
#include "cli/output.h"
#include "report/exit_code.h"

namespace veritope::cli {

using namespace report;

/// Runs a command with the options that were parsed: prints, and returns the exit status.
using RunCommand = std::function<ExitCode(StandardOutput& out)>;

struct Command {
  const char* name;
  const char* summary;  ///< in the help of the program
  /// Declares the command's options in an object that the returned function owns and reads.
  RunCommand (*declare)(OptionSet& set);
  /// False: the command runs even if the floating point is not what the filters need, and reports that itself.
  bool needs_fp = true;
};

/// All rows, in the order of the help.
std::span<const Command> commands();

RunCommand declare_certify(OptionSet& set);
RunCommand declare_info(OptionSet& set);
RunCommand declare_inspect(OptionSet& set);
RunCommand declare_convert(OptionSet& set);
RunCommand declare_build(OptionSet& set);
RunCommand declare_cage(OptionSet& set);
RunCommand declare_micro(OptionSet& set);
RunCommand declare_dms(OptionSet& set);
RunCommand declare_intersect(OptionSet& set);
RunCommand declare_project(OptionSet& set);
RunCommand declare_classify(OptionSet& set);
RunCommand declare_boolean(OptionSet& set);
RunCommand declare_chain(OptionSet& set);
RunCommand declare_render(OptionSet& set);
RunCommand declare_cover(OptionSet& set);
RunCommand declare_explain(OptionSet& set);
RunCommand declare_explain_certificate(OptionSet& set);
RunCommand declare_predicate(OptionSet& set);
RunCommand declare_selftest(OptionSet& set);
RunCommand declare_corpus(OptionSet& set);

}  // namespace veritope::cli
