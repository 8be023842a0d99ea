// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/micro_checker_fuzz.cc: gives any microstructure, any mesh and any certificate of microstructure-1 or
// micro-inside-1 to the C++ checker, which must not crash or hang, and must not accept two claims about one file with
// different numbers. What it accepts can be explained, and encoded again.
// An input is the size of the microstructure (4 bytes, little-endian), the microstructure, the size of the mesh, the
// mesh, the certificate. The mutator changes digits of files, numbers of the statement and the body, and then corrects
// sizes and hashes.
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

[[noreturn]] void fail_micro(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::abort();
}

struct MicroInput {
  std::string micro, mesh, certificate;

  static MicroInput decode(const std::uint8_t* data, std::size_t size) {
    MicroInput in;
    const Input first = Input::decode(data, size);
    in.micro = first.model;
    const auto* rest = reinterpret_cast<const std::uint8_t*>(first.certificate.data());
    const Input second = Input::decode(rest, first.certificate.size());
    in.mesh = second.model;
    in.certificate = second.certificate;
    return in;
  }
  std::string encode() const {
    Input second{mesh, certificate};
    return Input{micro, second.encode()}.encode();
  }
};

void make_true(MicroInput& in) {
  Input first{in.micro, in.certificate};
  make_hashes_true(first);
  const std::size_t line = first.certificate.find('\n');
  if (line == first.certificate.npos) return;
  std::string statement = first.certificate.substr(0, line);
  set(statement, "model_sha256", hash(in.mesh));
  set(statement, "model_bytes", std::to_string(in.mesh.size()));
  in.certificate = statement + first.certificate.substr(line);
}

constexpr const char* kMicroNumbers[] = {"cells",      "tiles",  "bridges", "glued_caps",
                                         "components", "shells", "genus"};

void check_micro_input(const MicroInput& in) {
  const std::string statement = in.certificate.substr(0, in.certificate.find('\n'));
  const std::string claim = get(statement, "claim");
  if (claim != "microstructure-1" && claim != "micro-inside-1") return;
  const std::span<const unsigned char> bytes(
      reinterpret_cast<const unsigned char*>(in.certificate.data()), in.certificate.size());
  std::string why;
  const bool is_explained = certificate::explain_certificate(bytes, 4, why).has_value();
  const auto decoded = certificate::decode_certificate(bytes, why);
  const std::string answer = check_in_process(in.micro, in.certificate, "", nullptr, in.mesh);
  if (answer.substr(0, 4) == "BUG ") fail_micro(answer);
  if (answer.substr(0, 7) != "ACCEPT ") return;
  if (!is_explained) fail_micro(answer + "\nbut it is not explained: " + why);
  if (!std::ranges::equal(decoded->claim->encode(decoded->body),
                          bytes.subspan(statement.size() + 1)))
    fail_micro(answer + "\nbut what is decoded is encoded otherwise");
  std::string numbers;
  for (const char* key : kMicroNumbers) numbers += get(statement, key) + " ";
  static std::map<std::string, std::string>* const known = new std::map<std::string, std::string>;
  const std::string& before = known->emplace(hash(in.micro), numbers).first->second;
  if (before != numbers)
    fail_micro(answer + "\nbut of this file other numbers were accepted: " + before);
}

class MicroMutator {
 public:
  MicroMutator(MicroInput in, unsigned seed) : in_(std::move(in)), random_(seed) {
    const std::size_t line = std::min(in_.certificate.find('\n'), in_.certificate.size());
    statement_ = in_.certificate.substr(0, line);
    body_ = in_.certificate.substr(std::min(line + 1, in_.certificate.size()));
  }
  MicroInput take() {
    in_.certificate = statement_ + "\n" + body_;
    return std::move(in_);
  }
  void change() {
    switch (pick(10)) {
      case 0:
        set(statement_, kMicroNumbers[pick(std::size(kMicroNumbers))], std::to_string(pick(30)));
        break;
      case 1: change_digit(in_.micro, random_); break;
      case 2: change_digit(in_.mesh, random_); break;
      case 3: body_.insert(pick(body_.size() + 1), 1, static_cast<char>(pick(16))); break;
      case 4: body_.erase(pick(body_.size() + 1), 1); break;
      case 5: change_hexadecimal(); break;
      default: change_byte();
    }
  }

 private:
  std::size_t pick(std::size_t n) { return random_below(random_, n); }
  void change_byte() {
    if (body_.empty()) return;
    char& c = body_[pick(body_.size())];
    c = pick(2) == 0 ? static_cast<char>(pick(8)) : static_cast<char>(c ^ (1 << pick(8)));
  }
  // Which cells hold tiles.
  void change_hexadecimal() {
    const std::size_t cells = in_.micro.find("\"cells\"");
    if (cells == in_.micro.npos) return;
    const std::size_t at = cells + pick(in_.micro.size() - cells);
    char& c = in_.micro[at];
    if ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'f')) c = "0123456789abcdef"[pick(16)];
  }

  MicroInput in_;
  std::string statement_, body_;
  std::mt19937 random_;
};

}  // namespace
}  // namespace veritope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check_micro_input(veritope::fuzz::MicroInput::decode(data, size));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  using namespace veritope::fuzz;
  if (seed % 32 == 0) return LLVMFuzzerMutate(data, size, max_size);
  MicroMutator mutator(MicroInput::decode(data, size), seed);
  for (unsigned n = 1 + seed / 32 % 3; n > 0; --n) mutator.change();
  MicroInput in = mutator.take();
  if (seed % 32 != 1) make_true(in);
  const std::string bytes = in.encode();
  if (bytes.size() > max_size) return size;
  std::memcpy(data, bytes.data(), bytes.size());
  return bytes.size();
}
