// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/signals.h"

#include <signal.h>
#include <string.h>
#include <unistd.h>

#include <atomic>

#include "io/base/atomic_file.h"

namespace veritope::cli {
namespace {

constexpr int kEnding[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU};
std::atomic<pid_t> running_child{0};
std::atomic<bool> progress_shown{false};
static_assert(std::atomic<pid_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "needed in signal handlers");

void write_error(const char* text) {
  // Nothing can be done if standard error takes no bytes.
  [[maybe_unused]] const ssize_t put = ::write(STDERR_FILENO, text, ::strlen(text));
}

// Async-signal-safe functions only.
extern "C" void end_by_signal(int number) {
  const bool has_removed = remove_unfinished_files();
  const pid_t child = running_child.load();
  if (child > 0) ::kill(child, SIGKILL);
  if (progress_shown.load()) write_error("\r\033[K");
  write_error(number == SIGINT ? "veritope: interrupted (SIGINT)" : "veritope: ended by a signal");
  write_error(has_removed ? "; unfinished output was removed\n" : "\n");
  ::signal(number, SIG_DFL);
  ::raise(number);  // takes effect when the handler returns
}

sigset_t ending_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : kEnding) sigaddset(&set, number);
  return set;
}

}  // namespace

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = end_by_signal;
  action.sa_mask = ending_signals();
  action.sa_flags = SA_RESTART;
  for (const int number : kEnding) {
    struct sigaction old {};
    const bool is_ignored = ::sigaction(number, nullptr, &old) == 0 && old.sa_handler == SIG_IGN;
    if (is_ignored) continue;  // nohup; `trap '' INT`; a job in the background of a script
    ::sigaction(number, &action, nullptr);
  }
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
}

SignalsBlocked::SignalsBlocked() {
  static_assert(sizeof(sigset_t) <= sizeof saved_, "room for the mask");
  const sigset_t set = ending_signals();
  sigset_t old;
  ::pthread_sigmask(SIG_BLOCK, &set, &old);
  ::memcpy(saved_, &old, sizeof old);
}

SignalsBlocked::~SignalsBlocked() {
  sigset_t old;
  ::memcpy(&old, saved_, sizeof old);
  ::pthread_sigmask(SIG_SETMASK, &old, nullptr);
}

void set_child(pid_t child) { running_child.store(child); }

void set_progress_shown(bool is_shown) { progress_shown.store(is_shown); }

}  // namespace veritope::cli
