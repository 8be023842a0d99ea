// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/perturbed.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "robust/base/check.h"
#include "tests/predicates/point_generators.h"
#include "tests/predicates/rational_oracle.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

// ---- The oracle: the determinant of the moved points as a polynomial in all amounts ---------------

// Bit r of a key: the amount number r of predicates/perturbed.h, e^(2^r). So the key is the exponent of e.
using Polynomial = std::map<std::uint32_t, mpq_class>;

Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial r;
  for (const auto& [e, c] : a) {
    for (const auto& [f, d] : b) {
      EXPECT_EQ(e & f, 0u);
      r[e | f] += c * d;
    }
  }
  return r;
}

struct Scene {
  std::size_t dimension;
  bool is_lifted;
  std::vector<Vec3d> points;
  std::vector<PointId> ids;

  std::size_t size() const { return points.size(); }
  std::size_t rank(std::size_t i) const {
    return static_cast<std::size_t>(
        std::count_if(ids.begin(), ids.end(), [&](PointId id) { return id < ids[i]; }));
  }
  // Coordinate j of point i, j = dimension: the squares.
  mpq_class entry(std::size_t i, std::size_t j) const {
    if (j < dimension) return points[i][static_cast<int>(j)];
    mpq_class sum;
    for (std::size_t k = 0; k < dimension; ++k) sum += entry(i, k) * entry(i, k);
    return sum;
  }
  std::size_t amount(std::size_t i, std::size_t j) const {
    if (j == dimension) return rank(i);
    return (is_lifted ? size() : 0) + rank(i) * dimension + j;
  }
  std::size_t num_columns() const { return dimension + (is_lifted ? 1 : 0); }
  int orientation() const { return is_lifted ? -1 : 1; }  // of the rows (1, coordinates, squares)
};

int sign_by_polynomial(const Scene& scene) {
  std::vector<std::size_t> order(scene.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Polynomial sum;
  do {  // Leibniz; column 0 holds the ones
    int sign = 1;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) sign = order[k] > order[i] ? -sign : sign;
    }
    Polynomial term{{0u, mpq_class(sign)}};
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (order[i] == 0) continue;
      const std::size_t j = order[i] - 1;
      term = times(term, {{0u, scene.entry(i, j)}, {1u << scene.amount(i, j), mpq_class(1)}});
    }
    for (const auto& [e, c] : term) sum[e] += c;
  } while (std::next_permutation(order.begin(), order.end()));
  for (const auto& [e, c] : sum) {
    if (sgn(c) != 0) return sgn(c) * scene.orientation();
  }
  return 0;
}

// With a number in the place of e: 2^-32 is small enough for integers up to 3.
int sign_by_tiny_amounts(const Scene& scene) {
  oracle::Matrix m;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    m.push_back({1});
    for (std::size_t j = 0; j < scene.num_columns(); ++j) {
      mpq_class e(1);
      mpq_div_2exp(e.get_mpq_t(), e.get_mpq_t(), 32ul << scene.amount(i, j));
      m.back().push_back(scene.entry(i, j) + e);
    }
  }
  return oracle::determinant_sign(std::move(m)) * scene.orientation();
}

// ---- The predicates on a scene --------------------------------------------------------------------

