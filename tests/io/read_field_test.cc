// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/fields/read_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/base/byte_buffer.h"
#include "robust/base/random.h"

namespace veritope {
namespace {

Result<FieldFile> read(const std::string& text) {
  static const std::string kName = "f.csv";
  const ByteBuffer buffer =
      copy_to_buffer({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  return read_field(source_of(buffer, kName), {});
}
std::string fault(const std::string& text) {
  const auto file = read(text);
  return file ? "none" : to_string(file.error());
}

TEST(ReadField, SixColumnsAreVectors) {
  for (const char* const text :
       {"0,1,2,3,4,5\n6,7,8,9,10,1e1\n", "0 1 2 3 4 5\r\n6 7 8 9 10 10",
        "\xef\xbb\xbfx,y,z,dx,dy,dz\r0;1;2;3;4;5\r6\t7 8 , 9 ,10 0x5p1",
        "# comment\n\n0 1 2 3 4 10/2\n  \n6 7 8 9 10 10\n",
        "\"X\" \"Y\" \"Z\" \"DX\" \"DY\" \"DZ\"\n0 1 2 3 4 5\n6 7 8 9 10 10",
        "dz dx dy z x y\n5 3 4 2 0 1\n10 9 10 8 6 7\n"}) {
    SCOPED_TRACE(text);
    const FieldFile file = read(text).value();
    EXPECT_FALSE(file.has_tensors);
    EXPECT_EQ(file.field.points, (std::vector<Point3d>{{0, 1, 2}, {6, 7, 8}}));
    EXPECT_EQ(file.field.axes, (std::vector<Point3d>{{3, 4, 5}, {9, 10, 10}}));
    EXPECT_TRUE(file.field.thickness.empty());
    ASSERT_EQ(file.lines.size(), 2u);
    EXPECT_LT(file.lines[0], file.lines[1]);
  }
  EXPECT_EQ(read("# c\n\n0 1 2 3 4 5\n").value().lines, std::vector<std::uint64_t>{3});
}

TEST(ReadField, ASeventhColumnIsAThickness) {
  EXPECT_EQ(read("0 1 2 3 4 5 1/4\n0 1 2 3 4 5 -1").value().field.thickness,
            (std::vector<double>{0.25, -1}));
  EXPECT_EQ(read("thickness x y z dx dy dz\n9 0 1 2 3 4 5").value().field.thickness,
            std::vector<double>{9});
}

TEST(ReadField, NineColumnsAreTensorsWhoseFirstDirectionIsTaken) {
  const auto axis = [](const std::string& text) { return read(text).value().field.axes[0]; };
  const Point3d x = axis("0 0 0 3 1 2 0 0 0"), z = axis("0 0 0 -3 -2 -1 0 0 0 7");
  EXPECT_NEAR(std::abs(x[0]), 1, 1e-15);
  EXPECT_NEAR(std::abs(z[2]), 1, 1e-15);
  // xx yy zz xy yz zx: pure shear in a plane.
  const Point3d xy = axis("0 0 0 0 0 0 1 0 0"), yz = axis("0 0 0 0 0 0 0 1 0"),
                zx = axis("0 0 0 0 0 0 0 0 1");
  EXPECT_NEAR(xy[0] * xy[1], 0.5, 1e-14);
  EXPECT_NEAR(yz[1] * yz[2], 0.5, 1e-14);
  EXPECT_NEAR(zx[0] * zx[2], 0.5, 1e-14);
  const Point3d named = axis("x y z xz yx zy xx yy zz\n0 0 0 1 0 0 0 0 0");
  EXPECT_NEAR(named[0] * named[2], 0.5, 1e-14);
  EXPECT_TRUE(read("0 0 0 3 1 2 0 0 0").value().has_tensors);
  EXPECT_EQ(read("0 0 0 3 1 2 0 0 0 7").value().field.thickness, std::vector<double>{7});
}

TEST(ReadField, RefusesWithTheLineAndTheValue) {
  const std::string good = "0 0 0 0 0 1\n";
  EXPECT_EQ(fault(good + "0 0 0 0 zero 1"), "f.csv: line 2: dy: 'zero' is not a number");
  EXPECT_EQ(fault(good + "0 nan 0 0 0 1"), "f.csv: line 2: y: 'nan' is not finite");
  EXPECT_EQ(fault("nan 0 0 0 0 1"), "f.csv: line 1: x: 'nan' is not finite");
  EXPECT_EQ(fault("0 0 0 0 0 -inf"), "f.csv: line 1: dz: '-inf' is not finite");
  EXPECT_EQ(fault("0 0 0 0 0 1e400"), "f.csv: line 1: dz: '1e400' is not finite");
  EXPECT_EQ(fault("0 0 0 0 0 1/0"), "f.csv: line 1: dz: '1/0' is not finite");
  EXPECT_EQ(fault(good + "\n0 0 0 0 -0 0"), "f.csv: line 3: the direction is 0");
  EXPECT_EQ(fault("0 0 0 0 0 1e-400"), "f.csv: line 1: the direction is 0");
  EXPECT_EQ(fault(good + "0 0 0 0 1"),
            "f.csv: line 2: a line has 6 numbers, like the first one, but there are 5");
  EXPECT_NE(fault("0 0 0 0 1").find("line 1: a line has 6 numbers (x y z dx dy dz) or 9"),
            std::string::npos);
  EXPECT_NE(fault("0,,0,0,0,1").find("line 1: a number is missing before"), std::string::npos);
  EXPECT_NE(fault("0,0,0,0,0,1,\n").find("line 1: a number is missing after"), std::string::npos);
  EXPECT_EQ(fault(""), "f.csv: there is no vector in it");
  EXPECT_EQ(fault("x,y,z,dx,dy,dz\n# none\n"), "f.csv: there is no vector in it");
  EXPECT_EQ(fault("0 0 0 2 2 1 0 0 0"),
            "f.csv: line 1: the tensor has no first principal direction: its greatest principal "
            "values are 2 and 2");
}

TEST(ReadField, RefusesHeadingsThatDoNotFit) {
  EXPECT_NE(fault("x y z dx dy speed\n0 0 0 0 0 1").find("line 1: the column 'speed' is not known"),
            std::string::npos);
  EXPECT_EQ(fault("x y z dx dy dy\n"), "f.csv: line 1: the column 'dy' is there twice");
  EXPECT_EQ(fault("x y z dx dy\n"), "f.csv: line 1: there is no column dz");
  EXPECT_EQ(fault("x y dx dy dz\n"), "f.csv: line 1: there is no column z");
  EXPECT_EQ(fault("x y z xx yy zz xy yz\n"), "f.csv: line 1: there is no column zx");
  EXPECT_EQ(fault("x y z xx yy zz xy yz zx dx\n"),
            "f.csv: line 1: the column dx does not go with those of a tensor");
  EXPECT_EQ(fault("x y z\n0 0 0\n"), "f.csv: line 1: there is no column dx");
}

TEST(ReadField, AnyBytesAreReadOrRefused) {
  Random random(1);
  const std::string letters = "0123456789 ,;.-+eE/xyzdtnaif#\n\r\t\"\0\xff";
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    if (random.below(2) == 0) text = "0 1 2 3 4 5\n";
    for (std::uint64_t k = random.below(40); k > 0; --k)
      text += letters[random.below(letters.size())];
    const auto file = read(text);
    if (file) {
      EXPECT_EQ(file->lines.size(), file->field.size());
      EXPECT_EQ(file->field.axes.size(), file->field.size());
    }
  }
}

}  // namespace
}  // namespace veritope
