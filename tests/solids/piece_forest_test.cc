// SPDX-License-Identifier: LGPL-3.0-or-later
// What every node of a PieceForest says, to some depth, against the same pieces in rationals.
#include "solids/pieces/piece_forest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solids/pieces/crossing_number.h"
#include "solids/pieces/exact_piece.h"
#include "solids/pieces/find_pieces.h"
#include "tests/solids/exact_nodes.h"

namespace veritope {
namespace {

using Sides = std::array<bool, 4>;
using Id = PieceForest::Id;

RationalNet determinants_of(const RationalNet& control) {
  const auto forms =
      determinant_form<Rational>(control.shape, control.components == 4, control.values.data());
  RationalNet out{determinant_shape(control.shape), 4, {}};
  for (const Numbers& form : forms) out.values.insert(out.values.end(), form.begin(), form.end());
  return out;
}

// Calls visit(id, control, determinants, on_side) for all roots, for their children, and for some nodes below them;
// on_side: which sides of the node lie in those of its patch.
template <typename Visit>
class Walk {
 public:
  Walk(PieceForest& forest, Random& random, Visit visit)
      : forest_(forest), random_(random), visit_(visit) {}

  void run(int depth) {
    {
      constexpr std::uint32_t p = 0;  // the other patch is the same sheet, reversed
      const PieceForest::Form& form = forest_.form(p);
      const RationalNet control = control_of(forest_, p), determinants = determinants_of(control);
      const std::uint32_t columns = 1u << form.root_bits[1], rows = 1u << form.root_bits[0];
      ASSERT_EQ(form.num_roots, rows * columns);
      for (std::uint32_t r = 0; r < form.num_roots; ++r) {
        const std::array<std::uint32_t, 2> place{r / columns, r % columns};
        const Sides on_side = form.shape.is_triangle
                                  ? Sides{true, true, true, false}
                                  : Sides{place[1] == 0, place[0] + 1 == rows,
                                          place[1] + 1 == columns, place[0] == 0};
        down(form.first_root + r, root_of(control, form, place), root_of(determinants, form, place),
             on_side, depth);
      }
    }
  }

 private:
  static RationalNet root_of(RationalNet net, const PieceForest::Form& form,
                          const std::array<std::uint32_t, 2>& place) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (int bit = form.root_bits[axis]; bit-- > 0;)
        net = half_of(net, axis, (place[axis] >> bit & 1) != 0);
    return net;
  }
  void down(Id id, const RationalNet& control, const RationalNet& determinants, const Sides& on_side,
            int depth) {
    visit_(id, control, determinants, on_side);
    if (depth == 0) return;
    const Id first = forest_.children(id);
    EXPECT_EQ(forest_.children(id), first);
    for (Id k = 0; k < 4; ++k) {
      EXPECT_EQ(forest_.node(first + k).parent, id);
      EXPECT_EQ(forest_.node(first + k).level, forest_.node(id).level + 1);
    }
    // One child, and none of the others twice.
    const auto k = static_cast<Id>(random_.below(4));
    const std::array<bool, 4> is_near =
        control.shape.is_triangle
            ? std::array<bool, 4>{k == 0 || k == 1, k == 1 || k == 2, k == 2 || k == 0, false}
            : std::array<bool, 4>{k % 2 == 0, k / 2 == 1, k % 2 == 1, k / 2 == 0};
    Sides sides{};
    for (std::size_t s = 0; s < 4; ++s) sides[s] = on_side[s] && is_near[s];
    down(first + k, quarter_of(control, k), quarter_of(determinants, k), sides, depth - 1);
  }

