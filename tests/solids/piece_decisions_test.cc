// SPDX-License-Identifier: LGPL-3.0-or-later
// The decisions of a PieceForest in doubles, where doubles without a bound would be wrong: against rationals.
#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "solids/interval_boxes/boundary_model.h"
#include "solids/patches/patch_transform.h"
#include "solids/pieces/crossing_number.h"
#include "solids/pieces/exact_piece.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using Vector = std::array<Rational, 3>;

Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector exactly(const Point3d& p) {
  return {Rational::from_double(p[0]), Rational::from_double(p[1]), Rational::from_double(p[2])};
}

// The image of the unit cube under a map whose coefficients no double holds.
struct Parallelepiped {
  Vector corner, edge[3];

  Parallelepiped(const Vector& p, const Vector& u, const Vector& v, const Vector& w)
      : corner(p), edge{u, v, w} {}
  explicit Parallelepiped(Random& random) {
    const auto third = [&](int lo, int hi) {
      return Rational(random.between(lo, hi)) / Rational(3 * 64);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = third(-64, 64);
      for (std::size_t e = 0; e < 3; ++e) edge[e][k] = third(e == k ? 150 : -40, e == k ? 200 : 40);
    }
  }
  Vector at(const Vector& t) const {
    Vector out = corner;
    for (std::size_t e = 0; e < 3; ++e)
      for (std::size_t k = 0; k < 3; ++k) out[k] += t[e] * edge[e][k];
    return out;
  }
  // The six faces of the unit box, moved; corners in the order of `bilinear`.
  Patches patches() const {
    Patches out;
    for (const Patch& face : unit_box()) {
      const Patch::Tensor& map = face.tensor();
      std::array<PatchPoint, 4> p;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t place = std::array<std::size_t, 4>{0, 2, 3, 1}[i];
        p[i] = at({map.component(0)[place], map.component(1)[place], map.component(2)[place]});
      }
      out.push_back(bilinear(p));
    }
    return out;
  }
};

Point3d rounded(const Vector& p) {
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}
Rational draw_part(Random& random) { return Rational(random.between(1, 99)) / Rational(100); }

// The forest's frame is exact; the test asks in its coordinates.
Vector in_frame(const PieceForest& forest, const Vector& p) {
  return {forest.in_frame(0, p[0]), forest.in_frame(1, p[1]), forest.in_frame(2, p[2])};
}

TEST(PieceDecisions, SidesOfPointsThatNearlyLieInAPlaneAreExactOnes) {
  constexpr std::uint64_t kSeed = 5;
  Random random(kSeed);
  int different = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Parallelepiped body(random);
    const PatchComplex complex = complex_of(body.patches());
    PieceForest forest = PieceForest::make(complex).value();
    for (std::uint32_t r = 0; r < forest.num_roots(); ++r) {
      const Patch& face = complex.patch(forest.node(r).patch);
      const auto vertex = [&](std::size_t i) {
        const Patch::Tensor& map = face.tensor();
        return in_frame(forest, {map.component(0)[i], map.component(1)[i], map.component(2)[i]});
      };
      const Vector a = vertex(0), u = minus(vertex(2), a), v = minus(vertex(1), a);
      Vector p = a;
      const Rational s = draw_part(random), t = draw_part(random);
      for (std::size_t k = 0; k < 3; ++k) p[k] += s * u[k] + t * v[k];
      const Point3d c = rounded(p);
      const Sign exact = dot(cross(u, v), minus(a, exactly(c))).sign();
      const Sign3 found = forest.side_of(r, c);
      EXPECT_EQ(found, exact == Sign::kZero       ? Sign3::kUncertain
                       : exact == Sign::kPositive ? Sign3::kPositive
                                                  : Sign3::kNegative)
          << "seed " << kSeed << ", trial " << trial << ", face " << r;
      // The sum that the bound guards, without it.
      const double* const g = forest.approx_determinants(r);
      const std::size_t n = forest.form(forest.node(r).patch).determinant.count();
      const Point3d& o = forest.form(forest.node(r).patch).origin;
      const double value =
          g[0] + (g[n] * (c[0] - o[0]) + g[2 * n] * (c[1] - o[1]) + g[3 * n] * (c[2] - o[2]));
      different += (value > 0) != (exact == Sign::kPositive);
    }
  }
  EXPECT_GT(different, 30);  // else the cases are too easy
}

