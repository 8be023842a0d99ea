// SPDX-License-Identifier: LGPL-3.0-or-later
// The conditions on domains and clouds of solids/dms: half-spaces, hulls, faces that meet, and defects of models.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "robust/base/random.h"
#include "solids/dms/dms_core.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_domain.h"
#include "solids/dms/dms_half_spaces.h"
#include "tests/support/dms_truth.h"

namespace veritope {
namespace {

DmsPoint draw_point(Random& random, int most) {
  DmsPoint p;
  for (Rational& c : p) c = Rational(random.between(-most, most));
  return p;
}

// ---- half-spaces

TEST(DmsHalfSpaces, HaveACommonPointOrWeightsThatShowThatTheyHaveNone) {
  Random random(7);
  std::array<int, 2> seen{};
  for (int round = 0; round < 600; ++round) {
    const DmsHalfSpaceKind kind =
        round % 2 == 0 ? DmsHalfSpaceKind::kOpen : DmsHalfSpaceKind::kClosed;
    std::vector<DmsHalfSpace> all(4);
    for (std::size_t m = 0; m < 3; ++m)
      all[m].vector[m] = Rational(1), all[3].vector[m] = Rational(-1);
    all[3].number = Rational(random.between(1, 4));
    for (std::int64_t i = random.between(0, 12); i > 0; --i)
      all.push_back({draw_point(random, 2), Rational(random.between(-3, 3))});
    const auto met = meet_half_spaces(all, kind);
    const bool is_open = kind == DmsHalfSpaceKind::kOpen;
    ++seen[met.index()];
    if (const auto* const p = std::get_if<DmsPoint>(&met)) {
      for (const DmsHalfSpace& h : all) {
        const Sign s = height_in(h, *p).sign();
        EXPECT_TRUE(s == Sign::kPositive || (!is_open && s == Sign::kZero)) << "round " << round;
      }
      continue;
    }
    const auto& weights = std::get<1>(met);
    ASSERT_TRUE(!weights.empty() && weights.size() <= 4) << "round " << round;
    DmsPoint vector;
    Rational number;
    for (const DmsWeightedHalfSpace& w : weights) {
      EXPECT_EQ(w.weight.sign(), Sign::kPositive);
      for (std::size_t c = 0; c < 3; ++c) vector[c] += w.weight * all[w.number].vector[c];
      number += w.weight * all[w.number].number;
    }
    EXPECT_EQ(vector, DmsPoint{}) << "round " << round;
    EXPECT_TRUE(number.sign() == Sign::kNegative || (is_open && number.sign() == Sign::kZero))
        << "round " << round;
  }
  EXPECT_GT(std::min(seen[0], seen[1]), 50);
}

TEST(DmsCore, AHullAndATetrahedronHaveAPlaneOrACommonPoint) {
  Random random(11);
  std::array<int, 2> seen{};
  for (int round = 0; round < 400; ++round) {
    std::array<DmsPoint, 4> corners;
    do {
      for (DmsPoint& p : corners) p = draw_point(random, 3);
    } while (simplex_oracle::volume6(corners[0], corners[1], corners[2], corners[3]).sign() !=
             Sign::kPositive);
    std::vector<DmsPoint> hull;
    for (std::int64_t i = random.between(1, 6); i > 0; --i) hull.push_back(draw_point(random, 4));
    const auto parted = part_from_tetrahedron(hull, corners);
    ++seen[parted.index()];
    if (const auto* const plane = std::get_if<DmsPlane>(&parted)) {
      const auto side = [&](const DmsPoint& p) {
        return dot_product(plane->vector, p) - plane->number;
      };
      EXPECT_NE(plane->vector, DmsPoint{});
      for (const DmsPoint& p : hull) EXPECT_NE(side(p).sign(), Sign::kPositive) << round;
      for (const DmsPoint& p : corners) EXPECT_NE(side(p).sign(), Sign::kNegative) << round;
      continue;
    }
    const auto& common = std::get<1>(parted);
    DmsPoint mean;
    Rational total;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      EXPECT_NE(common.shares[i].sign(), Sign::kNegative);
      total += common.shares[i];
      for (std::size_t c = 0; c < 3; ++c) mean[c] += common.shares[i] * hull[i][c];
    }
    EXPECT_EQ(total, Rational(1));
    EXPECT_EQ(mean, common.point);
    for (std::size_t m = 0; m < 4; ++m) {
      auto moved = corners;
      moved[m] = mean;
      EXPECT_EQ(simplex_oracle::volume6(moved[0], moved[1], moved[2], moved[3]).sign(),
                Sign::kPositive)
          << round;
    }
  }
  EXPECT_GT(std::min(seen[0], seen[1]), 50);
}

// ---- faces

struct Triangles {
  std::vector<ExactPoint3> points;
  internal::CornersWithIds f, g;
};
std::array<Rational, 3> weights_in(const internal::CornersWithIds& t, const DmsPoint& p,
                                   bool& is_in) {
  const auto at = [&](std::size_t i) { return t.points[i]->at(); };
  const DmsPoint normal = cross_product(difference(at(1), at(0)), difference(at(2), at(0)));
  std::array<Rational, 3> out;
  is_in = dot_product(normal, difference(p, at(0))).sign() == Sign::kZero;
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = dot_product(
        normal, cross_product(difference(at((i + 1) % 3), p), difference(at((i + 2) % 3), p)));
    is_in = is_in && out[i].sign() != Sign::kNegative;
  }
  return out;
}
bool has_id(const internal::CornersWithIds& t, std::uint32_t id) {
  return std::find(t.ids.begin(), t.ids.end(), id) != t.ids.end();
}
// A point of a grid on f that lies in g, and not in the common simplex.
bool has_sampled_point(const internal::CornersWithIds& f, const internal::CornersWithIds& g) {
  constexpr int kSteps = 12;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; i + j <= kSteps; ++j) {
      const std::array<int, 3> w{i, j, kSteps - i - j};
      bool is_proper = true;
      DmsPoint p;
      for (std::size_t m = 0; m < 3; ++m) {
        is_proper = is_proper && (w[m] == 0 || has_id(g, f.ids[m]));
        for (std::size_t c = 0; c < 3; ++c)
          p[c] += Rational(w[m]) * f.points[m]->at()[c] / Rational(kSteps);
      }
      bool is_in = false;
      weights_in(g, p, is_in);
      if (is_in && !is_proper) return true;
    }
  return false;
}

