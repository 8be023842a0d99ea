// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/pn_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "robust/base/random.h"

namespace veritope {
namespace {

// The octahedron's faces halved at the midpoints of their edges, `levels` times; vertices moved to radii near 1.
struct Model {
  TriangleMesh mesh;
  std::vector<Vec3d> normals;
};
Model ball(std::uint64_t seed, int levels) {
  Random random(seed);
  Model model;
  auto& positions = model.mesh.positions;
  auto& faces = model.mesh.faces;
  positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, is_new] =
          middle.try_emplace(std::minmax({a, b}), static_cast<std::uint32_t>(positions.size()));
      if (is_new) {
        const Vec3d p = positions[a], q = positions[b];
        const double x = p.x + q.x, y = p.y + q.y, z = p.z + q.z;
        const double r = (0.95 + 0.1 * random.unit()) / std::sqrt(x * x + y * y + z * z);
        positions.push_back({x * r, y * r, z * r});
      }
      return place->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : faces) {
      const auto ab = between(a, b), bc = between(b, c), ca = between(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = finer;
  }
  for (const Vec3d& p : positions) {
    const auto off = [&] { return 0.1 * (random.unit() - 0.5); };
    model.normals.push_back({p.x + off(), p.y + off(), p.z + off()});
  }
  return model;
}

// On every common edge, both faces' patches and normals have the same coefficients.
template <Ring R>
void expect_no_gaps(const Model& model, const PnMesh<R>& pn) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<BezierCurve<R>, BezierCurve<R>>> seen;
  std::size_t common = 0;
  for (std::size_t f = 0; f < pn.num_faces(); ++f)
    for (int e = 0; e < 3; ++e) {
      auto points = boundary_curve(pn.points(f), e), normals = boundary_curve(pn.normals(f), e);
      const auto& face = model.mesh.faces[f];
      const auto a = face[static_cast<std::size_t>(e + 1) % 3],
                 b = face[static_cast<std::size_t>(e + 2) % 3];
      if (const auto other = seen.find({b, a}); other != seen.end()) {
        ++common;
        for (auto* const curve : {&points, &normals})
          for (int c = 0; c < 3; ++c)
            std::reverse(curve->component(c).begin(), curve->component(c).end());
        EXPECT_EQ(points, other->second.first) << "face " << f << ", edge " << e;
        EXPECT_EQ(normals, other->second.second) << "face " << f << ", edge " << e;
      }
      seen.emplace(std::pair{a, b}, std::pair{points, normals});
    }
  EXPECT_EQ(common, pn.num_faces() * 3 / 2);
  EXPECT_EQ(pn.edges().size(), common);
}

TEST(PnMesh, HasNoGapsExactlyOrRounded) {
  const Model model = ball(1, 2);
  const auto exact = make_pn_mesh(model.mesh, model.normals);
  ASSERT_TRUE(exact) << to_string(exact.error());
  expect_no_gaps(model, *exact);
  const auto nearest = rounded(*exact);
  ASSERT_TRUE(nearest);
  expect_no_gaps(model, *nearest);
}

TEST(PnMesh, HasThePatchesOfItsTriangles) {
  const Model model = ball(2, 1);
  const auto pn = make_pn_mesh(model.mesh, model.normals);
  ASSERT_TRUE(pn);
  const auto exact = [](const Vec3d& v) -> PnPoint {
    return {Rational::from_double(v.x), Rational::from_double(v.y), Rational::from_double(v.z)};
  };
  for (std::size_t f = 0; f < pn->num_faces(); ++f) {
    std::array<PnPoint, 3> corners, normals;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = exact(model.mesh.positions[model.mesh.faces[f][i]]);
      normals[i] = exact(model.normals[model.mesh.faces[f][i]]);
    }
    const auto alone = make_pn_triangle(corners, normals);
    ASSERT_TRUE(alone);
    EXPECT_EQ(pn->points(f), alone->points) << "face " << f;
    EXPECT_EQ(pn->normals(f), alone->normals) << "face " << f;
  }
}

TEST(PnMesh, RoundsEveryNumberOnce) {
  const Model model = ball(3, 1);
  const auto exact = make_pn_mesh(model.mesh, model.normals);
  const auto nearest = rounded(*exact);
  ASSERT_TRUE(nearest);
  for (std::size_t f = 0; f < exact->num_faces(); ++f) {
    for (std::size_t i = 0; i < 30; ++i)
      EXPECT_EQ(nearest->points(f).coefficients()[i],
                nearest_double(exact->points(f).coefficients()[i]));
    for (std::size_t i = 0; i < 18; ++i)
      EXPECT_EQ(nearest->normals(f).coefficients()[i],
                nearest_double(exact->normals(f).coefficients()[i]));
  }
}