// Two edges have proportional x and y, so one component of their faces' normals is 0: a difference of equal products
// that no double holds.
TEST(PieceDecisions, AComponentOfANormalThatIsZeroHasNoSign) {
  const auto q = [](int n, int d) { return Rational(n) / Rational(d); };
  int different = 0;
  for (int i = 1; i <= 24; ++i) {
    const Vector corner{q(1, 3), q(i, 7), q(0, 1)}, u{q(i, 3), q(1, 7), q(1, 5)},
        v{q(2 * i, 9), q(2, 21), q(1, 1)}, w{q(1, 11), q(-1, 1), q(1, 13)};
    BoundaryModel model =
        BoundaryModel::make(complex_of(Parallelepiped(corner, u, v, w).patches())).value();
    PieceForest& forest = model.forest();
    for (std::uint32_t r = 0; r < forest.num_roots(); ++r) {
      const Patch::Tensor& map = model.complex().patch(forest.node(r).patch).tensor();
      const auto vertex = [&](std::size_t n) {
        return Vector{map.component(0)[n], map.component(1)[n], map.component(2)[n]};
      };
      const Vector normal = cross(minus(vertex(2), vertex(0)), minus(vertex(1), vertex(0)));
      const auto signs = model.normal_signs(r);
      const double* const g = forest.approx_determinants(r);
      const std::size_t n = forest.form(forest.node(r).patch).determinant.count();
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(signs[k], to_int(normal[k].sign())) << i << ", face " << r << ", axis " << k;
        different += normal[k].sign() == Sign::kZero && g[(k + 1) * n] != 0;
      }
    }
  }
  EXPECT_GT(different, 10);  // else the cases are too easy
}

TEST(PieceDecisions, HullsContainCoordinatesThatRoundInward) {
  // Relative to the first control point these coordinates are doubles, without an error; added to it again
  // they round.
  for (const Rational& side : {Rational(1), Rational(-1)}) {
    Patches patches;
    const Rational one(1), tiny = Rational::power_of_two(-60);
    for (const Patch& face :
         patch_shapes::box({one, one, one}, {one + side * tiny, Rational(2), Rational(2)}))
      patches.push_back(face);
    const PatchComplex complex = make_patch_complex(patches, PatchOrientation::kAuto).value();
    PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value();
    for (PieceForest::Id id = 0; id < forest.num_roots(); ++id) {
      EXPECT_TRUE(is_inside(ExactPiece(forest, forest.node(id)).hull(), forest.node(id).hull))
          << id;
      const PieceForest::Id first = forest.children(id);
      for (PieceForest::Id k = 0; k < 4; ++k)
        EXPECT_TRUE(is_inside(ExactPiece(forest, forest.node(first + k)).hull(),
                              forest.node(first + k).hull))
            << id << ", " << k;
    }
  }
}

// Whether the line meets the inside of the parallelogram a, a + u, a + v: the sign of its passage, or
// nothing on its boundary.
std::optional<int> crossing(const Vector& a, const Vector& u, const Vector& v, const Vector& from,
                            const Vector& d) {
  const Vector n = cross(u, v);
  const Rational slope = dot(n, d);
  const Rational t = dot(n, minus(a, from)) / slope;
  Vector p = from;
  for (std::size_t k = 0; k < 3; ++k) p[k] += t * d[k];
  p = minus(p, a);
  const Rational s = dot(cross(p, v), n) / dot(n, n), r = dot(cross(u, p), n) / dot(n, n);
  const Rational one(1), zero;
  if (s < zero || one < s || r < zero || one < r) return 0;
  if (s == zero || s == one || r == zero || r == one) return std::nullopt;
  return slope.sign() == Sign::kPositive ? 1 : -1;
}