Vec2d drop_z(const Vec3d& p) { return {p.x, p.y}; }
Sign ask(const Scene& s, const std::vector<std::size_t>& k) {
  const auto& p = s.points;
  const auto& id = s.ids;
  if (s.dimension == 2 && !s.is_lifted) {
    return orient2d_perturbed({drop_z(p[k[0]]), drop_z(p[k[1]]), drop_z(p[k[2]])},
                              {id[k[0]], id[k[1]], id[k[2]]});
  }
  if (s.dimension == 2) {
    return in_circle_perturbed({drop_z(p[k[0]]), drop_z(p[k[1]]), drop_z(p[k[2]]), drop_z(p[k[3]])},
                               {id[k[0]], id[k[1]], id[k[2]], id[k[3]]});
  }
  if (!s.is_lifted) {
    return orient3d_perturbed({p[k[0]], p[k[1]], p[k[2]], p[k[3]]},
                              {id[k[0]], id[k[1]], id[k[2]], id[k[3]]});
  }
  return in_sphere_perturbed({p[k[0]], p[k[1]], p[k[2]], p[k[3]], p[k[4]]},
                             {id[k[0]], id[k[1]], id[k[2]], id[k[3]], id[k[4]]});
}
std::vector<std::size_t> straight(const Scene& s) {
  std::vector<std::size_t> k(s.size());
  std::iota(k.begin(), k.end(), std::size_t{0});
  return k;
}
int unperturbed(const Scene& s) {
  const auto& p = s.points;
  if (s.dimension == 2 && !s.is_lifted) return to_int(orient2d(drop_z(p[0]), drop_z(p[1]), drop_z(p[2])));
  if (s.dimension == 2) return to_int(in_circle(drop_z(p[0]), drop_z(p[1]), drop_z(p[2]), drop_z(p[3])));
  if (!s.is_lifted) return to_int(orient3d(p[0], p[1], p[2], p[3]));
  return to_int(in_sphere(p[0], p[1], p[2], p[3], p[4]));
}

struct Shape {
  std::size_t dimension;
  bool is_lifted;
};
constexpr Shape kShapes[] = {{2, false}, {3, false}, {2, true}, {3, true}};

// Few values: coincident, collinear and coplanar points of every kind.
Scene degenerate_scene(Shape shape, Random& random) {
  Scene s{shape.dimension, shape.is_lifted, {}, {}};
  const std::int64_t range = random.between(0, 3);
  for (std::size_t i = 0; i < shape.dimension + (shape.is_lifted ? 2 : 1); ++i) {
    const auto draw = [&] { return static_cast<double>(random.between(-range, range)); };
    s.points.push_back({draw(), draw(), shape.dimension == 3 ? draw() : 0});
    s.ids.push_back(random.next() << 3 | i);
  }
  return s;
}
std::string text(const Scene& s) {
  std::string out = std::to_string(s.dimension) + (s.is_lifted ? "d lifted:" : "d:");
  for (std::size_t i = 0; i < s.size(); ++i) {
    char buffer[160];
    std::snprintf(buffer, sizeof buffer, " {%a, %a, %a} id %llu", s.points[i].x, s.points[i].y,
                  s.points[i].z, static_cast<unsigned long long>(s.ids[i]));
    out += buffer;
  }
  return out;
}

TEST(Perturbed, IsTheSignOfTheLeadingCoefficientOfTheMovedPoints) {
  const std::uint64_t seed = 3;
  Random random(seed);
  for (const Shape shape : kShapes) {
    int zeros = 0;
    for (long i = 0; i < scaled(shape.dimension == 3 && shape.is_lifted ? 60 : 300); ++i) {
      const Scene s = degenerate_scene(shape, random);
      const int expected = sign_by_polynomial(s), plain = unperturbed(s);
      zeros += plain == 0;
      EXPECT_NE(expected, 0);
      EXPECT_EQ(to_int(ask(s, straight(s))), expected) << "seed " << seed << ": " << text(s);
      if (plain != 0) {
        EXPECT_EQ(plain, expected);
      }
    }
    EXPECT_GE(zeros, 20);
  }
}

TEST(Perturbed, IsTheSignOfPointsThatAreMovedByTinyAmounts) {
  const std::uint64_t seed = 4;
  Random random(seed);
  for (const Shape shape : {kShapes[0], kShapes[1], kShapes[2]}) {
    for (int i = 0; i < 25; ++i) {
      const Scene s = degenerate_scene(shape, random);
      EXPECT_EQ(to_int(ask(s, straight(s))), sign_by_tiny_amounts(s))
          << "seed " << seed << ": " << text(s);
    }
  }
}

