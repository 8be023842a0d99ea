// SPDX-License-Identifier: LGPL-3.0-or-later
// Determinants of cells: their coefficients beside values in rationals, and what is decided about them.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

#include "solids/vmodel/jacobian_net.h"
#include "solids/vmodel/jacobian_sign.h"
#include "solids/vmodel/jacobian_tree_internal.h"
#include "solids/vmodel/piece_cutter.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_components.h"
#include "splines/bezier_domain.h"
#include "splines/de_casteljau.h"
#include "tests/support/v_cells.h"

namespace veritope {
namespace {

using v_cells::cube;
using v_cells::Point;

Rational q(std::int64_t p, std::int64_t d) { return Rational(p) / Rational(d); }

VModel model_of(std::vector<VVolume> cells, VOrientation orientation = VOrientation::kKeep) {
  return make_v_model(std::move(cells), orientation).value();
}
PieceCutter cutter_of(const VVolume& cell) {
  const VModel model = model_of({cell});
  return {cell, {model.breaks(0, 0), model.breaks(0, 1), model.breaks(0, 2)}};
}

// det J of a Bezier map at a point, times W^4.
Rational determinant_at(const BezierVolume<Rational>& map, const Point& at) {
  const auto weights = weight(map);
  const BezierVolume<Rational> points = numerators(map);
  const auto w = evaluate(weights, at)[0];
  const auto p = evaluate(points, at);
  std::array<Point, 3> d;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto dp = evaluate(derivative(points, a), at);
    const Rational dw = evaluate(derivative(weights, a), at)[0];
    for (std::size_t c = 0; c < 3; ++c) d[a][c] = w * dp[c] - dw * p[c];
  }
  Rational det;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    det += d[0][k] * (d[1][i] * d[2][j] - d[1][j] * d[2][i]);
  }
  return map.is_rational() ? det / (w * w) : det;  // w^6 det J over w^2
}

VVolume random_cell(Random& random, bool is_rational) {
  std::array<int, 3> degrees;
  for (int& p : degrees) p = static_cast<int>(1 + random.below(3));
  const auto at = [&](std::size_t i, std::size_t j, std::size_t k) {
    const auto noise = [&] { return q(random.between(-3, 3), 7); };
    return Point{Rational(i) + noise(), Rational(j) + noise(), Rational(k) + noise()};
  };
  if (!is_rational) return v_cells::polynomial(degrees, at);
  return v_cells::rational(degrees, at, [&](auto...) { return q(random.between(1, 9), 5); });
}
BezierVolume<Rational> bezier_of(const VVolume& cell) { return bezier_pieces(cell).pieces.front(); }

TEST(JacobianNet, ExactCoefficientsAreTheDeterminantUpToAFactor) {
  const std::uint64_t seed = 7;
  Random random(seed);
  for (int round = 0; round < 60; ++round) {
    const VVolume cell = random_cell(random, round % 2 == 1);
    const auto map = bezier_of(cell);
    const ExactJacobian net = exact_jacobian(cutter_of(cell).exact({0, 0, 0}));
    std::vector<Rational> values(net.values.begin(), net.values.end());
    std::array<int, 3> degrees;
    for (std::size_t a = 0; a < 3; ++a) degrees[a] = static_cast<int>(net.grid.size[a]) - 1;
    EXPECT_EQ(degrees[0], (round % 2 == 1 ? 4 : 3) * map.degree(0) - 1);
    const BezierVolume<Rational> n(degrees, 1, false, values);
    std::optional<Rational> factor;
    for (int i = 0; i < 4; ++i) {
      const Point at{q(random.between(0, 9), 9), q(random.between(0, 7), 7),
                     q(random.between(0, 8), 8)};
      const Rational truth = determinant_at(map, at), found = evaluate(n, at)[0];
      EXPECT_EQ(truth.sign(), jacobian_sign(cell, at)) << "seed " << seed << "\n"
                                                       << v_cells::text_of(cell);
      if (truth.sign() == Sign::kZero) {
        EXPECT_EQ(found.sign(), Sign::kZero);
        continue;
      }
      if (!factor) factor = found / truth;
      EXPECT_EQ(found / truth, *factor) << "seed " << seed << "\n" << v_cells::text_of(cell);
      EXPECT_EQ(factor->sign(), Sign::kPositive);
    }
  }
}