TEST(PieceDecisions, LinesThatPassNextToAnEdgeCrossTheRightFaces) {
  constexpr std::uint64_t kSeed = 7;
  Random random(kSeed);
  int inside = 0, outside = 0, undecided = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Parallelepiped body(random);
    const PatchComplex complex = complex_of(body.patches());
    PieceForest forest = PieceForest::make(complex).value();
    for (std::uint32_t r = 0; r < forest.num_roots(); ++r) {
      const Patch::Tensor& map = complex.patch(forest.node(r).patch).tensor();
      const auto vertex = [&](std::size_t i) {
        return in_frame(forest, {map.component(0)[i], map.component(1)[i], map.component(2)[i]});
      };
      const Vector a = vertex(0), u = minus(vertex(2), a), v = minus(vertex(1), a);
      Vector on_edge = a;
      const Rational s = draw_part(random);
      for (std::size_t k = 0; k < 3; ++k) on_edge[k] += s * u[k];
      CentreLine line;
      const Vector n = cross(u, v);
      for (std::size_t k = 0; k < 3; ++k) {
        const double aside = 0.2 * (random.unit() - 0.5), ahead = nearest_double(n[k]);
        line.inside[k] = nearest_double(on_edge[k]) - (ahead + aside);
        line.outside[k] = nearest_double(on_edge[k]) + 0.5 * (ahead + aside);
      }
      const Vector from = exactly(line.inside);
      const auto expected = crossing(a, u, v, from, minus(exactly(line.outside), from));
      if (!expected) continue;
      const auto found = crossing_number(forest, {r}, line);
      if (!found) {
        ++undecided;  // the budget of halvings is spent: nearer than 2^-60
        continue;
      }
      ++(*expected == 0 ? outside : inside);
      EXPECT_EQ(*found, *expected) << "seed " << kSeed << ", trial " << trial << ", face " << r;
    }
  }
  EXPECT_LT(undecided, 20);
  EXPECT_GT(inside, 50);
  EXPECT_GT(outside, 50);
}

// A flat piece as its corners, exactly.
struct FlatPiece {
  Vector a, u, v;
  bool is_triangle;

  FlatPiece(const PieceForest& forest, PieceForest::Id id) {
    const Patch& patch = forest.complex().patch(forest.node(id).patch);
    const ExactPiece piece(forest, forest.node(id));
    const auto corner = [&](std::uint32_t s) {
      const auto p = piece.control(patch.side_index(s, 0));
      return Vector{Rational(*p[0], *p[3]), Rational(*p[1], *p[3]), Rational(*p[2], *p[3])};
    };
    is_triangle = patch.is_triangle();
    a = corner(0), u = minus(corner(1), a), v = minus(corner(is_triangle ? 2 : 3), a);
  }
  // As `crossing`, of triangles, too.
  std::optional<int> crossed_by(const Vector& from, const Vector& d) const {
    const Vector n = cross(u, v);
    Vector p = from;
    const Rational slope = dot(n, d), t = dot(n, minus(a, from)) / slope;
    for (std::size_t k = 0; k < 3; ++k) p[k] += t * d[k];
    p = minus(p, a);
    const Rational s = dot(cross(p, v), n) / dot(n, n), r = dot(cross(u, p), n) / dot(n, n);
    const Rational one(1), zero, end = is_triangle ? one - r : one;
    if (s < zero || r < zero || end < s || one < r) return 0;
    if (s == zero || r == zero || s == end || r == one) return std::nullopt;
    return slope.sign() == Sign::kPositive ? 1 : -1;
  }
};

// The faces of a random tetrahedron, seen counterclockwise from outside.
Patches tetrahedron(Random& random) {
  const Parallelepiped body(random);
  const Rational zero, one(1);
  const PatchPoint o = body.at({zero, zero, zero}), x = body.at({one, zero, zero}),
                   y = body.at({zero, one, zero}), z = body.at({zero, zero, one});
  return {flat(o, y, x), flat(o, x, z), flat(o, z, y), flat(x, y, z)};
}

