// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/dms_checker_fuzz.cc: gives any simplex-spline solid and any certificate of dms-solid-1, dms-solid-2 or
// dms-invalid-1 to the C++ checker, which must not crash or hang, and must not accept two claims about one file with
// different shells, bodies or genus, or a defect that contradicts them. What it accepts can be explained, and encoded
// again, if the claim is one of those that the library knows. An input is the size of the file (4 bytes,
// little-endian), the file, the certificate. The mutator changes digits of the file, numbers of the statement and the
// body, and then corrects sizes and hashes.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <random>

#include "fuzz/certificate_input.h"
#include "tests/support/checker_call.h"
#include "verify/format/claims.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace veritope::fuzz {
namespace {

constexpr const char* kDmsNumbers[] = {"shells",         "bodies", "genus",   "tetrahedra",
                                       "control_points", "leaves", "patches", "faces"};
constexpr std::size_t kNumbersOfTheSolid = 5;  // the first ones; the others are those of the proof
constexpr const char* kDmsFindings[] = {"tet-reversed",
                                        "tet-face-overused",
                                        "cloud-degenerate",
                                        "cloud-no-core",
                                        "cloud-inside",
                                        "jacobian",
                                        "jacobian-zero",
                                        "M4",
                                        "M6",
                                        "M7",
                                        "M9",
                                        "meeting",
                                        "crossing",
                                        "covering"};

[[noreturn]] void fail_dms(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::abort();
}

// What the statement says about the solid: two such texts about one file are equal. Empty: nothing that dms-solid-1 or
// dms-solid-2 would contradict, which needs no common inner points of clouds.
std::string said_of_the_solid(const std::string& statement, bool is_solid) {
  if (!is_solid) return get(statement, "finding") == "cloud-no-core" ? "" : "a defect";
  std::string numbers;
  for (std::size_t i = 0; i < kNumbersOfTheSolid; ++i)
    numbers += get(statement, kDmsNumbers[i]) + " ";
  return numbers;
}

void check_dms_input(const Input& in) {
  const std::string statement = in.certificate.substr(0, in.certificate.find('\n'));
  const std::string claim = get(statement, "claim");
  const bool is_solid = claim == "dms-solid-1" || claim == "dms-solid-2";
  if (!is_solid && claim != "dms-invalid-1") return;
  const std::span<const unsigned char> bytes(
      reinterpret_cast<const unsigned char*>(in.certificate.data()), in.certificate.size());
  std::string why;
  const bool is_explained = certificate::explain_certificate(bytes, 4, why).has_value();
  const auto decoded = certificate::decode_certificate(bytes, why);
  const std::string answer = check_in_process(in.model, in.certificate);
  if (answer.substr(0, 4) == "BUG ") fail_dms(answer);
  if (answer.substr(0, 7) != "ACCEPT ") return;
  if (certificate::find_claim(claim) != nullptr && (!is_explained || !decoded))
    fail_dms(answer + "\nbut it is not explained: " + why);
  const std::string said = said_of_the_solid(statement, is_solid);
  if (said.empty()) return;
  static std::map<std::string, std::string>* const known = new std::map<std::string, std::string>;
  const std::string& before = known->emplace(hash(in.model), said).first->second;
  if (before != said) fail_dms(answer + "\nbut of this file was accepted: " + before);
}

class DmsMutator {
 public:
  DmsMutator(Input in, unsigned seed) : in_(std::move(in)), random_(seed) {
    const std::size_t line = std::min(in_.certificate.find('\n'), in_.certificate.size());
    statement_ = in_.certificate.substr(0, line);
    body_ = in_.certificate.substr(std::min(line + 1, in_.certificate.size()));
  }
  Input take() {
    in_.certificate = statement_ + "\n" + body_;
    return std::move(in_);
  }
  void change() {
    switch (pick(8)) {
      case 0: change_statement(); break;
      case 1:
      case 2: change_digit(in_.model, random_); break;
      case 3: body_.insert(pick(body_.size() + 1), 1, static_cast<char>(pick(16))); break;
      case 4: body_.erase(pick(body_.size() + 1), 1); break;
      default: change_byte();
    }
  }

 private:
  std::size_t pick(std::size_t n) { return random_below(random_, n); }
  void change_statement() {
    set(statement_, kDmsNumbers[pick(std::size(kDmsNumbers))], std::to_string(pick(30)));
    if (get(statement_, "claim") != "dms-invalid-1" || body_.size() < 9) return;
    // The body's kind stands behind its magic number and T.
    const std::size_t kind = pick(std::size(kDmsFindings));
    set(statement_, "finding", kDmsFindings[kind]);
    body_[8] = static_cast<char>(kind);
  }
  void change_byte() {
    if (body_.empty()) return;
    char& c = body_[pick(body_.size())];
    c = pick(2) == 0 ? static_cast<char>(pick(16)) : static_cast<char>(c ^ (1 << pick(8)));
  }

  Input in_;
  std::string statement_, body_;
  std::mt19937 random_;
};

}  // namespace
}  // namespace veritope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check_dms_input(veritope::fuzz::Input::decode(data, size));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  using namespace veritope::fuzz;
  if (seed % 32 == 0) return LLVMFuzzerMutate(data, size, max_size);
  DmsMutator mutator(Input::decode(data, size), seed);
  for (unsigned n = 1 + seed / 32 % 3; n > 0; --n) mutator.change();
  Input in = mutator.take();
  if (seed % 32 != 1) make_hashes_true(in);
  const std::string bytes = in.encode();
  if (bytes.size() > max_size) return size;
  std::memcpy(data, bytes.data(), bytes.size());
  return bytes.size();
}