// The greatest ratio of rounded and exact coefficients to the bound; scaled so that both have one factor.
TEST(JacobianNet, RoundedCoefficientsKeepTheirBound) {
  const std::uint64_t seed = 11;
  Random random(seed);
  for (int round = 0; round < 120; ++round) {
    VVolume cell = random_cell(random, round % 2 == 1);
    if (round % 3 == 1)
      cell = v_cells::mapped(cell, [](Point p) {
        return Point{p[0] + Rational(1000), p[1] * q(1, 1024), p[2]};
      });
    if (round % 4 >= 2) cell = insert_knot(cell, 1, q(1, 3));
    const PieceCutter cutter = cutter_of(cell);
    for (std::size_t piece = 0; piece < cutter.grid().size[1]; ++piece) {
      const ExactJacobian exact = exact_jacobian(cutter.exact({0, piece, 0}));
      const RoundedJacobian rounded = rounded_jacobian(cutter.rounded({0, piece, 0}));
      ASSERT_EQ(exact.values.size(), rounded.values.size());
      // One factor for both, from the sums of absolute values: it is off by at most the error of each.
      Rational a, b;
      for (std::size_t i = 0; i < exact.values.size(); ++i) {
        const Rational r = Rational::from_double(rounded.values[i]);
        a += abs(Rational(exact.values[i]));
        b += abs(r);
      }
      const Rational factor = b / a, error = Rational::from_double(rounded.error);
      EXPECT_GT(rounded.error, 0);
      for (std::size_t i = 0; i < exact.values.size(); ++i) {
        const Rational difference =
            Rational::from_double(rounded.values[i]) - Rational(exact.values[i]) * factor;
        ASSERT_LE(abs(difference), error * Rational(2)) << "seed " << seed << "\n"
                                                        << v_cells::text_of(cell);
        const bool is_certain = std::abs(rounded.values[i]) > rounded.error;
        ASSERT_TRUE(!is_certain ||
                    (rounded.values[i] > 0) == (exact.values[i].sign() == Sign::kPositive))
            << "seed " << seed << "\n"
            << v_cells::text_of(cell);
      }
    }
  }
}

TEST(JacobianNet, HugeNumbersLeaveEverythingOpen) {
  const VVolume cell = v_cells::mapped(cube(0, 0, 0), [](Point p) {
    return Point{p[0] * Rational::power_of_two(1100), p[1], p[2]};
  });
  const PieceCutter cutter = cutter_of(cell);
  EXPECT_FALSE(rounded_jacobian(cutter.rounded({0, 0, 0})).is_positive(1));
  EXPECT_TRUE(decide_determinants(model_of({cell})).is_proved());
  const VVolume tiny = v_cells::mapped(cube(0, 0, 0), [](Point p) {
    return Point{p[0] * Rational::power_of_two(-1100), p[1], p[2]};
  });
  EXPECT_TRUE(decide_determinants(model_of({tiny})).is_proved());
}

TEST(JacobianSign, APositiveCellNeedsNothing) {
  const VDeterminants d = decide_determinants(model_of({cube(0, 0, 0), cube(1, 0, 0)}));
  EXPECT_TRUE(d.is_proved());
  EXPECT_TRUE(d.proofs.empty());
  EXPECT_EQ(d.num_exact, 0u);
}

