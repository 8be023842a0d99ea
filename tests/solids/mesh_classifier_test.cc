// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/mesh_classifier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "solids/classify/ray_count_internal.h"
#include "solids/classify/scaled_point_internal.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/shapes.h"
#include "topology/incidence.h"
#include "topology/surface.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 20261127;

MeshClassifier classifier(const TriangleMesh& mesh, const MeshShells* shells = nullptr) {
  return std::move(MeshClassifier::make(mesh, shells).value());
}

std::vector<std::uint32_t> all_facets(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> out(mesh.faces.size());
  std::iota(out.begin(), out.end(), 0u);
  return out;
}

ExactPoint exact(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}

// The least facet that contains p, by the definition of a convex hull: p = a + s (b - a) + t (c - a) in rationals, or
// a point of an edge.
bool holds(const std::array<ExactPoint, 3>& t, const ExactPoint& p) {
  const auto minus = [](const ExactPoint& a, const ExactPoint& b) {
    return ExactPoint{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto dot = [](const ExactPoint& a, const ExactPoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const auto is_on_segment = [&](const ExactPoint& a, const ExactPoint& b) {
    const ExactPoint u = minus(b, a), w = minus(p, a);
    const Rational along = dot(u, w);
    return dot(w, w) * dot(u, u) == along * along && along.sign() >= 0 && along <= dot(u, u) &&
           (dot(u, u).sign() > 0 || dot(w, w).sign() == 0);
  };
  if (is_on_segment(t[0], t[1]) || is_on_segment(t[1], t[2]) || is_on_segment(t[2], t[0]))
    return true;
  const ExactPoint u = minus(t[1], t[0]), v = minus(t[2], t[0]), w = minus(p, t[0]);
  const Rational uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
  if (det.sign() == 0) return false;
  const Rational r = (vv * dot(u, w) - uv * dot(v, w)) / det,
                 s = (uu * dot(v, w) - uv * dot(u, w)) / det;
  for (std::size_t k = 0; k < 3; ++k)
    if (u[k] * r + v[k] * s != w[k]) return false;
  return r.sign() >= 0 && s.sign() >= 0 && r + s <= Rational(1);
}

// By rational rays in random directions, which share no code with the classifier.
PointAnswer slow_answer(const TriangleMesh& mesh, const Vec3d& p, Random& random) {
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& t = mesh.faces[f];
    if (holds(
            {exact(mesh.positions[t[0]]), exact(mesh.positions[t[1]]), exact(mesh.positions[t[2]])},
            exact(p)))
      return {0, f, kNowhere};
  }
  return {static_cast<std::int32_t>(
              oracle::winding_number(mesh, all_facets(mesh), oracle::rational(p), random)),
          kNowhere, kNowhere};
}

std::string text(const Vec3d& p) {
  char out[100];
  std::snprintf(out, sizeof out, "%a,%a,%a", p.x, p.y, p.z);
  return out;
}

// Vertices, points of edges and facets, of their planes, above them, lattice points, points that share coordinates with
// vertices, and random ones.
std::vector<Vec3d> hard_points(const TriangleMesh& mesh, Random& random, int num) {
  std::vector<Vec3d> out;
  const auto vertex = [&] { return mesh.positions[random.below(mesh.positions.size())]; };
  for (int i = 0; i < num; ++i) {
    const auto& t = mesh.faces[random.below(mesh.faces.size())];
    const Vec3d a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    const double s = static_cast<double>(random.below(9)) / 8,
                 r = static_cast<double>(random.below(9)) / 8;
    const auto mix = [&](double x, double y, double z) {
      return x + s * (y - x) + r * (1 - s) * (z - x);
    };
    const Vec3d on{mix(a.x, b.x, c.x), mix(a.y, b.y, c.y), mix(a.z, b.z, c.z)};
    const Vec3d v = vertex(), w = vertex();
    switch (i % 7) {
      case 0: out.push_back(v); break;
      case 1: out.push_back(on); break;
      case 2: out.push_back({v.x, w.y, on.z}); break;
      case 3: out.push_back({v.x, v.y, w.z}); break;
      case 4:
        out.push_back({on.x, on.y, std::nextafter(on.z, 10 * (random.below(2) != 0 ? 1 : -1))});
        break;
      case 5: out.push_back({std::floor(on.x), std::ceil(on.y), std::floor(2 * on.z) / 2}); break;
      default:
        out.push_back(
            {on.x + random.unit() - 0.5, on.y + random.unit() - 0.5, on.z + random.unit() - 0.5});
    }
  }
  return out;
}

void expect_slow_answers(const TriangleMesh& mesh, std::uint64_t seed, int num) {
  Random random(seed);
  const MeshClassifier c = classifier(mesh);
  const std::vector<Vec3d> points = hard_points(mesh, random, num);
  std::vector<PointAnswer> answers(points.size());
  c.classify(points, answers, 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(answers[i], slow_answer(mesh, points[i], random))
        << "seed " << seed << " point " << text(points[i]) << "\n"
        << shapes::to_text(mesh).substr(0, 2000);
    ASSERT_EQ(answers[i], c.classify(points[i])) << text(points[i]);
    ASSERT_EQ(answers[i], c.classify(exact(points[i]))) << text(points[i]);
  }
}

// PROVES POINT-1
TEST(MeshClassifier, AnswersPointsOfABox) {
  const TriangleMesh mesh = shapes::box({0, 0, 0}, {1, 1, 1});
  const MeshClassifier c = classifier(mesh);
  EXPECT_EQ(c.classify(Vec3d{.5, .5, .5}), (PointAnswer{1, kNowhere, kNowhere}));
  EXPECT_EQ(c.classify(Vec3d{.5, .5, 1.5}), PointAnswer());
  EXPECT_EQ(c.classify(Vec3d{-.5, .5, .5}), PointAnswer());
  for (const Vec3d& p : {Vec3d{0, 0, 0}, Vec3d{1, .25, 0}, Vec3d{.5, 1, .125}, Vec3d{1, 1, 1}})
    EXPECT_TRUE(c.classify(p).is_on()) << text(p);
  EXPECT_EQ(c.classify(Vec3d{1, .5, std::nextafter(1, 2)}), PointAnswer());
  EXPECT_EQ(c.classify(Vec3d{.5, .5, std::nextafter(1, 0)}).winding, 1);
}

TEST(MeshClassifier, AgreesWithRationalRays) {
  Random random(kSeed);
  const int num = static_cast<int>(scaled(40));
  expect_slow_answers(shapes::box({-1, 0, 0}, {1, 2, 3}, 2), kSeed + 1, num);
  expect_slow_answers(shapes::torus(9, 6, 3, 1), kSeed + 2, num);
  expect_slow_answers(shapes::saddle(), kSeed + 3, num);
  expect_slow_answers(shapes::star_polyhedron(random, 2), kSeed + 4, num);
  expect_slow_answers(shapes::hyperboloid(12, 4), kSeed + 5, num);
  expect_slow_answers(shapes::bipyramid(40), kSeed + 6, num);
  expect_slow_answers(shapes::needles(random, 20), kSeed + 7, num);
  expect_slow_answers(shapes::box_grid(3, 0.5), kSeed + 8, num);
  for (std::uint64_t i = 0; i < 20; ++i)
    expect_slow_answers(shapes::random_polycube(random, 3, 9), kSeed + 10 + i, num);
}

// Rays through vertices, along edges and in the planes of facets.
// PROVES POINT-2
TEST(RayCount, IsTheWindingNumberWhateverTheRayMeets) {
  const TriangleMesh box = shapes::box({0, 0, 0}, {2, 2, 2}, 2);
  const TriangleMesh octahedron = shapes::parse(
      "v 2,0,0 -2,0,0 0,2,0 0,-2,0 0,0,2 0,0,-2; f 0,2,4 2,1,4 1,3,4 3,0,4 2,0,5 1,2,5 3,1,5 "
      "0,3,5");
  for (int x = -3; x <= 5; ++x)
    for (int y = -3; y <= 5; ++y)
      for (int z = -3; z <= 5; ++z) {
        const auto is_off_box = [](int c) { return c < 0 || c > 4; };
        const auto is_side = [](int c) { return c == 0 || c == 4; };
        const Vec3d p{x / 2.0, y / 2.0, z / 2.0};
        const bool is_out = is_off_box(x) || is_off_box(y) || is_off_box(z);
        const auto winding = [&](const TriangleMesh& mesh, const auto& q) {
          return internal::change_along_ray(mesh, q, nullptr).winding;
        };
        if (is_out || !(is_side(x) || is_side(y) || is_side(z))) {
          EXPECT_EQ(winding(box, p), is_out ? 0 : 1) << text(p);
          EXPECT_EQ(winding(box, internal::ScaledPoint(exact(p))), is_out ? 0 : 1) << text(p);
        }
        const int sum = std::abs(x) + std::abs(y) + std::abs(z);
        if (sum == 4) continue;
        EXPECT_EQ(winding(octahedron, p), sum < 4 ? 1 : 0) << text(p);
        EXPECT_EQ(winding(octahedron, internal::ScaledPoint(exact(p))), sum < 4 ? 1 : 0) << text(p);
      }
}

// Closed chains that bound no solid: reversed, twice as large inside of itself, or crossing itself.
TEST(MeshClassifier, AnswersWindingNumbersOfAnyClosedChain) {
  const TriangleMesh outer = shapes::box({0, 0, 0}, {4, 4, 4}),
                     inner = shapes::box({1, 1, 1}, {5, 2, 2});
  const TriangleMesh turned = shapes::reversed(outer);
  EXPECT_EQ(classifier(turned).classify(Vec3d{2, 2, 3}).winding, -1);
  const TriangleMesh both = shapes::joined(outer, inner);
  EXPECT_EQ(classifier(both).classify(Vec3d{1.5, 1.5, 1.25}).winding, 2);
  EXPECT_EQ(classifier(both).classify(Vec3d{4.5, 1.5, 1.25}).winding, 1);
  expect_slow_answers(both, kSeed + 50, 100);
  // A facet with no area closes the chain: the midpoint of an edge is a vertex on one side only.
  const TriangleMesh t =
      shapes::parse("v 0,0,0 1,0,0 0,1,0 0,0,1 0.5,0,0; f 0,2,1 0,4,3 4,1,3 0,3,2 1,2,3 0,1,4");
  expect_slow_answers(t, kSeed + 51, 200);
}

TEST(MeshClassifier, AnswersAtEveryScale) {
  const TriangleMesh shape = shapes::torus(7, 5, 3, 1);
  for (const int exponent : {-1060, -1000, -500, 0, 500, 1000, 1020}) {
    const TriangleMesh mesh = shapes::scaled(shape, exponent);
    const MeshClassifier c = classifier(mesh), plain = classifier(shape);
    for (const Vec3d& p :
         {Vec3d{3, 0.25, 0.25}, Vec3d{0, 0, 0}, Vec3d{-3, 0.125, 0}, Vec3d{3.5, 3.5, 0}}) {
      const Vec3d q{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent),
                    std::ldexp(p.z, exponent)};
      if (exponent > -1000) {
        EXPECT_EQ(c.classify(q).winding, plain.classify(p).winding) << exponent << " " << text(p);
      }
    }
    for (std::uint32_t v = 0; v < mesh.positions.size(); v += 5)
      EXPECT_TRUE(c.classify(mesh.positions[v]).is_on());
  }
  // Far from the origin: 13 bits are left for the shape, or 2.
  for (const double far : {0x1p40, 0x1p50})
    expect_slow_answers(shapes::moved(shapes::box({0, 0, 0}, {8, 8, 8}, 2), {far, -far, far}),
                        kSeed + 60, 60);
}

TEST(MeshClassifier, DecidesPointsThatBinary64DoesNotHave) {
  const TriangleMesh mesh = shapes::parse("tet 0,0,0 1,0,0 0,1,0 0,0,1");
  const MeshClassifier c = classifier(mesh);
  const Rational third(Integer(1), Integer(3));
  EXPECT_TRUE(c.classify(ExactPoint{third, third, third}).is_on());  // 1/3 + 1/3 + 1/3 = 1
  for (const int depth : {60, 300, 1000, 3000}) {
    const Rational tiny = Rational::power_of_two(-depth);
    EXPECT_EQ(c.classify(ExactPoint{third, third, third - tiny}).winding, 1) << depth;
    EXPECT_EQ(c.classify(ExactPoint{third, third, third + tiny}), PointAnswer()) << depth;
    EXPECT_EQ(c.classify(ExactPoint{tiny, tiny, tiny}).winding, 1) << depth;
    EXPECT_EQ(c.classify(ExactPoint{tiny, tiny, -tiny}), PointAnswer()) << depth;
    EXPECT_TRUE(c.classify(ExactPoint{tiny, third, Rational()}).is_on()) << depth;
  }
  EXPECT_EQ(c.classify(ExactPoint{Rational::power_of_two(5000), third, third}), PointAnswer());
}

MeshShells shells_of(const TriangleMesh& mesh, const std::vector<std::uint32_t>& depth) {
  const SurfaceTopology topology = analyse_surface(
      mesh.faces,
      Incidence::build(mesh.faces, static_cast<std::uint32_t>(mesh.positions.size()), 1), 0, 1);
  return {{topology.shell_of_face.data(), topology.shell_of_face.data() + mesh.faces.size()},
          depth};
}

TEST(MeshClassifier, NamesTheInnermostShell) {
  // Boxes with the corners (i, i, i) and (16 - i, 16 - i, 16 - i), and one beside them.
  std::vector<TriangleMesh> parts;
  for (int i = 0; i < 5; ++i) {
    const double lo = i, hi = 16 - i;
    parts.push_back(shapes::box({lo, lo, lo}, {hi, hi, hi}, 3));
    if (i % 2 != 0) parts.back() = shapes::reversed(parts.back());
  }
  parts.push_back(shapes::box({20, 0, 0}, {30, 16, 16}));
  const TriangleMesh mesh = shapes::joined(parts);
  const MeshShells shells = shells_of(mesh, {0, 1, 2, 3, 4, 0});
  const MeshClassifier c = classifier(mesh, &shells);
  for (std::uint32_t i = 0; i < 5; ++i) {
    const double x = i + 0.5;
    EXPECT_EQ(c.classify(Vec3d{x, 8.25, 7.75}), (PointAnswer{i % 2 == 0 ? 1 : 0, kNowhere, i}))
        << i;
    EXPECT_EQ(c.classify(Vec3d{8.25, 16 - x, 7.75}), (PointAnswer{i % 2 == 0 ? 1 : 0, kNowhere, i}))
        << i;
    const PointAnswer on = c.classify(Vec3d{x - 0.5, 8.25, 7.75});
    EXPECT_TRUE(on.is_on());
    EXPECT_EQ(on.shell, i);
  }
  EXPECT_EQ(c.classify(Vec3d{25, 8, 8}), (PointAnswer{1, kNowhere, 5}));
  EXPECT_EQ(c.classify(Vec3d{18, 8, 8}), PointAnswer());
}

TEST(MeshClassifier, AnswersFollowRelabellingReversalAndExactMaps) {
  Random random(kSeed);
  const TriangleMesh mesh = shapes::star_polyhedron(random, 3);
  const TriangleMesh other = shapes::relabelled(mesh, random), reversed = shapes::reversed(mesh);
  const MeshClassifier c = classifier(mesh), again = classifier(other),
                       turned = classifier(reversed);
  TriangleMesh cyclic = mesh;
  for (Vec3d& p : cyclic.positions) p = {p.y, p.z, p.x};
  const MeshClassifier rotated = classifier(cyclic);
  for (const Vec3d& p : hard_points(mesh, random, static_cast<int>(scaled(300)))) {
    const PointAnswer a = c.classify(p);
    EXPECT_EQ(again.classify(p).winding, a.winding) << text(p);
    EXPECT_EQ(again.classify(p).is_on(), a.is_on()) << text(p);
    EXPECT_EQ(turned.classify(p).winding, -a.winding) << text(p);
    EXPECT_EQ(rotated.classify(Vec3d{p.y, p.z, p.x}), a) << text(p);
  }
}

TEST(MeshClassifier, DoesNotDependOnThreads) {
  Random random(kSeed);
  const TriangleMesh mesh = shapes::torus(40, 20, 3, 1);
  const MeshClassifier c = classifier(mesh);
  const std::vector<Vec3d> points = hard_points(mesh, random, 5000);
  std::vector<PointAnswer> one(points.size()), four(points.size());
  c.classify(points, one, 1);
  c.classify(points, four, 4);
  EXPECT_EQ(one, four);
}

TEST(MeshClassifier, RefusesOpenSurfaces) {
  TriangleMesh mesh = shapes::box({0, 0, 0}, {1, 1, 1});
  mesh.faces.pop_back();
  const auto made = MeshClassifier::make(mesh);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, Code::kBadArgument);
  EXPECT_NE(made.error().message.find("the edge from vertex 0 to vertex 1 is used 1 times in this direction and 0 times in the other"),
            std::string::npos)
      << made.error().message;
}

TEST(MeshClassifier, TakesAtMost250BytesAFacet) {
  for (const TriangleMesh& mesh :
       {shapes::torus(200, 100, 3, 1), shapes::bipyramid(5000), shapes::hyperboloid(5000, 900)}) {
    const LookupSize size = classifier(mesh).lookup();
    EXPECT_LE(size.bytes, 250 * mesh.faces.size());
    EXPECT_GT(size.cells, 8u);
  }
}

}  // namespace
}  // namespace veritope
