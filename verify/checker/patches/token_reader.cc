// SPDX-License-Identifier: Apache-2.0 OR MIT
// token_reader.cc: files of tokens; section 1 of docs/certificates/reading-rule-g2.md and of reading-rule-mfem.md.
#include "token_reader.h"

namespace {

const char kBlanks[] = " \t\v\f\n\r";
const size_t kMostShown = 40;  // bytes of a token in a message

}  // namespace

std::string line_and_token(const std::string& file, size_t at) {
  const auto end = file.begin() + int64_t(std::min(at, file.size()));
  const auto line =
      1 + std::max(std::count(file.begin(), end, '\n'), std::count(file.begin(), end, '\r'));
  const size_t last = std::min(file.find_first_of(std::string(kBlanks) + '#', at), at + kMostShown);
  return "line " + std::to_string(line) + ", at '" +
         (at < file.size() ? file.substr(at, last - at) : std::string()) + "': ";
}

TokenReader::TokenReader(const std::string& file, bool comments, size_t* begin)
    : text_(file), has_comments_(comments), at_(*begin) {
  next();
}

void TokenReader::next() {
  at_ = std::min(text_.find_first_not_of(kBlanks, at_ + token_.size()), text_.size());
  while (has_comments_ && at_ < text_.size() && text_[at_] == '#') {
    at_ = std::min(text_.find_first_of("\n\r", at_), text_.size());
    at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size());
  }
  const size_t end = text_.find_first_of(has_comments_ ? " \t\v\f\n\r#" : kBlanks, at_);
  token_ = text_.substr(at_, std::min(end, text_.size()) - at_);
}

bool TokenReader::take_if(const char* word) {
  const bool is = token_ == word;
  if (is) next();
  return is;
}
void TokenReader::take(const char* word) {
  if (!take_if(word)) throw Refused{std::string("expected ") + word};
}

int64_t TokenReader::value(int64_t least, int64_t most) const {
  const size_t sign = !token_.empty() && (token_[0] == '+' || token_[0] == '-');
  expect(token_.size() > sign && token_.find_first_not_of("0123456789", sign) == token_.npos,
         "expected an integer");
  uint64_t v = 0;  // not above 2^62 + 1
  for (size_t i = sign; i < token_.size() && v <= uint64_t(kMostInteger); ++i)
    v = std::min<u128>(u128(10) * v + u128(token_[i] - '0'), u128(kMostInteger) + 1);
  const int64_t signed_v = token_[0] == '-' ? -int64_t(v) : int64_t(v);
  if (signed_v < least || signed_v > most)
    throw Refused{"expected an integer from " + std::to_string(least) + " to " +
                  std::to_string(most)};
  return signed_v;
}
int64_t TokenReader::integer(int64_t least, int64_t most) {
  const int64_t v = value(least, most);
  next();
  return v;
}
void TokenReader::integers(uint64_t n) {
  for (; n > 0; --n) integer();
}

std::vector<Ratio> TokenReader::decimals(uint64_t n) {
  std::vector<Ratio> r;
  for (; n > 0; --n) {
    r.push_back(read_decimal(token_));
    next();
  }
  return r;
}

uint64_t TokenReader::product(uint64_t a, uint64_t b) const {
  expect(b == 0 || a <= bytes() / b, "more control points than the file can hold");
  return a * b;
}
