// SPDX-License-Identifier: LGPL-3.0-or-later
// Boxes with several sheets, and in frames, made by hand; beside each condition a lie that only it refuses.
#include "solids/star_box/sheet_box.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/solids/exact_nodes.h"

namespace veritope {
namespace {

Rational ratio(std::int64_t p, std::int64_t q = 1) { return Rational(p) / Rational(q); }

// A model with its forest; boxes are given in the model's coordinates and scaled to the forest's.
class Model {
 public:
  explicit Model(Patches patches)
      : complex_(complex_of(std::move(patches))),
        forest_(PieceForest::make(complex_, PieceForest::FrameChoice::kWhole).value()) {}

  bool holds(const SheetBox& box, std::size_t most = 4096) {
    return is_sheet_box(forest_, scaled(box), most, &pieces_);
  }
  const SheetPieces& pieces() const { return pieces_; }
  PieceForest& forest() { return forest_; }
  SheetBox scaled(SheetBox box) const {
    const double s = std::ldexp(1.0, forest_.scale());
    const auto scale = [&](Point3d* p) {
      for (double& v : *p) v *= s;
    };
    scale(&box.box.lo), scale(&box.box.hi);
    for (Sheet& sheet : box.sheets) scale(&sheet.inside), scale(&sheet.outside);
    for (SheetSeparator& q : box.separators) scale(&q.origin), q.unit *= s;
    return box;
  }