// The closed surface of flat triangles as before, under other maps: every vertex has a weight of its own.
Patches weighted(const Patches& patches, Random& random) {
  std::vector<std::pair<PatchPoint, Rational>> weights;
  const auto weight_of = [&](const PatchPoint& p) {
    for (const auto& [q, w] : weights)
      if (q == p) return w;
    weights.push_back({p, Rational(random.between(1, 9)) / Rational(7)});
    return weights.back().second;
  };
  Patches out;
  for (const Patch& patch : patches) {
    const Patch::Triangle& from = patch.triangle();
    Patch::Triangle map(1, 4, true);
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational w =
          weight_of({from.component(0)[i], from.component(1)[i], from.component(2)[i]});
      for (int c = 0; c < 3; ++c) map.component(c)[i] = w * from.component(c)[i];
      map.component(3)[i] = w;
    }
    out.push_back(make_patch(std::move(map)).value());
  }
  return out;
}

// Next to a corner the sides of a triangle with one short and two long sides are known with errors
// of unlike sizes: an end of a curve that is not known to lie on one side of the half-line must not
// be taken for either.
TEST(PieceDecisions, LinesThatPassNextToACornerCrossTheRightFaces) {
  constexpr std::uint64_t kSeed = 13;
  Random random(kSeed);
  int inside = 0, outside = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Parallelepiped body(random);
    const Rational zero, one(1), part = Rational::power_of_two(-random.between(0, 24));
    // The short side lies at either end of the corner under test.
    const bool is_first = random.below(2) == 0;
    const PatchPoint o = body.at({zero, zero, zero}),
                     x = body.at({is_first ? part : one, zero, zero}),
                     y = body.at({zero, is_first ? one : part, zero});
    const PatchPoint z = body.at({zero, zero, one});
    Patches patches{flat(o, x, y), flat(o, z, x), flat(o, y, z), flat(x, z, y)};
    if (trial % 2 == 1) patches = weighted(patches, random);
    const PatchComplex complex = complex_of(patches);
    PieceForest forest = PieceForest::make(complex).value();
    const FlatPiece piece(forest, forest.root(0));
    const Vector corner = trial % 3 == 0
                              ? piece.a
                              : minus(piece.a, minus(Vector{}, trial % 3 == 1 ? piece.u : piece.v));
    CentreLine line;
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = nearest_double(corner[k]) * (1 + std::ldexp(random.unit() - 0.5, -44));
      const double d = random.unit() - 0.5 + (k == 2 ? 1 : 0);
      line.inside[k] = at - d, line.outside[k] = at + 0.75 * d;
    }
    const Vector from = exactly(line.inside);
    const auto expected = piece.crossed_by(from, minus(exactly(line.outside), from));
    const auto found = crossing_number(forest, {forest.root(0)}, line);
    if (!expected || !found) continue;
    ++(*expected == 0 ? outside : inside);
    EXPECT_EQ(*found, *expected) << "seed " << kSeed << ", trial " << trial;
  }
  EXPECT_GT(inside, 20);
  EXPECT_GT(outside, 20);
}

// Takes the piece, or some of its children, into the union.
void take_some(PieceForest& forest, PieceForest::Id id, Random& random,
               std::vector<PieceForest::Id>* tested) {
  const auto choice = random.below(3);
  if (choice == 0 || forest.node(id).level == 3) {
    if (choice < 2) tested->push_back(id);
    return;
  }
  const PieceForest::Id first = forest.children(id);
  for (PieceForest::Id k = 0; k < 4; ++k) take_some(forest, first + k, random, tested);
}

