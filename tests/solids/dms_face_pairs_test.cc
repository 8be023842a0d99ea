// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_face_pairs_test.cc: what blocks and directions say of exact values of random solids, and pairs of
// faces that no proof may cover.
#include "solids/dms/dms_face_pairs.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_evaluator.h"
#include "tests/support/dms_truth.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

struct Proved {
  DmsModel model;
  TetrahedralComplex complex;
  DmsFacePairs pairs;
};

TetrahedralComplex complex_of(const DmsModel& model) {
  return TetrahedralComplex(model.tetrahedra, static_cast<std::uint32_t>(model.clouds.size()));
}

// A random solid near the identity, with clouds on the boundary, if it is proved; odd seeds are bent so much that pairs
// often stay open.
std::optional<Proved> draw_proved(std::uint64_t seed) {
  DmsModel model = draw_dms(seed, 3, 0).model;
  Random random(seed + 1000);
  const Rational unit = Rational(1) / Rational(seed % 2 == 0 ? 200 : 50);
  dms_truth::warp_control(model, [&](const DmsPoint& p) {
    DmsPoint out = p;
    for (std::size_t c = 0; c < 3; ++c)
      out[c] += Rational(random.between(-8, 8)) * unit + p[(c + 1) % 3] * p[(c + 2) % 3] * unit * 5;
    return out;
  });
  if (find_geometry_defects(model, 1).count > 0) return std::nullopt;
  auto trees = prove_jacobian(model);
  if (trees.index() != 0) return std::nullopt;
  TetrahedralComplex complex = complex_of(model);
  auto proved = prove_face_pairs(model, complex, std::get<0>(trees));
  if (const auto* const open = std::get_if<DmsOpenPair>(&proved)) {
    EXPECT_LE(open->first, open->second);
    EXPECT_LT(open->second, complex.boundary().size());
    return std::nullopt;
  }
  return Proved{std::move(model), std::move(complex), std::get<0>(std::move(proved))};
}

DmsPoint mean_of(Random& random, const std::vector<DmsPoint>& corners) {
  DmsPoint sum;
  Rational total;
  for (const DmsPoint& p : corners) {
    const Rational weight(random.between(0, 4));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * p[c];
    total += weight;
  }
  if (total.sign() == Sign::kZero) return corners[random.below(corners.size())];
  for (Rational& c : sum) c /= total;
  return sum;
}
std::vector<DmsPoint> corners_of(const Proved& p, std::size_t face) {
  std::vector<DmsPoint> out;
  for (const std::uint32_t v : p.complex.vertices(p.complex.boundary()[face]))
    out.push_back(p.model.knot(v, 0));
  return out;
}
DmsPoint image(DmsEvaluator& map, const DmsPoint& p) {
  const DmsValue value = map.evaluate(*map.locate(p));
  return {value.value[0], value.value[1], value.value[2]};
}

// For different points x and y of the faces of a pair.
void expect_apart(const Proved& p, const DmsFacePair& pair, DmsEvaluator& map, const DmsPoint& x,
                  const DmsPoint& y, const std::string& text) {
  const DmsPoint way = difference(image(map, y), image(map, x));
  bool grows = false;
  for (const DmsPoint& w : pair.directions)
    grows = grows || dot_product(w, way).sign() == Sign::kPositive;
  EXPECT_TRUE(grows) << text << ", faces " << pair.first << ", " << pair.second;
}

// PROVES DMS-5.U2
// PROVES DMS-5.U4
// PROVES DMS-5.U5
// PROVES DMS-5.U6
TEST(DmsFacePairs, SayWhatExactValuesShow) {
  std::array<std::size_t, 3> pairs{};
  std::size_t blocks = 0, solids = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto p = draw_proved(seed);
    if (!p) continue;
    ++solids;
    Random random(seed);
    DmsEvaluator map(p->model);
    for (const DmsFacePair& pair : p->pairs.pairs) {
      ++pairs[static_cast<std::size_t>(pair.kind)];
      const DmsPoint x = mean_of(random, corners_of(*p, pair.first)),
                     y = mean_of(random, corners_of(*p, pair.second));
      if (x != y) expect_apart(*p, pair, map, x, y, "seed " + std::to_string(seed));
    }
    for (const DmsBlock& block : p->pairs.blocks) {
      ++blocks;
      std::vector<DmsPoint> corners;
      for (const std::uint32_t t : block.tetrahedra)
        for (const std::uint32_t v : p->model.tetrahedra[t]) corners.push_back(p->model.knot(v, 0));
      const DmsPoint x = mean_of(random, corners), y = mean_of(random, corners);
      // The hull of the tetrahedra is part of the domain.
      ASSERT_TRUE(map.locate(x) && map.locate(y)) << "seed " << seed;
      if (x == y) continue;
      const DmsPoint d = difference(image(map, y), image(map, x));
      const auto& r = block.matrix;
      const DmsPoint turned{dot_product({r[0], r[1], r[2]}, d), dot_product({r[3], r[4], r[5]}, d),
                            dot_product({r[6], r[7], r[8]}, d)};
      EXPECT_EQ(dot_product(difference(y, x), turned).sign(), Sign::kPositive) << "seed " << seed;
    }
  }
  EXPECT_GT(solids, 20u);
  EXPECT_GT(blocks, 20u);
  for (const std::size_t n : pairs) EXPECT_GT(n, 20u);
}

