// SPDX-License-Identifier: LGPL-3.0-or-later
// The program veritope. Documented in docs/cli/README.md.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/commands.h"
#include "cli/option_set.h"
#include "cli/signals.h"
#include "report/text_style.h"
#include "robust/base/check.h"
#include "robust/base/fp_guard.h"
#include "verify/certify/certify.h"

namespace veritope::cli {

using namespace report;
namespace {

constexpr char kTitle[] = "veritope: solid models that come with proofs";
constexpr char kFooter[] =
    "Exit: 0 valid or done, 1 invalid, 2 wrong usage, 3 undecided, 4 unreadable, over\n"
    "a limit or cannot write, 5 our bug; several files: the first of 5, 1, 4, 3, 0";
constexpr char kListFooter[] =
    "SUBCOMMAND --help or -h lists its options; --version or -V prints the version\n"
    "Exit: 0 valid or done, 1 invalid, 2 usage, 3 undecided, 4 unreadable, 5 our bug";

// Prevents a file that is opened later from getting the number of a standard stream that was closed. Writing to that
// stream then fails, and is not lost silently.
void occupy_standard_streams() {
  int descriptor = 0;
  do {
    descriptor = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor >= 0) ::close(descriptor);
}

ExitCode guarded(const RunCommand& run, StandardOutput& out) {
  try {
    return run(out);
  } catch (const std::bad_alloc&) {
    complain("not enough memory");
    return kExitUndecided;
  } catch (const std::system_error& error) {
    complain(std::string("the system refuses: ") + error.what());
    return kExitUndecided;
  } catch (const std::exception& error) {
    complain(std::string("a bug of veritope, please report it: ") + error.what());
    return kExitBug;
  }
}

ExitCode run_command(const Command& command, const RunCommand& run, StandardOutput& out) {
  if (const Status status = command.needs_fp ? check_fp() : ok_status(); !status) {
    complain(status.error().message);
    return kExitBug;
  }
  return guarded(run, out);
}

int main_of(int argc, const char* const* argv) {
  CommandLine line(kTitle, tool_name(), kFooter);
  std::vector<RunCommand> runs;
  for (const Command& command : commands())
    runs.push_back(command.declare(line.add_command(command.name, command.summary)));
  line.set_list_footer(kListFooter);
  const ParsedLine parsed = line.parse(argc, argv);
  if (!parsed.error.empty()) {
    const bool is_known =
        argc > 1 && std::any_of(commands().begin(), commands().end(), [&](const Command& c) {
          return std::string_view(c.name) == argv[1];
        });
    complain(harmless(parsed.error) + "\nveritope " + (is_known ? std::string(argv[1]) + " " : "") +
             "--help says more");
    return kExitUsage;
  }
  StandardOutput out;
  ExitCode exit = kExitValid;
  if (parsed.command) {
    exit = run_command(commands()[*parsed.command], runs[*parsed.command], out);
  } else {
    out.write(parsed.text);
  }
  const Status written = out.status();
  if (written) return exit;
  complain(to_string(written.error()));
  return exit == kExitUsage ? exit : first_of(exit, kExitUnreadable);
}

}  // namespace
}  // namespace veritope::cli

int main(int argc, char** argv) {
  veritope::cli::occupy_standard_streams();
  veritope::cli::install_signal_handlers();
  return veritope::cli::main_of(argc, argv);
}
