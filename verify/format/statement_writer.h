// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/statement_writer.h: the first line of a certificate. Internal to verify/format.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "verify/format/mesh_certificate.h"

namespace veritope::certificate::internal {

/// One flat JSON object; the values hold no character that needs an escape.
class StatementWriter {
 public:
  void text(std::string_view key, std::string_view value) {
    open(key);
    line_ += '"';
    line_ += value;
    line_ += '"';
  }
  void number(std::string_view key, std::uint64_t value) {
    open(key);
    line_ += std::to_string(value);
  }
  void boolean(std::string_view key, bool value) {
    open(key);
    line_ += value ? "true" : "false";
  }
  std::string take() { return line_ + "}"; }

 private:
  void open(std::string_view key) {
    line_ += line_.empty() ? "{\"" : ",\"";
    line_ += key;
    line_ += "\":";
  }
  std::string line_;
};

/// The keys with which every statement begins.
inline void state_subject(StatementWriter& w, const Subject& s, std::string_view claim) {
  w.text("certificate", kFormatName);
  w.text("tool", s.tool);
  w.text("claim", claim);
  w.text("subject_sha256", s.sha256);
  w.number("subject_bytes", s.bytes);
  w.text("subject_format", s.format);
}

/// Statement, line feed, body.
inline Bytes join(const std::string& statement, const Bytes& body) {
  Bytes out;
  out.reserve(statement.size() + 1 + body.size());
  out.insert(out.end(), statement.begin(), statement.end());
  out.push_back('\n');
  out.insert(out.end(), body.begin(), body.end());
  return out;
}

}  // namespace veritope::certificate::internal
