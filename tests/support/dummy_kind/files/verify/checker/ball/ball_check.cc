// SPDX-License-Identifier: Apache-2.0 OR MIT
// ball_check.cc: the conditions B1 and P1 to P3 of the page about balls.
#include <algorithm>

#include "ball_claims.h"

namespace {

struct Number {  // digits / 10^decimals
  int64_t digits;
  unsigned decimals;
  std::string text;  // its shortest decimal
};

struct Reader {
  const std::string& file;
  size_t at;

  void word(const std::string& expected) {
    if (file.compare(at, expected.size(), expected) != 0) throw Refused{"is no file of a ball"};
    at += expected.size();
  }
  Number number() {
    const size_t end = std::min(file.find_first_of(" \n", at), file.size());
    std::string text = file.substr(at, end - at);
    at = end;
    const bool below = !text.empty() && text[0] == '-';
    if (below) text.erase(0, 1);
    const size_t point = std::min(text.find('.'), text.size());
    std::string whole = text.substr(0, point), part = text.substr(std::min(point + 1, text.size()));
    if (whole.empty() || (whole + part).find_first_not_of("0123456789") != text.npos ||
        (point < text.size() && part.empty()) || whole.size() + part.size() > 18)
      throw Refused{"has a number that is no decimal of at most 18 digits"};
    while (!part.empty() && part.back() == '0') part.pop_back();
    while (whole.size() > 1 && whole[0] == '0') whole.erase(0, 1);
    Number n = {std::stoll(whole + part), unsigned(part.size()),
                whole + (part.empty() ? "" : "." + part)};
    if (below && n.digits != 0) n.digits = -n.digits, n.text = "-" + n.text;
    return n;
  }
};

}  // namespace

std::string check_ball(const Statement& statement, std::string model, const Body& bytes) {
  Reader r = {model, 0};
  Number numbers[4];
  static const char* const before[] = {"ball\ncentre ", " ", " ", "\nradius "};
  for (int i = 0; i < 4; ++i) {
    r.word(before[i]);
    numbers[i] = r.number();
  }
  r.word("\n");
  if (r.at != model.size()) throw Refused{"goes on behind the radius"};
  Body body = bytes;
  require(body.begins_with(statement.claim->magic), "B1", "another magic");
  for (int i = 0; i < 4; ++i) {
    const bool same = body.natural(8) == uint64_t(numbers[i].digits);
    require(body.natural(1) == numbers[i].decimals && same, "P1", "not the model's number",
            uint64_t(i));
  }
  require(body.left() == 0, "B1", "bytes behind the radius:", body.left());
  require(statement.text.at("radius") == numbers[3].text, "P2", "not the model's radius");
  const bool solid = std::string(statement.claim->name) == "ball-1";
  require((numbers[3].digits > 0) == solid, "P3",
          solid ? "the radius is not positive" : "the radius is positive");
  return "radius " + numbers[3].text;
}