TEST(DmsDomain, FacesMeetImproperlyIfAndOnlyIfAPointShowsIt) {
  Random random(5);
  std::array<int, 2> seen{};
  for (int round = 0; round < 1500; ++round) {
    Triangles t;
    const std::size_t common = static_cast<std::size_t>(random.below(3));
    const int flat = static_cast<int>(random.below(2));
    std::set<DmsPoint> places;
    while (places.size() < 6 - common) {
      DmsPoint p = draw_point(random, 2);
      if (flat != 0) p[2] = p[0];
      if (places.insert(p).second) t.points.emplace_back(p);
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      t.f.ids[i] = i, t.f.points[i] = &t.points[i];
      const std::uint32_t k = i < common ? i : static_cast<std::uint32_t>(3 - common) + i;
      t.g.ids[i] = k, t.g.points[i] = &t.points[k];
    }
    const auto is_thin = [](const internal::CornersWithIds& c) {
      return cross_product(difference(c.points[1]->at(), c.points[0]->at()),
                           difference(c.points[2]->at(), c.points[0]->at())) == DmsPoint{};
    };
    if (is_thin(t.f) || is_thin(t.g)) continue;
    const auto found = internal::find_improper_point(t.f, t.g);
    ++seen[found.has_value()];
    if (!found) {
      EXPECT_FALSE(has_sampled_point(t.f, t.g) || has_sampled_point(t.g, t.f)) << "round " << round;
      continue;
    }
    const auto& first = found->is_swapped ? t.g : t.f;
    const auto& second = found->is_swapped ? t.f : t.g;
    bool is_off = false;
    for (std::size_t s = 0; s < 2; ++s) {
      DmsPoint p;
      for (std::size_t i = 0; i < 3; ++i) {
        const Rational& w = found->weights[s][i];
        EXPECT_NE(w.sign(), Sign::kNegative);
        for (std::size_t c = 0; c < 3; ++c)
          p[c] += w * (s == 0 ? first : second).points[i]->at()[c];
        if (s == 0 && w.sign() == Sign::kPositive && !has_id(second, first.ids[i])) is_off = true;
      }
      EXPECT_EQ(p, found->point) << "round " << round;
    }
    EXPECT_TRUE(is_off) << "round " << round;
  }
  EXPECT_GT(std::min(seen[0], seen[1]), 200);
}

// ---- models

DmsModel tetrahedra(std::vector<DmsPoint> points, std::vector<TetrahedronCorners> all) {
  DmsModel model;
  for (DmsPoint& p : points) model.clouds.push_back({std::move(p)});
  model.tetrahedra = std::move(all);
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  return model;
}
std::string codes_of(const DmsModel& model) {
  std::string out;
  for (const DmsDefect& d : find_dms_defects(model).first)
    out += (out.empty() ? "" : " ") + std::string(fault_name(d.fault));
  return out;
}
DmsPoint at(int x, int y, int z) { return {Rational(x), Rational(y), Rational(z)}; }