TEST(PieceDecisions, UnionsOfPiecesAreCrossedAsOftenAsTheirParts) {
  constexpr std::uint64_t kSeed = 9;
  Random random(kSeed), weights(kSeed + 1);
  std::array<int, 5> seen{};  // by the crossing number + 2
  for (int trial = 0; trial < 18; ++trial) {
    Patches patches = trial % 3 == 0 ? Parallelepiped(random).patches() : tetrahedron(random);
    if (trial % 3 == 2) patches = elevated(patches, 1 + trial % 2);
    if (trial % 3 == 1 && trial % 2 == 0) patches = weighted(patches, weights);
    const PatchComplex complex = complex_of(patches);
    PieceForest forest = PieceForest::make(complex).value();
    std::vector<PieceForest::Id> tested;
    for (std::uint32_t r = 0; r < forest.num_roots(); ++r) take_some(forest, r, random, &tested);
    std::vector<FlatPiece> pieces;
    for (const PieceForest::Id id : tested) pieces.emplace_back(forest, id);
    const Box3d all = forest.node(forest.root(0)).hull;
    for (int attempt = 0; attempt < 6; ++attempt) {
      CentreLine line;
      for (std::size_t k = 0; k < 3; ++k) {
        const double middle = 0.5 * (all.lo[k] + all.hi[k]);
        line.inside[k] = middle + 0.3 * (random.unit() - 0.5);
        line.outside[k] = middle + 2 * (random.unit() - 0.5);
      }
      const Vector from = exactly(line.inside), d = minus(exactly(line.outside), from);
      int expected = 0;
      bool is_clear = true;
      for (const FlatPiece& piece : pieces) {
        const auto one = piece.crossed_by(from, d);
        is_clear = is_clear && one.has_value();
        expected += one.value_or(0);
      }
      if (!is_clear) continue;
      const auto found = crossing_number(forest, tested, line);
      ASSERT_TRUE(found.has_value()) << "seed " << kSeed << ", trial " << trial;
      EXPECT_EQ(*found, expected) << "seed " << kSeed << ", trial " << trial << ", attempt "
                                  << attempt;
      if (std::abs(expected) <= 2) ++seen[static_cast<std::size_t>(expected + 2)];
    }
  }
  EXPECT_GT(seen[1], 5);
  EXPECT_GT(seen[2], 5);
  EXPECT_GT(seen[3], 5);
}

// A triangle may be the mate of a tensor: their parameters run in opposite directions.
TEST(PieceDecisions, UnionsOfTrianglesAndQuadranglesAreCrossedAsOftenAsTheirParts) {
  constexpr std::uint64_t kSeed = 17;
  Random random(kSeed);
  int crossed = 0;
  for (int trial = 0; trial < 10; ++trial) {
    const Parallelepiped body(random);
    const Rational zero, one(1), half = Rational(1) / Rational(2);
    const PatchPoint a = body.at({zero, zero, zero}), b = body.at({one, zero, zero}),
                     c = body.at({one, one, zero}), d = body.at({zero, one, zero}),
                     top = body.at({half, half, one});
    Patches patches{flat(a, b, top), flat(b, c, top), flat(c, d, top), flat(d, a, top)};
    patches.insert(patches.begin() + trial % 5, reversed(bilinear({a, b, c, d})));
    const PatchComplex complex = complex_of(patches);
    ASSERT_TRUE(complex.is_closed_oriented_surface());
    PieceForest forest = PieceForest::make(complex).value();
    std::vector<PieceForest::Id> tested;
    for (std::uint32_t r = 0; r < forest.num_roots(); ++r) take_some(forest, r, random, &tested);
    std::vector<FlatPiece> pieces;
    for (const PieceForest::Id id : tested) pieces.emplace_back(forest, id);
    const Vector inner = in_frame(forest, body.at({half, half, half / Rational(2)}));
    // Lines along an axis, too: the projection is along the axis that the line runs along.
    for (std::size_t axis = 0; axis < 6; ++axis) {
      CentreLine line;
      for (std::size_t k = 0; k < 3; ++k) {
        line.inside[k] = nearest_double(inner[k]) + 0.05 * (random.unit() - 0.5);
        line.outside[k] = line.inside[k] + (axis < 3 && k != axis ? 0 : random.unit() - 0.5);
      }
      const Vector from = exactly(line.inside), d3 = minus(exactly(line.outside), from);
      int expected = 0;
      bool is_clear = true;
      for (const FlatPiece& piece : pieces) {
        if (dot(cross(piece.u, piece.v), d3).sign() == Sign::kZero) is_clear = false;
        if (!is_clear) break;
        const auto found = piece.crossed_by(from, d3);
        is_clear = found.has_value();
        expected += found.value_or(0);
      }
      if (!is_clear) continue;
      const auto found = crossing_number(forest, tested, line);
      ASSERT_TRUE(found.has_value()) << "seed " << kSeed << ", trial " << trial << ", " << axis;
      EXPECT_EQ(*found, expected) << "seed " << kSeed << ", trial " << trial << ", " << axis;
      crossed += expected == 0 ? 0 : 1;
    }
  }
  EXPECT_GT(crossed, 5);
}

