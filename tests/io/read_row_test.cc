// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/points/read_row.h"

#include <gtest/gtest.h>

#include <string>

namespace veritope {
namespace {

class Rows {
 public:
  Rows() : lines_(4, 6, {}) {}
  // The row, or the column and the fault, or "none".
  std::string read(const std::string& line) {
    const std::string padded = line + std::string(8, '\0');
    std::optional<PointFault> fault;
    const auto row = lines_.read(std::string_view(padded).substr(0, line.size()), fault);
    if (fault) return std::to_string(fault->column) + ": " + fault->message;
    if (!row) return "none";
    std::string text;
    for (const Rational& x : *row) text += (text.empty() ? "" : " ") + x.to_string();
    return text;
  }

 private:
  RowLines lines_;
};

TEST(ReadRow, TakesExactNumbersInAllForms) {
  Rows rows;
  EXPECT_EQ(rows.read("x, y, z, density, heat"), "none");
  EXPECT_EQ(rows.read("# 1 2 3"), "none");
  EXPECT_EQ(rows.read("  "), "none");
  EXPECT_EQ(rows.read("0.1 -2e1\t1/3; 0x1p-2,7"), "1/10 -20 1/3 1/4 7");
  EXPECT_EQ(rows.read("1 2 3 4 5"), "1 2 3 4 5");
}

TEST(ReadRow, NamesTheColumnOfAFault) {
  const auto first = [](const std::string& line) { return Rows().read(line); };
  EXPECT_EQ(first("1 2 3"), "6: a line has at least 4 numbers, but there are 3");
  EXPECT_EQ(first("1 2 3 4 5 6 77"), "13: a line has at most 6 numbers, but there are 7");
  EXPECT_EQ(first("1 2 nan 4"), "5: 'nan' is not finite");
  EXPECT_EQ(first("1 2 3 -inf"), "7: '-inf' is not finite");
  EXPECT_EQ(first("1 2 3 1/0").substr(0, 3), "7: ");
  EXPECT_EQ(first("1 2 3 0x10"),
            "7: '0x10' lacks the exponent of a hexadecimal number, as in 0x1p0");
  EXPECT_EQ(first("1,,2 3 4"), "3: a number is missing beside this mark");
  EXPECT_EQ(first("1 2 3 4,"), "8: a number is missing beside this mark");
  EXPECT_EQ(first("1 2 x 4"),
            "5: 'x' is neither a decimal, nor a fraction, nor a hexadecimal number");
}

TEST(ReadRow, WantsAsManyNumbersAsTheFirstRowHas) {
  Rows rows;
  EXPECT_EQ(rows.read("1 2 3 4"), "1 2 3 4");
  EXPECT_EQ(rows.read("1 2 3 4 5"),
            "10: each line has as many numbers as the first one, 4, but there are 5");
  EXPECT_EQ(rows.read("1 2 3"),
            "6: each line has as many numbers as the first one, 4, but there are 3");
  EXPECT_EQ(rows.read("x y z w"),
            "1: 'x' is neither a decimal, nor a fraction, nor a hexadecimal number");
}

}  // namespace
}  // namespace veritope