  PieceForest& forest_;
  Random& random_;
  Visit visit_;
};

template <typename Visit>
void walk(PieceForest& forest, Random& random, int depth, Visit visit) {
  Walk<Visit>(forest, random, visit).run(depth);
}

struct Subject {
  FormShape shape;
  unsigned collapsed = 0;
  int stretch = 1;
};
std::vector<Subject> tensors() {
  return {{{false, 1, 1}},    {{false, 2, 1}},    {{false, 1, 3}, 0, 3}, {{false, 2, 2}, 1},
          {{false, 2, 1}, 2}, {{false, 1, 2}, 4}, {{false, 2, 2}, 8},    {{false, 2, 2}, 5},
          {{false, 2, 2}, 3}, {{false, 2, 2}, 6}, {{false, 2, 2}, 9}};
}
std::vector<Subject> triangles() {
  return {{{true, 1, 0}},    {{true, 2, 0}},    {{true, 3, 0}},   {{true, 2, 0}, 1},
          {{true, 2, 0}, 2}, {{true, 2, 0}, 4}, {{true, 3, 0}, 3}};
}

void expect_pieces(const std::vector<Subject>& subjects, bool is_rational) {
  constexpr std::uint64_t kSeed = 21;
  Random random(kSeed);
  for (const Subject& subject : subjects) {
    const Patch sheet =
        bent_sheet(subject.shape, is_rational, subject.collapsed, subject.stretch, random);
    const PatchComplex complex = both_sides(sheet);
    PieceForest forest = PieceForest::make(complex).value();
    walk(forest, random, 2,
         [&](Id id, const RationalNet& control, const RationalNet& determinants, const Sides& on_side) {
           SCOPED_TRACE(testing::Message()
                        << "seed " << kSeed << ", subject " << &subject - subjects.data()
                        << (is_rational ? ", rational" : "") << ", node " << id);
           const PieceForest::Node& node = forest.node(id);
           const Point3d origin = forest.form(node.patch).origin;
           const ExactPiece piece(forest, node);
           Box3d tight = piece.hull();
           const double* const net = forest.control(id);
           const std::size_t n = control.shape.count();
           for (std::size_t k = 0; k < 3; ++k) {
             Rational least, greatest;
             for (std::size_t i = 0; i < n; ++i) {
               const Rational w = is_rational ? control.at(3, i) : Rational(1);
               const Rational x = control.at(k, i) / w + from(origin[k]);
               const auto p = piece.control(i);
               ASSERT_EQ(Rational(*p[k], *p[3]), x) << "integers, point " << i;
               if (i == 0 || x < least) least = x;
               if (i == 0 || greatest < x) greatest = x;
             }
             EXPECT_TRUE(from(tight.lo[k]) <= least && greatest <= from(tight.hi[k]));
             EXPECT_TRUE(from(node.hull.lo[k]) <= least && greatest <= from(node.hull.hi[k]));
             const Rational narrow = Rational::power_of_two(-44);
             EXPECT_TRUE(is_within(from(node.hull.lo[k]), least, narrow));
             EXPECT_TRUE(is_within(from(node.hull.hi[k]), greatest, narrow));
             EXPECT_TRUE(is_within(from(tight.lo[k]), least, Rational::power_of_two(-52)));
             EXPECT_TRUE(is_within(from(tight.hi[k]), greatest, Rational::power_of_two(-52)));
           }
           for (std::size_t c = 0; c < static_cast<std::size_t>(control.components); ++c) {
             EXPECT_LE(forest.control_error(id, c), 0x1p-46);
             for (std::size_t i = 0; i < n; ++i)
               EXPECT_TRUE(is_within(from(net[c * n + i]), control.at(c, i),
                                     from(forest.control_error(id, c))))
                   << "control " << c << ", " << i;
           }
           const double* const g = forest.approx_determinants(id);
           const std::size_t m = determinants.shape.count();
           for (std::size_t c = 0; c < 4; ++c) {
             EXPECT_LE(forest.determinant_error(id, c), 0x1p-38 * subject.stretch);
             for (std::size_t i = 0; i < m; ++i)
               EXPECT_TRUE(is_within(from(g[c * m + i]), determinants.at(c, i),
                                     from(forest.determinant_error(id, c))))
                   << "determinant " << c << ", " << i;
           }
           for (std::uint32_t s = 0; s < complex.patch(node.patch).num_sides(); ++s)
             EXPECT_EQ(forest.side_of_patch(node, s), on_side[s]) << "side " << s;
         });
  }
}

TEST(PieceForestNodes, OfTensorsHoldTheirPiecesWithinNarrowBounds) {
  expect_pieces(tensors(), false);
}
TEST(PieceForestNodes, OfRationalTensorsHoldTheirPiecesWithinNarrowBounds) {
  expect_pieces(tensors(), true);
}
TEST(PieceForestNodes, OfTrianglesHoldTheirPiecesWithinNarrowBounds) {
  expect_pieces(triangles(), false);
}
TEST(PieceForestNodes, OfRationalTrianglesHoldTheirPiecesWithinNarrowBounds) {
  expect_pieces(triangles(), true);
}

// The places of the coefficients beside the node's collapsed sides; nothing if two of those share a corner.
std::optional<std::vector<std::size_t>> kept_of(const Patch& patch, const RationalNet& control,
                                                const FormShape& d) {
  const std::uint32_t n = patch.num_sides();
  Sides is_point{};
  for (std::uint32_t s = 0; s < n; ++s) {
    is_point[s] = true;
    for (std::size_t t = 1; t < patch.side_length(s); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t a = patch.side_index(s, 0), b = patch.side_index(s, t);
        const auto x = [&](std::size_t i) {
          return control.components == 4 ? control.at(k, i) / control.at(3, i) : control.at(k, i);
        };
        is_point[s] = is_point[s] && x(a) == x(b);
      }
  }
  for (std::uint32_t s = 0; s < n; ++s)
    if (is_point[s] && is_point[(s + 1) % n]) return std::nullopt;
  std::vector<std::size_t> out;
  const auto keep = [&](std::size_t at, const Sides& in) {
    bool is_kept = true;
    for (std::size_t s = 0; s < 4; ++s) is_kept = is_kept && !(in[s] && is_point[s]);
    if (is_kept) out.push_back(at);
  };
  if (d.is_triangle)
    for_each_triangle_index(d.p, [&](int i, int j, int k) {
      keep(triangle_index(j, k), {k == 0, i == 0, j == 0, false});
    });
  else
    for (int i = 0; i <= d.p; ++i)
      for (int j = 0; j <= d.q; ++j)
        keep(static_cast<std::size_t>(i * (d.q + 1) + j), {j == 0, i == d.p, j == d.q, i == 0});
  return out;
}

void expect_sides(const std::vector<Subject>& subjects, bool is_rational) {
  constexpr std::uint64_t kSeed = 23;
  Random random(kSeed);
  std::array<int, 3> seen{};
  for (const Subject& subject : subjects) {
    const Patch sheet =
        bent_sheet(subject.shape, is_rational, subject.collapsed, subject.stretch, random);
    const PatchComplex complex = both_sides(sheet);
    PieceForest forest = PieceForest::make(complex).value();
    walk(forest, random, 2,
         [&](Id id, const RationalNet& control, const RationalNet& determinants, const Sides&) {
           const PieceForest::Node& node = forest.node(id);
           const PieceForest::Form& form = forest.form(node.patch);
           const auto kept = kept_of(complex.patch(node.patch), control, determinants.shape);
           for (int trial = 0; trial < 8; ++trial) {
             const Box3d hull = forest.node(id).hull;
             Point3d c = approx_centre(hull);
             // In the middle, beside the piece on either side, or at a corner, where one coefficient is 0 but for rounding.
             const std::size_t corner =
                 complex.patch(node.patch).side_index(static_cast<std::uint32_t>(trial % 3), 0);
             for (std::size_t k = 0; k < 3; ++k) {
               if (trial < 2)
                 c[k] = nearest_double(control.at(k, corner) /
                                           (is_rational ? control.at(3, corner) : Rational(1)) +
                                       from(form.origin[k]));
               else
                 c[k] += (trial < 5 ? 1.0 : 4.0) * extent(hull) * (random.unit() - 0.5);
             }
             Sign3 expected = Sign3::kUncertain;
             if (kept && !kept->empty()) {
               std::optional<Sign> common;
               bool is_one = true;
               for (const std::size_t i : *kept) {
                 Rational g = determinants.at(0, i);
                 for (std::size_t k = 0; k < 3; ++k)
                   g += determinants.at(k + 1, i) * (from(c[k]) - from(form.origin[k]));
                 is_one =
                     is_one && g.sign() != Sign::kZero && g.sign() == common.value_or(g.sign());
                 common = g.sign();
               }
               if (is_one)
                 expected = *common == Sign::kPositive ? Sign3::kPositive : Sign3::kNegative;
             }
             ++seen[expected == Sign3::kPositive ? 2 : expected == Sign3::kNegative ? 1 : 0];
             EXPECT_EQ(forest.side_of(id, c), expected)
                 << "seed " << kSeed << ", subject " << &subject - subjects.data()
                 << (is_rational ? ", rational" : "") << ", node " << id << ", trial " << trial;
           }
         });
  }
  for (const int n : seen) EXPECT_GT(n, 10);
}

TEST(PieceForestNodes, OfTensorsHaveTheSideThatTheirExactCoefficientsHave) {
  expect_sides(tensors(), false);
}
TEST(PieceForestNodes, OfRationalTensorsHaveTheSideThatTheirExactCoefficientsHave) {
  expect_sides(tensors(), true);
}
TEST(PieceForestNodes, OfTrianglesHaveTheSideThatTheirExactCoefficientsHave) {
  expect_sides(triangles(), false);
}
TEST(PieceForestNodes, OfRationalTrianglesHaveTheSideThatTheirExactCoefficientsHave) {
  expect_sides(triangles(), true);
}

// Once the budget of exact hulls is spent, nothing but the sign of the weights keeps a quotient by almost 0 out of a
// hull.
TEST(PieceForestNodes, StayInTheirHullsWhereWeightsAlmostVanishAndTheBudgetIsSpent) {
  const Rational zero, one(1), tiny = Rational::power_of_two(-80);
  const std::vector<Rational> values{zero, tiny, zero, zero, zero, tiny,
                                     zero, zero, tiny, one,  tiny, tiny};
  const PatchComplex complex = both_sides(make_patch(Patch::Triangle(1, 4, true, values)).value());
  PieceForest forest = PieceForest::make(complex).value();
  std::vector<Id> edge{forest.form(0).first_root};  // the nodes along the edge of tiny weights
  bool is_spent = false;
  for (int level = 1; level <= 16 && !is_spent; ++level) {
    std::vector<Id> next;
    for (const Id id : edge) {
      const Id first = forest.children(id);
      next.insert(next.end(), {first + 1, first + 2});
    }
    for (const std::size_t i : {std::size_t{0}, next.size() / 2, next.size() - 1}) {
      const Box3d& hull = forest.node(next[i]).hull;
      const Box3d exact = ExactPiece(forest, forest.node(next[i])).hull();
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_LE(hull.lo[c], exact.lo[c]) << "level " << level << ", node " << i;
        EXPECT_GE(hull.hi[c], exact.hi[c]) << "level " << level << ", node " << i;
      }
      is_spent = is_spent || !std::isfinite(hull.lo[0]);
    }
    edge = std::move(next);
  }
  EXPECT_TRUE(is_spent);
}

