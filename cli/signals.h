// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/signals.h: what happens on SIGINT, SIGTERM, SIGHUP, SIGPIPE and SIGXFSZ.
#pragma once
#include <sys/types.h>

namespace veritope::cli {

/// From now on SIGINT, SIGTERM and SIGHUP remove unfinished outputs (io/base/atomic_file.h), end the running
/// checker, say so on standard error and end this process by the same signal: a shell reports 130, 143,
/// 129. SIGPIPE and SIGXFSZ are ignored: a write into a closed pipe, or beyond a limit, fails instead,
/// see cli/output.h.
void install_signal_handlers();

/// Blocks SIGINT, SIGTERM and SIGHUP in this thread while it lives, so that they cannot interrupt what must be done as
/// a whole.
class SignalsBlocked {
 public:
  SignalsBlocked();
  ~SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  unsigned char saved_[128];  ///< a sigset_t
};

/// Sets the child that an interruption ends as well; 0: none.
void set_child(pid_t child);

/// Sets whether a line of progress is on the terminal, which an interruption then erases.
void set_progress_shown(bool is_shown);

}  // namespace veritope::cli
