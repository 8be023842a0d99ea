// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/points/read_point.h"

#include <gtest/gtest.h>

#include "io/points/npy_header.h"

namespace veritope {
namespace {

// A line with the padding that readers need.
class Line {
 public:
  explicit Line(const std::string& text)
      : text_(text + std::string(16, '\n')), size_(text.size()) {}
  std::string_view view() const { return std::string_view(text_).substr(0, size_); }

 private:
  std::string text_;
  std::size_t size_;
};

// "x y z" with the exact values, "-" for a line without a point, or "COLUMN: message".
std::string read(PointLines& lines, const std::string& text) {
  const Line line(text);
  std::optional<PointFault> fault;
  const std::optional<ReadPoint> point = lines.read(line.view(), fault);
  if (fault) return std::to_string(fault->column) + ": " + fault->message;
  if (!point) return "-";
  std::string out;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto* p = std::get_if<Vec3d>(&point->point);
    const Rational x = p != nullptr ? Rational::from_double((*p)[static_cast<int>(k)])
                                    : std::get<ExactPoint>(point->point)[k];
    out += (k > 0 ? " " : "") + x.to_string();
  }
  return out + (std::holds_alternative<Vec3d>(point->point) ? "" : " exact");
}
std::string read(const std::string& text, Decimals decimals = Decimals::kNearest) {
  PointLines lines(decimals, {});
  read(lines, "1 2 3");  // no header any more
  return read(lines, text);
}

TEST(ReadPoint, SeparatesCoordinatesByBlanksAndOneMark) {
  for (const char* text :
       {"1 2 3", "1,2,3", "1;2;3", " 1\t2 ,3 ", "1 , 2 ; 3", "+1 2. 3e0", "0x1p0 4/2 3"})
    EXPECT_EQ(read(text), "1 2 3") << text;
  EXPECT_EQ(read("1,,2,3"), "3: a number is missing beside this mark");
  EXPECT_EQ(read(",1,2,3"), "1: a number is missing beside this mark");
  EXPECT_EQ(read("1,2,3,"), "6: a number is missing beside this mark");
}

TEST(ReadPoint, TakesTwoCoordinatesInThePlane) {
  PointLines lines(Decimals::kExact, {}, 2);
  EXPECT_EQ(read(lines, "x;y"), "-");
  EXPECT_EQ(read(lines, "1,2/4"), "1 1/2 0");
  EXPECT_EQ(read(lines, "1/3 2"), "1/3 2 0 exact");
  EXPECT_EQ(read(lines, "1 2 3"), "5: a point has two coordinates, but there are 3");
  EXPECT_EQ(read(lines, "1"), "2: a point has two coordinates, but there are 1");
  EXPECT_EQ(read(lines, "1 nan"), "3: 'nan' is not finite");
  EXPECT_EQ(read(lines, "1,2,"), "4: a number is missing beside this mark");
  const Line line("5;7");
  std::optional<PointFault> fault;
  EXPECT_EQ(lines.read(line.view(), fault)->tokens,
            (std::array<std::string_view, 3>{"5", "7", ""}));
}

TEST(ReadPoint, SkipsEmptyLinesCommentsAndAFirstLineOfWords) {
  PointLines lines(Decimals::kNearest, {});
  EXPECT_EQ(read(lines, ""), "-");
  EXPECT_EQ(read(lines, " \t"), "-");
  EXPECT_EQ(read(lines, "# x y z"), "-");
  EXPECT_EQ(read(lines, "x,\"y\",z_1 and more"), "-");
  EXPECT_EQ(read(lines, "x,y,z"),
            "1: 'x' is neither a decimal, nor a fraction, nor a hexadecimal number");
  PointLines others(Decimals::kNearest, {});
  EXPECT_EQ(read(others, "1 y z"),
            "3: 'y' is neither a decimal, nor a fraction, nor a hexadecimal number");
}

TEST(ReadPoint, RefusesAFirstLineThatIsMeantToBeAPoint) {
  for (const char* text : {"nan nan nan", "inf -inf NaN", "1e999 1e999 1e999", "1d0 2d0 3d0",
                           "\"1\",\"2\",\"3\"", "\x93NUMPY\x01",
                           "\xff\xfe"
                           "1",
                           "a\x01"
                           " b c",
                           "-x -y -z"}) {
    PointLines lines(Decimals::kNearest, {});
    EXPECT_EQ(read(lines, text).substr(0, 2), "1:") << text;
  }
  PointLines marked(Decimals::kNearest, {});
  EXPECT_EQ(read(marked,
                 "\xef\xbb\xbf"
                 "1 2 3"),
            "1 2 3");
}

// Otherwise no checker would accept the answers.
TEST(ReadPoint, HasTheLimitsOfTheCertificate) {
  EXPECT_EQ(read("0x10 0 0"), "1: '0x10' lacks the exponent of a hexadecimal number, as in 0x1p0");
  EXPECT_NE(read("1e0" + std::string(5000, '0') + "1 0 0").find("is longer than 4096 bytes"),
            std::string::npos);
  ReadLimits wide;
  wide.max_exponent = 100000;
  PointLines exact(Decimals::kExact, wide), nearest(Decimals::kNearest, wide);
  read(exact, "1 2 3"), read(nearest, "1 2 3");
  EXPECT_NE(read(exact, "1e5000 0 0").find("--max-exponent 4096"), std::string::npos);
  EXPECT_NE(read(nearest, "0x1p5000 0 0").find("--max-exponent 4096"), std::string::npos);
  EXPECT_EQ(read(nearest, "1e-5000 0 0"), "0 0 0");
}

TEST(ReadPoint, DecimalsAreNearestOrExact) {
  EXPECT_EQ(read("0.5 1e-2 0"), "1/2 5764607523034235/576460752303423488 0");
  EXPECT_EQ(read("0.5 1e-2 0", Decimals::kExact), "1/2 1/100 0 exact");
  EXPECT_EQ(read("0.5 1e2 -0", Decimals::kExact), "1/2 100 0");
  EXPECT_EQ(read("1/3 0x1.8p-1 1"), "1/3 3/4 1 exact");
  EXPECT_EQ(read("1e-400 0 0"), "0 0 0");
  EXPECT_EQ(read("9007199254740993 0 0"), "9007199254740992 0 0");
  EXPECT_EQ(read("9007199254740993 0 0", Decimals::kExact), "9007199254740993 0 0 exact");
}

TEST(ReadPoint, NamesTheColumnOfWhatIsWrong) {
  EXPECT_EQ(read("1 2"), "4: a point has three coordinates, but there are 2");
  EXPECT_EQ(read("1 2 3 4"), "7: a point has three coordinates, but there are 4");
  EXPECT_EQ(read("1 nan 3"), "3: 'nan' is not finite");
  EXPECT_EQ(read("1 2 1e999"), "5: '1e999' is not finite");
  EXPECT_EQ(read("1 2 -inf", Decimals::kExact), "5: '-inf' is not finite");
  EXPECT_EQ(read("1 2/0 3").substr(0, 3), "3: ");
  EXPECT_EQ(read("1 2 3e5000", Decimals::kExact),
            "5: '3e5000' has an exponent over --max-exponent 4096");
  EXPECT_EQ(read(std::string(1001, '7') + " 2 3").substr(0, 5), "1: '7");
}

std::string npy(const std::string& header, std::size_t version = 1) {
  std::string out = "\x93NUMPY";
  out += static_cast<char>(version);
  out += '\0';
  for (std::size_t i = 0; i < (version == 1 ? 2u : 4u); ++i)
    out += static_cast<char>(header.size() >> (8 * i) & 255);
  return out + header;
}
Result<NpyHeader> header_of(const std::string& bytes) {
  return read_npy_header({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

TEST(NpyHeader, HasTypeAndNumberOfPoints) {
  for (const std::size_t version : {1u, 2u, 3u}) {
    const std::string bytes =
        npy("{'descr': '<f8', 'fortran_order': False, 'shape': (7, 3), }   \n", version);
    const auto h = header_of(bytes + "rest");
    ASSERT_TRUE(h) << h.error().message;
    EXPECT_EQ(h->num_points, 7u);
    EXPECT_EQ(h->num_bytes, bytes.size());
    EXPECT_EQ(h->row_bytes(), 24u);
  }
  const auto big = header_of(npy("{'descr': '>f4', 'fortran_order': False, 'shape': (0, 3)}"));
  ASSERT_TRUE(big);
  EXPECT_TRUE(big->is_big_endian);
  EXPECT_EQ(big->row_bytes(), 12u);
}

TEST(NpyHeader, HasTwoColumnsInThePlane) {
  const std::string two = npy("{'descr': '<f8', 'fortran_order': False, 'shape': (7, 2), }"),
                    three = npy("{'descr': '<f4', 'fortran_order': False, 'shape': (7, 3), }");
  const auto header = [](const std::string& bytes) {
    return read_npy_header({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, 2);
  };
  ASSERT_TRUE(header(two));
  EXPECT_EQ(header(two)->row_bytes(), 16u);
  const unsigned char row[16] = {0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 0, 0, 0, 0, 0, 0, 0, 0xc0};
  EXPECT_EQ(npy_row(*header(two), row), (Vec3d{1, -2, 0}));
  ASSERT_FALSE(header(three));
  EXPECT_EQ(header(three).error().message,
            "a .npy file, but with the shape (7,3) instead of (n, 2)");
}

TEST(NpyHeader, RefusesOtherArraysAndBrokenHeaders) {
  EXPECT_FALSE(header_of("solid"));
  EXPECT_FALSE(header_of("\x93NUMPY"));
  EXPECT_FALSE(
      header_of(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (7, 3), }").substr(0, 40)));
  for (const char* header :
       {"{'descr': '<i8', 'fortran_order': False, 'shape': (7, 3), }",
        "{'descr': '<f8', 'fortran_order': True, 'shape': (7, 3), }",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (7, 2), }",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (7,), }",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (7, 3, 1), }",
        "{'descr': '<f8', 'shape': (7, 3), }",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999999999, 3), }",
        "{'descr'"})
    EXPECT_FALSE(header_of(npy(header))) << header;
  EXPECT_FALSE(header_of(npy(std::string(70000, ' '), 2)));
}

TEST(NpyHeader, RowsHaveEitherByteOrder) {
  NpyHeader h;
  const unsigned char little[24] = {0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 0, 0, 0, 0, 0, 0, 0, 0xc0};
  EXPECT_EQ(npy_row(h, little), (Vec3d{1, -2, 0}));
  h.is_double = false;
  h.is_big_endian = true;
  const unsigned char big[12] = {0x3f, 0x80, 0, 0, 0xc0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(npy_row(h, big), (Vec3d{1, -2, 0}));
}

TEST(ReadPoint, TakesTheTwoEndsOfSegmentsExactly) {
  PointLines lines(Decimals::kExact, {}, 6);
  std::optional<PointFault> fault;
  const Line line("0.1 1/3,0x1p-3 ; -2 0 1e2"), comment("# nothing"), long_one("1 2 3 4 5 6 7");
  const auto ends = lines.read_segment(line.view(), fault);
  ASSERT_TRUE(ends.has_value());
  EXPECT_FALSE(fault.has_value());
  EXPECT_EQ((*ends)[0], (ExactPoint{Rational(1) / Rational(10), Rational(1) / Rational(3),
                                    Rational(1) / Rational(8)}));
  EXPECT_EQ((*ends)[1], (ExactPoint{-2, 0, 100}));
  EXPECT_FALSE(lines.read_segment(comment.view(), fault).has_value());
  EXPECT_FALSE(fault.has_value());
  EXPECT_FALSE(lines.read_segment(long_one.view(), fault).has_value());
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->column, 13u);
  EXPECT_EQ(fault->message, "a segment has six coordinates, three of each end, but there are 7");
}

}  // namespace
}  // namespace veritope
