// SPDX-License-Identifier: LGPL-3.0-or-later
// docs/certificates/reading-rule-faces.md, by the kernel. tests/certify/reading_rules_test.cc compares a checker with it.
#include "io/splines/boundary_faces.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <numeric>

#include "io/splines/volume_faces.h"
#include "solids/patches/patch_complex.h"
#include "solids/patches/patch_sources.h"
#include "splines/bspline_domain.h"
#include "tests/io/spline_test_util.h"

namespace veritope {
namespace {

using Index = std::array<std::size_t, 3>;

/// A volume by its points: knots of each axis, the first one slowest here.
template <typename At>
ExactVolume volume_of(const std::array<int, 3>& degrees,
                      const std::array<std::vector<int>, 3>& knots, bool is_rational, At at) {
  std::array<KnotAxis<Rational>, 3> axes;
  Grid<3> grid;
  for (std::size_t a = 0; a < 3; ++a) {
    std::vector<Rational> numbers;
    for (const int k : knots[a]) numbers.emplace_back(k);
    axes[a] = make_knot_axis(degrees[a], std::move(numbers)).value();
    grid.size[a] = axes[a].num_control();
  }
  const std::size_t count = grid.count(), components = is_rational ? 4 : 3;
  std::vector<Rational> values(count * components);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<Rational> p = at(grid.index_of(i));
    for (std::size_t c = 0; c < components; ++c) values[c * count + i] = p[c];
  }
  return {axes, static_cast<int>(components), is_rational, std::move(values)};
}

/// The volume with other axes: axis a of the result is axis `from[a]`, reversed or not. Knots t become -t.
ExactVolume turned(const ExactVolume& v, const Index& from,
                   const std::array<bool, 3>& is_reversed) {
  std::array<KnotAxis<Rational>, 3> axes;
  Grid<3> grid;
  for (std::size_t a = 0; a < 3; ++a) {
    axes[a] = v.axis(from[a]);
    if (is_reversed[a]) {
      for (Rational& t : axes[a].knots) t.negate();
      std::reverse(axes[a].knots.begin(), axes[a].knots.end());
    }
    grid.size[a] = axes[a].num_control();
  }
  std::vector<Rational> values;
  for (int c = 0; c < v.num_components(); ++c)
    for (std::size_t i = 0; i < grid.count(); ++i) {
      const Index to = grid.index_of(i);
      Index old{};
      for (std::size_t a = 0; a < 3; ++a)
        old[from[a]] = is_reversed[a] ? grid.size[a] - 1 - to[a] : to[a];
      values.push_back(v.component(c)[v.grid().at(old)]);
    }
  return {axes, v.num_components(), v.is_rational(), std::move(values)};
}

SplineModel model_of(std::vector<ExactVolume> volumes) {
  SplineModel out;
  for (ExactVolume& v : volumes) out.entities.push_back({std::move(v), {}, {}, {}});
  return out;
}

BoundaryFaces faces_of(const SplineModel& model) {
  auto faces = boundary_faces(model);
  EXPECT_TRUE(faces) << (faces ? "" : to_string(faces.error()));
  return faces ? std::move(*faces) : BoundaryFaces{};
}
BoundaryFaces faces_of_text(const std::string& itd) {
  return faces_of(io_test::model_of(SplineFormat::kItd, itd));
}

/// Whether the pieces of volume_faces, which is another algorithm, are the pieces of these faces.
bool agrees(const BoundaryFaces& faces, const SplineModel& model) {
  const auto pieces = volume_faces(model);
  return pieces && have_same_pieces(faces, pieces->patches);
}

bool is_closed(const BoundaryFaces& faces) {
  std::vector<ExactSurface> surfaces;
  for (const SplineEntity& e : faces.model.entities)
    surfaces.push_back(std::get<ExactSurface>(e.shape));
  PatchInput input;
  input.patches = patches_of(surfaces).value();
  return make_patch_complex(std::move(input)).value().is_closed_oriented_surface();
}

/// Numbers 6 volume + 2 axis + end.
std::vector<std::uint64_t> numbers_of(const BoundaryFaces& faces) {
  std::vector<std::uint64_t> out;
  for (const VolumeFace& f : faces.faces) out.push_back(6 * f.volume + 2 * f.axis + f.end);
  return out;
}
std::vector<std::uint64_t> all_but(std::uint64_t count, const std::vector<std::uint64_t>& missing) {
  std::vector<std::uint64_t> out;
  for (std::uint64_t i = 0; i < count; ++i)
    if (std::find(missing.begin(), missing.end(), i) == missing.end()) out.push_back(i);
  return out;
}

/// The box from (x, 0, 0) to (x + 1, 1, 1), u along x.
ExactVolume box(int x, bool is_left_handed = false) {
  const std::vector<int> k = {0, 0, 1, 1};
  const ExactVolume out = volume_of({1, 1, 1}, {k, k, k}, false, [&](const Index& i) {
    return std::vector<Rational>{Rational(x + static_cast<int>(i[0])),
                                 Rational(static_cast<int>(i[1])),
                                 Rational(static_cast<int>(i[2]))};
  });
  return is_left_handed ? turned(out, {1, 0, 2}, {}) : out;
}

/// A block from x to x + 1 whose sides have no symmetry: degrees 1, 2, 1 and knots that are not even.
ExactVolume lopsided(int x, int weight) {
  return volume_of({1, 2, 1}, {{{0, 0, 1, 1}, {0, 0, 0, 1, 3, 3, 3}, {0, 0, 2, 7, 7}}}, true,
                   [&](const Index& i) {
                     const int y = static_cast<int>(i[1]), z = static_cast<int>(i[2]);
                     const Rational w(weight * (1 + y + z));
                     return std::vector<Rational>{w * Rational(x + static_cast<int>(i[0])),
                                                  w * Rational(y * y), w * Rational(z), w};
                   });
}

// The table of section 3, literally.
constexpr std::size_t kRightHanded[3][2][2] = {
    {{2, 1}, {1, 2}}, {{0, 2}, {2, 0}}, {{1, 0}, {0, 1}}};

TEST(BoundaryFaces, HaveTheParametersOfTheTableForEitherHand) {
  for (const bool is_left : {false, true}) {
    const SplineModel model = model_of({box(0, is_left)});
    const BoundaryFaces faces = faces_of(model);
    ASSERT_EQ(numbers_of(faces), all_but(6, {}));
    for (std::size_t f = 0; f < 6; ++f) {
      const VolumeFace& face = faces.faces[f];
      const auto& table = kRightHanded[face.axis][face.end];
      EXPECT_EQ(face.axes[0], table[is_left ? 1 : 0]) << f;
      EXPECT_EQ(face.axes[1], table[is_left ? 0 : 1]) << f;
      EXPECT_EQ(face.at, Rational(static_cast<int>(face.end)));
      // Each control point is the volume's.
      const auto& surface = std::get<ExactSurface>(faces.model.entities[f].shape);
      const auto& volume = std::get<ExactVolume>(model.entities[0].shape);
      for (std::size_t i = 0; i < 4; ++i) {
        Index at{};
        at[face.axis] = face.end, at[face.axes[0]] = i / 2, at[face.axes[1]] = i % 2;
        for (int c = 0; c < 3; ++c)
          EXPECT_EQ(surface.component(c)[i], volume.component(c)[volume.grid().at(at)]);
      }
    }
    EXPECT_TRUE(is_closed(faces));
    EXPECT_TRUE(agrees(faces, model));
  }
}

// The second volume's axes are permuted and reversed in all 48 ways; half of them are left-handed, and its face is the
// wall under each of the 8 symmetries.
TEST(BoundaryFaces, FindAWallUnderEverySymmetry) {
  Index from = {0, 1, 2};
  std::array<std::size_t, 2> hands{};
  do {
    for (unsigned flips = 0; flips < 8; ++flips) {
      const std::array<bool, 3> is_reversed = {(flips & 1) != 0, (flips & 2) != 0,
                                               (flips & 4) != 0};
      const SplineModel model =
          model_of({lopsided(0, 1), turned(lopsided(1, 5), from, is_reversed)});
      const BoundaryFaces faces = faces_of(model);
      EXPECT_EQ(faces.num_walls, 1u) << flips;
      EXPECT_EQ(faces.faces.size(), 10u) << flips;
      EXPECT_TRUE(is_closed(faces)) << flips;
      EXPECT_TRUE(agrees(faces, model)) << flips;
      // The faces of a right-handed volume have the axes of the table.
      const VolumeFace& last = faces.faces.back();
      const bool is_left = last.axes[0] != kRightHanded[last.axis][last.end][0];
      ++hands[is_left ? 1 : 0];
    }
  } while (std::next_permutation(from.begin(), from.end()));
  EXPECT_EQ(hands, (std::array<std::size_t, 2>{24, 24}));
}

TEST(BoundaryFaces, AreNoWallIfAnythingDiffers) {
  const auto count = [](ExactVolume second) {
    return faces_of(model_of({lopsided(0, 1), std::move(second)})).num_walls;
  };
  EXPECT_EQ(count(lopsided(1, 3)), 1u);
  ExactVolume point = lopsided(1, 3);
  point.component(2)[4] += Rational(Integer(1), Integer(1) << 40);  // on its first layer
  EXPECT_EQ(count(point), 0u);
  ExactVolume weight = lopsided(1, 3);
  for (int c = 0; c < 4; ++c) weight.component(c)[4] *= Rational(2);
  EXPECT_EQ(count(weight), 0u);
  const ExactVolume even =
      volume_of({1, 2, 1}, {{{0, 0, 1, 1}, {0, 0, 0, 1, 2, 2, 2}, {0, 0, 2, 7, 7}}}, true,
                [&](const Index& i) {
                  const ExactVolume same = lopsided(1, 3);
                  std::vector<Rational> out;
                  for (int c = 0; c < 4; ++c) out.push_back(same.component(c)[same.grid().at(i)]);
                  return out;
                });
  EXPECT_EQ(count(even), 0u);
  EXPECT_EQ(count(lopsided(2, 3)), 0u);  // elsewhere
}

TEST(BoundaryFaces, AreComparedInTheirLowestDegrees) {
  const ExactVolume raised = volume_of(
      {1, 3, 2}, {{{0, 0, 1, 1}, {0, 0, 0, 0, 6, 6, 6, 6}, {0, 0, 0, 4, 4, 4}}}, true,
      [](const Index& i) {
        return std::vector<Rational>{Rational(1 + static_cast<int>(i[0])),
                                     Rational(static_cast<int>(i[1])) / Rational(3),
                                     Rational(static_cast<int>(i[2])) / Rational(2), Rational(1)};
      });
  const SplineModel model = model_of({box(0), raised, box(2)});
  const BoundaryFaces faces = faces_of(model);
  EXPECT_EQ(faces.num_walls, 2u);
  EXPECT_TRUE(agrees(faces, model));
  EXPECT_EQ(std::get<ExactSurface>(faces.model.entities[6].shape).axis(0).degree, 2)
      << "the entities keep their degrees";
}

TEST(BoundaryFaces, OfARingThatIsClosedOnItselfHaveNoWall) {
  constexpr int kSquare[5][2] = {{2, 0}, {0, 2}, {-2, 0}, {0, -2}, {2, 0}};
  for (const bool is_left : {false, true}) {
    const ExactVolume ring =
        volume_of({1, 1, 1}, {{{0, 0, 1, 2, 3, 4, 4}, {0, 0, 1, 1}, {0, 0, 1, 1}}}, false,
                  [&](const Index& i) {
                    const int r = 1 + static_cast<int>(i[1]);
                    return std::vector<Rational>{Rational(r * kSquare[i[0]][0]),
                                                 Rational(r * kSquare[i[0]][1]),
                                                 Rational(static_cast<int>(i[2]))};
                  });
    const SplineModel model = model_of({is_left ? turned(ring, {0, 2, 1}, {}) : ring});
    const BoundaryFaces faces = faces_of(model);
    EXPECT_EQ(numbers_of(faces), all_but(6, {0, 1}));
    EXPECT_TRUE(is_closed(faces));
    EXPECT_TRUE(agrees(faces, model));
  }
}

// The last two are one box, so that three faces are the square x = 1.
TEST(BoundaryFaces, ThatThreeVolumesShareStay) {
  const BoundaryFaces faces = faces_of(model_of({box(0), box(1), box(1, true), box(2)}));
  EXPECT_EQ(faces.num_walls, 0u);
  EXPECT_EQ(faces.faces.size(), 24u);
}

// Two volumes on the same side of a face: normals agree, so that it is no wall.
TEST(BoundaryFaces, OfTwoVolumesOnOneSideStay) {
  const SplineModel twice = model_of({box(0), box(0)});
  EXPECT_EQ(faces_of(twice).faces.size(), 12u);
  EXPECT_TRUE(agrees(faces_of(twice), twice));
}

// A wedge of a cone, rational in u; v = 0 is its axis, w = 1 its apex.
TEST(BoundaryFaces, WithoutAreaAreLeftOut) {
  const auto wedge = [](const std::string& a, const std::string& b, const std::string& c) {
    const std::string apex = " [1 0 0 2] [.5 0 0 1] [1 0 0 2]";
    return "[TRIVAR BEZIER 3 2 2 P3 [1 0 0 0] [.5 0 0 0] [1 0 0 0] [1 " + a + " 0] [.5 " + b +
           " 0] [1 " + c + " 0]" + apex + apex + "]\n";
  };
  const std::string cone = wedge("1 0", "1 1", "0 1") + wedge("0 1", "-1 1", "-1 0") +
                           wedge("-1 0", "-1 -1", "0 -1") + wedge("0 -1", "1 -1", "1 0");
  const BoundaryFaces faces = faces_of_text(cone);
  EXPECT_EQ(faces.num_flat, 8u);
  EXPECT_EQ(faces.faces.size(), 8u);
  EXPECT_TRUE(is_closed(faces));
  EXPECT_TRUE(agrees(faces, io_test::model_of(SplineFormat::kItd, cone)));
}

// A disc of degree 2 has no hand in its corners: the first determinants are 0.
TEST(BoundaryFaces, OfAVolumeWithFlatCornersHaveTheHandOfItsInside) {
  constexpr int kDisc[9][3] = {{1, 0, 1},  {1, 1, 1},  {0, 1, 1},   {1, -1, 1}, {0, 0, 2},
                               {-1, 1, 1}, {0, -1, 1}, {-1, -1, 1}, {-1, 0, 1}};
  const auto cylinder = volume_of(
      {2, 2, 1}, {{{0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}}}, true,
      [&](const Index& i) {
        const auto& p = kDisc[3 * i[0] + i[1]];
        return std::vector<Rational>{Rational(p[0]), Rational(p[1]),
                                     Rational(p[2] * static_cast<int>(i[2])), Rational(p[2])};
      });
  for (const bool is_left : {false, true}) {
    const SplineModel model = model_of({is_left ? turned(cylinder, {0, 1, 2}, {true}) : cylinder});
    EXPECT_TRUE(agrees(faces_of(model), model)) << is_left;
  }
}

std::string refusal(const SplineModel& model) {
  const auto faces = boundary_faces(model);
  if (faces) return "none";
  const Error& error = faces.error();
  return std::string(code_name(error.code)) +
         (error.place.entity ? " " + std::to_string(*error.place.entity) : "") + ": " +
         error.message;
}
void expect_refused(const SplineModel& model, const std::string& start) {
  EXPECT_EQ(refusal(model).substr(0, start.size()), start);
}

TEST(BoundaryFaces, OfModelsThatTheRuleRefusesAreAnError) {
  const auto with = [](const ExactVolume& v) { return model_of({box(0), v}); };
  const auto knots = [](std::vector<int> u) {
    return volume_of({2, 1, 1}, {{std::move(u), {0, 0, 1, 1}, {0, 0, 1, 1}}}, false,
                     [](const Index& i) {
                       return std::vector<Rational>{Rational(3 + static_cast<int>(i[0])),
                                                    Rational(static_cast<int>(i[1])),
                                                    Rational(static_cast<int>(i[2]))};
                     });
  };
  EXPECT_EQ(refusal(with(knots({0, 0, 0, 1, 1, 2, 2, 2}))), "none");
  expect_refused(with(knots({0, 0, 0, 1, 1, 1, 2, 2, 2})),
                 "bad-argument 1: axis u: the knot 1 occurs more often than the degree");
  expect_refused(with(knots({0, 0, 1, 2, 2, 2})),
                 "bad-argument 1: axis u: its ends are not clamped");
  expect_refused(with(knots({0, 0, 0, 1, 1, 2})),
                 "bad-argument 1: axis u: its ends are not clamped");
  expect_refused(
      io_test::model_of(SplineFormat::kItd, "[TRIVAR BEZIER 2 2 2 E1 [0][1][2][3][4][5][6][7]]"),
      "bad-argument 0: a volume with 1 coordinates");
  expect_refused(io_test::model_of(SplineFormat::kItd,
                                   "[SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 0]]"),
                 "bad-argument 0: a surface");
  ExactVolume flat = box(0);  // four faces are segments, two a wall
  for (Rational& z : flat.component(2)) z = Rational();
  expect_refused(model_of({flat}), "empty: no face of a volume is left");
  ExactVolume longer = box(0);
  longer.component(0)[7] = Rational(Integer(1) << 8191);
  EXPECT_EQ(refusal(model_of({longer})), "none");
  longer.component(1)[7] = Rational(Integer(5), Integer(3));
  expect_refused(model_of({longer}),
                 "bad-argument 0: control point 7 has numbers of over 8192 bits");
  // Closed on itself in three directions.
  const std::vector<int> two = {0, 0, 1, 2, 2};
  expect_refused(model_of({volume_of({1, 1, 1}, {two, two, two}, false,
                                     [](const Index& i) {
                                       std::vector<Rational> p;
                                       for (const std::size_t k : i) p.emplace_back(k == 1 ? 1 : 0);
                                       return p;
                                     })}),
                 "bad-argument 0: the volume is folded: its corners have different hands");
}

TEST(BoundaryFaces, TheCornersOfAVolumeHaveOneHandOrItFolds) {
  EXPECT_EQ(hand_at_corners(box(0)), Sign::kPositive);
  EXPECT_EQ(hand_at_corners(turned(box(0), {0, 1, 2}, {true})), Sign::kNegative);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    ExactVolume dented = box(0);  // the corner lies behind the plane of its three neighbours
    for (int c = 0; c < 3; ++c) {
      Rational& x = dented.component(c)[corner];
      const Rational& opposite = dented.component(c)[7 - corner];
      x = (x + Rational(3) * opposite) / Rational(4);
    }
    EXPECT_EQ(hand_at_corners(dented), std::nullopt) << corner;
    expect_refused(model_of({box(5), dented}), "bad-argument 1: the volume is folded");
  }
  ExactVolume flat = box(0);
  for (Rational& z : flat.component(2)) z = Rational();
  EXPECT_EQ(hand_at_corners(flat), Sign::kZero);
}

