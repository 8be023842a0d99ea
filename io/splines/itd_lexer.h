// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/itd_lexer.h: the tokens of IRIT's .itd: brackets, quoted strings and words; attributes.
#pragma once
#include "io/splines/spline_text_reader.h"

namespace veritope {

class ItdLexer : public SplineTextReader {
 public:
  ItdLexer(const Source& source, const ReadLimits& limits) : SplineTextReader(source, limits) {
    own_tokens_ = "[]\"";
  }

 protected:
  /// Whether this token is next.
  bool at(char c) { return peek() == std::string_view(&c, 1); }
  bool take_bracket(char c);
  bool take_word(std::string& word);
  /// Reads '[' and the keyword.
  bool open_keyword(const char* keyword);
  /// Moves from the string's first quote to after its last.
  bool skip_string();
  /// Moves from after an opening bracket to after its closing one.
  bool skip_brackets();
  /// Reads from after the attribute's '[' to after its ']'; keeps the text between them.
  bool read_attribute(std::vector<std::string>& into);
  /// Reads all [...] up to one that is a part of a spline.
  bool read_attributes(std::vector<std::string>& into);
  /// Mentions attributes that the model has no place for.
  void drop_attributes(const std::vector<std::string>& inner);

 private:
  void count_splines_in(std::string_view attribute);
};

}  // namespace veritope