// Every pair with a common vertex is listed, or in a block.
TEST(DmsFacePairs, LeaveNoPairOut) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto p = draw_proved(seed);
    if (!p) continue;
    std::set<std::pair<std::size_t, std::size_t>> known;
    for (const DmsFacePair& pair : p->pairs.pairs)
      ASSERT_TRUE(known.emplace(pair.first, pair.second).second) << "seed " << seed;
    const auto& boundary = p->complex.boundary();
    const auto are_in_block = [&](std::size_t i, std::size_t j) {
      return std::any_of(p->pairs.blocks.begin(), p->pairs.blocks.end(), [&](const DmsBlock& b) {
        const auto has = [&](std::size_t f) {
          return std::find(b.tetrahedra.begin(), b.tetrahedra.end(),
                           face_tetrahedron(boundary[f])) != b.tetrahedra.end();
        };
        return has(i) && has(j);
      });
    };
    for (std::size_t i = 0; i < boundary.size(); ++i)
      for (std::size_t j = i + 1; j < boundary.size(); ++j) {
        const auto a = p->complex.vertices(boundary[i]), b = p->complex.vertices(boundary[j]);
        const bool is_near = std::any_of(a.begin(), a.end(), [&](std::uint32_t v) {
          return std::find(b.begin(), b.end(), v) != b.end();
        });
        EXPECT_TRUE(!is_near || known.count({i, j}) > 0 || are_in_block(i, j)) << "seed " << seed;
      }
  }
}

// The two ends of a bar that is bent to a closed ring are one place.
TEST(DmsFacePairs, AreOpenWhereImagesMeet) {
  DmsModel bar = kuhn_domain({12, 1, 1});
  bar.degree = 2;
  for (DmsCloud& cloud : bar.clouds) cloud.resize(1);
  dms_truth::warp_control(bar, [](const DmsPoint& p) {
    const double turn = nearest_double(p[0]) * (2 * std::numbers::pi / 12),
                 radius = 4 + nearest_double(p[1]);
    return DmsPoint{Rational::from_double(std::round(radius * std::sin(turn) * 1024) / 1024),
                    Rational::from_double(std::round(radius * std::cos(turn) * 1024) / 1024), p[2]};
  });
  auto trees = prove_jacobian(bar);
  ASSERT_EQ(trees.index(), 0u);
  EXPECT_EQ(prove_face_pairs(bar, complex_of(bar), std::get<0>(trees)).index(), 1u);
}

TEST(DmsFacePairs, DoNotDependOnThreads) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto p = draw_proved(seed);
    if (!p) continue;
    DmsFacePairOptions four;
    four.jobs = 4;
    const auto again =
        prove_face_pairs(p->model, p->complex, std::get<0>(prove_jacobian(p->model)), four);
    ASSERT_EQ(again.index(), 0u);
    const DmsFacePairs& other = std::get<0>(again);
    ASSERT_EQ(other.pairs.size(), p->pairs.pairs.size());
    for (std::size_t i = 0; i < other.pairs.size(); ++i)
      EXPECT_EQ(other.pairs[i].directions, p->pairs.pairs[i].directions);
    ASSERT_EQ(other.blocks.size(), p->pairs.blocks.size());
    for (std::size_t i = 0; i < other.blocks.size(); ++i)
      EXPECT_EQ(other.blocks[i].tetrahedra, p->pairs.blocks[i].tetrahedra);
  }
}

}  // namespace
}  // namespace veritope
