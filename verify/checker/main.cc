// SPDX-License-Identifier: Apache-2.0 OR MIT
// main.cc: veritope-check MODEL CERT [ANSWERS] [--model M]. Output and exit codes: docs/certificates/mesh.md.
#include <sys/stat.h>  // C++11 cannot tell a file from a FIFO, whose opening waits for a writer

#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "claims.h"

namespace {

const char kUsage[] =
    "usage: veritope-check MODEL CERT [ANSWERS] [--model M]\n"
    "Checks the certificate CERT about the model MODEL (STL, OBJ, PLY, OFF, vjson, itd, g2, MFEM,\n"
    "vmicro, vdms, or a chain file, whose operands are read, too). ANSWERS is the file of classified\n"
    "points that the claim points-1 needs, M the solid that micro-inside-1 needs, and no other.\n"
    "Prints ACCEPT with the claim and exits with 0, or REJECT with the condition that fails and\n"
    "exits with 1. Other exit codes: 2 usage; 3 out of memory; 4 a file cannot be opened, the\n"
    "reading rule refuses a model, or the answer cannot be printed; 5 a bug.\n"
    "--claims prints the claims that it decides, with the keys of their statements.";

// third: ANSWERS and M, null where they are not given. False: the program is not used so.
bool read_arguments(int argc, char** argv, const char** third) {
  for (int i = 1; i < argc; ++i) {
    const bool is_solid = i > 2 && i + 1 < argc && std::strcmp(argv[i], "--model") == 0;
    i += is_solid;
    if (std::strncmp(argv[i], "--", 2) == 0 || third[is_solid] != nullptr) return false;
    if (i > 2) third[is_solid] = argv[i];
  }
  return argc > 2;
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
  const char* third[2] = {nullptr, nullptr};
  if (!read_arguments(argc, argv, third)) return say(stderr, kUsage, 2);
  std::string name = argv[2];  // the file that a refusal names
  try {
    const std::string certificate = read_file(name);
    name = first;
    std::string file = read_file(name), bytes[2];
    for (int k = 0; k < 2; ++k)
      if (third[k] != nullptr) bytes[k] = read_file(name = third[k]);
    name = first;
    Body body = {nullptr, nullptr};
    Statement s = read_statement(all_claims(), certificate, file, &body);
    for (int k = 0; k < 2; ++k)
      if ((k == 0 ? s.needs_answers() : s.needs_solid()) != (third[k] != nullptr))
        return say(stderr,
                   std::string("The claim ") + s.claim->name +
                       (third[k] != nullptr ? " needs no file " : " needs a third file, ") +
                       (k == 0 ? "ANSWERS: veritope-check MODEL CERT [ANSWERS]"
                               : "M: veritope-check MODEL CERT --model M"),
                   2);
    s.answers = std::move(bytes[0]), s.solid = std::move(bytes[1]);
    if (s.needs_solid()) s.solid_name = third[1];
    s.model_name = name;
    s.read_file = read_file;
    const std::string what = s.claim->check(s, std::move(file), body);
    return say(stdout, std::string("ACCEPT ") + s.claim->name + ": " + what, 0);
  } catch (const Rejected& r) {
    return say(stdout, "REJECT " + r.id + ": " + r.why, 1);
  } catch (const Refused& r) {
    return say(stderr, name + ": " + r.why, 4);
  } catch (const std::bad_alloc&) {
    std::fputs("veritope-check stops: out of memory\n", stderr);
    return 3;
  } catch (const std::exception& e) {                                         // NOT COVERED: a bug
    return say(stderr, std::string("veritope-check stops: ") + e.what(), 5);  // NOT COVERED: a bug
  }                                                                           // NOT COVERED: a bug
}
