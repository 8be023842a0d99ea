// SPDX-License-Identifier: LGPL-3.0-or-later
// The program veritope. Documented in docs/cli.md.
#include <fcntl.h>
#include <unistd.h>

#include <exception>
#include <new>
#include <system_error>

#include "cli/commands.h"
#include "cli/signals.h"
#include "report/text_style.h"
#include "robust/base/check.h"
#include "robust/base/fp_guard.h"

namespace veritope::cli {

using namespace report;
namespace {

// So that no file that is opened later gets the number of a standard stream. What is written to a stream that was
// closed fails: it is not lost in silence.
void occupy_standard_streams() {
  int descriptor = 0;
  do {
    descriptor = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor >= 0) ::close(descriptor);
}

ExitCode run(const Options& options, StandardOutput& out) {
  switch (options.command) {
    case Command::kCertify: return run_certify(options, out);
    case Command::kInfo: return run_info(options, out);
    case Command::kConvert: return run_convert(options, out);
    case Command::kIntersect: return run_intersect(options, out);
    case Command::kProject: return run_project(options, out);
    case Command::kCover: return run_cover(options, out);
    case Command::kExplain: return run_explain(options, out);
    case Command::kExplainCertificate: return run_explain_certificate(options, out);
    case Command::kPredicate: return run_predicate(options, out);
    case Command::kSelftest: return run_selftest(options, out);
    case Command::kCorpus: return run_corpus(options, out);
  }
  return kExitBug;
}

ExitCode guarded(const Options& options, StandardOutput& out) {
  try {
    return run(options, out);
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

int main_of(int argc, const char* const* argv) {
  const ParsedArguments arguments = parse_arguments(argc, argv);
  if (!arguments.error.empty()) {
    complain(harmless(arguments.error) + "\nveritope --help and veritope COMMAND --help say more");
    return kExitUsage;
  }
  StandardOutput out;
  ExitCode exit = kExitValid;
  if (arguments.options) {
    // The self-test reports on the floating point itself.
    const bool must_check = arguments.options->command != Command::kSelftest;
    if (const Status status = must_check ? check_fp() : ok_status(); !status) {
      complain(status.error().message);
      return kExitBug;
    }
    exit = guarded(*arguments.options, out);
  } else {
    out.write(arguments.text);
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