TEST(Perturbed, EveryOrderOfTheArgumentsHasTheSignOfItsPermutation) {
  const std::uint64_t seed = 5;
  Random random(seed);
  for (const Shape shape : kShapes) {
    for (int i = 0; i < 10; ++i) {
      const Scene s = degenerate_scene(shape, random);
      const Sign first = ask(s, straight(s));
      std::vector<std::size_t> k = straight(s);
      do {
        Sign sign = first;
        for (std::size_t a = 0; a < k.size(); ++a) {
          for (std::size_t b = 0; b < a; ++b) sign = k[b] > k[a] ? -sign : sign;
        }
        EXPECT_EQ(ask(s, k), sign) << "seed " << seed << ": " << text(s);
      } while (std::next_permutation(k.begin(), k.end()));
    }
  }
}

TEST(Perturbed, OnlyTheOrderOfTheIdsMatters) {
  Random random(6);
  for (const Shape shape : kShapes) {
    for (int i = 0; i < 50; ++i) {
      const Scene s = degenerate_scene(shape, random);
      Scene t = s;
      for (std::size_t k = 0; k < s.size(); ++k) t.ids[k] = 1000 + 7 * s.rank(k);
      EXPECT_EQ(ask(s, straight(s)), ask(t, straight(t))) << text(s);
    }
  }
}

// Five points in the plane, each three seen as one triangle orientation: no contradiction, by the Grassmann-Pluecker
// relation that three-valued signs of real points obey.
TEST(Perturbed, SignsOfAllTriplesAreThoseOfRealPoints) {
  Random random(8);
  for (int i = 0; i < 300; ++i) {
    const std::int64_t range = random.between(0, 2);
    std::array<Vec2d, 5> p;
    for (Vec2d& v : p)
      v = {static_cast<double>(random.between(-range, range)),
           static_cast<double>(random.between(-range, range))};
    const auto turn = [&](PointId a, PointId b, PointId c) {
      return to_int(orient2d_perturbed({p[a], p[b], p[c]}, {a, b, c}));
    };
    // [0 1 2][0 3 4] - [0 1 3][0 2 4] + [0 1 4][0 2 3] = 0
    const int x = turn(0, 1, 2) * turn(0, 3, 4), y = -turn(0, 1, 3) * turn(0, 2, 4),
              z = turn(0, 1, 4) * turn(0, 2, 3);
    EXPECT_FALSE(x == y && y == z) << i;
  }
}

TEST(Perturbed, ExtremeExponentsAndEveryKindOfPointsAreNeverZero) {
  const std::uint64_t seed = 9;
  Random random(seed);
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    for (int i = 0; i < 20; ++i) {
      const generate::Points p = generate::points(static_cast<generate::Kind>(kind), random);
      for (const Shape shape : kShapes) {
        Scene s{shape.dimension, shape.is_lifted, {}, {}};
        for (std::size_t k = 0; k < shape.dimension + (shape.is_lifted ? 2 : 1); ++k) {
          s.points.push_back(p[k]), s.ids.push_back(k == 0 ? 99 : k);
        }
        const Sign sign = ask(s, straight(s));
        EXPECT_NE(sign, Sign::kZero) << text(s);
        if (i < 4 && s.size() < 5) {
          EXPECT_EQ(to_int(sign), sign_by_polynomial(s)) << text(s);
        }
      }
    }
  }
}

TEST(Perturbed, EqualIdsAreRefusedWhereTheyWouldDecide) {
  EXPECT_EQ(orient2d_perturbed({Vec2d{0, 0}, {1, 0}, {0, 1}}, {1, 1, 1}), Sign::kPositive);
  EXPECT_THROW(orient2d_perturbed({Vec2d{0, 0}, {1, 0}, {2, 0}}, {1, 2, 1}), InternalError);
}

}  // namespace
}  // namespace veritope
