// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/interval/itf1788_reader.h: the statements of an .itl file of the ITF1788 collection.
#pragma once
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "interval/decorated.h"

namespace veritope::itf1788 {

struct Word {
  std::string text;
};
struct Text {
  std::string text;
};
using Numbers = std::vector<double>;
using Value = std::variant<Interval, DecoratedInterval, double, Word, Text, Numbers>;

struct Statement {
  std::string source;  ///< blanks made single, without the semicolon
  std::string operation;
  std::vector<Value> operands, results;
  Signal signal = Signal::kNone;
  bool unknown_signal = false;
};

// Comments become blanks; strings are kept.
inline std::string without_comments(const std::string& text) {
  std::string out;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!quoted && text.compare(i, 2, "//") == 0) {
      while (i < text.size() && text[i] != '\n') ++i;
      out += '\n';
    } else if (!quoted && text.compare(i, 2, "/*") == 0) {
      i = std::min(text.find("*/", i + 2), text.size() - 2) + 1;
      out += ' ';
    } else {
      if (text[i] == '"') quoted = !quoted;
      out += text[i];
    }
  }
  return out;
}

inline std::vector<std::string> tokens_of(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',') {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    if (c == '"') {
      end = text.find('"', i + 1) + 1;
    } else if (c == '[') {
      end = text.find(']', i) + 1;
      if (end < text.size() && text[end] == '_') end += 4;
    } else if (c != '{' && c != '}' && c != ';' && c != '=') {
      end = std::min(text.find_first_of(" \t\r\n,;={}", i), text.size());
    }
    out.push_back(text.substr(i, end - i));
    i = end;
  }
  return out;
}

inline Decoration decoration_named(const std::string& name) {
  return name == "com"   ? Decoration::kCom
         : name == "dac" ? Decoration::kDac
         : name == "def" ? Decoration::kDef
         : name == "trv" ? Decoration::kTrv
                         : Decoration::kIll;
}

// The files write numbers that are binary64 already, or mean the nearest one.
inline double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }
inline bool is_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return end != text.c_str() && *end == '\0';
}

inline Value interval_value(const std::string& token) {
  const std::size_t close = token.find(']');
  std::string body = token.substr(1, close - 1);
  std::erase_if(body, [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; });
  if (body == "nai") return DecoratedInterval::nai();
  Interval bare;
  const std::size_t comma = body.find(',');
  if (body == "empty") {
    bare = Interval::empty();
  } else if (body == "entire") {
    bare = Interval::entire();
  } else {
    const std::string lo = body.substr(0, comma);
    bare = Interval::from_bounds(number(lo),
                                 number(comma == std::string::npos ? lo : body.substr(comma + 1)));
  }
  if (close + 1 == token.size()) return bare;
  return DecoratedInterval(bare, decoration_named(token.substr(close + 2)));
}

inline std::vector<Value> values_of(const std::vector<std::string>& tokens, std::size_t begin,
                                    std::size_t end) {
  std::vector<Value> out;
  for (std::size_t i = begin; i < end; ++i) {
    const std::string& t = tokens[i];
    if (t == "{") {
      Numbers list;
      for (++i; i < end && tokens[i] != "}"; ++i) list.push_back(number(tokens[i]));
      out.emplace_back(list);
    } else if (t.front() == '[') {
      out.push_back(interval_value(t));
    } else if (t.front() == '"') {
      out.emplace_back(Text{t.substr(1, t.size() - 2)});
    } else if (is_number(t)) {
      out.emplace_back(number(t));
    } else {
      out.emplace_back(Word{t});
    }
  }
  return out;
}

inline Statement statement_of(std::vector<std::string> tokens) {
  Statement out;
  for (const std::string& t : tokens) out.source += (out.source.empty() ? "" : " ") + t;
  out.operation = tokens.front();
  if (tokens.size() > 2 && tokens[tokens.size() - 2] == "signal") {
    out.signal = tokens.back() == "UndefinedOperation" ? Signal::kUndefinedOperation
                 : tokens.back() == "IntvlPartOfNaI"   ? Signal::kIntervalPartOfNai
                                                       : Signal::kNone;
    out.unknown_signal = out.signal == Signal::kNone;
    tokens.resize(tokens.size() - 2);
  }
  std::size_t equals = 0;
  while (equals < tokens.size() && tokens[equals] != "=") ++equals;
  out.operands = values_of(tokens, 1, equals);
  out.results = values_of(tokens, equals + 1, tokens.size());
  return out;
}

/// In the order of the file. REQUIRES that the file can be read.
inline std::vector<Statement> read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  std::vector<Statement> out;
  std::vector<std::string> current;
  for (const std::string& token : tokens_of(without_comments(text.str()))) {
    const bool in_testcase = !current.empty() && current.front() == "testcase";
    if (token == ";") {
      if (!current.empty()) out.push_back(statement_of(current));
      current.clear();
    } else if (token == "{" && in_testcase) {
      current.clear();
    } else if (token == "}" && current.empty()) {
      continue;
    } else {
      current.push_back(token);
    }
  }
  return out;
}

}  // namespace veritope::itf1788