// Where two volumes cut their wall differently, the rule keeps it, and the pieces of volume_faces are fewer.
TEST(BoundaryFaces, DoNotHaveThePiecesOfVolumesThatCutAWallDifferently) {
  const std::string bar =
      "[TRIVAR BSPLINE 2 3 2 2 2 2 E3 [KV 0 0 1 1] [KV 0 0 1 2 2] [KV 0 0 1 1] [1 0 0][2 0 0]"
      "[1 1 0][2 1 0][1 2 0][2 2 0] [1 0 1][2 0 1][1 1 1][2 1 1][1 2 1][2 2 1]]\n";
  const auto cube = [](const std::string& y, const std::string& z) {
    return "[TRIVAR BEZIER 2 2 2 E3 [0 " + y + " 0] [1 " + y + " 0] [0 " + z + " 0] [1 " + z +
           " 0] [0 " + y + " 1] [1 " + y + " 1] [0 " + z + " 1] [1 " + z + " 1]]\n";
  };
  const SplineModel model =
      io_test::model_of(SplineFormat::kItd, bar + cube("0", "1") + cube("1", "2"));
  const BoundaryFaces faces = faces_of(model);
  EXPECT_EQ(faces.num_walls, 1u);
  EXPECT_FALSE(agrees(faces, model));
}

TEST(BoundaryFaces, OfRealVolumesHaveTheirPieces) {
  const char* const data = std::getenv("VERITOPE_DATA");
  if (data == nullptr) GTEST_SKIP() << "VERITOPE_DATA is not set";
  const std::string cad = std::string(data) + "/cad/";
  for (const char* const name :
       {"iritprim__ns_sphere_rational.itd", "iritprim__ns_cone_rational.itd",
        "iritprim__ns_cylinder_rational.itd", "mfem__ball-nurbs.mesh",
        "mfem__two-cubes-nurbs-rot.mesh", "mfem__beam-hex-nurbs.mesh", "gismo__GshapedVolume.xml",
        "gotools-data__nut.g2"}) {
    const auto file = read_spline_file(cad + name, {});
    ASSERT_TRUE(file) << name;
    EXPECT_TRUE(agrees(faces_of(file->model), file->model)) << name;
  }
}

}  // namespace
}  // namespace veritope