// The first corner of a root, in the coordinates of the forest, rounded.
Point3d corner_of_root(const PieceForest& forest, Id id) {
  const ExactPiece piece(forest, forest.node(id));
  const auto p = piece.control(0);
  Point3d out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = nearest_double(Rational(*p[k], *p[3]));
  return out;
}

// A budget that is spent on signs that do not exist leaves later signs uncertain.
TEST(PieceForestNodes, SayNothingInIntegersBeyondTheBudget) {
  const PatchComplex complex = complex_of(unit_box());
  PieceForest forest = PieceForest::make(complex).value();
  const auto corner = [&](Id id) { return corner_of_root(forest, id); };
  const Point3d c = corner(0);
  EXPECT_NE(forest.exact(1), nullptr);
  EXPECT_FALSE(forest.exact(1)->has_determinants());
  ASSERT_NE(forest.exact_determinants(2), nullptr);
  EXPECT_TRUE(forest.exact_determinants(2)->has_determinants());
  for (int k = 0; k < 20000; ++k) ASSERT_EQ(forest.side_of(0, c), Sign3::kUncertain);
  EXPECT_EQ(forest.exact(3), nullptr);
  EXPECT_EQ(forest.exact_determinants(3), nullptr);
  EXPECT_EQ(forest.side_of(3, corner(3)), Sign3::kUncertain);
  EXPECT_FALSE(forest.side_with_zeros(3, corner(3)));
  EXPECT_NE(forest.exact(1), nullptr);
  // A line through the corner is left undecided, too.
  CentreLine line{corner(3), corner(3)};
  for (const std::size_t k : {0, 1, 2}) {
    line.inside[k] -= 0.25;
    line.outside[k] += 0.25;
  }
  EXPECT_EQ(crossing_number(forest, {3}, line), std::nullopt);
}

