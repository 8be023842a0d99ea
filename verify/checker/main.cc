// SPDX-License-Identifier: Apache-2.0 OR MIT
// main.cc: veritope-check MODEL CERT [ANSWERS] [--model M]. Output and exit codes: docs/certificates/mesh.md.
#include <sys/stat.h>  // C++11 cannot tell a file from a FIFO, whose opening waits for a writer

#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "claims.h"

namespace {

const char kCommand[] = "veritope-check MODEL CERT [ANSWERS] [--model M]";
const char kUsage[] =
    "usage: veritope-check MODEL CERT [ANSWERS] [--model M]\n"
    "Checks the certificate CERT about the model MODEL (STL, OBJ, PLY, OFF, vjson, itd, g2, MFEM, "
    "vmicro,\n"
    "or a chain file, whose operands are read, too).\n"
    "ANSWERS is the file of classified points that the claim points-1 needs, M the mesh that the "
    "claim\n"
    "micro-inside-1 needs, and no other claim.\n"
    "Prints ACCEPT with the claim and exits with 0, or REJECT with the condition that fails and "
    "exits "
    "with\n"
    "1. Other exit codes: 2 usage; 3 out of memory; 4 a file cannot be opened, the reading rule "
    "refuses\n"
    "a model, or the answer cannot be printed; 5 a bug.\n"
    "--claims prints the claims that it decides, with the keys of their statements.";

struct Arguments {  // after MODEL and CERT
  std::string answers, solid;
  bool has_answers = false, has_solid = false;
};
// Whether that is how the program is used.
bool read_arguments(int argc, char** argv, Arguments* to) {
  if (argc < 3) return false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool is_solid = i > 2 && word == "--model" && i + 1 < argc && !to->has_solid;
    if (is_solid) to->solid = argv[++i], to->has_solid = true;
    if (std::strncmp(argv[i], "--", 2) == 0) return false;
    if (i < 3 || is_solid) continue;
    if (to->has_answers) return false;
    to->answers = word, to->has_answers = true;
  }
  return true;
}
// Whether the claim needs the files that are given and no others; otherwise says so.
std::string unneeded(const Statement& s, const Arguments& given) {
  std::string why;
  if (s.needs_answers() != given.has_answers)
    why = given.has_answers ? " needs no file ANSWERS" : " needs a third file, ANSWERS";
  if (s.needs_solid() != given.has_solid)
    why = given.has_solid ? " needs no model M" : " needs a third file, --model M";
  return why.empty() ? why : std::string("The claim ") + s.claim->name + why + ": " + kCommand;
}

std::string read_file(const std::string& name) {
  struct stat status = {};
  if (stat(name.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
    throw Refused{"is not a regular file"};
  std::FILE* const file = std::fopen(name.c_str(), "rb");
  if (file == nullptr) throw Refused{"cannot be opened"};
  std::string bytes;
  bytes.reserve(size_t(status.st_size));
  char part[65536];
  for (size_t n; (n = std::fread(part, 1, sizeof part, file)) > 0;) bytes.append(part, n);
  const bool failed = std::ferror(file) != 0;
  std::fclose(file);
  if (failed) throw Refused{"cannot be read"};
  return bytes;
}

// An answer that cannot be printed does not count: the exit code says so.
int say(std::FILE* to, const std::string& text, int exit_code) {
  for (char c : text) std::fputc((c < 32 || c > 126) && c != '\n' ? '?' : c, to);
  std::fputc('\n', to);
  std::fflush(to);
  return std::ferror(to) == 0 ? exit_code : 4;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  if (argc == 2 && (first == "--help" || first == "-h")) return say(stdout, kUsage, 0);
  if (argc == 2 && first == "--version") return say(stdout, "veritope-check 1", 0);
  if (argc == 2 && first == "--claims") return say(stdout, claims_as_text(), 0);
  Arguments given;
  if (!read_arguments(argc, argv, &given)) return say(stderr, kUsage, 2);
  std::string name = argv[2];  // the file that a refusal names
  try {
    const std::string certificate = read_file(name);
    name = first;
    std::string file = read_file(name), answers, solid;
    if (given.has_answers) answers = read_file(name = given.answers);
    if (given.has_solid) solid = read_file(name = given.solid);
    name = first;
    Body body = {nullptr, nullptr};
    Statement s = read_statement(all_claims(), certificate, file, &body);
    const std::string wrong = unneeded(s, given);
    if (!wrong.empty()) return say(stderr, wrong, 2);
    s.solid = std::move(solid);
    s.solid_name = given.solid;
    s.answers = std::move(answers);
    s.model_name = name;
    s.read_file = read_file;
    return say(
        stdout,
        std::string("ACCEPT ") + s.claim->name + ": " + s.claim->check(s, std::move(file), body),
        0);
  } catch (const Rejected& r) {
    return say(stdout, "REJECT " + r.id + ": " + r.why, 1);
  } catch (const Refused& r) {
    return say(stderr, name + ": " + r.why, 4);
  } catch (const std::bad_alloc&) {
    std::fputs("veritope-check stops: out of memory\n", stderr);
    return 3;
  } catch (const std::exception& e) {  // NOT COVERED: a bug of the checker
    return say(stderr, std::string("veritope-check stops: ") + e.what(),
               5);  // NOT COVERED: the same
  }                 // NOT COVERED: the same
}
