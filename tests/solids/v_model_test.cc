// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_model.h"

#include <gtest/gtest.h>

#include <set>

#include "solids/patches/patch_complex.h"
#include "solids/vmodel/v_face_internal.h"
#include "solids/vmodel/v_faces.h"
#include "splines/de_boor.h"
#include "tests/support/v_cells.h"

namespace veritope {
namespace {

using v_cells::box;
using v_cells::cube;
using v_cells::Point;

VModel model_of(std::vector<VVolume> cells, VOrientation orientation = VOrientation::kKeep) {
  return make_v_model(std::move(cells), orientation).value();
}
Rational q(std::int64_t p, std::int64_t d) { return Rational(p) / Rational(d); }

void expect_counts(const VModel& model,
                   std::array<std::uint64_t, 5> points_curves_surfaces_internal_halves) {
  const VCounts& n = model.counts();
  const std::array<std::uint64_t, 5> found{n.v_points, n.v_curves, n.v_surfaces, n.internal,
                                           n.half_v_surfaces};
  EXPECT_EQ(found, points_curves_surfaces_internal_halves);
  EXPECT_EQ(n.boundary + n.internal, n.v_surfaces);
}

TEST(VModel, ABoxHasEightPointsTwelveCurvesAndSixSurfaces) {
  const VModel model = model_of({cube(0, 0, 0)});
  expect_counts(model, {8, 12, 6, 0, 6});
  EXPECT_EQ(model.counts().euler, 1);
  EXPECT_EQ(model.counts().pieces, 1u);
  EXPECT_EQ(model.hand(0), Sign::kPositive);
  const PatchComplex border =
      make_patch_complex(patches_of(border_of(model)).value(), PatchOrientation::kKeep).value();
  EXPECT_TRUE(border.is_closed_oriented_surface());
}

TEST(VModel, ThreeCubesInAnLHaveTheNumbersOfFigure3) {
  const VModel model = model_of({cube(0, 0, 0), cube(1, 0, 0), cube(0, 1, 0)});
  expect_counts(model, {16, 28, 16, 2, 18});
  EXPECT_EQ(model.face(0, 1).mate, 6u);
  EXPECT_EQ(model.face(0, 1).symmetry, 0u);
  EXPECT_EQ(model.face(0, 3).mate, 14u);
  EXPECT_EQ(model.face_code(0), 0u);
  EXPECT_EQ(model.face_code(1), 3u + 8 * 4);
  EXPECT_EQ(model.face_code(6), 2u);
  EXPECT_EQ(border_of(model).faces.size(), 14u);
}

TEST(VModel, CubesThatShareAnEdgeOrACornerAreNotGlued) {
  expect_counts(model_of({cube(0, 0, 0), cube(1, 1, 0)}), {16, 24, 12, 0, 12});
  expect_counts(model_of({cube(0, 0, 0), cube(1, 1, 1)}), {16, 24, 12, 0, 12});
}

TEST(VModel, ACellAndItsCopyAreNotGlued) {
  const VModel model = model_of({cube(0, 0, 0), cube(0, 0, 0)});
  EXPECT_EQ(model.counts().internal, 0u);
  EXPECT_EQ(model.copies().size(), 6u);
  EXPECT_TRUE(model.crowds().empty());
}

TEST(VModel, ThreeEqualFacesAreNotGlued) {
  const VModel model = model_of({cube(0, 0, 0), cube(1, 0, 0),
                                 box({q(1, 1), q(0, 1), q(0, 1)}, {q(3, 1), q(1, 1), q(1, 1)})});
  ASSERT_EQ(model.crowds().size(), 1u);
  EXPECT_EQ(model.crowds()[0], (std::vector<VFaceNumber>{1, 6, 12}));
  EXPECT_EQ(model.counts().internal, 0u);
}

// Half of a square ring: control points of a cell that runs around the z axis through `turns` quarters.
VVolume ring_part(int first, int quarters) {
  const std::array<std::array<int, 2>, 4> around{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  std::array<KnotAxis<Rational>, 3> axes;
  axes[0] = axes[2] = {1, {Rational(0), Rational(0), Rational(1), Rational(1)}, false};
  axes[1].degree = 1;
  axes[1].knots.push_back(Rational(0));
  for (int i = 0; i <= quarters; ++i) axes[1].knots.push_back(Rational(i));
  axes[1].knots.push_back(Rational(quarters));
  std::vector<Rational> values;
  for (std::size_t c = 0; c < 3; ++c)
    for (int r = 2; r > 0;
         --r)  // from outside to inside: (u, v, w) is right-handed then with v counterclockwise?
      for (int i = 0; i <= quarters; ++i)
        for (int z = 0; z < 2; ++z)
          values.push_back(
              c == 2 ? Rational(z)
                     : Rational(r * around[static_cast<std::size_t>((first + i) % 4)][c]));
  return {std::move(axes), 3, false, std::move(values)};
}

TEST(VModel, ACellIsGluedToItself) {
  const VModel model = model_of({ring_part(0, 4)}, VOrientation::kAuto);
  EXPECT_TRUE(model.face(0, 2).is_glued());
  EXPECT_EQ(model.face(0, 2).mate, 3u);
  expect_counts(model, {4, 8, 5, 1, 6});
  EXPECT_EQ(model.counts().euler, 0);
  EXPECT_EQ(model.num_pieces(), 4u);
  EXPECT_TRUE(model.forbidden().empty());
  const PatchComplex border =
      make_patch_complex(patches_of(border_of(model)).value(), PatchOrientation::kKeep).value();
  EXPECT_TRUE(border.is_closed_oriented_surface());
}

TEST(VModel, TwoCellsMakeARing) {
  const VModel model = model_of({ring_part(0, 2), ring_part(2, 2)}, VOrientation::kAuto);
  expect_counts(model, {8, 16, 10, 2, 12});
  EXPECT_EQ(model.counts().euler, 0);
}

TEST(VModel, LeftHandedCellsAreReversedOnRequestOnly) {
  const std::vector<VVolume> cells{cube(0, 0, 0), swapped(cube(1, 0, 0), 0, 1)};
  const VModel kept = model_of(cells), turned = model_of(cells, VOrientation::kAuto);
  EXPECT_EQ(kept.left_handed(), std::vector<std::uint32_t>{1});
  EXPECT_FALSE(kept.is_reversed(1));
  EXPECT_EQ(kept.counts().internal, 0u);
  EXPECT_EQ(kept.copies().size(), 1u);
  EXPECT_TRUE(turned.is_reversed(1));
  EXPECT_EQ(turned.counts().internal, 1u);
  EXPECT_EQ(turned.counts().reversed, 1u);
}

// The pyramid over a square: w = 1 is a point; then the wedge: w = 1 is a line along u.
TEST(VModel, CollapsedFacesAreFound) {
  const VModel pyramid = model_of({v_cells::polynomial({1, 1, 1}, [](std::size_t i, std::size_t j,
                                                                     std::size_t k) {
    return k == 1 ? Point{q(1, 2), q(1, 2), q(1, 1)} : Point{Rational(i), Rational(j), Rational(0)};
  })});
  EXPECT_EQ(pyramid.face(0, 5).collapse, VCollapse::kToPoint);
  expect_counts(pyramid, {5, 8, 5, 0, 5});
  const VModel wedge =
      model_of({v_cells::polynomial({1, 1, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        return k == 1 ? Point{Rational(i), q(1, 2), q(1, 1)}
                      : Point{Rational(i), Rational(j), Rational(0)};
      })});
  EXPECT_EQ(wedge.face(0, 5).collapse, VCollapse::kAlongSecond);
  expect_counts(wedge, {6, 9, 5, 0, 5});
  EXPECT_EQ(wedge.counts().euler, 1);
  EXPECT_TRUE(wedge.is_edge_collapsed(0, 4 + 2));
}

// Rows of equal points with other weights are not proportional: such a face sweeps no surface but is not collapsed.
TEST(VModel, EqualPointsWithOtherWeightsDoNotCollapseAFace) {
  const auto wedge = [](bool proportional) {
    return v_cells::rational(
        {1, 2, 1},
        [](std::size_t i, std::size_t j, std::size_t k) {
          return k == 1 ? Point{Rational(0), Rational(j), q(1, 1)}
                        : Point{Rational(i), Rational(j), Rational(0)};
        },
        [=](std::size_t i, std::size_t j, std::size_t k) {
          if (k == 0) return Rational(1);
          return proportional ? Rational(i + 1) : (i == 1 && j == 1 ? Rational(4) : Rational(1));
        });
  };
  EXPECT_EQ(model_of({wedge(true)}).face(0, 5).collapse, VCollapse::kAlongFirst);
  EXPECT_EQ(model_of({wedge(false)}).face(0, 5).collapse, VCollapse::kNone);
}

// The wedge as a cell with an inner knot on u, where the face w = 1 is a line along v for u <= 1/2 only.
TEST(VModel, AFaceCollapsedOnOneKnotSpanIsNamedWithTheKnot) {
  std::array<KnotAxis<Rational>, 3> axes;
  axes[1] = axes[2] = {1, {Rational(0), Rational(0), Rational(1), Rational(1)}, false};
  axes[0] = {1, {Rational(0), Rational(0), q(1, 2), Rational(1), Rational(1)}, false};
  std::vector<Rational> values;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 2; ++k)
          values.push_back(c == 0   ? Rational(i)
                           : c == 1 ? (k == 1 && i < 2 ? q(1, 2) : Rational(j))
                                    : Rational(k));
  const VVolume cell(axes, 3, false, values);
  const VModel model = model_of({cell});
  ASSERT_EQ(model.forbidden().size(), 1u);
  const VForbiddenCollapse& f = model.forbidden()[0];
  EXPECT_EQ(f.kind, VForbiddenCollapse::Kind::kPartOfFace);
  EXPECT_EQ(f.face, std::optional<std::size_t>(5));
  ASSERT_EQ(f.splits.size(), 1u);
  EXPECT_EQ(f.splits[0].axis, 0u);
  EXPECT_EQ(f.splits[0].at, q(1, 2));
  // Split there, nothing is forbidden, and the two cells are glued.
  const VModel split = model_of({restricted(cell, 0, Rational(0), q(1, 2)).value(),
                                 restricted(cell, 0, q(1, 2), Rational(1)).value()});
  EXPECT_TRUE(split.forbidden().empty());
  EXPECT_EQ(split.counts().internal, 1u);
}

TEST(VModel, AnInnerCollapseIsForbidden) {
  std::array<KnotAxis<Rational>, 3> axes;
  axes[0] = axes[1] = {1, {Rational(0), Rational(0), Rational(1), Rational(1)}, false};
  axes[2] = {1, {Rational(0), Rational(0), q(1, 2), Rational(1), Rational(1)}, false};
  std::vector<Rational> values;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 3; ++k)
          values.push_back(c == 2
                               ? Rational(k)
                               : (c == 0 ? Rational(i) : Rational(j)) * Rational(k == 1 ? 0 : 1));
  const VModel model = model_of({VVolume(axes, 3, false, values)});
  EXPECT_FALSE(model.forbidden().empty());
  for (const VForbiddenCollapse& f : model.forbidden())
    EXPECT_EQ(f.kind, VForbiddenCollapse::Kind::kInside);
}

// Whether some edge of some Bezier piece is collapsed against condition V1, or a face of a piece in a face of the cell
// that is not, piece by piece in rationals.
bool has_forbidden_piece(const VModel& model) {
  const VVolume& cell = model.cell(0);
  const auto cut = bezier_pieces(cell);
  const Grid<3> pieces = cut.grid();
  for (std::size_t n = 0; n < cut.pieces.size(); ++n) {
    const VVolume piece = to_bspline(cut.pieces[n]);
    const auto at = pieces.index_of(n);
    for (std::size_t k = 0; k < 6; ++k)
      if (at[k / 2] == (k % 2 == 0 ? 0 : pieces.size[k / 2] - 1) &&
          !model.face(0, k).is_collapsed() &&
          internal::collapse_of(internal::FaceView(piece, k)) != VCollapse::kNone)
        return true;
    for (std::size_t edge = 0; edge < 12; ++edge) {
      if (!internal::is_edge_collapsed(piece, edge)) continue;
      const std::size_t axis = edge / 4;
      const auto others = v_face_axes(axis);
      const std::array<std::size_t, 2> ends{edge & 1, edge >> 1 & 1};
      bool is_allowed = false;
      std::size_t num_walls = 0;
      for (std::size_t k = 0; k < 2; ++k) {
        if (at[others[k]] != (ends[k] == 0 ? 0 : pieces.size[others[k]] - 1)) continue;
        ++num_walls;
        const VCollapse whole = model.face(0, 2 * others[k] + ends[k]).collapse;
        const auto along =
            v_face_axes(others[k])[0] == axis ? VCollapse::kAlongFirst : VCollapse::kAlongSecond;
        is_allowed = is_allowed || whole == VCollapse::kToPoint || whole == along;
      }
      is_allowed = is_allowed || (num_walls == 2 && model.is_edge_collapsed(0, edge));
      if (!is_allowed) return true;
    }
  }
  return false;
}

TEST(VModel, ForbiddenCollapsesAreThoseOfThePieces) {
  const std::uint64_t seed = 99;
  Random random(seed);
  std::size_t forbidden = 0, allowed = 0;
  for (int round = 0; round < 3000; ++round) {
    std::array<KnotAxis<Rational>, 3> axes;
    std::size_t count = 1;
    for (auto& axis : axes) {
      axis.degree = static_cast<int>(1 + random.below(2));
      const auto p = static_cast<std::size_t>(axis.degree);
      axis.knots.assign(p + 1, Rational(0));
      if (random.below(2) == 0) axis.knots.insert(axis.knots.end(), 1 + random.below(p), q(1, 3));
      axis.knots.insert(axis.knots.end(), p + 1, Rational(1));
      count *= axis.num_control();
    }
    const bool is_rational = random.below(3) == 0;
    const std::uint64_t step = 1 + random.below(count);  // neighbours are often equal
    std::vector<Rational> values(count * (is_rational ? 4 : 3));
    for (std::size_t n = 0; n < values.size(); ++n)
      values[n] = n >= 3 * count  ? Rational(1)
                  : n % step == 0 ? Rational(random.below(2))
                                  : values[n - 1];
    const VVolume cell(axes, is_rational ? 4 : 3, is_rational, values);
    const VModel model = model_of({cell});
    const bool truth = has_forbidden_piece(model);
    ASSERT_EQ(!model.forbidden().empty(), truth) << "seed " << seed << ", round " << round << "\n"
                                                 << v_cells::text_of(cell);
    ++(truth ? forbidden : allowed);
  }
  EXPECT_GT(forbidden, 300u);
  EXPECT_GT(allowed, 300u);
}

TEST(VModel, NeighboursInOtherSpacesAreGluedAndCutAlike) {
  VVolume right = elevate(cube(1, 0, 0), 1, 1);
  right = insert_knot(right, 1, q(1, 3));
  right = with_domain(reversed(right, 1), 1, Rational(5), Rational(8)).value();
  right = reversed(right, 0);  // two reversals: still right-handed
  const VModel model =
      model_of({cube(0, 0, 0), v_cells::with_factor(right, q(3, 7)), cube(2, 0, 0)});
  EXPECT_EQ(model.counts().internal, 2u);
  EXPECT_EQ(model.face(0, 1).mate, 7u);
  EXPECT_EQ(model.face(0, 1).symmetry, 2u);
  EXPECT_EQ(model.added_breaks(0, 1), std::vector<Rational>{q(1, 3)});
  EXPECT_TRUE(model.added_breaks(1, 1).empty());
  EXPECT_EQ(model.added_breaks(2, 1), std::vector<Rational>{q(1, 3)});
  EXPECT_EQ(model.breaks(1, 1), (std::vector<Rational>{Rational(5), Rational(7), Rational(8)}));
  EXPECT_EQ(model.counts().pieces, 6u);
  const PatchComplex border =
      make_patch_complex(patches_of(border_of(model)).value(), PatchOrientation::kKeep).value();
  EXPECT_TRUE(border.is_closed_oriented_surface());
}

TEST(VModel, APolynomialFactorMakesAnotherFace) {
  const auto face_weights = [](std::size_t, std::size_t j, std::size_t) { return Rational(j + 1); };
  const auto at = [](std::size_t i, std::size_t j, std::size_t k) {
    return Point{Rational(1 + static_cast<std::int64_t>(i)), Rational(j) / Rational(2),
                 Rational(k)};
  };
  // The linear parametrisation times the factor 1 + v.
  const VVolume factor = v_cells::rational(
      {1, 2, 1},
      [&](std::size_t i, std::size_t j, std::size_t k) {
        Point p = at(i, j, k);
        p[1] = j == 1 ? q(1, 3) : p[1];
        return p;
      },
      [](std::size_t, std::size_t j, std::size_t) {
        return j == 1 ? q(3, 2) : Rational(j == 0 ? 1 : 2);
      });
  const VVolume constant = v_cells::rational(
      {1, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) { return at(i, 2 * j, k); },
      [](std::size_t, std::size_t, std::size_t) { return Rational(3); });
  EXPECT_EQ(model_of({cube(0, 0, 0), factor}).counts().internal, 0u);
  EXPECT_EQ(model_of({cube(0, 0, 0), constant}).counts().internal, 1u);
  const VVolume speed = v_cells::rational(
      {1, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) { return at(i, 2 * j, k); },
      face_weights);
  EXPECT_EQ(model_of({cube(0, 0, 0), speed}).counts().internal, 0u);
}

TEST(VModel, FacesWithTheSameCornersAndMiddlesAreTold) {
  // Lenses: cells between graphs over the unit square that agree on its border and in a grid of points.
  const auto sheet = [](std::int64_t height, std::size_t i, std::size_t j) {
    return i > 0 && i < 3 && j > 0 && j < 3 ? Rational(height * (i == j ? 1 : -1)) : Rational(0);
  };
  std::vector<VVolume> cells;
  for (std::int64_t n = 0; n < 6; ++n)
    cells.push_back(
        v_cells::polynomial({3, 3, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
          return Point{Rational(i), Rational(j), sheet(n + static_cast<std::int64_t>(k), i, j)};
        }));
  const VModel model = model_of(cells, VOrientation::kAuto);
  // The determinants are 0 at all middles, so that no cell is reversed.
  for (std::uint32_t n = 0; n + 1 < 6; ++n) EXPECT_EQ(model.face(n, 5).mate, 6 * (n + 1) + 4);
}

// All 48 x 48 descriptions of two neighbours: glued iff hands allow, under the symmetry that takes points to points.
TEST(VModel, EverySymmetryIsFound) {
  const VVolume left =
      v_cells::polynomial({2, 1, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        return Point{Rational(i), Rational(j) * Rational(i + 2),
                     Rational(k) + q(static_cast<std::int64_t>(i * j), 9)};
      });
  const VVolume right =
      v_cells::polynomial({1, 1, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        return Point{Rational(2) + Rational(i), Rational(j) * Rational(4),
                     Rational(k) + q(static_cast<std::int64_t>(2 * j), 9)};
      });
  std::set<unsigned> seen;
  for (unsigned s = 0; s < 48; ++s)
    for (unsigned t = 0; t < 48; ++t) {
      const VModel model =
          model_of({v_cells::turned(left, s), v_cells::turned(right, t)}, VOrientation::kAuto);
      ASSERT_EQ(model.is_reversed(0), v_cells::is_turn_odd(s)) << s;
      ASSERT_EQ(model.counts().internal, 1u) << s << " " << t;
      expect_counts(model, {12, 20, 11, 1, 12});
      for (VFaceNumber f = 0; f < 6; ++f)
        if (model.face(f).is_glued()) {
          seen.insert(model.face(f).symmetry);
          const VFaceRole& back = model.face(model.face(f).mate);
          EXPECT_EQ(back.mate, f);
          EXPECT_EQ(back.symmetry, v_symmetry_inverse(model.face(f).symmetry));
        }
      const PatchComplex border =
          make_patch_complex(patches_of(border_of(model)).value(), PatchOrientation::kKeep).value();
      ASSERT_TRUE(border.is_closed_oriented_surface()) << s << " " << t;
    }
  EXPECT_EQ(seen.size(), 8u);
}

TEST(VModel, SymmetriesAreUndoneByTheirInverses) {
  for (unsigned s = 0; s < 8; ++s)
    for (const unsigned x : {0u, 1u})
      for (const unsigned y : {0u, 1u}) {
        const std::array<unsigned, 2> at{x, y};
        EXPECT_EQ(v_symmetry_image(v_symmetry_inverse(s), v_symmetry_image(s, at)), at) << s;
      }
}

// What condition V3 of docs/certificates/vmodel.md asks, at random points instead of as an identity.
void expect_glued_faces_agree(const VModel& model, Random& random) {
  const auto on_axis = [](const KnotAxis<Rational>& axis, const Rational& t) {
    return axis.domain_begin() + t * (axis.domain_end() - axis.domain_begin());
  };
  const auto point_on = [&](VFaceNumber f, std::array<Rational, 2> at) {
    const VVolume& cell = model.cell(f / 6);
    const auto axes = v_face_axes(f % 6 / 2);
    Point where;
    where[f % 6 / 2] = on_axis(cell.axis(f % 6 / 2), Rational(f % 2));
    for (std::size_t k = 0; k < 2; ++k) where[axes[k]] = on_axis(cell.axis(axes[k]), at[k]);
    return point(cell, where).value();
  };
  const auto hand = [&](VFaceNumber f) {
    const bool is_negative = ((f % 2 == 0) != (f % 6 / 2 == 1)) != model.is_reversed(f / 6);
    return is_negative ? -1 : 1;
  };
  const auto unit_breaks = [&](VFaceNumber f, std::size_t k, bool is_reversed) {
    const std::size_t axis = v_face_axes(f % 6 / 2)[k];
    std::vector<Rational> out = model.breaks(f / 6, axis);
    const Rational begin = out.front(), length = out.back() - out.front();
    for (Rational& t : out)
      t = is_reversed ? Rational(1) - (t - begin) / length : (t - begin) / length;
    std::sort(out.begin(), out.end());
    return out;
  };
  for (VFaceNumber f = 0; f < model.num_faces(); ++f) {
    const VFaceRole& role = model.face(f);
    if (!role.is_glued()) continue;
    const unsigned s = role.symmetry;
    EXPECT_EQ(hand(f) * hand(role.mate), is_v_symmetry_odd(s) ? 1 : -1);
    const std::array<Rational, 2> at{q(random.between(0, 11), 11), q(random.between(0, 13), 13)};
    std::array<Rational, 2> to = at;
    if ((s & 1) != 0) std::swap(to[0], to[1]);
    if ((s & 2) != 0) to[0] = Rational(1) - to[0];
    if ((s & 4) != 0) to[1] = Rational(1) - to[1];
    EXPECT_EQ(point_on(f, at), point_on(role.mate, to));
    EXPECT_EQ(unit_breaks(f, s & 1, (s & 2) != 0), unit_breaks(role.mate, 0, false));
    EXPECT_EQ(unit_breaks(f, 1 - (s & 1), (s & 4) != 0), unit_breaks(role.mate, 1, false));
  }
}

TEST(VModel, RandomDescriptionsOfAGridHaveTheSameNumbers) {
  const std::uint64_t seed = 20240101;
  Random random(seed);
  const auto cells = v_cells::grid(2, {1, 1, 1}, [](const Point& p) {
    return Point{p[0] + p[1] * p[1] / Rational(8), p[1] + p[2] * p[0] / Rational(9),
                 p[2] + p[0] * p[1] / Rational(7)};
  });
  const VCounts truth = model_of(cells).counts();
  EXPECT_EQ(truth.internal, 12u);
  for (int round = 0; round < 40; ++round) {
    std::vector<VVolume> others;
    std::string operands;
    for (const VVolume& cell : cells) {
      others.push_back(v_cells::redescribed(
          v_cells::turned(cell, static_cast<unsigned>(random.below(48))), random));
      operands += v_cells::text_of(others.back());
    }
    const VModel model = model_of(others, VOrientation::kAuto);
    expect_glued_faces_agree(model, random);
    EXPECT_TRUE(make_patch_complex(patches_of(border_of(model)).value(), PatchOrientation::kKeep)
                    .value()
                    .is_closed_oriented_surface());
    VCounts found = model.counts();
    found.reversed = truth.reversed, found.pieces = truth.pieces;
    ASSERT_EQ(found, truth) << "seed " << seed << ", round " << round << "\n" << operands;
  }
}

// ---- refusals

void expect_refused(std::vector<VVolume> cells, Code code, std::uint64_t cell,
                    const std::string& part) {
  const auto made = make_v_model(std::move(cells), VOrientation::kKeep);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, code);
  EXPECT_EQ(made.error().place.entity, std::optional<std::uint64_t>(cell));
  EXPECT_NE(made.error().message.find(part), std::string::npos) << made.error().message;
}