// Replays a tree in rationals: condition V2.
void expect_tree_holds(const BezierVolume<Rational>& n, const PieceProof& proof) {
  std::size_t next = 0;
  const auto zeros_hold = [&](const std::array<Point, 2>& box, unsigned sub_face) {
    const auto s = internal::sub_face_places(sub_face);
    for (unsigned z = 0; z < 26; ++z) {
      if ((proof.zeros >> z & 1) == 0) continue;
      const auto t = internal::sub_face_places(z);
      bool is_in = true;
      for (std::size_t a = 0; a < 3; ++a)
        is_in = is_in && (t[a] == 2 || (s[a] == t[a] && box[t[a]][a] == Rational(t[a])));
      if (is_in) return true;
    }
    return false;
  };
  const std::function<void(BezierVolume<Rational>, std::array<Point, 2>)> visit =
      [&](BezierVolume<Rational> node, std::array<Point, 2> box) {
        ASSERT_LT(next, proof.tree.size());
        const unsigned symbol = proof.tree[next++];
        if (symbol > 0) {
          const std::size_t a = symbol - 1;
          const Rational half = q(1, 2), middle = (box[0][a] + box[1][a]) / Rational(2);
          auto lower = box, upper = box;
          lower[1][a] = upper[0][a] = middle;
          visit(restricted(node, a, Rational(0), half), lower);
          visit(restricted(node, a, half, Rational(1)), upper);
          return;
        }
        const Grid<3> grid = node.grid();
        std::uint32_t positive = 0;
        for (std::size_t i = 0; i < grid.count(); ++i) {
          const Sign sign = node.component(0)[i].sign();
          EXPECT_NE(sign, Sign::kNegative);
          const auto at = grid.index_of(i);
          for (unsigned f = 0; f < 27 && sign == Sign::kPositive; ++f) {
            const auto s = internal::sub_face_places(f);
            bool is_on = true;
            for (std::size_t a = 0; a < 3; ++a)
              is_on = is_on && (s[a] == 2 || at[a] == (s[a] == 0 ? 0 : grid.size[a] - 1));
            if (is_on) positive |= 1u << f;
          }
        }
        for (unsigned f = 0; f < 27; ++f)
          EXPECT_TRUE((positive >> f & 1) != 0 || zeros_hold(box, f)) << f;
      };
  const Point low{Rational(0), Rational(0), Rational(0)},
      high{Rational(1), Rational(1), Rational(1)};
  visit(n, {low, high});
  EXPECT_EQ(next, proof.tree.size());
}
BezierVolume<Rational> exact_net(const VModel& model, std::size_t cell, std::size_t number) {
  const PieceCutter cutter(model.cell(cell),
                           {model.breaks(cell, 0), model.breaks(cell, 1), model.breaks(cell, 2)});
  const ExactJacobian net = exact_jacobian(cutter.exact(cutter.grid().index_of(number)));
  std::array<int, 3> degrees;
  for (std::size_t a = 0; a < 3; ++a) degrees[a] = static_cast<int>(net.grid.size[a]) - 1;
  BezierVolume<Rational> out(degrees, 1, false,
                             std::vector<Rational>(net.values.begin(), net.values.end()));
  if (model.is_reversed(cell))
    for (Rational& x : out.coefficients()) x = -x;
  return out;
}

// A square whose upper side is bent into a wedge of 180 degrees at two of its corners: N = 0 on two edges.
VVolume squircle() {
  const std::array<std::array<Point, 3>, 3> p{{
      {Point{q(-1, 1), q(0, 1), q(0, 1)}, Point{q(-1, 1), q(1, 1), q(0, 1)},
       Point{q(0, 1), q(1, 1), q(0, 1)}},
      {Point{q(-1, 1), q(-1, 1), q(0, 1)}, Point{q(0, 1), q(0, 1), q(0, 1)},
       Point{q(1, 1), q(1, 1), q(0, 1)}},
      {Point{q(0, 1), q(-1, 1), q(0, 1)}, Point{q(1, 1), q(-1, 1), q(0, 1)},
       Point{q(1, 1), q(0, 1), q(0, 1)}},
  }};
  return v_cells::polynomial({2, 2, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
    Point at = p[i][j];
    at[2] = Rational(k);
    return at;
  });
}

