// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/checker_process.h: veritope-check as another process. There is no verdict unless it accepts
// the certificate.
#pragma once
#include <string>
#include <vector>

#include "robust/base/result.h"

namespace veritope::cli {

/// The checker's program: beside this program, in ../libexec/veritope or ../libexec, in PATH, or the value of
/// VERITOPE_CHECK, the first that can be executed.
/// @error kCannotOpen
Result<std::string> find_checker();

/// How a run of the checker ended.
struct CheckerOutcome {
  bool is_started = false;
  bool is_accepted = false;  ///< exit 0 and "ACCEPT <claim>" for the claim that was to be checked
  bool lacks_resources =
      false;  ///< out of memory (exit 3), or killed (SIGKILL): as the system does when memory is short
  bool exceeds_work =
      false;  ///< "REJECT C2: more work ...", "over a limit of this checker ...": what a checker may spend is bounded
  bool exceeds_lengths =
      false;  ///< "REJECT B2: a number has more bits ...": a model that the format does not cover
  int exit = -1;      ///< exit status; -1: ended by a signal, or never started
  std::string words;  ///< its first line of output, or how it ended
  double seconds = 0;
};

/// Runs `checker model certificate`, followed by `answers` unless that is empty, and by `--model solid` likewise, and
/// waits. `inherited`: descriptors that the child keeps, for paths such as /dev/fd/5.
CheckerOutcome run_checker(const std::string& checker, const std::string& model,
                           const std::string& certificate, const std::string& claim,
                           const std::vector<int>& inherited, const std::string& answers = {},
                           const std::string& solid = {});

}  // namespace veritope::cli