TEST(VModel, BadCellsAreNamed) {
  EXPECT_EQ(make_v_model({}, VOrientation::kKeep).error().code, Code::kEmpty);
  VVolume torn = insert_knot(cube(1, 0, 0), 2, q(1, 2));
  torn = insert_knot(torn, 2, q(1, 2));
  expect_refused({cube(0, 0, 0), torn}, Code::kBadArgument, 1,
                 "axis 2: the inner knot 1/2 occurs more often");
  expect_refused({elevate(cube(0, 0, 0), 0, 15)}, Code::kOverLimit, 0, "the degree 16 along u");
  std::array<KnotAxis<Rational>, 3> axes = cube(0, 0, 0).axes();
  axes[1].knots = {Rational(0), Rational(1), Rational(2), Rational(3)};
  const VVolume whole = cube(0, 0, 0);
  const auto c = whole.coefficients();
  expect_refused({VVolume(axes, 3, false, {c.begin(), c.end()})}, Code::kBadArgument, 0,
                 "axis 1: the knots are not clamped");
  expect_refused({VVolume(cube(0, 0, 0).axes(), 2, false, std::vector<Rational>(16))},
                 Code::kBadArgument, 0, "2 coordinates");
  VVolume weights = v_cells::with_factor(cube(0, 0, 0), Rational(1));
  weights.component(3)[2] = Rational(0);
  expect_refused({weights}, Code::kBadArgument, 0, "the weight 0");
}