TEST(JacobianSign, ASquircleVanishesOnItsFourEdges) {
  for (const bool mirrored : {false, true}) {
    VVolume cell = squircle();
    if (mirrored) cell = reversed(cell, 2);
    const VModel model = model_of({cell}, VOrientation::kAuto);
    const VDeterminants d = decide_determinants(model);
    ASSERT_TRUE(d.is_proved()) << static_cast<int>(d.findings[0].kind);
    EXPECT_EQ(d.num_zeros, 4u);
    ASSERT_EQ(d.proofs.size(), 1u);
    EXPECT_EQ(d.proofs[0].zeros,
              1u << 2 | 1u << 5 | 1u << 11 | 1u << 14);  // (0,0,2) (0,1,2) (1,0,2) (1,1,2)
    expect_tree_holds(exact_net(model, 0, 0), d.proofs[0]);
  }
}

// The squircle's edges w lie inside of a model: zeros on inner edges are allowed.
TEST(JacobianSign, ASquircleMayLieAmongOtherCells) {
  std::vector<VVolume> cells{squircle()};
  // One quadratic arc each, around it, ruled to the arc three times as large.
  for (std::size_t side = 0; side < 4; ++side)
    cells.push_back(
        v_cells::polynomial({2, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
          const BezierVolume<Rational> map = bezier_of(squircle());
          const std::size_t u = side < 2 ? 2 * side : i, v = side < 2 ? i : 2 * (side - 2);
          const std::size_t n = map.grid().at({u, v, 0});
          const Rational scale(j == 0 ? 1 : 3);
          return Point{map.component(0)[n] * scale, map.component(1)[n] * scale, Rational(k)};
        }));
  const VModel model = model_of(cells, VOrientation::kAuto);
  EXPECT_EQ(model.counts().internal, 8u);
  const VDeterminants d = decide_determinants(model);
  ASSERT_TRUE(d.is_proved());
  EXPECT_EQ(d.num_zeros, 4u);
}

TEST(JacobianSign, AWedgeVanishesOnItsCollapsedFace) {
  const VVolume wedge =
      v_cells::polynomial({1, 1, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        return k == 1 ? Point{Rational(i), q(1, 2), q(1, 1)}
                      : Point{Rational(i), Rational(j), Rational(0)};
      });
  const VDeterminants d = decide_determinants(model_of({wedge}));
  ASSERT_TRUE(d.is_proved());
  ASSERT_EQ(d.proofs.size(), 1u);
  EXPECT_EQ(d.proofs[0].zeros, 1u << 25);
}