// A unit box, whose roots come first, with a closed sheet beside it.
PatchComplex box_and_sheet(const Patch& sheet) {
  return complex_of(patch_shapes::joined({unit_box(), {sheet, reversed(sheet)}}));
}

TEST(PieceForestNodes, BesideCollapsedSidesHaveTheirSidesWithoutIntegers) {
  Random random(37);
  for (const unsigned collapsed : {1u, 2u, 4u, 8u}) {
    const PatchComplex complex =
        box_and_sheet(bent_sheet({false, 2, 3}, collapsed % 2 == 0, collapsed, 1, random));
    PieceForest fresh = PieceForest::make(complex).value();
    PieceForest spent = PieceForest::make(complex).value();
    const Point3d corner = corner_of_root(spent, 0);
    for (int k = 0; k < 20000; ++k) ASSERT_EQ(spent.side_of(0, corner), Sign3::kUncertain);
    ASSERT_EQ(spent.exact(3), nullptr);
    std::vector<Id> nodes;
    for (Id r = 0; r < fresh.form(6).num_roots; ++r) nodes.push_back(fresh.form(6).first_root + r);
    int certain = 0;
    for (std::size_t n = 0; n < nodes.size() && n < 40; ++n) {
      const Id first = fresh.children(nodes[n]);
      ASSERT_EQ(spent.children(nodes[n]), first);
      for (Id k = 0; k < 4; ++k) nodes.push_back(first + k);
      for (int trial = 0; trial < 8; ++trial) {
        const Box3d hull = fresh.node(nodes[n]).hull;
        Point3d c = approx_centre(hull);
        for (double& v : c) v += 8 * extent(hull) * (random.unit() - 0.5);
        const Sign3 expected = fresh.side_of(nodes[n], c);
        EXPECT_EQ(spent.side_of(nodes[n], c), expected) << "node " << nodes[n];
        const auto with_zeros = spent.side_with_zeros(nodes[n], c);
        EXPECT_EQ(with_zeros.has_value(), is_certain(expected)) << "node " << nodes[n];
        for (std::uint32_t s = 0; s < 4; ++s)
          certain += is_certain(expected) && (collapsed >> s & 1) != 0 &&
                     fresh.side_of_patch(fresh.node(nodes[n]), s);
      }
    }
    EXPECT_GT(certain, 10);
  }
}

