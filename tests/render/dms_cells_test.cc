// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/render/dms_cells_test.cc: Bezier tetrahedra of simplex-spline solids, read back from their .vtu file and
// compared with exact values of the model.
#include "render/dms_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "render/spline_view.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_make.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

TEST(VtkTetrahedronOrder, NumbersCornersEdgesFacesThenTheTetrahedronInside) {
  // The cubic of VTK: corners; edges 01, 12, 20, 03, 13, 23; the faces 013, 123, 023, 012.
  const std::array<TetrahedralIndex, 20> order = {
      {{3, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 3, 0}, {0, 0, 0, 3}, {2, 1, 0, 0},
       {1, 2, 0, 0}, {0, 2, 1, 0}, {0, 1, 2, 0}, {1, 0, 2, 0}, {2, 0, 1, 0},
       {2, 0, 0, 1}, {1, 0, 0, 2}, {0, 2, 0, 1}, {0, 1, 0, 2}, {0, 0, 2, 1},
       {0, 0, 1, 2}, {1, 1, 0, 1}, {0, 1, 1, 1}, {1, 0, 1, 1}, {1, 1, 1, 0}}};
  for (std::size_t n = 0; n < order.size(); ++n) EXPECT_EQ(vtk_tetrahedron_index(order[n]), n);
  EXPECT_EQ(vtk_tetrahedron_index({1, 1, 1, 1}), 34u);
  // For degree 4 the inside of a face is a triangle of degree 1, and turns as the list of faces says.
  EXPECT_EQ(vtk_tetrahedron_index({2, 1, 0, 1}), 22u);
  EXPECT_EQ(vtk_tetrahedron_index({1, 2, 0, 1}), 23u);
  EXPECT_EQ(vtk_tetrahedron_index({0, 1, 2, 1}), 25u);
  EXPECT_EQ(vtk_tetrahedron_index({0, 1, 1, 2}), 26u);
  EXPECT_EQ(vtk_tetrahedron_index({0, 2, 1, 1}), 27u);
}
TEST(VtkTetrahedronOrder, NumbersEachControlPointOnce) {
  for (int degree = 1; degree <= kMaxDmsDegree; ++degree) {
    std::set<std::size_t> seen;
    for_each_tetrahedral_index(
        degree, [&](const TetrahedralIndex& index) { seen.insert(vtk_tetrahedron_index(index)); });
    EXPECT_EQ(seen.size(), num_tetrahedral_indices(degree));
    EXPECT_EQ(*seen.rbegin(), seen.size() - 1);
  }
}

// The numbers of an array of a .vtu file.
std::vector<double> array_of(const std::string& file, const std::string& name) {
  const std::size_t at = file.find("Name=\"" + name + "\"");
  EXPECT_NE(at, file.npos) << name;
  if (at == file.npos) return {};
  const std::size_t begin = file.find(">\n", at) + 2;
  std::istringstream text(file.substr(begin, file.find("</DataArray>", begin) - begin));
  std::vector<double> out;
  for (double x; text >> x;) out.push_back(x);
  return out;
}

double binomial_share(int n, const TetrahedralIndex& index, const std::array<double, 4>& at) {
  double out = 1;
  int left = n;
  for (std::size_t m = 0; m < 4; ++m)
    for (int k = 1; k <= index[m]; ++k) out *= at[m] * left-- / k;
  return out;
}

struct ReadCells {
  std::vector<double> points, attribute, connectivity, tetrahedra;
  std::size_t num_points = 0, num_cells = 0, corners = 0;

  ReadCells(const std::string& vtu, const DmsModel& model)
      : points(array_of(vtu, "Points")),
        connectivity(array_of(vtu, "connectivity")),
        tetrahedra(array_of(vtu, "tetrahedron")),
        num_points(points.size() / 3),
        num_cells(tetrahedra.size()),
        corners(num_tetrahedral_indices(model.degree)) {
    if (!model.attributes.empty()) attribute = array_of(vtu, model.attributes[0]);
  }
  // x, y, z and the first attribute of the cell where its corners have these weights.
  std::array<double, 4> at(std::size_t cell, int degree, const std::array<double, 4>& w) const {
    std::array<double, 4> out{};
    for_each_tetrahedral_index(degree, [&](const TetrahedralIndex& index) {
      const auto p =
          static_cast<std::size_t>(connectivity[cell * corners + vtk_tetrahedron_index(index)]);
      const double share = binomial_share(degree, index, w);
      for (std::size_t c = 0; c < 3; ++c) out[c] += share * points[3 * p + c];
      if (!attribute.empty()) out[3] += share * attribute[p];
    });
    return out;
  }
};

// The identity of the domain with a drawn attribute, so that the place of a point of a cell in the domain is known.
DmsModel identity_of(DmsModel model) {
  model.attributes = {"a"};
  Random random(7);
  std::vector<Rational> values;
  for (std::size_t v = 0; v < model.clouds.size(); ++v)
    values.push_back(Rational(random.between(-8, 8)));
  model.control = {};
  set_control_by_rule(model, DmsControlRule::kGreville, values);
  return model;
}

