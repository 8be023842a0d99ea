// SPDX-License-Identifier: Apache-2.0 OR MIT
// statement.cc: conditions S1 to S4 of docs/certificates/mesh.md; the claim's row has what differs by claim.
#include "checker.h"
#include "sha256.h"

namespace {

const char kReadingRule[] =
    "Reading rule v1: vertices with equal coordinates are one vertex, -0 equals +0, unless "
    "as_indexed is true (STL: always one); vertex ids count first occurrences in file order; "
    "polygons are fans from their first vertex; decimals round to the nearest binary64, ties to "
    "even; binary floats are widened exactly; normals, colours, texture, lines, groups and "
    "attribute bytes are ignored; unreferenced vertices are ignored; all solid blocks of an ASCII "
    "STL are one model; the file is refused unless it yields at least one triangle, finite "
    "coordinates and indices in range.";

// One flat JSON object without blanks outside strings. The line feed after it ends every loop.
struct Json {
  const char* p;

  void take(char c) {
    require(*p == c, "S1", "the statement is no flat JSON object");
    ++p;
  }
  std::string string() {
    take('"');
    const char* const b = p;
    while (*p != '"' && *p != '\\' && *p != '\n') ++p;
    take('"');
    return std::string(b, p - 1);
  }
  void value(const std::string& key, Statement* s) {
    const char* const b = p;
    while (*p != '"' && *p != ',' && *p != '}' && *p != '\n') ++p;
    const std::string word(b, p), zeros(20 - std::min<size_t>(20, word.size()), '0');
    if (word.empty()) {
      s->text[key] = string();
    } else if (word == "true" || word == "false") {
      s->flag[key] = word == "true";
    } else {
      require(is_natural(word) && word.size() <= 20 && zeros + word <= "18446744073709551615", "S1",
              "a value is no string, boolean or natural number below 2^64");
      s->number[key] = std::stoull(word);
    }
  }
  Statement object() {
    Statement s;
    size_t n = 0;
    do {
      take(n == 0 ? '{' : ',');
      const std::string key = string();
      take(':');
      value(key, &s);
      require(++n == s.text.size() + s.number.size() + s.flag.size(), "S1", "a key occurs twice");
    } while (*p == ',');
    take('}');
    take('\n');
    return s;
  }
};

bool only(const std::string& s, const char* allowed) {
  return !s.empty() && s.find_first_not_of(allowed) == s.npos;
}
bool is_hash(const std::string& s) { return s.size() == 64 && only(s, "0123456789abcdef"); }

template <class T>
std::string keys(const std::map<std::string, T>& values) {  // a map is sorted by its keys
  std::string r;
  for (const auto& value : values) r += ' ' + value.first;
  return r;
}

// Whether the word is one of those that commas separate.
bool is_among(const std::string& word, const std::string& words) {
  return word.find(',') == word.npos && (',' + words + ',').find(',' + word + ',') != words.npos;
}

// S1, except its syntax.
void check_form(const std::vector<Claim>& claims, Statement* s) {
  for (const Claim& row : claims)
    if (s->text["claim"] == row.name) s->claim = &row;
  const Claim* const c = s->claim;
  require(c != nullptr, "S1", "unknown claim");
  require(keys(s->text) == c->text && keys(s->number) == c->number && keys(s->flag) == c->flag, "S1",
          "not exactly the keys of the claim, each with a value of its kind");
  require(s->text["certificate"] == "veritope-certificate-1", "S1", "unknown kind of certificate");
  require(s->text["tool"].size() <= 200, "S1", "tool is longer than 200 bytes");
  require(is_hash(s->text["subject_sha256"]) && is_hash(s->text["body_sha256"]), "S1", "no hash");
  require(!s->needs_answers() || is_hash(s->text["answers_sha256"]), "S1", "no hash of the answers");
  require(is_among(s->text["subject_format"], c->formats), "S1", "unknown subject_format");
  if (c->check_values != nullptr) c->check_values(*s);
}

}  // namespace

Statement read_statement(const std::vector<Claim>& claims, const std::string& certificate,
                         const std::string& model, Body* body) {
  const size_t size = std::min(certificate.find('\n'), certificate.size());
  require(size < certificate.size() && size <= 65536, "S1", "no line feed within 64 KiB");
  for (size_t i = 0; i < size; ++i)
    require(certificate[i] >= 32 && certificate[i] <= 126, "S1", "no printable ASCII: byte", i);
  Statement s = Json{certificate.data()}.object();
  check_form(claims, &s);
  require(s.text.count("reading_rule") == 0 || s.text["reading_rule"] == kReadingRule, "S2",
          "another reading rule");
  require(s.number["subject_bytes"] == model.size(), "S3", "the model's size is", model.size());
  require(s.text["subject_sha256"] == sha256(model.data(), model.size()), "S3", "another model");
  const uint8_t* const begin = reinterpret_cast<const uint8_t*>(certificate.data());
  *body = Body{begin + size + 1, begin + certificate.size()};
  require(s.text["body_sha256"] == sha256(body->p, body->left()), "S4", "another body");
  return s;
}