TEST(DmsDefects, TwoTetrahedraAtAnEdgeAreM4) {
  const DmsModel model =
      tetrahedra({at(0, 0, 0), at(0, 0, 1), at(1, 0, 0), at(0, 1, 0), at(-1, 0, 0), at(0, -1, 0)},
                 {{0, 2, 3, 1}, {0, 4, 5, 1}});
  EXPECT_EQ(codes_of(model).substr(0, 2), "M4");
  const DmsDefect d = find_dms_defects(model).first[0];
  EXPECT_EQ(d.vertices, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(d.faces.size(), 4u);
  EXPECT_EQ(to_string(d), "the edge of the vertices 0, 1 is in 4 faces of the domain's boundary");
}
TEST(DmsDefects, TwoTetrahedraAtAVertexAreM6) {
  const DmsModel model = tetrahedra({at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1),
                                     at(-1, 0, 0), at(0, -1, 0), at(0, 0, -1)},
                                    {{0, 1, 2, 3}, {0, 5, 4, 6}});
  EXPECT_EQ(codes_of(model), "M6");
  EXPECT_EQ(find_dms_defects(model).first[0].vertices, (std::vector<std::uint32_t>{0}));
}
TEST(DmsDefects, TetrahedraThatTouchOrCrossAreM7) {
  const std::vector<DmsPoint> base{at(0, 0, 0), at(3, 0, 0), at(0, 3, 0), at(0, 0, 3)};
  const auto beside = [&](std::vector<DmsPoint> more) {
    std::vector<DmsPoint> points = base;
    points.insert(points.end(), more.begin(), more.end());
    return codes_of(tetrahedra(points, {{0, 1, 2, 3}, {4, 5, 6, 7}}));
  };
  EXPECT_EQ(beside({at(1, 1, -3), at(3, 0, -3), at(0, 3, -3), at(1, 1, -1)}), "");
  EXPECT_EQ(beside({at(1, 1, -3), at(3, 0, -3), at(0, 3, -3), at(1, 1, 0)}).substr(0, 2), "M7");
  EXPECT_EQ(beside({at(1, 1, -3), at(3, 0, -3), at(0, 3, -3), at(1, 1, 1)}).substr(0, 2), "M7");
  // Two vertices at one place.
  EXPECT_EQ(beside({at(0, 0, 0), at(0, -1, 0), at(-1, 0, 0), at(0, 0, -1)}).substr(0, 2), "M7");
}
TEST(DmsDefects, ATetrahedronInsideOfAnotherIsM9) {
  const DmsModel model = tetrahedra({at(0, 0, 0), at(9, 0, 0), at(0, 9, 0), at(0, 0, 9),
                                     at(1, 1, 1), at(2, 1, 1), at(1, 2, 1), at(1, 1, 2)},
                                    {{0, 1, 2, 3}, {4, 5, 6, 7}});
  ASSERT_EQ(codes_of(model), "M9");
  const DmsDefect d = find_dms_defects(model).first[0];
  EXPECT_EQ(d.tetrahedra, (std::vector<std::uint32_t>{0, 1}));
  for (const TetrahedronCorners& t : model.tetrahedra)
    for (std::size_t m = 0; m < 4; ++m) {
      std::array<DmsPoint, 4> corners;
      for (std::size_t i = 0; i < 4; ++i) corners[i] = i == m ? *d.point : model.knot(t[i], 0);
      EXPECT_EQ(simplex_oracle::volume6(corners[0], corners[1], corners[2], corners[3]).sign(),
                Sign::kPositive);
    }
}
TEST(DmsDefects, GridsWithHolesAreDomains) {
  EXPECT_EQ(codes_of(kuhn_domain(
                {3, 3, 3}, [](int x, int y, int z) { return !(x == 1 && y == 1 && z == 1); })),
            "");
  // Two cubes at an edge.
  EXPECT_NE(codes_of(kuhn_domain({2, 2, 1}, [](int x, int y, int) { return x == y; })), "");
}

// Each class breaks its condition by 2^-40, and its twin does not.
TEST(DmsDefects, CloudsAtTheLimitsAreDecided) {
  std::set<std::string> seen;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const dms_truth::Case bad = dms_truth::clouded(seed, false);
    EXPECT_EQ(codes_of(bad.model).substr(0, bad.code.size()), bad.code) << bad.text;
    seen.insert(bad.code);
    const dms_truth::Case good = dms_truth::clouded(seed, true);
    EXPECT_EQ(codes_of(good.model), "") << good.text;
  }
  EXPECT_EQ(seen.size(), 3u);
}
TEST(DmsDefects, WeightsShowThatThereIsNoCore) {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const dms_truth::Case bad = dms_truth::clouded(seed, false);
    const DmsModel& model = bad.model;
    for (const DmsDefect& d : find_dms_defects(model).first) {
      if (d.fault != DmsFault::kNoCore) continue;
      const TetrahedronCorners& v = model.tetrahedra[d.tetrahedra[0]];
      // The sum is a constant: equal at five points that span space.
      std::vector<Rational> sums;
      for (const DmsPoint& u : {at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1), at(3, 4, 5)}) {
        Rational sum;
        for (const DmsCoreWeight& w : d.weights) {
          std::array<DmsPoint, 4> corners;
          for (std::size_t m = 0; m < 4; ++m) corners[m] = model.knot(v[m], w.gamma[m]);
          corners[static_cast<std::size_t>(w.corner)] = u;
          sum += w.weight * simplex_oracle::volume6(corners[0], corners[1], corners[2], corners[3]);
        }
        sums.push_back(sum);
      }
      EXPECT_TRUE(!d.weights.empty() && d.weights.size() <= 4);
      for (const Rational& sum : sums) EXPECT_EQ(sum, sums[0]) << bad.text;
      EXPECT_NE(sums[0].sign(), Sign::kPositive) << bad.text;
    }
  }
}

}  // namespace
}  // namespace veritope