 private:
  PatchComplex complex_;
  PieceForest forest_;
  SheetPieces pieces_;
};

constexpr double kGap = 0x1p-6;

SheetSeparator separator(int degree, const Point3d& origin, double unit,
                         std::vector<std::int64_t> coefficients) {
  SheetSeparator q;
  q.degree = degree, q.origin = origin, q.unit = unit, q.coefficients = std::move(coefficients);
  return q;
}
constexpr Sign kPlus = Sign::kPositive, kMinus = Sign::kNegative, kNone = Sign::kZero;

// A plate of thickness `gap` whose lower wall lies in z = 0.
Patches plate(const Rational& gap = Rational::from_double(kGap)) {
  return patch_shapes::box({ratio(-1), ratio(-1), ratio(0)}, {ratio(1), ratio(1), gap});
}
// Both walls around the z axis; a plane between them.
SheetBox both_walls() {
  SheetBox out;
  out.box = {{-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25}};
  out.sheets = {{{0, 0, -0.125}, {0, 0, 0.125}, {kPlus}},
                {{0, 0, 0.125}, {0, 0, -0.125}, {kMinus}}};
  out.separators = {separator(1, {0, 0, kGap / 2}, kGap, {0, 1, 0, 0})};
  return out;
}

TEST(SheetBox, AcceptsTwoParallelWallsWithAPlaneBetweenThem) {
  Model model(plate());
  ASSERT_TRUE(model.holds(both_walls()));
  EXPECT_FALSE(model.pieces().tested[0].empty());
  EXPECT_FALSE(model.pieces().tested[1].empty());
  for (const PieceForest::Id id : model.pieces().held)
    EXPECT_TRUE(is_inside(model.forest().node(id).hull, model.scaled(both_walls()).box));
  // Signs may be exchanged together with the separator's, and more separators than needed do no harm.
  SheetBox other = both_walls();
  other.separators.push_back(separator(1, {0, 0, kGap / 2}, kGap, {0, -1, 0, 0}));
  other.sheets[0].signs.push_back(kMinus), other.sheets[1].signs.push_back(kNone);
  EXPECT_TRUE(model.holds(other));
  other.sheets[0].signs[0] = kNone;  // now no separator keeps them apart
  EXPECT_FALSE(model.holds(other));
  other.sheets[1].signs[1] = kPlus;
  EXPECT_TRUE(model.holds(other));
  EXPECT_FALSE(model.holds(both_walls(), 1));  // two pieces are needed
}

// Everything but the signs holds: each wall has its own centres.
TEST(SheetBox, RefusesSheetsThatNoSeparatorKeepsApart) {
  Model model(plate());
  SheetBox box = both_walls();
  box.separators[0].coefficients = {1, 0, 0, 0};
  for (const std::array<Sign, 2>& signs : {std::array{kPlus, kPlus}, std::array{kNone, kPlus},
                                           std::array{kPlus, kNone}, std::array{kNone, kNone}}) {
    for (std::size_t i = 0; i < 2; ++i) box.sheets[i].signs[0] = signs[i];
    EXPECT_FALSE(model.holds(box)) << to_int(signs[0]) << ", " << to_int(signs[1]);
  }
  box.separators.clear();
  for (Sheet& s : box.sheets) s.signs.clear();
  EXPECT_FALSE(model.holds(box));
  // Opposite signs of different separators are no difference.
  box.separators = {separator(1, {0, 0, 0}, 1, {1, 0, 0, 0}),
                    separator(1, {0, 0, 0}, 1, {-1, 0, 0, 0})};
  box.sheets[0].signs = {kPlus, kNone}, box.sheets[1].signs = {kNone, kMinus};
  EXPECT_FALSE(model.holds(box));
}

// The signs are opposite and the centres right.
TEST(SheetBox, RefusesSheetsOnTheWrongSideOfASeparator) {
  Model model(plate());
  SheetBox box = both_walls();
  std::swap(box.sheets[0].signs, box.sheets[1].signs);
  EXPECT_FALSE(model.holds(box));
  const SheetSeparator plane = both_walls().separators[0];
  for (const double z : {0.0, kGap, 2 * kGap, -kGap}) {  // it lies in a wall, or beyond one
    box = both_walls();
    box.separators[0].origin[2] = z;
    EXPECT_FALSE(model.holds(box)) << z;
  }
  box = both_walls();
  box.separators[0].coefficients = {0, 1, 1, 0};  // a plane that meets both walls
  EXPECT_FALSE(model.holds(box));
  box = both_walls();
  box.separators.push_back(plane);  // a second separator that one sheet has with a wrong sign
  for (Sheet& s : box.sheets) s.signs.push_back(s.signs[0]);
  EXPECT_TRUE(model.holds(box));
  box.sheets[1].signs[1] = kPlus;
  EXPECT_FALSE(model.holds(box));
}

TEST(SheetBox, RefusesCentresThatAreExchangedOrOfTheOtherSheet) {
  Model model(plate());
  for (std::size_t i = 0; i < 2; ++i) {
    SheetBox box = both_walls();
    std::swap(box.sheets[i].inside, box.sheets[i].outside);
    EXPECT_FALSE(model.holds(box)) << i;
    box = both_walls();
    box.sheets[i].inside[2] = (i == 0 ? 1.5 : -0.5) * kGap;  // both centres on one side
    EXPECT_FALSE(model.holds(box)) << i;
  }
}

// The line between the centres crosses the sheet once, but a wall beside it is seen from the wrong side: from outside at
// a convex edge, from inside at a concave edge.
TEST(SheetBox, RefusesACentreThatSeesAnotherWallFromTheWrongSide) {
  Model cube(patch_shapes::blocks({{0, 0, 0}}));
  SheetBox box;
  box.box = {{0.25, 0.25, 0.25}, {1.75, 0.75, 1.75}};
  box.sheets = {{{0.5, 0.5, 0.5}, {1.25, 0.5, 1.25}, {}}};
  EXPECT_TRUE(cube.holds(box));
  box.sheets[0].outside = {0.75, 0.5, 1.25};
  EXPECT_FALSE(cube.holds(box));
  Model corner(patch_shapes::blocks({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}));
  box.sheets = {{{0.5, 0.5, 0.5}, {1.5, 0.5, 1.5}, {}}};
  EXPECT_TRUE(corner.holds(box));
  box.sheets[0].inside = {0.5, 0.5, 1.25};
  EXPECT_FALSE(corner.holds(box));
}

TEST(SheetBox, RefusesCentresOnTheBorderOfTheBoxOrBeyondIt) {
  Model model(plate());
  for (const double z : {0.25, 0.5})
    for (std::size_t i = 0; i < 2; ++i)
      for (const bool is_inside : {false, true}) {
        SheetBox box = both_walls();
        Point3d& c = is_inside ? box.sheets[i].inside : box.sheets[i].outside;
        c[2] = c[2] < 0 ? -z : z;
        EXPECT_FALSE(model.holds(box)) << z << ", sheet " << i;
        c[2] *= 0.9375 * 0.25 / z;
        EXPECT_TRUE(model.holds(box)) << z << ", sheet " << i;
      }
}

// Parts of two spheres about the origin with the radii 1 and 63/64; a sphere between them.
SheetBox two_spheres() {
  SheetBox out;
  const double m = 0.5625, c = 0.125;
  out.box = {{m - 0.25, m - 0.25, m - 0.25}, {m + 0.25, m + 0.25, m + 0.25}};
  const Point3d low{m - c, m - c, m - c}, high{m + c, m + c, m + c};
  out.sheets = {{low, high, {kPlus}}, {high, low, {kMinus}}};
  // 256 (x^2 + y^2 + z^2) - 252
  out.separators = {separator(2, {0, 0, 0}, 0x1p-4, {-252, 0, 1, 0, 0, 1, 0, 0, 0, 1})};
  return out;
}
Patches spheres(const Rational& inner) {
  const Patches ball = patch_shapes::octant_sphere();
  return patch_shapes::joined({ball, patch_shapes::reversed(patch_shapes::placed(
                                         ball, inner, {ratio(0), ratio(0), ratio(0)}))});
}

TEST(SheetBox, AcceptsTwoConcentricSpheresWithASphereBetweenThem) {
  Model model(spheres(ratio(63, 64)));
  EXPECT_TRUE(model.holds(two_spheres()));
  SheetBox box = two_spheres();
  for (const std::int64_t constant :
       {-256, -248, -260, -240}) {  // spheres that meet a wall, or none
    box.separators[0].coefficients[0] = constant;
    EXPECT_FALSE(model.holds(box)) << constant;
  }
  Model touching(spheres(ratio(1)));
  EXPECT_FALSE(touching.holds(two_spheres()));
}

// x -> M x / 3, where M M^T = 9.
constexpr std::array<std::array<int, 3>, 3> kTurn{{{2, -1, 2}, {2, 2, -1}, {-1, 2, 2}}};
Patches turned(Patches patches) {
  for (Patch& p : patches) {
    Patch::Tensor map = p.tensor();
    for (std::size_t i = 0; i < p.num_control(); ++i) {
      std::array<Rational, 3> x;
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
          x[r] += ratio(kTurn[r][c], 3) * p.component(static_cast<int>(c))[i];
      for (std::size_t r = 0; r < 3; ++r) map.component(static_cast<int>(r))[i] = x[r];
    }
    p = make_patch(std::move(map), p.origin()).value();
  }
  return patches;
}
Point3d turned(const Point3d& x) {
  Point3d out{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) out[r] += kTurn[r][c] * x[c] / 3;
  return out;
}
// The frame in which the turned x is 3 x.
BoxFrame turned_back(int sign = 1) {
  BoxFrame::Rows rows;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) rows[r][c] = kTurn[c][r] * (r == 2 ? sign : 1);
  return BoxFrame::make(rows).value();
}
// The upper wall of the turned plate alone: the box ends in its middle.
SheetBox upper_wall() {
  SheetBox out;
  out.frame = turned_back();
  out.box = {{-0.75, -0.75, 1.5 * kGap}, {0.75, 0.75, 4.5 * kGap}};
  out.sheets = {{turned({0, 0, 0.625 * kGap}), turned({0, 0, 1.375 * kGap}), {}}};
  return out;
}

TEST(SheetBox, AcceptsAWallOfAPlateInATurnedFrame) {
  Model model(turned(plate()));
  EXPECT_TRUE(model.holds(upper_wall()));
  SheetBox box = upper_wall();
  box.box.lo[2] = -1.5 * kGap;  // the lower wall, too
  EXPECT_FALSE(model.holds(box));
  box = upper_wall();
  box.frame = BoxFrame();  // along the axes
  EXPECT_FALSE(model.holds(box));
  // Both walls.
  SheetBox both = both_walls();
  both.frame = turned_back();
  for (double* const v : {&both.box.lo[0], &both.box.hi[0]})
    for (std::size_t k = 0; k < 3; ++k) v[k] *= 3;
  for (Sheet& s : both.sheets) s.inside = turned(s.inside), s.outside = turned(s.outside);
  both.separators[0].origin = turned(both.separators[0].origin);
  both.separators[0].coefficients = {0, 2, -1,
                                     2};  // y3, y2, y1 along the third column of the matrix
  EXPECT_TRUE(model.holds(both));
  both.separators[0].coefficients = {0, 2, 2, -1};
  EXPECT_FALSE(model.holds(both));
}

// S1 is a condition in the model's coordinates: a frame that mirrors changes neither truth nor lies.
TEST(SheetBox, DoesNotDependOnTheHandOfAFrame) {
  Model model(turned(plate())), inside_out(patch_shapes::reversed(turned(plate())));
  for (const int sign : {1, -1}) {
    SheetBox box = upper_wall();
    box.frame = turned_back(sign);
    if (sign < 0) box.box.lo[2] = -4.5 * kGap, box.box.hi[2] = -1.5 * kGap;
    EXPECT_TRUE(model.holds(box)) << sign;
    EXPECT_FALSE(inside_out.holds(box)) << sign;
    std::swap(box.sheets[0].inside, box.sheets[0].outside);
    EXPECT_TRUE(inside_out.holds(box)) << sign;
    EXPECT_FALSE(model.holds(box)) << sign;
  }
}

// The centre is in the box around the framed one, and sees what it should.
TEST(SheetBox, RefusesACentreOutsideOfTheFramedBox) {
  Model model(turned(plate()));
  for (const double depth : {1.5, 1.625, 4.0}) {
    SheetBox box = upper_wall();
    box.sheets[0].outside = turned({0, 0, depth * kGap});
    ASSERT_TRUE(
        is_inside(Box3d{box.sheets[0].outside, box.sheets[0].outside}, box.frame.around(box.box)));
    EXPECT_FALSE(model.holds(box)) << depth;
  }
  SheetBox box = upper_wall();
  box.sheets[0].inside = turned({0, 0, 0.5 * kGap});  // on the border
  EXPECT_FALSE(model.holds(box));
}

// Three walls over each other are one sheet that is folded like a Z: the line through them crosses it once, in all.
TEST(SheetBox, RefusesAFold) {
  Model model(patch_shapes::blocks({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, 2}, {1, 0, 2}}));
  SheetBox box;
  box.box = {{1.25, 0.25, 0.25}, {1.75, 0.75, 2.75}};
  const Point3d low{1.5, 0.5, 0.5}, high{1.5, 0.5, 2.625};
  box.sheets = {{low, high, {}}};
  // The walls z = 1 and z = 2: a sheet that is folded once.
  EXPECT_FALSE(model.holds(box));
  box.box.hi[2] = 3.75;
  box.sheets[0].outside[2] = 3.5;
  EXPECT_FALSE(model.holds(box));
}

