// SPDX-License-Identifier: Apache-2.0 OR MIT
// checker.h: what all claims share. The pages: docs/certificates.
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

struct Refused {  // a file cannot be opened, or the reading rule refuses the model
  std::string why;
};
struct Rejected {  // the certificate fails the condition `id`
  std::string id, why;
};
inline void require(bool holds, const char* id, const char* why) {
  if (!holds) throw Rejected{id, why};
}
inline void require(bool holds, const char* id, const char* why, uint64_t number) {
  if (!holds) throw Rejected{id, why + (' ' + std::to_string(number))};
}

struct Claim;
struct Statement {
  const Claim* claim = nullptr;
  std::map<std::string, std::string> text;
  std::map<std::string, uint64_t> number;
  std::map<std::string, bool> flag;
  std::string answers, solid, solid_name;  // bytes of ANSWERS, or of M and its name, where needed
  std::string model_name;
  std::function<std::string(const std::string& name)> read_file;  // for files that the model names
  bool needs_answers() const { return text.count("answers_sha256") != 0; }
  bool needs_solid() const { return text.count("model_sha256") != 0; }
};
struct Body {  // the bytes after the statement that are still to be read
  const uint8_t *p, *end;
  uint64_t left() const { return uint64_t(end - p); }
  bool begins_with(const char* magic) {  // takes four bytes
    bool same = true;
    for (int i = 0; i < 4; ++i) same = natural(1) == uint8_t(magic[i]) && same;
    return same;
  }
  uint64_t natural(unsigned bytes) {  // little-endian
    require(left() >= bytes, "B1", "the body ends too early");
    uint64_t v = 0;
    for (unsigned i = 0; i < bytes; ++i) v |= uint64_t(*p++) << 8 * i;
    return v;
  }
  uint64_t varint() {
    uint64_t v = 0, b = 128;
    for (int shift = 0; b >= 128; shift += 7) {
      b = natural(1);
      require((shift == 0 || b != 0) && (shift < 63 || b <= 1), "B1",
              "a varint is not in its shortest form or not below 2^64");
      v |= (b & 127) << shift;
    }
    return v;
  }
  uint64_t count(uint64_t bytes_each) {  // of elements that follow, each at least that large
    const uint64_t n = natural(4);
    require(n <= left() / bytes_each, "B1", "too few bytes for the count", n);
    return n;
  }
};
inline bool is_natural(const std::string& s) {  // in shortest form
  return !s.empty() && s.find_first_not_of("0123456789") == s.npos && (s[0] != '0' || s == "0");
}

struct Claim {                       // a row of the table of claims (claims.cc)
  const char *name, *magic;          // magic: the first four bytes of the body
  const char* formats;               // the model's, separated by commas
  const char *text, *number, *flag;  // the statement's keys by the kind of their values, sorted
  void (*check_values)(const Statement& statement);  // S1, of the claim's own keys; may be null
  // The conditions after S4. The result is what ACCEPT prints after the claim.
  std::string (*check)(const Statement& statement, std::string model, const Body& body);
};
// S1 to S4. The statement's `claim` is one of these rows.
Statement read_statement(const std::vector<Claim>& claims, const std::string& certificate,
                         const std::string& model, Body* body);
