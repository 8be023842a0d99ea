// SPDX-License-Identifier: Apache-2.0 OR MIT
// token_reader.h: files of tokens; section 1 of docs/certificates/reading-rule-g2.md and of reading-rule-mfem.md.
#pragma once
#include "star_model.h"

const int64_t kMostInteger = int64_t(1) << 62, kMostCoordinates = 1000;

struct TokenReader {
  TokenReader(const std::string& file, bool comments, size_t* begin);

  // The token at *at_; empty at the end of the file. What is refused was found there.
  const std::string& token() const { return token_; }
  void next();
  bool is_at_end() const { return token_.empty(); }
  bool take_if(const char* word);
  void take(const char* word);
  int64_t value(int64_t least, int64_t most) const;  // of the token, an integer
  // These take the token.
  int64_t integer(int64_t least = -kMostInteger, int64_t most = kMostInteger);
  uint64_t count() { return uint64_t(integer(0, int64_t(text_.size()))); }
  void integers(uint64_t n);  // passes over them
  std::vector<Ratio> decimals(uint64_t n);

  uint64_t bytes() const { return text_.size(); }
  // a b, if the file can hold so many decimals.
  uint64_t product(uint64_t a, uint64_t b) const;

 private:
  const std::string& text_;
  const bool has_comments_;
  size_t& at_;
  std::string token_;
};
