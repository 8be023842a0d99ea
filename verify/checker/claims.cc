// SPDX-License-Identifier: Apache-2.0 OR MIT
// claims.cc: what the claims' statements have (S1), and who checks the rest.
#include "checker.h"
#include "numbers.h"

namespace {

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
     " bodies boxes edges flipped genus patches shells subject_bytes vertices", ""},
    {"star-box-turned-1", " body_sha256 certificate claim subject_format subject_sha256 tool",
     " bodies boxes edges flipped genus patches shells subject_bytes vertices winding", ""},
    {"collar-1", " body_sha256 certificate claim subject_format subject_sha256 tool",
     " bodies boxes cells edges flipped genus patches shells subject_bytes vertices", ""},
    {"patch-invalid-1", " body_sha256 certificate claim finding subject_format subject_sha256 tool",
     " flipped opposite patches same subject_bytes", ""}};
const Keys* const kEnd = kClaims + sizeof kClaims / sizeof *kClaims;

}  // namespace

void check_form(Statement s) {
  const Keys* c = kClaims;
  while (c != kEnd && s.text["claim"] != c->claim) ++c;
  require(c != kEnd, "S1", "unknown claim");
  const bool valid = c == kClaims, is_mesh = c < kClaims + 2;
  require(keys(s.text) == c->text && keys(s.number) == c->number && keys(s.flag) == c->flag, "S1",
          "not exactly the keys of the claim, each with a value of its kind");
  require(s.text["certificate"] == "veritope-certificate-1", "S1", "unknown kind of certificate");
  require(s.text["tool"].size() <= 200, "S1", "tool is longer than 200 bytes");
  require(is_hash(s.text["subject_sha256"]) && is_hash(s.text["body_sha256"]), "S1", "no hash");
  const std::string format = s.text["subject_format"], volume = s.text["volume"];
  require(is_mesh ? format == "stl" || format == "obj" || format == "ply" || format == "off"
                  : format == "vjson",
          "S1", "unknown subject_format");
  const std::string finding = s.text["finding"];
  require(finding.empty() == (c + 1 != kEnd) &&
              (finding.empty() || finding == "crossing" || finding == "side"),
          "S1", "unknown finding");
  const size_t slash = std::min(volume.find('/'), volume.size());
  require(!valid || (is_natural(volume.substr(0, slash)) && slash < volume.size() &&
                     is_natural(volume.substr(slash + 1)) && volume[slash + 1] != '0'),
          "S1", "volume is not p/q");
  std::string rules = s.text["rules"] + ' ';
  for (char c = '1'; c <= '9'; ++c)
    if (rules.compare(0, 3, std::string("M") + c + ' ') == 0) rules.erase(0, 3);
  require(valid || !is_mesh || rules.empty(), "S1", "rules is no ascending list of M1 to M9");
}

std::string check_claim(const Statement& s, std::string model, const Body& body) {
  const std::string &claim = s.text.at("claim"), &format = s.text.at("subject_format");
  if (claim == "patch-invalid-1") return check_patch_invalid(s, model, body);
  if (format == "vjson") return check_star_box(s, model, body);
  const Model mesh = read_model(std::move(model), format, s.flag.at("as_indexed"));
  return (claim == "mesh-valid-1" ? check_mesh_valid : check_mesh_invalid)(s, mesh, body);
}