TEST(DmsCells, AreTheMapAndItsAttributes) {
  std::size_t with_many = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const RandomDms drawn = draw_dms(seed, 3, 0);
    const DmsModel model = identity_of(drawn.model);
    ASSERT_TRUE(validate(model)) << drawn.text;
    const auto cells = dms_cells(model, {1, 60});
    if (!cells) {
      ASSERT_EQ(cells.error().code, Code::kOverLimit) << drawn.text;
      continue;  // cubic ones with general clouds take seconds
    }
    const ReadCells read(cells->vtu, model);
    EXPECT_EQ(read.num_cells, cells->num_cells);
    EXPECT_EQ(read.connectivity.size(), read.num_cells * read.corners);
    EXPECT_EQ(read.attribute.size(), read.num_points);
    with_many += read.num_cells > model.tetrahedra.size() ? 1 : 0;
    DmsEvaluator evaluator(model);
    Random random(seed);
    for (int tries = 0; tries < 10; ++tries) {
      const std::size_t cell = random.below(read.num_cells);
      const std::array<double, 4> w{0.375, 0.25, 0.25, 0.125};
      const auto p = read.at(cell, model.degree, w);
      const auto place = evaluator.locate(
          {Rational::from_double(p[0]), Rational::from_double(p[1]), Rational::from_double(p[2])});
      ASSERT_TRUE(place.has_value()) << drawn.text;
      EXPECT_EQ(place->tetrahedron, static_cast<std::uint32_t>(read.tetrahedra[cell]))
          << drawn.text;
      EXPECT_NEAR(p[3], nearest_double(evaluator.evaluate(*place).value[3]), 1e-9) << drawn.text;
    }
  }
  EXPECT_GT(with_many, 3u);
}

TEST(DmsCells, ShareTheControlPointsOfCommonFaces) {
  // Two tetrahedra with collapsed clouds, quadratic: 10 control points each, 6 of them in common.
  DmsModel model;
  model.degree = 2;
  for (const auto& [x, y, z] :
       std::vector<std::array<int, 3>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}})
    model.clouds.push_back({{Rational(x), Rational(y), Rational(z)}});
  model.tetrahedra = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  for (std::uint32_t a = 0; a < 5; ++a)
    for (std::uint32_t b = a; b < 5; ++b) {
      if (a == 0 && b == 4) continue;
      model.control.at.insert(model.control.at.end(), {a, b});
      for (std::size_t c = 0; c < 3; ++c)
        model.control.values.push_back((model.clouds[a][0][c] + model.clouds[b][0][c]) /
                                       Rational(2));
    }
  ASSERT_TRUE(validate(model));
  const auto cells = dms_cells(model, {});
  ASSERT_TRUE(cells);
  EXPECT_EQ(cells->num_cells, 2u);
  EXPECT_NE(cells->vtu.find("NumberOfPoints=\"14\" NumberOfCells=\"2\""), std::string::npos);
  EXPECT_NE(cells->vtu.find("\n78\n78\n"), std::string::npos);
}

TEST(DmsCells, HaveTheSameBytesForEveryNumberOfThreads) {
  const DmsModel model = draw_dms(3, 2).model;
  const auto one = dms_cells(model, {1, 4096}), three = dms_cells(model, {3, 4096});
  ASSERT_TRUE(one && three);
  EXPECT_EQ(one->vtu, three->vtu);
}

TEST(DmsCells, AreRefusedWithTheTetrahedron) {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const DmsModel model = draw_dms(seed, 2, 0).model;
    const auto all = dms_cells(model, {});
    ASSERT_TRUE(all) << "seed " << seed;
    if (all->num_cells == model.tetrahedra.size()) continue;
    const auto cells = dms_cells(model, {1, 1});
    ASSERT_FALSE(cells);
    EXPECT_EQ(cells.error().code, Code::kOverLimit);
    EXPECT_TRUE(cells.error().place.entity.has_value());
    DmsModel wide = model;
    for (Rational& x : wide.control.values) x = Rational::power_of_two(1100);
    EXPECT_EQ(dms_cells(wide, {}).error().code, Code::kNotFinite);
    return;
  }
  FAIL() << "no model with clouds that are not collapsed";
}

TEST(DmsCells, KeepNamesThatXmlReserves) {
  DmsModel model = identity_of(draw_dms(1, 2, 0).model);
  model.attributes = {"p<q & \"r\""};
  const auto cells = dms_cells(model, {});
  ASSERT_TRUE(cells);
  EXPECT_NE(cells->vtu.find("Name=\"p&lt;q &amp; &quot;r&quot;\""), std::string::npos);
  model.attributes = {"a\x1f"};
  EXPECT_NE(dms_cells(model, {})->vtu.find("Name=\"a\\x1f\""), std::string::npos);
}

}  // namespace
}  // namespace veritope
