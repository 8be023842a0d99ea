// SPDX-License-Identifier: LGPL-3.0-or-later
// io/tetrahedra/words.h: a text as words between blanks and line ends, with comments from # to the end of a line.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "robust/rational.h"

namespace veritope {

/// The functions return false, and do nothing, once error() is set.
class Words {
 public:
  Words(const Source& source, const ReadLimits& limits);

  bool is_failed() const { return is_failed_; }
  const Error& error() const { return error_; }
  /// The next word is there; it is at_word().
  bool has_word();
  std::string_view word() const { return {at_, static_cast<std::size_t>(stop_ - at_)}; }
  void skip_word() { at_ = stop_; }
  /// Skips `count` words.
  bool skip_words(std::uint64_t count);
  /// Skips what is left of the line.
  void skip_line();
  /// Whether another word follows in this line.
  bool has_word_in_line();

  bool take_integer(const char* what, std::uint64_t least, std::uint64_t most,
                    std::uint64_t& value);
  bool take_number(const char* what, Rational& value);
  bool take_point(std::array<Rational, 3>& point);

  /// Sets the error, at the current word.
  bool fail(Code code, std::string message);

 private:
  bool need_word(const char* what);

  const Source& source_;
  const ReadLimits& limits_;
  const char *at_, *stop_;
  bool is_failed_ = false;
  Error error_;
};

}  // namespace veritope