// Doubles find two signs from the middle of a saddle; between two collapsed sides that share a corner none is asked for.
TEST(PieceForestNodes, CostNoIntegersWhereDoublesSayThatNoSideExists) {
  Random random(41);
  const Rational three(3), four(4), zero, one(1);
  const Patch saddle = make_patch(BezierSurface<Rational>({1, 1}, 3, false,
                                                          {three, three, four, four, zero, one,
                                                           zero, one, zero, zero, zero, one}))
                           .value();
  for (const unsigned collapsed : {0u, 3u, 6u, 9u}) {
    const PatchComplex complex = box_and_sheet(
        collapsed == 0 ? saddle : bent_sheet({false, 3, 3}, false, collapsed, 1, random));
    PieceForest forest = PieceForest::make(complex).value();
    const Id root = forest.form(6).first_root;
    Point3d c = approx_centre(forest.node(root).hull);
    if (collapsed == 0) {
      const Rational middle[3] = {Rational(7) / Rational(2), one / Rational(2), one / Rational(4)};
      for (std::size_t k = 0; k < 3; ++k) c[k] = nearest_double(forest.in_frame(k, middle[k]));
    } else {
      const Point3d n = forest.approx_normal(root);
      const double length = std::hypot(n[0], n[1], n[2]), far = 8 * extent(forest.node(root).hull);
      for (std::size_t k = 0; k < 3; ++k) c[k] += far * n[k] / length;
    }
    for (int k = 0; k < 20000; ++k) ASSERT_EQ(forest.side_of(root, c), Sign3::kUncertain);
    for (int k = 0; k < 20000; ++k) ASSERT_FALSE(forest.side_with_zeros(root, c));
    EXPECT_NE(forest.exact(3), nullptr) << collapsed;
  }
}

// From a point in its plane a face has no side. From the double nearest to a corner with other coordinates it has one,
// which only integers find, and no zeros.
TEST(PieceForestNodes, HaveASideWithZerosWhereSomeCoefficientIsNotZero) {
  const PatchComplex box = complex_of(unit_box());
  PieceForest flat = PieceForest::make(box).value();
  for (Id id = 0; id < flat.num_roots(); ++id)
    EXPECT_FALSE(flat.side_with_zeros(id, corner_of_root(flat, id)));
  const auto third = [](int n) { return Rational(n) / Rational(3 * 7); };
  Numbers values;
  for (const std::array<int, 3>& c : {std::array{5, 17, 8}, {11, 2, 29}, {20, 1, 4}})
    for (const int u : {0, 1})
      for (const int v : {0, 1}) values.push_back(third(c[0] + u * c[1] + v * c[2]));
  const PatchComplex complex =
      both_sides(make_patch(BezierSurface<Rational>({1, 1}, 3, false, values)).value());
  PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value();
  const Point3d c = corner_of_root(forest, 0);
  const auto side = forest.side_with_zeros(0, c);
  ASSERT_TRUE(side);
  EXPECT_EQ(side->sign == Sign::kPositive ? Sign3::kPositive : Sign3::kNegative,
            forest.side_of(0, c));
  EXPECT_TRUE(side->is_zero.empty());
}

