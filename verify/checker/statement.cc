// SPDX-License-Identifier: Apache-2.0 OR MIT
// statement.cc: conditions S1 to S4 of docs/certificates/mesh.md and star-box.md.
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

bool only(const std::string& s, const char* allowed) {
  return !s.empty() && s.find_first_not_of(allowed) == s.npos;
}
bool is_hash(const std::string& s) { return s.size() == 64 && only(s, "0123456789abcdef"); }
bool is_natural(const std::string& s) { return only(s, "0123456789") && (s[0] != '0' || s == "0"); }

// One flat JSON object without blanks outside strings. The line feed behind it ends every loop.
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

template <class T>
std::string keys(const std::map<std::string, T>& values) {  // a map is sorted by its keys
  std::string r;
  for (const auto& value : values) r += ' ' + value.first;
  return r;
}

struct Keys {  // what a claim's statement has beside what all have, sorted
  const char *claim, *text, *number, *flag;
};
const Keys kClaims[] = {
    {"mesh-valid-1",
     " body_sha256 certificate claim reading_rule subject_format subject_sha256 tool volume",
     " bodies edges faces genus shells subject_bytes vertices", " as_indexed"},
    {"mesh-invalid-1",
     " body_sha256 certificate claim reading_rule rules subject_format subject_sha256 tool",
     " subject_bytes", " as_indexed"},
    {"star-box-1", " body_sha256 certificate claim subject_format subject_sha256 tool",
     " bodies boxes edges flipped genus patches shells subject_bytes vertices", ""}};

void check_form(Statement s) {
  const Keys* c = kClaims;
  while (c != kClaims + 3 && s.text["claim"] != c->claim) ++c;
  require(c != kClaims + 3, "S1", "unknown claim");
  const bool valid = c == kClaims, is_mesh = c < kClaims + 2;
  require(keys(s.text) == c->text && keys(s.number) == c->number && keys(s.flag) == c->flag, "S1",
          "not exactly the keys of the claim, each with a value of its kind");
  require(s.text["certificate"] == "veritope-certificate-1", "S1", "unknown kind of certificate");
  require(s.text["tool"].size() <= 200, "S1", "tool is longer than 200 bytes");
  require(is_hash(s.text["subject_sha256"]) && is_hash(s.text["body_sha256"]), "S1", "no hash");
  const std::string format = s.text["subject_format"], volume = s.text["volume"];
  require(is_mesh ? format == "stl" || format == "obj" || format == "ply" || format == "off"
                  : format == "vjson" || format == "itd",
          "S1", "unknown subject_format");
  const size_t slash = std::min(volume.find('/'), volume.size());
  require(!valid || (is_natural(volume.substr(0, slash)) && slash < volume.size() &&
                     is_natural(volume.substr(slash + 1)) && volume[slash + 1] != '0'),
          "S1", "volume is not p/q");
  std::string rules = s.text["rules"] + ' ';
  for (char c = '1'; c <= '9'; ++c)
    if (rules.compare(0, 3, std::string("M") + c + ' ') == 0) rules.erase(0, 3);
  require(valid || !is_mesh || rules.empty(), "S1", "rules is no ascending list of M1 to M9");
}

}  // namespace

Statement read_statement(const std::string& certificate, const std::string& model, Body* body) {
  const size_t size = std::min(certificate.find('\n'), certificate.size());
  require(size < certificate.size() && size <= 65536, "S1", "no line feed within 64 KiB");
  for (size_t i = 0; i < size; ++i)
    require(certificate[i] >= 32 && certificate[i] <= 126, "S1", "no printable ASCII: byte", i);
  Statement s = Json{certificate.data()}.object();
  check_form(s);
  require(s.text["claim"] == "star-box-1" || s.text["reading_rule"] == kReadingRule, "S2",
          "another reading rule");
  require(s.number["subject_bytes"] == model.size(), "S3", "the model's size is", model.size());
  require(s.text["subject_sha256"] == sha256(model.data(), model.size()), "S3", "another model");
  const uint8_t* const begin = reinterpret_cast<const uint8_t*>(certificate.data());
  *body = Body{begin + size + 1, begin + certificate.size()};
  require(s.text["body_sha256"] == sha256(body->p, body->left()), "S4", "another body");
  return s;
}