// Each cell of a row has 200 knots of its own, which cut all others, too.
TEST(VModel, TooManyPiecesAreRefusedBeforeTheyAreMade) {
  std::vector<VVolume> cells;
  for (int n = 0; n < 300; ++n) {
    std::vector<Rational> knots;
    for (int i = 1; i <= 200; ++i) knots.push_back(q(300 * i + n, 300 * 202));
    cells.push_back(refine(cube(n, 0, 0), 1, knots));
  }
  const auto made = make_v_model(std::move(cells), VOrientation::kKeep);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, Code::kOverLimit);
  EXPECT_TRUE(made.error().place.entity.has_value());
}

TEST(VModel, AttributesAreStripped) {
  const VVolume whole = cube(0, 0, 0);
  const auto old = whole.coefficients();
  std::vector<Rational> values(old.begin(), old.end());
  values.insert(values.end(), 8, Rational(77));
  values.insert(values.end(), 8, Rational(2));
  const VVolume with_attribute(cube(0, 0, 0).axes(), 5, true, values);
  const VVolume geometry = geometry_of(with_attribute).value();
  EXPECT_EQ(geometry.num_components(), 4);
  EXPECT_EQ(geometry.component(3)[0], Rational(2));
  EXPECT_EQ(model_of({with_attribute}).cell(0), geometry);
}

}  // namespace
}  // namespace veritope
