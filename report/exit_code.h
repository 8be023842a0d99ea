// SPDX-License-Identifier: LGPL-3.0-or-later
// report/exit_code.h: what the exit status says. Documented in docs/cli/README.md.
#pragma once
#include <initializer_list>

namespace veritope::report {

enum ExitCode : int {
  kExitValid = 0,
  kExitInvalid = 1,
  kExitUsage = 2,
  kExitUndecided = 3,
  kExitUnreadable = 4,  ///< an input that cannot be read, a limit, an output that cannot be written
  kExitBug = 5,
};

/// The one of two outcomes that comes first in 5, 1, 4, 3, 0. REQUIRES that neither is kExitUsage.
constexpr ExitCode first_of(ExitCode a, ExitCode b) {
  for (const ExitCode code : {kExitBug, kExitInvalid, kExitUnreadable, kExitUndecided}) {
    if (a == code || b == code) return code;
  }
  return kExitValid;
}

}  // namespace veritope::report