// Cells with collapsed faces, or with zeros on edges, in any description: the zeros and trees hold.
TEST(JacobianSign, ZerosHoldInAnyDescription) {
  const std::uint64_t seed = 17;
  Random random(seed);
  const VVolume pyramid = v_cells::polynomial({1, 1, 1}, [](std::size_t i, std::size_t j,
                                                            std::size_t k) {
    return k == 1 ? Point{q(1, 2), q(1, 2), q(1, 1)} : Point{Rational(i), Rational(j), Rational(0)};
  });
  const VVolume wedge =
      v_cells::polynomial({1, 1, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        return k == 1 ? Point{Rational(i), q(1, 2), q(1, 1)}
                      : Point{Rational(i), Rational(j), Rational(0)};
      });
  // Two opposite edges of the wedge's line are points, too.
  const VVolume tetrahedron = v_cells::mapped(wedge, [](Point p) {
    return p[2] == Rational(0) && p[1] == Rational(0) ? Point{q(1, 2), Rational(0), Rational(0)}
                                                      : p;
  });
  const std::array<VVolume, 4> all{pyramid, wedge, tetrahedron, squircle()};
  std::size_t proofs = 0;
  for (int round = 0; round < 120; ++round) {
    const VVolume cell =
        v_cells::redescribed(v_cells::turned(all[static_cast<std::size_t>(round) % 4],
                                             static_cast<unsigned>(random.below(48))),
                             random);
    const VModel model = model_of({cell}, VOrientation::kAuto);
    const VDeterminants d = decide_determinants(model);
    ASSERT_TRUE(d.is_proved()) << "seed " << seed << ", round " << round << "\n"
                               << v_cells::text_of(cell);
    EXPECT_TRUE(model.forbidden().empty()) << v_cells::text_of(cell);
    EXPECT_GE(d.num_zeros, 1u);
    for (const PieceProof& proof : d.proofs) {
      ++proofs;
      expect_tree_holds(exact_net(model, 0, proof.piece), proof);
      ASSERT_FALSE(HasFailure()) << "seed " << seed << ", round " << round << "\n"
                                 << v_cells::text_of(cell);
    }
  }
  EXPECT_GE(proofs, 120u);
}

// N = 9 (3 - 16 t / 81) is least at (2/3, 1/3, 1/3), which no halving meets.
TEST(JacobianSign, ATinyFoldIsFoundWhereTheTreeGetsTooLarge) {
  const auto decided = [](const Rational& t) {
    const VVolume cell =
        v_cells::polynomial({3, 3, 3}, [&](std::size_t i, std::size_t j, std::size_t k) {
          return Point{Rational(i) + (i == 1 && j == 1 && k == 1 ? t : Rational(0)), Rational(j),
                       Rational(k)};
        });
    JacobianOptions options;
    options.max_nodes = 64;
    return decide_determinants(model_of({cell}), options);
  };
  const Rational limit = q(243, 16), little = Rational::power_of_two(-40);
  const VDeterminants folded = decided(limit * (Rational(1) + little)),
                      sound = decided(limit * (Rational(1) - little));
  ASSERT_EQ(folded.findings.size(), 1u);
  EXPECT_EQ(folded.findings[0].kind, JacobianFinding::Kind::kFolded);
  ASSERT_EQ(folded.findings[0].places.size(), 2u);
  const Point& at = folded.findings[0].places[1].at;
  EXPECT_LT(abs(at[0] - q(2, 3)), Rational::power_of_two(-18));
  ASSERT_EQ(sound.findings.size(), 1u);
  EXPECT_EQ(sound.findings[0].kind, JacobianFinding::Kind::kUndecided);
}

// Three inner control points pulled up and out: the border is a cube, the inside is folded.
TEST(JacobianSign, AFoldInsideOfACubeIsShown) {
  const VVolume cell =
      v_cells::polynomial({3, 3, 3}, [](std::size_t i, std::size_t j, std::size_t k) {
        const bool is_inner = i > 0 && i < 3 && j > 0 && j < 3 && k > 0 && k < 3;
        Point p{Rational(i), Rational(j), Rational(k)};
        if (is_inner && i == 1) p[2] += Rational(20);
        return p;
      });
  const VModel model = model_of({cell, v_cells::mapped(cell, [](Point p) {
                                   return Point{p[0] + Rational(9), p[1], p[2]};
                                 })});
  const VDeterminants d = decide_determinants(model);
  ASSERT_EQ(d.findings.size(), 2u);
  for (const JacobianFinding& f : d.findings) {
    EXPECT_EQ(f.kind, JacobianFinding::Kind::kFolded);
    ASSERT_EQ(f.places.size(), 2u);
    EXPECT_EQ(jacobian_sign(model.cell(f.cell), f.places[0].at), Sign::kPositive);
    EXPECT_EQ(jacobian_sign(model.cell(f.cell), f.places[1].at), Sign::kNegative);
    EXPECT_EQ(f.places[1].sign, Sign::kNegative);
  }
}

