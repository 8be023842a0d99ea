// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/text_style.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace veritope::report {
namespace {

std::string without_blanks(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '\n') out += c;
  return out;
}

TEST(Fold, LeavesLinesAloneThatFit) {
  EXPECT_EQ(fold("", 10), "");
  EXPECT_EQ(fold("0123456789\n", 10), "0123456789\n");
  EXPECT_EQ(fold("a  b   c\n\n  d", 10), "a  b   c\n\n  d");
}

TEST(Fold, ContinuesBelowTheValueOfADetailLine) {
  EXPECT_EQ(fold(detail_line("file", "one two three"), 23), "  file         one two\n               three\n");
  EXPECT_EQ(fold(detail_line("", "one two three"), 23), "               one two\n               three\n");
}

TEST(Fold, ContinuesOtherLinesTwoColumnsToTheRight) {
  EXPECT_EQ(fold("    one two three\n", 12), "    one two\n      three\n");
  EXPECT_EQ(fold("VALID  one two\n", 10), "VALID  one\n    two\n");
}

TEST(Fold, KeepsWordsThatAreLongerThanALine) {
  EXPECT_EQ(fold("  a 0123456789 b\n", 6), "  a\n    0123456789\n    b\n");
}

TEST(Fold, DoesNotBreakUnbrokenSpaces) {
  EXPECT_EQ(fold("x " + unbroken("my part.stl") + " y\n", 8), "x\n    my part.stl\n    y\n");
}

TEST(Fold, CountsCharactersAndNoColours) {
  const Style style{true};
  const std::string red = style.red("12345");
  EXPECT_EQ(fold(red + " 67890", 11), red + " 67890");
  EXPECT_EQ(fold("\u00e4\u00f6\u00fc \u00e4\u00f6\u00fc", 7), "\u00e4\u00f6\u00fc \u00e4\u00f6\u00fc");
}

TEST(Fold, LosesNothingAndKeepsToTheWidthWhereverWordsAllowIt) {
  std::mt19937 random(20261125);
  for (int i = 0; i < 2000; ++i) {
    const std::size_t width = 20 + random() % 60;
    std::string text = random() % 2 == 0 ? "  name         " : std::string(random() % 6, ' ');
    for (std::size_t words = random() % 40; words-- > 0;)
      text += std::string(1 + random() % 8, static_cast<char>('a' + random() % 26)) +
              (random() % 9 == 0 ? "  " : " ");
    const std::string folded = fold(text, width);
    ASSERT_EQ(without_blanks(folded), without_blanks(text)) << text << "\nwidth " << width;
    for (std::size_t at = 0; at < folded.size();) {
      const std::size_t end = std::min(folded.find('\n', at), folded.size());
      const std::string line = folded.substr(at, end - at);
      const std::size_t last = line.empty() ? 0 : std::min(line.find_last_not_of(' '), line.size());
      const std::size_t first = std::min(line.find_first_not_of(' '), line.size());
      const bool is_one_word = line.find(' ', first) > last;
      ASSERT_TRUE(is_one_word || last + 1 <= width) << text << "\n" << folded;
      at = end + 1;
    }
  }
}

}  // namespace
}  // namespace veritope::report
