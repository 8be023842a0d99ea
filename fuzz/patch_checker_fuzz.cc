// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/patch_checker_fuzz.cc: gives any spline model and any certificate of a claim about patches or volumes to the C++
// checker, which must not crash or hang, and must not accept two claims about one model that contradict each other.
// What it accepts can be explained, and encoded again. The mutator changes the model's digits, the statement's numbers
// and the body, and then corrects sizes and hashes. Another format of the statement is another model.
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

[[noreturn]] void fail(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::abort();
}

// The facts about a model that follow from a claim about it. The prover chooses the flags: a certificate with flags is
// about another orientation.
enum Fact : unsigned {
  kEmbedded = 1,  // the patches can be oriented and are mapped injectively
  kSolid = 2,     // and as they are they bound a solid
  kReversed = 4,  // as they are they bound none, though they are closed and oriented
  kCrossing = 8,  // the map is not injective
  kSide = 16,     // a border that is passed wrongly, or twice
  kOneHand = 32,  // no volume is folded
  kFolded = 64    // one is
};
unsigned facts(const std::string& statement) {
  const std::string claim = get(statement, "claim");
  if (claim == "patch-invalid-1")
    return get(statement, "finding") == "crossing" ? kCrossing : kSide;
  if (claim == "patch-invalid-2") return kCrossing;
  if (claim == "volume-folded-1") return kFolded;  // it says nothing about faces
  if (claim == "vmodel-1") return kOneHand;        // faces have another format
  if (claim == "vmodel-invalid-1" || claim == "microstructure-1") return 0;
  if (claim == "star-box-turned-1" || claim == "star-box-turned-2") return kEmbedded | kReversed;
  return get(statement, "flipped") == "0" ? kEmbedded | kSolid : kEmbedded;
}
bool contradict(unsigned all) {
  const auto both = [&](unsigned a, unsigned b) { return (all & a) != 0 && (all & b) != 0; };
  return both(kEmbedded, kCrossing) || both(kSolid | kReversed, kSide) || both(kSolid, kReversed) ||
         both(kOneHand, kFolded);
}
// The numbers of a V-model that do not depend on breaks or boxes. Cells have one orientation, and all equal faces are
// glued, or X would not be embedded.
std::string numbers_of_vmodel(const std::string& statement) {
  std::string all;
  for (const char* key : {"cells", "half_v_surfaces", "v_surfaces", "v_curves", "v_points", "euler",
                          "reversed", "shells", "bodies", "genus"})
    all += get(statement, key) + " ";
  return all;
}

void check(const Input& in) {
  const std::string statement = in.certificate.substr(0, in.certificate.find('\n'));
  const std::span<const unsigned char> bytes(
      reinterpret_cast<const unsigned char*>(in.certificate.data()), in.certificate.size());
  std::string why;
  const bool is_explained = certificate::explain_certificate(bytes, 4, why).has_value();
  const auto decoded = certificate::decode_certificate(bytes, why);
  if (get(statement, "claim").substr(0, 4) == "mesh") return;  // fuzz/checker_fuzz.cc
  const std::string answer = check_in_process(in.model, in.certificate);
  if (answer.substr(0, 4) == "BUG ") fail(answer);
  if (answer.substr(0, 7) != "ACCEPT ") return;
  if (!is_explained) fail(answer + "\nbut it is not explained: " + why);
  if (!std::ranges::equal(decoded->claim->encode(decoded->body),
                          bytes.subspan(statement.size() + 1)))
    fail(answer + "\nbut what is decoded is encoded otherwise");
  static std::map<std::string, unsigned>* const known = new std::map<std::string, unsigned>;
  unsigned& all = (*known)[get(statement, "subject_format") + hash(in.model)];
  all |= facts(statement);
  if (contradict(all))
    fail(answer + "\nbut of this model a claim was accepted that contradicts it");
  if (get(statement, "claim") != "vmodel-1") return;
  static std::map<std::string, std::string>* const numbers = new std::map<std::string, std::string>;
  const std::string& before =
      numbers
          ->emplace(get(statement, "subject_format") + hash(in.model), numbers_of_vmodel(statement))
          .first->second;
  if (before != numbers_of_vmodel(statement))
    fail(answer + "\nbut of this model other numbers were accepted: " + before);
}

