// SPDX-License-Identifier: Apache-2.0 OR MIT
// answers.cc: conditions A1 and A2, and S1 of the key `decimals`; docs/certificates/points.md.
#include "answers.h"

#include "../common/sha256.h"
#include "points_claim.h"

namespace {

// 0 or [1-9] and at most nine more digits.
bool is_number(const std::string& s) { return is_natural(s) && s.size() <= 10; }

// Whether the three words fit one another and `winding`; sets the word and f of the answer.
bool fits(const std::string& word, const std::string& f, const std::string& shell, bool winding,
          bool has_shells, Answer* answer) {
  if (word == "undecided") {
    answer->word = Answer::kUndecided;
    return f == "-" && shell == "-";
  }
  if (shell != "-" && (!has_shells || !is_number(shell))) return false;
  if (word == "on") {
    answer->word = Answer::kOn;
    return f == "-";
  }
  answer->word = Answer::kOff;
  if (!winding) {
    answer->f = f == "1";
    return word == (f == "1" ? "in" : "out") && (f == "0" || f == "1");
  }
  const bool below = f[0] == '-';
  const std::string size = f.substr(below ? 1 : 0);
  if (word != "-" || !is_number(size) || (below && size == "0")) return false;
  answer->f = below ? -std::stoll(size) : std::stoll(size);
  return true;
}

bool read_line(const char* line, const char* end, const Statement& s, Answer* answer) {
  answer->line = line;
  if (std::count(line, end, ' ') != 5) return false;
  const bool nearest = s.text.at("decimals") == "nearest";
  for (int i = 0; i < 3; ++i)
    if (!is_coordinate(next_word(&line), nearest)) return false;
  const std::string word = next_word(&line), f = next_word(&line), shell = next_word(&line);
  return fits(word, f, shell, s.flag.at("winding"), !is_about_expression(s), answer);
}

}  // namespace

bool is_about_expression(const Statement& s) { return s.text.at("subject_format") == "chain"; }

std::string next_word(const char** at) {
  const char* const begin = *at;
  while (**at != ' ' && **at != '\n') ++*at;
  return std::string(begin, (*at)++);
}

void read_point(const Answer& answer, bool nearest, Coordinate* coordinates) {
  const char* at = answer.line;
  for (int k = 0; k < 3; ++k) coordinates[k] = coordinate(next_word(&at), nearest);
}

void check_decimals(const Statement& statement) {
  const std::string& decimals = statement.text.at("decimals");
  require(decimals == "nearest" || decimals == "exact", "S1",
          "decimals is neither nearest nor exact");
}

std::vector<Answer> read_answers(const Statement& statement) {
  const std::string& bytes = statement.answers;
  require(statement.number.at("answers_bytes") == bytes.size(), "A1", "the answers' size is",
          bytes.size());
  require(statement.text.at("answers_sha256") == sha256(bytes.data(), bytes.size()), "A1",
          "other answers");
  require(!is_about_expression(statement) || !statement.flag.at("winding"), "A2",
          "an expression has no winding numbers");
  std::vector<Answer> answers;
  uint64_t words[3] = {0, 0, 0};
  const char *p = bytes.data(), *const end = p + bytes.size();
  while (p != end) {
    const char* const stop = std::find(p, end, '\n');
    Answer answer = {p, 0, 0, Answer::kOff};
    require(stop != end && read_line(p, stop, statement, &answer), "A2", "malformed: line",
            answers.size() + 1);
    answers.push_back(answer);
    ++words[answer.word];
    p = stop + 1;
  }
  require(statement.number.at("points") == answers.size(), "A2", "the number of lines is",
          answers.size());
  require(statement.number.at("on") == words[Answer::kOn], "A2", "the number of points on is",
          words[Answer::kOn]);
  require(statement.number.at("undecided") == words[Answer::kUndecided], "A2",
          "the number of undecided points is", words[Answer::kUndecided]);
  return answers;
}