// Only the middle control point moves: N = 1 - t at (1, 1/2, 1/2), and more everywhere else.
VVolume pushed_cube(const Rational& t) {
  return v_cells::polynomial({2, 2, 2}, [&](std::size_t i, std::size_t j, std::size_t k) {
    Point p{Rational(i) / Rational(2), Rational(j) / Rational(2), Rational(k) / Rational(2)};
    // x = u + 8 m u (1 - u) v (1 - v) w (1 - w), x_u = 1 - m / 2 at (1, 1/2, 1/2).
    if (i == 1 && j == 1 && k == 1) p[0] += Rational(2) * t;
    return p;
  });
}

TEST(JacobianSign, DeterminantsJustAboveAndBelowZeroAreDecided) {
  for (const int bits : {20, 40, 52, 60, 100}) {
    SCOPED_TRACE(bits);
    const Rational tiny = Rational::power_of_two(-bits);
    EXPECT_TRUE(decide_determinants(model_of({pushed_cube(Rational(1) - tiny)})).is_proved());
    for (unsigned s = 0; s < 48; s += 5) {
      const VModel model =
          model_of({v_cells::turned(pushed_cube(Rational(1) + tiny), s)}, VOrientation::kAuto);
      const VDeterminants d = decide_determinants(model);
      ASSERT_EQ(d.findings.size(), 1u);
      EXPECT_EQ(d.findings[0].kind, JacobianFinding::Kind::kFolded);
      ASSERT_EQ(d.findings[0].places.size(), 2u);
      for (const JacobianPlace& place : d.findings[0].places) {
        EXPECT_EQ(jacobian_sign(model.cell(0), place.at), place.sign);
        for (std::size_t a = 0; a < 3; ++a)
          EXPECT_TRUE(Rational(0) < place.at[a] && place.at[a] < Rational(1));
      }
    }
  }
  const VDeterminants zero = decide_determinants(model_of({pushed_cube(Rational(1))}));
  ASSERT_EQ(zero.findings.size(), 1u);
  EXPECT_EQ(zero.findings[0].kind, JacobianFinding::Kind::kZero);
  EXPECT_EQ(zero.findings[0].box[0][0], Rational(1));
  EXPECT_EQ(zero.findings[0].box[1][0], q(1, 2));
}

TEST(JacobianSign, ALeftHandedCellIsNotProvedUnlessReversed) {
  const VVolume cell = swapped(cube(0, 0, 0), 0, 1);
  const VDeterminants kept = decide_determinants(model_of({cell}));
  ASSERT_EQ(kept.findings.size(), 1u);
  EXPECT_EQ(kept.findings[0].kind, JacobianFinding::Kind::kLeftHanded);
  EXPECT_EQ(kept.findings[0].places[0].sign, Sign::kNegative);
  EXPECT_TRUE(decide_determinants(model_of({cell}, VOrientation::kAuto)).is_proved());
}

TEST(JacobianSign, AFlatPieceIsNamed) {
  VVolume cell = insert_knot(elevate(cube(0, 0, 0), 0, 1), 0, q(1, 2));
  cell = insert_knot(cell, 0, q(1, 2));
  for (std::size_t n = 0; n < cell.grid().count(); ++n)
    if (cell.component(0)[n] > q(1, 2)) cell.component(0)[n] = q(1, 2);
  const VDeterminants d = decide_determinants(model_of({cell}));
  ASSERT_EQ(d.findings.size(), 1u);
  EXPECT_EQ(d.findings[0].kind, JacobianFinding::Kind::kFlat);
  EXPECT_EQ(d.findings[0].box[0][0], q(1, 2));
  EXPECT_EQ(d.findings[0].box[0][1], q(1, 1));
}

