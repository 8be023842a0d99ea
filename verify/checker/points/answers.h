// SPDX-License-Identifier: Apache-2.0 OR MIT
// answers.h: conditions A1 and A2 of docs/certificates/points.md.
#pragma once
#include "../common/checker.h"
#include "coordinate.h"

struct Answer {  // a line of the answers file
  enum Word { kOn, kOff, kUndecided };
  const char* line;  // where its first coordinate begins
  int64_t f;         // if it is off the triangles
  uint32_t code;     // of the body
  Word word;
};
// The words of the line, which end at blanks and at its line feed: the next one from *at, which is moved behind the
// byte that ends it.
std::string next_word(const char** at);
// Its three coordinates.
void read_point(const Answer& answer, bool nearest, Coordinate* coordinates);

bool is_about_expression(const Statement& statement);
std::vector<Answer> read_answers(const Statement& statement);