// Open meshes, edges of three faces and vertices that no face has are legal: the surface is what the triangles say.
TEST(PnMesh, TakesWhatIsNoClosedSurface) {
  const Model fan{{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}},
                   {{0, 2, 1}, {0, 3, 1}, {0, 4, 1}}},
                  {{1, -1, 0}, {2, -1, 0}, {1, -1, 0}, {1, -1, 0}, {1, -1, 0}, {0, 0, 0}}};
  const auto pn = make_pn_mesh(fan.mesh, fan.normals);
  ASSERT_TRUE(pn) << to_string(pn.error());
  EXPECT_EQ(pn->edges().size(), 7u);
  const auto axis = boundary_curve(pn->points(0), 1);
  EXPECT_EQ(boundary_curve(pn->points(1), 1), axis);
  EXPECT_EQ(boundary_curve(pn->points(2), 1), axis);
}

TEST(PnMesh, OfNoFacesHasNone) {
  const auto pn = make_pn_mesh({}, std::span<const Vec3d>());
  ASSERT_TRUE(pn);
  EXPECT_EQ(pn->num_faces(), 0u);
  EXPECT_TRUE(rounded(*pn));
}

TEST(PnMesh, NamesTheFaceAndTheCornerThatItRefuses) {
  Model model = ball(4, 0);
  model.normals[3] = {0, 1, 0};
  const auto off = make_pn_mesh(model.mesh, model.normals);
  ASSERT_FALSE(off);
  EXPECT_EQ(off.error().code, Code::kBadArgument);
  EXPECT_EQ(to_string(off.error()),
            "face 2: vertex 3: the normal of corner 1, (0, 1, 0), is 90 degrees or more off the "
            "plane's normal, (-1, -1, 1)");
  model.normals[3] = {0, 0, 0};
  EXPECT_EQ(to_string(make_pn_mesh(model.mesh, model.normals).error()),
            "face 2: vertex 3: the normal of corner 1 is zero");
}

// On the octahedron with one corner pulled out: sums by hand.
TEST(PnMesh, AreaNormalsAreExactSums) {
  Model model = ball(4, 0);
  const std::vector<PnDirection> sums = area_normals(model.mesh);
  std::vector<std::array<Rational, 3>> want(model.mesh.positions.size());
  for (const auto& face : model.mesh.faces) {
    std::array<std::array<Rational, 3>, 3> p;
    for (std::size_t c = 0; c < 3; ++c)
      for (int k = 0; k < 3; ++k)
        p[c][static_cast<std::size_t>(k)] = Rational::from_double(model.mesh.positions[face[c]][k]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      Rational area;  // the shoelace formula
      for (std::size_t c = 0; c < 3; ++c)
        area += p[c][i] * p[(c + 1) % 3][j] - p[c][j] * p[(c + 1) % 3][i];
      for (const std::uint32_t v : face) want[v][k] += area;
    }
  }
  for (std::size_t v = 0; v < want.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(sums[v][k].to_rational(), want[v][k]);
  // Lengths do not matter, and sums of unequal lengths give the same patches as normals along them.
  const auto exact = make_pn_mesh(model.mesh, sums);
  ASSERT_TRUE(exact);
  std::vector<Vec3d> along;
  for (const PnDirection& n : sums)
    along.push_back({nearest_double(n[0].to_rational()), nearest_double(n[1].to_rational()),
                     nearest_double(n[2].to_rational())});
  const auto same = make_pn_mesh(model.mesh, along);
  ASSERT_TRUE(same);
  for (std::size_t f = 0; f < exact->num_faces(); ++f)
    EXPECT_TRUE(
        std::ranges::equal(exact->points(f).coefficients(), same->points(f).coefficients()));
}

TEST(PnMesh, RefusesDegenerateAndBrokenInput) {
  Model model = ball(5, 0);
  const auto message = [](const Model& m) {
    return to_string(make_pn_mesh(m.mesh, m.normals).error());
  };
  Model bad = model;
  bad.mesh.faces[4] = {2, 0, 0};
  EXPECT_EQ(message(bad), "face 4: the triangle is degenerate: (0, 1, 0) (1, 0, 0) (1, 0, 0)");
  bad = model;
  bad.mesh.faces[7][1] = 6;
  EXPECT_EQ(message(bad), "face 7: vertex 6 of 6");
  bad = model;
  bad.normals.pop_back();
  EXPECT_EQ(message(bad), "5 normals for 6 vertices");
  bad = model;
  bad.normals[2].y = std::nan("");
  EXPECT_EQ(message(bad), "vertex 2: the normal is not finite");
  bad = model;
  bad.mesh.positions[1].z = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message(bad), "vertex 1: the position is not finite");
}

TEST(PnMesh, SaysWhereAControlPointIsNoDouble) {
  constexpr double kHuge = std::numeric_limits<double>::max();
  const TriangleMesh mesh{{{kHuge, -kHuge, 0}, {kHuge, kHuge, 0}, {-kHuge, 0, 0}}, {{0, 1, 2}}};
  std::vector<Vec3d> normals(3, Vec3d{0, 0, 1});
  EXPECT_TRUE(rounded(*make_pn_mesh(mesh, normals)));
  normals[0] = {-1, 1, 0.125};
  const auto exact = make_pn_mesh(mesh, normals);
  ASSERT_TRUE(exact) << to_string(exact.error());
  const auto beyond = rounded(*exact);
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().code, Code::kNotFinite);
  EXPECT_EQ(to_string(beyond.error()), "face 0: a control point is beyond the largest double");
}

}  // namespace
}  // namespace veritope
