// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/itd_lexer.h"

namespace veritope {

bool ItdLexer::take_bracket(char c) {
  if (!at(c)) return fail_expected(quoted(std::string_view(&c, 1)));
  ++p_;
  return true;
}

bool ItdLexer::take_word(std::string& word) {
  const std::string_view token = peek();
  if (token.empty() || own_tokens_.find(token[0]) != own_tokens_.npos)
    return fail_expected("a word");
  word = std::string(token);
  p_ += token.size();
  return true;
}

bool ItdLexer::open_keyword(const char* keyword) {
  if (!take_bracket('[')) return false;
  if (peek() != keyword) return fail_expected(keyword);
  p_ += std::string_view(keyword).size();
  return true;
}

bool ItdLexer::skip_string() {
  const char* const start = p_++;
  for (; p_ < source_.end && *p_ != '"'; ++p_)
    if (*p_ == '\\' && p_ + 1 < source_.end) ++p_;
  if (p_ >= source_.end) return fail(start, Code::kTruncated, "a string does not end");
  ++p_;
  return true;
}

bool ItdLexer::skip_brackets() {
  const char* const start = p_;
  for (std::uint64_t depth = 1; depth > 0;) {
    while (p_ < source_.end && *p_ != '[' && *p_ != ']' && *p_ != '"') ++p_;
    if (p_ >= source_.end) return fail(start, Code::kTruncated, "a '[' is not closed");
    if (*p_ == '"') {
      if (!skip_string()) return false;
      continue;
    }
    depth += *p_ == '[' ? 1u : ~std::uint64_t{0};
    ++p_;
  }
  return true;
}

// Starts after the attribute's '['.
bool ItdLexer::read_attribute(std::vector<std::string>& into) {
  skip();
  const char* const start = p_;
  if (!skip_brackets()) return false;
  const char* last = p_ - 1;
  while (last > start && has_class(last[-1], kTokenEnd)) --last;
  into.push_back(to_utf8({start, static_cast<std::size_t>(last - start)}));
  count_splines_in(into.back());
  return true;
}

// Attributes that hold whole objects (animations, textures) stay text, but are mentioned.
void ItdLexer::count_splines_in(std::string_view attribute) {
  constexpr std::pair<std::string_view, const char*> kWords[] = {
      {"CURVE ", "curves within attributes"},
      {"SURFACE ", "surfaces within attributes"},
      {"TRIVAR ", "volumes within attributes"}};
  for (std::size_t at = attribute.find('['); at != attribute.npos; at = attribute.find('[', at + 1))
    for (const auto& [word, what] : kWords)
      if (attribute.substr(at + 1).starts_with(word)) leave_out(what, "kept as text", false);
}

bool ItdLexer::read_attributes(std::vector<std::string>& into) {
  while (at('[')) {
    const char* const open = p_++;
    const std::string_view word = peek();
    if (word == "KV" || word == "KVP" || word == "SURFACE" || word == "TRIMCRV" ||
        word == "CURVE") {
      p_ = open;
      return true;
    }
    if (!read_attribute(into)) return false;
  }
  return true;
}

void ItdLexer::drop_attributes(const std::vector<std::string>& inner) {
  if (!inner.empty())
    leave_out("attributes within trimmed surfaces and models", "", false, inner.size());
}

}  // namespace veritope
