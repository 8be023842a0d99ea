// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/certificate_input.h: a model and a certificate as one input: the size of the model (4 bytes, little-endian), the
// model, the certificate.
#pragma once
#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <utility>

#include "verify/format/sha256.h"

namespace veritope::fuzz {

inline constexpr std::size_t kMaxModel = 1 << 14;

struct Input {
  std::string model, certificate;

  static Input decode(const std::uint8_t* data, std::size_t size) {
    Input in;
    if (size < 4) return in;
    std::size_t n = 0;
    for (int i = 0; i < 4; ++i) n |= std::size_t{data[i]} << (8 * i);
    n = std::min({n, size - 4, kMaxModel});
    in.model.assign(reinterpret_cast<const char*>(data) + 4, n);
    in.certificate.assign(reinterpret_cast<const char*>(data) + 4 + n, size - 4 - n);
    return in;
  }
  std::string encode() const {
    std::string out;
    for (int i = 0; i < 4; ++i) out += static_cast<char>(model.size() >> (8 * i) & 255u);
    return out + model + certificate;
  }
};

inline std::string hash(std::string_view bytes) {
  return to_hex(sha256({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}));
}

// The text after "key": up to the next comma or brace, without quotes.
inline std::pair<std::size_t, std::size_t> value_of(const std::string& statement, const std::string& key) {
  const std::size_t at = statement.find("\"" + key + "\":");
  if (at == statement.npos) return {0, 0};
  std::size_t first = at + key.size() + 3;
  const bool quoted = first < statement.size() && statement[first] == '"';
  first += quoted ? 1 : 0;
  const std::size_t last = statement.find_first_of(quoted ? "\"" : ",}", first);
  return last == statement.npos ? std::pair<std::size_t, std::size_t>{0, 0} : std::pair{first, last};
}
inline std::string get(const std::string& statement, const std::string& key) {
  const auto [first, last] = value_of(statement, key);
  return statement.substr(first, last - first);
}
inline void set(std::string& statement, const std::string& key, const std::string& value) {
  const auto [first, last] = value_of(statement, key);
  if (last != 0) statement.replace(first, last - first, value);
}

inline std::size_t random_below(std::mt19937& random, std::size_t n) { return n == 0 ? 0 : random() % n; }
// Changes the first digit found in twenty tries.
inline void change_digit(std::string& text, std::mt19937& random) {
  for (int tries = 0; tries < 20 && !text.empty(); ++tries) {
    char& c = text[random_below(random, text.size())];
    if (c < '0' || c > '9') continue;
    c = static_cast<char>('0' + random_below(random, 10));
    return;
  }
}

inline void make_hashes_true(Input& in) {
  const std::size_t line = in.certificate.find('\n');
  if (line == in.certificate.npos) return;
  std::string statement = in.certificate.substr(0, line);
  const std::string body = in.certificate.substr(line + 1);
  set(statement, "subject_sha256", hash(in.model));
  set(statement, "subject_bytes", std::to_string(in.model.size()));
  set(statement, "body_sha256", hash(body));
  in.certificate = statement + "\n" + body;
}

}  // namespace veritope::fuzz