// The first two coordinates of these patches are their parameters.
TEST(PieceForestNodes, KnowWhichOfTheirCornersLieOnSidesOfThePatch) {
  const auto z = [](int x, int y) { return Rational(x + 2 * y); };
  const Patch square = make_patch(BezierSurface<Rational>(
                                      {1, 1}, 3, false,
                                      {0, 0, 1, 1, 0, 1, 0, 1, z(0, 0), z(0, 1), z(1, 0), z(1, 1)}))
                           .value();
  Numbers values(9);
  const std::array<std::array<int, 2>, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};
  for_each_triangle_index(1, [&](int i, int j, int k) {
    const auto& at = corners[i == 1 ? 0 : j == 1 ? 1 : 2];
    const std::size_t n = triangle_index(j, k);
    values[n] = at[0], values[3 + n] = at[1], values[6 + n] = z(at[0], at[1]);
  });
  const Patch triangle = make_patch(Patch::Triangle(1, 3, false, values)).value();
  for (const Patch& patch : {square, triangle}) {
    const PatchComplex complex = both_sides(patch);
    PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value();
    std::vector<Id> nodes;
    for (Id r = 0; r < forest.form(0).num_roots; ++r) nodes.push_back(r);
    for (std::size_t k = 0; k < 21; ++k)
      for (Id c = 0; c < 4; ++c) nodes.push_back(forest.children(nodes[k]) + c);
    const std::uint32_t n = patch.num_sides();
    const Rational one = forest.in_frame(0, Rational(1));
    for (const Id id : nodes) {
      const ExactPiece piece(forest, forest.node(id));
      for (std::uint32_t corner = 0; corner < n; ++corner) {
        const auto p = piece.control(patch.side_index(corner, 0));
        const Rational x(*p[0], *p[3]), y(*p[1], *p[3]), zero;
        const std::array<bool, 4> is_on =
            n == 4 ? std::array<bool, 4>{y == zero, x == one, y == one, x == zero}
                   : std::array<bool, 4>{y == zero, x + y == one, x == zero, false};
        for (std::uint32_t s = 0; s < n; ++s)
          EXPECT_EQ(forest.is_on_side(forest.node(id), corner, s), is_on[s])
              << n << " sides, node " << id << ", corner " << corner << ", side " << s;
      }
    }
  }
}

// There are more such pieces than exact hulls in the budget.
TEST(PieceForestNodes, OfRationalTrianglesHaveBoundedHullsWithoutIntegers) {
  const PatchComplex complex = complex_of(patch_shapes::octant_sphere());
  PieceForest forest = PieceForest::make(complex).value();
  Id last = forest.num_roots();
  for (Id id = 0; last < 20000; ++id) last = forest.children(id) + 3;
  for (Id id = 0; id <= last; ++id) EXPECT_TRUE(std::isfinite(extent(forest.node(id).hull))) << id;
}

TEST(PieceForestNodes, HaveApproximateNormalsThatPointOutwards) {
  const PatchComplex complex = complex_of(unit_box());
  PieceForest forest = PieceForest::make(complex).value();
  const Point3d middle = approx_centre(hull_of_roots(forest));
  const auto sign = [](double v) { return (v > 0 ? 1 : 0) - (v < 0 ? 1 : 0); };
  for (const bool is_again : {false, true}) {
    for (Id id = 0; id < forest.num_roots(); ++id) {
      const Point3d n = forest.approx_normal(id), at = approx_centre(forest.node(id).hull);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(sign(n[k]), sign(at[k] - middle[k])) << id << (is_again ? ", again" : "");
      EXPECT_EQ(forest.approx_normal(id), n);
    }
    forest.limit_memory(0);
  }
}

TEST(PieceForestNodes, OfTheGreatestDegreeHaveDeterminants) {
  Random random(43);
  for (const FormShape& shape :
       {FormShape{false, kMaxPatchDegree, 1}, {false, 1, kMaxPatchDegree}}) {
    const PatchComplex complex = both_sides(bent_sheet(shape, false, 0, 1, random));
    PieceForest forest = PieceForest::make(complex).value();
    EXPECT_TRUE(std::isfinite(forest.approx_determinants(forest.children(0))[0]));
  }
}

}  // namespace
}  // namespace veritope