class Mutator {
 public:
  Mutator(Input in, unsigned seed) : in_(std::move(in)), random_(seed) {
    const std::size_t line = std::min(in_.certificate.find('\n'), in_.certificate.size());
    statement_ = in_.certificate.substr(0, line);
    body_ = in_.certificate.substr(std::min(line + 1, in_.certificate.size()));
  }
  Input take() {
    in_.certificate = statement_ + "\n" + body_;
    return std::move(in_);
  }
  void change() {
    switch (pick(12)) {
      case 0: change_statement(); break;
      case 1: change_digit(in_.model, random_); break;
      case 2: body_.insert(pick(body_.size() + 1), 1, static_cast<char>(pick(16))); break;
      case 3: body_.erase(pick(body_.size() + 1), 1); break;
      case 4: repeat_part(); break;
      case 5: swap_parts(); break;
      case 6: body_.insert(pick(body_.size() + 1), large_varint()); break;
      default: change_byte(body_);
    }
  }

 private:
  std::size_t pick(std::size_t n) { return random_below(random_, n); }
  void change_byte(std::string& text) {
    if (text.empty()) return;
    char& c = text[pick(text.size())];
    switch (pick(4)) {
      case 0: c = static_cast<char>(pick(8)); break;
      case 1: c = static_cast<char>(c + 2 * static_cast<int>(pick(2)) - 1); break;
      case 2:
        c = static_cast<char>(c + 4 * static_cast<int>(pick(2)) - 2);
        break;  // a zigzag number by one
      default: c = static_cast<char>(c ^ (1 << pick(8)));
    }
  }
  std::string large_varint() {
    std::string out;
    for (std::size_t n = pick(10); n > 0; --n) out += static_cast<char>(128 + pick(128));
    return out + static_cast<char>(1 + pick(127));
  }
  // Repeats a part of the body, whose elements are stored one after the other.
  void repeat_part() {
    if (body_.empty()) return;
    const std::size_t at = pick(body_.size());
    body_.insert(pick(body_.size() + 1), body_.substr(at, 1 + pick(12)));
  }
  void swap_parts() {
    const std::size_t n = 1 + pick(8);
    if (body_.size() < 2 * n) return;
    const std::size_t at = pick(body_.size() - 2 * n + 1);
    std::swap_ranges(body_.begin() + static_cast<std::ptrdiff_t>(at),
                     body_.begin() + static_cast<std::ptrdiff_t>(at + n),
                     body_.begin() + static_cast<std::ptrdiff_t>(at + n));
  }
  void change_statement() {
    static const char* const kNumbers[] = {
        "patches",  "edges",   "vertices", "shells",          "bodies",     "genus",
        "boxes",    "flipped", "winding",  "cells",           "same",       "opposite",
        "entity",   "volumes", "pieces",   "half_v_surfaces", "v_surfaces", "v_curves",
        "v_points", "euler",   "reversed", "singular"};
    static const char* const kFormats[] = {"vjson",       "itd",       "g2",       "mfem",
                                           "vjson-faces", "itd-faces", "g2-faces", "mfem-faces"};
    const std::span<const certificate::Claim> claims = certificate::all_claims();
    switch (pick(5)) {
      case 0: set(statement_, "claim", std::string(claims[pick(claims.size())].name)); break;
      case 1: set(statement_, "finding", pick(2) == 0 ? "side" : "crossing"); break;
      case 2: change_byte(statement_); break;
      case 3: set(statement_, "subject_format", kFormats[pick(std::size(kFormats))]); break;
      default: set(statement_, kNumbers[pick(std::size(kNumbers))], std::to_string(pick(30)));
    }
  }

  Input in_;
  std::string statement_, body_;
  std::mt19937 random_;
};

}  // namespace
}  // namespace veritope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check(veritope::fuzz::Input::decode(data, size));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  using namespace veritope::fuzz;
  if (seed % 32 == 0) return LLVMFuzzerMutate(data, size, max_size);
  Mutator mutator(Input::decode(data, size), seed);
  for (unsigned n = 1 + seed / 32 % 3; n > 0; --n) mutator.change();
  Input in = mutator.take();
  if (seed % 32 != 1) make_hashes_true(in);
  const std::string bytes = in.encode();
  if (bytes.size() > max_size) return size;
  std::memcpy(data, bytes.data(), bytes.size());
  return bytes.size();
}