// More stretches than integers may decide: doubles have to, whole and half ones.
TEST(PieceDecisions, LinesThroughManyPiecesNeedNoIntegers) {
  const Rational zero, one(1), length(64);
  const PatchComplex complex =
      complex_of(patch_shapes::box({zero, zero, zero}, {length, one, one}));
  PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value();
  for (std::uint32_t p = 0; p < forest.num_patches(); ++p) {
    const PieceForest::Form form = forest.form(p);
    if (form.num_roots != 64) continue;
    for (const bool has_halves : {false, true}) {
      // Every other column of pieces; and beside each, pieces of half its size along half of its side.
      std::vector<PieceForest::Id> tested;
      for (PieceForest::Id r = 0; r < form.num_roots; ++r) {
        const PieceForest::Id first = forest.children(form.first_root + r);
        const bool is_along_u = form.root_bits[0] != 0;
        for (PieceForest::Id k = 0; k < 4; ++k) {
          const bool is_odd = (is_along_u ? k / 2 : k % 2) == 1;
          if (!is_odd) {
            tested.push_back(first + k);
          } else if (has_halves) {
            const PieceForest::Id half = forest.children(first + k);
            for (PieceForest::Id h = 0; h < 4; ++h)
              if ((is_along_u ? h % 2 : h / 2) == 0) tested.push_back(half + h);
          }
        }
      }
      std::vector<FlatPiece> pieces;
      for (const PieceForest::Id id : tested) pieces.emplace_back(forest, id);
      for (const double across : {0.29, 0.81}) {
        for (const double along : {0.2, 63.3}) {
          const FlatPiece face(forest, form.first_root);
          const Vector n = cross(face.u, face.v);
          CentreLine line;
          const double unit = std::ldexp(1.0, forest.scale());
          std::size_t normal = 0;
          for (std::size_t k = 0; k < 3; ++k)
            if (n[k].sign() != Sign::kZero) normal = k;
          for (std::size_t k = 0; k < 3; ++k) {
            const double at = k == 0 ? along : across;
            const double tilt = k == 0 ? 0.003 : k == normal ? 0.5 : 0.007;
            const double middle = k == normal ? nearest_double(face.a[k]) / unit : at;
            line.inside[k] = (middle - tilt) * unit, line.outside[k] = (middle + tilt) * unit;
          }
          int expected = 0;
          const Vector from = exactly(line.inside), d = minus(exactly(line.outside), from);
          for (const FlatPiece& piece : pieces) {
            const auto one_of_them = piece.crossed_by(from, d);
            ASSERT_TRUE(one_of_them.has_value());
            expected += *one_of_them;
          }
          const auto found = crossing_number(forest, tested, line);
          ASSERT_TRUE(found.has_value()) << p << ", " << across << ", " << along << has_halves;
          EXPECT_EQ(*found, expected) << p << ", " << across << ", " << along << has_halves;
        }
      }
    }
  }
}

TEST(PieceDecisions, AClosedSurfaceIsCrossedOutwardsAsOftenAsInwards) {
  // With collapsed sides, which have no mate.
  for (const Patches& patches : {patch_shapes::octant_sphere(), patch_shapes::frustum(1, 0, 2)}) {
    const PatchComplex complex = complex_of(patches);
    PieceForest forest = PieceForest::make(complex).value();
    std::vector<PieceForest::Id> tested;
    for (std::uint32_t r = 0; r < forest.num_roots(); ++r) tested.push_back(forest.root(r));
    EXPECT_EQ(crossing_number(forest, tested, {{0.1, 0.2, 0.3}, {0.7, 1.1, 2.3}}), 0);
  }
}

}  // namespace
}  // namespace veritope
