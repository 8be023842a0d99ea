// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/patch_cells.h"

#include <gtest/gtest.h>

#include "render/spline_view.h"
#include "splines/bspline_pieces.h"

namespace veritope {
namespace {

BezierSurface<Rational> surface(std::array<int, 2> degrees, bool is_rational, int seed) {
  BezierSurface<Rational> out(degrees, is_rational ? 4 : 3, is_rational);
  for (std::size_t n = 0; n < out.coefficients().size(); ++n)
    out.coefficients()[n] =
        Rational(static_cast<std::int64_t>((n * 37 + static_cast<std::size_t>(seed)) % 19) + 1) /
        Rational(8);
  // Powers of two, so that quotients of rounded numbers are the rounded quotients.
  if (is_rational)
    for (std::size_t n = 0; n < out.grid().count(); ++n)
      out.component(3)[n] = Rational::power_of_two(static_cast<std::int64_t>(n % 3));
  return out;
}

// The text of an array of a .vtu file.
std::string array_of(const std::string& file, const std::string& name) {
  const std::size_t at = file.find("Name=\"" + name + "\"");
  if (at == file.npos) return "no array " + name;
  const std::size_t begin = file.find(">\n", at) + 2;
  return file.substr(begin, file.find("</DataArray>", begin) - begin);
}

TEST(PatchCells, HaveCurvesWhereTheSecondDegreeIsZero) {
  SplineModel model;
  PatchCells cells({"patch"});
  PatchCells::Part made;
  std::uint64_t points = 0;
  for (int degree = 1; degree <= 5; ++degree) {
    const auto s = surface({degree, 0}, degree == 3, degree);
    ASSERT_TRUE(made.add(s, {degree}));
    points += s.grid().count();
    const BezierCurve<Rational> curve({degree}, s.num_components(), s.is_rational(),
                                      {s.coefficients().begin(), s.coefficients().end()});
    model.entities.push_back({to_bspline(curve), {}, std::nullopt, {}});
  }
  std::string file = PatchCells::begin(points, 5) + cells.take(std::move(made));
  ASSERT_TRUE(cells.end([&](std::string_view text) {
    file += text;
    return ok_status();
  }));
  const std::string whole = view_bytes(model, ViewFormat::kVtu, {}).value();
  for (const char* const name :
       {"Points", "RationalWeights", "HigherOrderDegrees", "offsets", "types", "connectivity"})
    EXPECT_EQ(array_of(file, name), array_of(whole, name)) << name;
}

TEST(PatchCells, AreTheCellsThatAModelOfTheseSurfacesHas) {
  SplineModel model;
  PatchCells cells({"volume", "patch"});
  std::uint64_t points = 0;
  std::string middle;
  for (int part = 0; part < 3; ++part) {
    PatchCells::Part made;
    for (int n = 0; n <= part; ++n) {
      const auto s = surface({1 + part, 3 - n}, (part + n) % 2 == 1, 5 * part + n);
      ASSERT_TRUE(made.add(s, {part, n}));
      points += s.grid().count();
      model.entities.push_back({to_bspline(s), {}, std::nullopt, {}});
    }
    middle += cells.take(std::move(made));
  }
  std::string file = PatchCells::begin(points, model.entities.size()) + middle;
  ASSERT_TRUE(cells.end([&](std::string_view text) {
    file += text;
    return ok_status();
  }));
  const std::string whole = view_bytes(model, ViewFormat::kVtu, {}).value();
  for (const char* const name :
       {"Points", "RationalWeights", "HigherOrderDegrees", "offsets", "types"})
    EXPECT_EQ(array_of(file, name), array_of(whole, name)) << name;
  EXPECT_EQ(array_of(file, "connectivity"), array_of(whole, "connectivity"));
  EXPECT_EQ(array_of(file, "volume"), "0\n1\n1\n2\n2\n2\n");
  EXPECT_EQ(array_of(file, "patch"), "0\n0\n1\n0\n1\n2\n");
  EXPECT_NE(file.find("NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfCells=\"6\""),
            file.npos);
}

TEST(PatchCells, PointsBeyondBinary64AreRefused) {
  BezierSurface<Rational> huge = surface({1, 1}, false, 0);
  huge.coefficients()[2] = Rational::power_of_two(2000);
  PatchCells::Part part;
  const Status status = part.add(huge, {});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Code::kNotFinite);
}

TEST(PatchCells, AFailureOfTheSinkIsReported) {
  PatchCells cells({});
  const Status status =
      cells.end([](std::string_view) -> Status { return bad_argument("no place is left"); });
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().message, "no place is left");
}

}  // namespace
}  // namespace veritope