// x = (u - 1/2)^3: N = 0 on the plane u = 1/2, inside of the piece.
TEST(JacobianSign, AZeroInsideIsNamed) {
  // (u - 1/2)^3 has the Bernstein coefficients -1/8, 1/8, -1/8, 1/8.
  const VVolume cubic =
      v_cells::polynomial({3, 1, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        return Point{q(i % 2 == 0 ? -1 : 1, 8), Rational(j), Rational(k)};
      });
  // The hand is decided at middles, where the determinant is 0: a knot at 1/3 moves them.
  const VDeterminants d = decide_determinants(model_of({insert_knot(cubic, 0, q(1, 3))}));
  ASSERT_EQ(d.findings.size(), 1u);
  EXPECT_TRUE(d.findings[0].kind == JacobianFinding::Kind::kZero ||
              d.findings[0].kind == JacobianFinding::Kind::kUndecided);
  const VDeterminants split = decide_determinants(model_of({insert_knot(cubic, 0, q(1, 2))}));
  ASSERT_EQ(split.findings.size(), 1u);
  EXPECT_EQ(split.findings[0].kind, JacobianFinding::Kind::kZeroFace);
}

// N > 0 with coefficients that are not: the tree is needed, and it holds.
TEST(JacobianSign, TreesHoldInRationals) {
  const std::uint64_t seed = 5;
  Random random(seed);
  std::size_t trees = 0, folded = 0;
  for (int round = 0; round < 500; ++round) {
    const bool is_rational = round % 3 == 0;
    VVolume cell = random_cell(random, is_rational);
    if (random.below(2) == 0) cell = insert_knot(cell, random.below(3), q(1, 2));
    cell = v_cells::turned(cell, static_cast<unsigned>(random.below(48)));
    const VModel model = model_of({cell}, VOrientation::kAuto);
    const VDeterminants d = decide_determinants(model);
    for (const JacobianFinding& f : d.findings) {
      if (f.kind != JacobianFinding::Kind::kFolded) continue;
      ++folded;
      EXPECT_EQ(jacobian_sign(cell, f.places[0].at), Sign::kPositive) << "seed " << seed << "\n"
                                                                      << v_cells::text_of(cell);
      EXPECT_EQ(jacobian_sign(cell, f.places[1].at), Sign::kNegative) << "seed " << seed << "\n"
                                                                      << v_cells::text_of(cell);
    }
    if (!d.is_proved()) continue;
    for (const PieceProof& proof : d.proofs) {
      ++trees;
      expect_tree_holds(exact_net(model, 0, proof.piece), proof);
      ASSERT_FALSE(HasFailure()) << "seed " << seed << ", round " << round << "\n"
                                 << v_cells::text_of(cell);
    }
  }
  EXPECT_GT(trees, 20u);
  EXPECT_GT(folded, 20u);
}

TEST(JacobianSign, AnyNumberOfThreadsFindsTheSame) {
  Random random(3);
  std::vector<VVolume> cells;
  for (int n = 0; n < 300; ++n)
    cells.push_back(v_cells::mapped(random_cell(random, n % 5 == 0), [n](Point p) {
      return Point{p[0] + Rational(10 * n), p[1], p[2]};
    }));
  const VModel model = model_of(cells, VOrientation::kAuto);
  const VDeterminants one = decide_determinants(model);
  JacobianOptions options;
  options.jobs = 2;
  const VDeterminants two = decide_determinants(model, options);
  ASSERT_EQ(one.proofs.size(), two.proofs.size());
  for (std::size_t i = 0; i < one.proofs.size(); ++i) {
    EXPECT_EQ(one.proofs[i].piece, two.proofs[i].piece);
    EXPECT_EQ(one.proofs[i].tree, two.proofs[i].tree);
  }
  ASSERT_EQ(one.findings.size(), two.findings.size());
  for (std::size_t i = 0; i < one.findings.size(); ++i)
    EXPECT_EQ(one.findings[i].box, two.findings[i].box);
}

}  // namespace
}  // namespace veritope