// Plates over each other: the walls z = 1, 2, 3 in one box.
class ThreeWalls : public testing::Test {
 protected:
  static Patches patches() {
    return patch_shapes::joined(
        {patch_shapes::box({ratio(0), ratio(0), ratio(0)}, {ratio(3), ratio(3), ratio(1)}),
         patch_shapes::box({ratio(0), ratio(0), ratio(2)}, {ratio(3), ratio(3), ratio(3)})});
  }
  static SheetBox box() {
    SheetBox out;
    out.box = {{1, 1, 0.5}, {2, 2, 3.5}};
    return out;
  }
  static constexpr Point3d kLow{1.5, 1.5, 0.75}, kHigh{1.5, 1.5, 3.25};
  Model model_{patches()};
};

TEST_F(ThreeWalls, AreThreeSheets) {
  SheetBox box = this->box();
  box.sheets = {{kLow, kHigh, {kMinus, kNone}},
                {kHigh, kLow, {kPlus, kMinus}},
                {kLow, kHigh, {kNone, kPlus}}};
  box.separators = {separator(1, {0, 0, 1.5}, 1, {0, 1, 0, 0}),
                    separator(1, {0, 0, 2.5}, 1, {0, 1, 0, 0})};
  EXPECT_FALSE(model_.holds(box));  // no separator has opposite signs of the first and the third
  box.sheets[2].signs = {kPlus, kPlus};
  EXPECT_TRUE(model_.holds(box));
  box.sheets.pop_back();
  EXPECT_FALSE(model_.holds(box));  // the third wall belongs to no sheet
}

