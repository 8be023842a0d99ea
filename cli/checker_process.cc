// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/checker_process.h"

#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <initializer_list>
#include <string_view>
#include <system_error>

#include "cli/signals.h"

namespace veritope::cli {
namespace {

constexpr std::string_view kName = "veritope-check";
constexpr int kOutOfMemory = 3;  // the checker's exit status

bool is_program(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
         ::access(path.c_str(), X_OK) == 0;
}

// The folder of the running program, with a slash; empty if it is unknown.
std::string own_folder() {
  char path[PATH_MAX];
  const ssize_t size = ::readlink("/proc/self/exe", path, sizeof path);
  if (size <= 0 || size == static_cast<ssize_t>(sizeof path)) return "";
  const std::string_view text(path, static_cast<std::size_t>(size));
  return std::string(text.substr(0, text.rfind('/') + 1));
}

std::vector<std::string> candidates() {
  std::vector<std::string> paths;
  const std::string folder = own_folder(), name(kName);
  if (!folder.empty()) {
    paths = {folder + name, folder + "../libexec/veritope/" + name, folder + "../libexec/" + name};
  }
  const char* const path = ::getenv("PATH");
  std::string_view rest = path != nullptr ? path : "";
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const std::string_view entry = rest.substr(0, colon);
    if (!entry.empty()) paths.push_back(std::string(entry) + "/" + name);
    rest = colon == rest.npos ? "" : rest.substr(colon + 1);
  }
  const char* const named = ::getenv("VERITOPE_CHECK");
  if (named != nullptr && *named != '\0') paths.emplace_back(named);
  return paths;
}

// The beginning of what comes out of the pipe; the rest is read and dropped, so that the writer never waits.
std::string drain(int descriptor) {
  constexpr std::size_t kMost = 4096;
  std::string kept;
  char buffer[4096];
  for (;;) {
    const ssize_t got = ::read(descriptor, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return kept;
    kept.append(buffer, std::min(static_cast<std::size_t>(got), kMost - kept.size()));
  }
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

bool says_accept(const std::string& line, const std::string& claim) {
  const std::string wanted = "ACCEPT " + claim;
  if (line.compare(0, wanted.size(), wanted) != 0) return false;
  return line.size() == wanted.size() || line[wanted.size()] == ' ' || line[wanted.size()] == ':';
}

// Whether the line says REJECT, a condition, and a reason that begins with one of these.
bool rejects_with(std::string_view line, std::initializer_list<std::string_view> words) {
  const std::size_t colon = line.find(": ");
  if (!line.starts_with("REJECT ") || colon == line.npos) return false;
  const std::string_view reason = line.substr(colon + 2);
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view w) { return reason.starts_with(w); });
}

void judge(int status, const std::string& claim, CheckerOutcome& outcome) {
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    outcome.lacks_resources = number == SIGKILL;
    outcome.words = "died by signal " + std::to_string(number) + " (" + ::strsignal(number) + ")";
    return;
  }
  outcome.exit = WEXITSTATUS(status);
  outcome.lacks_resources = outcome.exit == kOutOfMemory;
  outcome.exceeds_work =
      outcome.exit == 1 &&
      rejects_with(outcome.words, {"more work than allowed", "over a limit of this checker"});
  outcome.exceeds_lengths =
      outcome.exit == 1 &&
      rejects_with(outcome.words, {"a common denominator has more bits", "a number has more bits",
                                   "the coefficients are too long"});
  outcome.is_accepted = outcome.exit == 0 && says_accept(outcome.words, claim);
  if (outcome.words.empty()) outcome.words = "said nothing, exit " + std::to_string(outcome.exit);
}

// What the child gets apart from this process: /dev/null to read, the pipe to write, `inherited`,
// and the signals that are ignored here.
class SpawnSettings {
 public:
  SpawnSettings(const std::vector<int>& inherited, int output) {
    ::posix_spawn_file_actions_init(&files_);
    ::posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files_, output, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files_, output, STDERR_FILENO);
    for (const int descriptor : inherited) {
      ::lseek(descriptor, 0, SEEK_SET);
      ::posix_spawn_file_actions_adddup2(&files_, descriptor, descriptor);  // keeps it open
    }
    sigset_t set;
    ::posix_spawnattr_init(&attributes_);
    sigemptyset(&set);
    ::posix_spawnattr_setsigmask(&attributes_, &set);
    sigaddset(&set, SIGPIPE);
    sigaddset(&set, SIGXFSZ);
    ::posix_spawnattr_setsigdefault(&attributes_, &set);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnSettings() {
    ::posix_spawn_file_actions_destroy(&files_);
    ::posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  // 0, or an error number.
  int spawn(pid_t& child, const char* const* arguments) const {
    return ::posix_spawn(&child, arguments[0], &files_, &attributes_,
                         const_cast<char* const*>(arguments), environ);
  }

 private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

// 0, or an error number. On success `output` is open.
int start(const char* const* arguments, const std::vector<int>& inherited, pid_t& child,
          int& output) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return errno;
  int error = 0;
  {
    const SpawnSettings settings(inherited, ends[1]);
    const SignalsBlocked blocked;  // until the handler knows the child
    error = settings.spawn(child, arguments);
    if (error == 0) set_child(child);
  }
  ::close(ends[1]);
  if (error != 0) ::close(ends[0]);
  output = ends[0];
  return error;
}

}  // namespace

Result<std::string> find_checker() {
  for (const std::string& path : candidates()) {
    if (is_program(path)) return path;
  }
  return Error{Code::kCannotOpen, Place{},
               "veritope-check was found neither beside veritope nor in libexec, PATH or "
               "VERITOPE_CHECK; --no-check certifies without it, and says so"};
}

CheckerOutcome run_checker(const std::string& checker, const std::string& model,
                           const std::string& certificate, const std::string& claim,
                           const std::vector<int>& inherited, const std::string& answers,
                           const std::string& solid) {
  const auto begin = std::chrono::steady_clock::now();
  // A name that looks like an option is a file, too.
  const auto named = [](const std::string& path) {
    return path.starts_with("-") ? "./" + path : path;
  };
  const std::string subject = named(model), other = named(solid);
  std::vector<const char*> arguments{checker.c_str(), subject.c_str(), certificate.c_str()};
  if (!answers.empty()) arguments.push_back(answers.c_str());
  if (!solid.empty()) arguments.insert(arguments.end(), {"--model", other.c_str()});
  arguments.push_back(nullptr);
  CheckerOutcome outcome;
  pid_t child = 0;
  int output = -1;
  if (const int error = start(arguments.data(), inherited, child, output); error != 0) {
    outcome.words = "could not be started: " + std::generic_category().message(error);
  } else {
    outcome.is_started = true;
    outcome.words = first_line(drain(output));
    ::close(output);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    set_child(0);
    judge(status, claim, outcome);
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

}  // namespace veritope::cli
