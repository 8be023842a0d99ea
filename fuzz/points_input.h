// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/points_input.h: a model, an answers file and a certificate of it as one input: the size of the model and that of
// the answers (4 bytes each, little-endian), the model, the answers, the certificate. The mutator changes each of them,
// and then corrects the statement's sizes, hashes and numbers of lines.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <utility>

#include "fuzz/certificate_input.h"
#include "io/base/exact_number.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace veritope::fuzz {

struct PointsInput : Input {
  std::string answers;

  static PointsInput decode(const std::uint8_t* data, std::size_t size) {
    PointsInput in;
    if (size < 8) return in;
    std::size_t n[2] = {0, 0};
    for (std::size_t i = 0; i < 8; ++i) n[i / 4] |= std::size_t{data[i]} << (8 * (i % 4));
    const char* const text = reinterpret_cast<const char*>(data) + 8;
    n[0] = std::min({n[0], size - 8, kMaxModel});
    n[1] = std::min({n[1], size - 8 - n[0], kMaxModel});
    in.model.assign(text, n[0]);
    in.answers.assign(text + n[0], n[1]);
    in.certificate.assign(text + n[0] + n[1], size - 8 - n[0] - n[1]);
    return in;
  }
  std::string encode() const {
    std::string out;
    for (const std::size_t n : {model.size(), answers.size()})
      for (int i = 0; i < 4; ++i) out += static_cast<char>(n >> (8 * i) & 255u);
    return out + model + answers + certificate;
  }
};

using Words = std::array<std::string, 6>;

inline Words words_of(const std::string& line) {
  std::istringstream words(line);
  Words word;
  for (std::string& w : word) words >> w;
  return word;
}

// False if the kernel does not read a coordinate.
inline bool read_point(const Words& word, bool nearest, std::array<Rational, 3>& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    const ReadLimits limits{.max_digits = 4096};
    double rounded = 0;
    const bool is_decimal = word[k].find_first_of("/xX") == std::string::npos;
    if (nearest && is_decimal) {
      if (DecimalReader({.max_digits = 4096, .max_exponent = ~0u}).read_slowly(word[k], rounded) !=
          DecimalFault::kNone)
        return false;
      p[k] = Rational::from_double(rounded);
    } else if (read_exact_number(word[k], limits, p[k]) != DecimalFault::kNone) {
      return false;
    }
  }
  return true;
}

class PointsMutator {
 public:
  PointsMutator(PointsInput in, unsigned seed) : in_(std::move(in)), random_(seed) {}
  PointsInput take() { return std::move(in_); }

  void change() {
    const std::size_t line = std::min(in_.certificate.find('\n'), in_.certificate.size());
    switch (pick(10)) {
      case 0: change_statement(line); break;
      case 1:
      case 2: change_byte(in_.certificate, line); break;
      case 3: change_byte(in_.model, in_.model.size() / 4); break;
      case 4: change_digit(in_.model, random_); break;
      case 5: change_byte(in_.answers, 0); break;
      case 6: change_digit(in_.answers, random_); break;
      case 7: replace_word(); break;
      case 8: in_.certificate.insert(body_place(line), 1, static_cast<char>(pick(8))); break;
      default:
        if (in_.certificate.size() > line + 1) in_.certificate.erase(body_place(line), 1);
    }
  }
  void correct() {
    make_hashes_true(in_);
    std::size_t counts[3] = {0, 0, 0};
    std::istringstream lines(in_.answers);
    for (std::string line; std::getline(lines, line); ++counts[0]) {
      counts[1] += line.find(" on ") != std::string::npos;
      counts[2] += line.find(" undecided ") != std::string::npos;
    }
    const std::size_t end = std::min(in_.certificate.find('\n'), in_.certificate.size());
    std::string statement = in_.certificate.substr(0, end);
    set(statement, "answers_sha256", hash(in_.answers));
    set(statement, "answers_bytes", std::to_string(in_.answers.size()));
    set(statement, "points", std::to_string(counts[0]));
    set(statement, "on", std::to_string(counts[1]));
    set(statement, "undecided", std::to_string(counts[2]));
    in_.certificate = statement + in_.certificate.substr(end);
  }

 private:
  std::size_t pick(std::size_t n) { return random_below(random_, n); }
  std::size_t body_place(std::size_t line) {
    const std::size_t first = std::min(line + 1, in_.certificate.size());
    return first + pick(in_.certificate.size() - first);
  }
  void change_byte(std::string& text, std::size_t from) {
    if (from >= text.size()) return;
    char& c = text[from + pick(text.size() - from)];
    switch (pick(3)) {
      case 0: c = static_cast<char>(pick(128)); break;
      case 1: c = static_cast<char>(c + (pick(2) == 0 ? 1 : -1)); break;
      default: c = static_cast<char>(c ^ (1 << pick(8)));
    }
  }
  // Puts a word where another one is, or a copy of a line at the end.
  void replace_word() {
    static const char* const kWords[] = {
        "in",   "out",       "on",   "-",      "undecided", "0",    "1",
        "-1",   "2",         "1/3",  "-2/7",   "0.5",       ".1",   "1e4",
        "1e-9", "0x1p-1000", "4e-9", "0x1p99", "0x1.8p0",   "-1.5", "1e-4000"};
    std::string& text = in_.answers;
    if (text.empty()) return;
    const std::size_t at = pick(text.size());
    const std::size_t begin =
        text.find_last_of(" \n", at) == text.npos ? 0 : text.find_last_of(" \n", at) + 1;
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    if (pick(4) != 0) {
      text.replace(begin, end - begin, kWords[pick(std::size(kWords))]);
    } else {
      const std::size_t first = text.find_last_of('\n', at == 0 ? 0 : at - 1);
      const std::size_t line = first == text.npos ? 0 : first + 1;
      text += text.substr(line, text.find('\n', line) - line) + "\n";
      in_.certificate += static_cast<char>(pick(6));
      if (const std::size_t body = in_.certificate.find('\n') + 13; body < in_.certificate.size())
        ++in_.certificate[body];
    }
  }
  void change_statement(std::size_t line) {
    std::string statement = in_.certificate.substr(0, line);
    const std::string rest = in_.certificate.substr(line);
    static const char* const kFlags[] = {"as_indexed", "winding"};
    switch (pick(4)) {
      case 0: set(statement, kFlags[pick(2)], pick(2) == 0 ? "true" : "false"); break;
      case 1: set(statement, "decimals", pick(2) == 0 ? "nearest" : "exact"); break;
      case 2: {
        static const char* const kFormats[] = {
            "stl",  "obj",         "ply",       "off",      "vjson",      "itd",  "g2",
            "mfem", "vjson-faces", "itd-faces", "g2-faces", "mfem-faces", "chain"};
        set(statement, "subject_format", kFormats[pick(std::size(kFormats))]);
        break;
      }
      default: change_byte(statement, 0);
    }
    in_.certificate = statement + rest;
  }

  PointsInput in_;
  std::mt19937 random_;
};

inline std::size_t mutate_points(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                 unsigned seed) {
  if (seed % 16 == 0) return LLVMFuzzerMutate(data, size, max_size);
  PointsMutator mutator(PointsInput::decode(data, size), seed);
  for (unsigned n = 1 + seed / 16 % 3; n > 0; --n) mutator.change();
  if (seed % 16 != 1) mutator.correct();
  const std::string bytes = mutator.take().encode();
  if (bytes.size() > max_size) return size;
  std::memcpy(data, bytes.data(), bytes.size());
  return bytes.size();
}

}  // namespace veritope::fuzz
