// SPDX-License-Identifier: Apache-2.0 OR MIT
// checker.h: what all parts share. The pages: docs/certificates.
#pragma once
#include <cstdint>
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

struct Model {
  std::vector<int64_t> key;   // three coordinates a vertex, as keys (numbers.h)
  std::vector<uint32_t> tri;  // three vertex ids a triangle; at most 2^30 triangles
  uint32_t vertices() const { return uint32_t(key.size() / 3); }
  uint32_t faces() const { return uint32_t(tri.size() / 3); }
};
Model read_model(std::string file, const std::string& format, bool as_indexed);

struct Statement {
  std::map<std::string, std::string> text;
  std::map<std::string, uint64_t> number;
  std::map<std::string, bool> flag;
};
struct Body {  // the bytes behind the statement that are still to be read
  const uint8_t *p, *end;
  uint64_t left() const { return uint64_t(end - p); }
  uint64_t natural(unsigned bytes) {  // little-endian
    require(left() >= bytes, "B1", "the body ends too early");
    uint64_t v = 0;
    for (unsigned i = 0; i < bytes; ++i) v |= uint64_t(*p++) << 8 * i;
    return v;
  }
  uint64_t count(uint64_t bytes_each) {  // of elements of at least that size behind the count
    const uint64_t n = natural(4);
    require(n <= left() / bytes_each, "B1", "too few bytes for the count", n);
    return n;
  }
};
struct Work {  // what section 5 of mesh.md counts and bounds; units: 1000 (F + size of the body)
  uint64_t done, limit;
  Work(const Model& model, const Body& body)
      : done(0), limit(1000 * (model.faces() + body.left())) {}
  void add(uint64_t units) {
    done += units;
    require(done <= limit, "B1", "more work than allowed, units", limit);
  }
};
inline bool is_natural(const std::string& s) {  // in shortest form
  return !s.empty() && s.find_first_not_of("0123456789") == s.npos && (s[0] != '0' || s == "0");
}
void check_form(Statement statement);  // S1, behind its syntax
Statement read_statement(const std::string& certificate, const std::string& model, Body* body);

// The conditions behind S4. The result is what ACCEPT prints behind the claim.
std::string check_mesh_valid(const Statement& statement, const Model& model, const Body& body);
std::string check_mesh_invalid(const Statement& statement, const Model& model, const Body& body);
std::string check_star_box(const Statement& statement, const std::string& model, const Body& body);
std::string check_patch_invalid(const Statement& statement, const std::string& model,
                                const Body& body);
// The one of them that the statement's claim asks for.
std::string check_claim(const Statement& statement, std::string model, const Body& body);