// Every piece belongs to its sheet, but one sheet consists of two walls.
TEST_F(ThreeWalls, AreNotTwoSheets) {
  SheetBox box = this->box();
  // (y3 - 3/2) (5/2 - y3) * 4 = -15 + 16 y3 - 4 y3^2
  box.separators = {separator(2, {0, 0, 0}, 1, {-15, 16, -4, 0, 0, 0, 0, 0, 0, 0})};
  for (const bool is_first : {false, true}) {
    box.sheets = {{kHigh, kLow, {kPlus}}, {kLow, kHigh, {kMinus}}};
    if (is_first) std::swap(box.sheets[0], box.sheets[1]);
    EXPECT_FALSE(model_.holds(box)) << is_first;
  }
  // A box that ends below the third wall has two.
  box.box.hi[2] = 2.875;
  box.sheets[0].outside[2] = box.sheets[1].inside[2] = 2.75;
  EXPECT_TRUE(model_.holds(box));
  // A sheet that is nowhere crosses its line 0 times.
  box.box.hi[2] = 1.75;
  box.sheets[0].outside[2] = box.sheets[1].inside[2] = 1.625;
  EXPECT_FALSE(model_.holds(box));
}

// Two blocks whose tops z = x / 10 and z = 1/50 - x / 10 cross: seen from the centres every top is a graph.
TEST(SheetBox, RefusesSheetsThatCross) {
  const auto wedge = [](const Rational& slope, const Rational& height) {
    Patches block =
        patch_shapes::box({ratio(-1), ratio(-1), ratio(-2)}, {ratio(1), ratio(1), ratio(0)});
    for (Patch& p : block)
      for (std::size_t i = 0; i < p.num_control(); ++i)
        p = with_coefficient(p, 2, i, p.component(2)[i] + slope * p.component(0)[i] + height);
    return block;
  };
  SheetBox box;
  box.box = {{-0.125, -0.125, -0.125}, {0.125, 0.125, 0.125}};
  box.sheets = {{{0, 0, -0.1015625}, {0, 0, 0.1015625}, {}}};
  Model one(wedge(ratio(1, 10), ratio(0)));
  EXPECT_TRUE(one.holds(box));
  Model two(
      patch_shapes::joined({wedge(ratio(1, 10), ratio(0)), wedge(ratio(-1, 10), ratio(1, 50))}));
  EXPECT_FALSE(two.holds(box));
  // As two sheets: no polynomial tells them apart.
  box.sheets = {box.sheets[0], box.sheets[0]};
  box.sheets[0].signs = {kPlus}, box.sheets[1].signs = {kMinus};
  for (const std::vector<std::int64_t>& q :
       {std::vector<std::int64_t>{-1, 100, 0, 0}, {0, 0, 0, 1}, {-1, 100, 0, 10}, {0, 1, 0, 0}}) {
    box.separators = {separator(1, {0, 0, 0}, 1, q)};
    EXPECT_FALSE(two.holds(box));
  }
}

TEST(SheetBox, WithoutASheetIsOurBug) {
  Model model(plate());
  SheetBox box = both_walls();
  box.sheets.clear();
  EXPECT_THROW((void)model.holds(box), InternalError);
}

}  // namespace
}  // namespace veritope
