// SPDX-License-Identifier: LGPL-3.0-or-later
// Frames against the same points in rationals: what a frame maps is contained, and narrow.
#include "solids/star_box/box_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "tests/solids/exact_nodes.h"

namespace veritope {
namespace {

using Rows = BoxFrame::Rows;
using ExactPoint = std::array<Rational, 3>;

constexpr std::int64_t kMost = BoxFrame::kEntryLimit - 1;

std::string text(const Rows& a) {
  std::ostringstream out;
  for (const auto& row : a) out << "{" << row[0] << ", " << row[1] << ", " << row[2] << "} ";
  return out.str();
}

Rational cofactor(const Rows& a, std::size_t r, std::size_t c) {
  const auto at = [&](std::size_t i, std::size_t j) {
    return Rational(a[(r + i) % 3][(c + j) % 3]);
  };
  return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
}
Rational determinant(const Rows& a) {
  Rational sum;
  for (std::size_t c = 0; c < 3; ++c) sum += Rational(a[0][c]) * cofactor(a, 0, c);
  return sum;
}
ExactPoint product(const Rows& a, const ExactPoint& x) {
  ExactPoint out;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) out[r] += Rational(a[r][c]) * x[c];
  return out;
}
// The sum of the absolute values of the terms: what errors are relative to.
ExactPoint magnitude(const Rows& a, const ExactPoint& x) {
  ExactPoint out;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) out[r] += abs(Rational(a[r][c]) * x[c]);
  return out;
}
ExactPoint exact(const Point3d& x) { return {from(x[0]), from(x[1]), from(x[2])}; }

// Entries of at most `bits` bits.
Rows random_rows(Random& random, int bits) {
  Rows out;
  const std::int64_t most = (std::int64_t{1} << bits) - 1;
  for (auto& row : out)
    for (std::int64_t& v : row) v = random.between(-most, most);
  return out;
}
// Rows of integers with determinant 1 or -1 and entries near 2^31: steps of Euclid's algorithm, as of Fibonacci's
// numbers. Doubles do not tell their determinant from 0.
Rows nearly_singular(Random& random) {
  Rows out{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int step = 0; step < 400; ++step) {
    const std::size_t i = random.below(3), j = (i + 1 + random.below(2)) % 3;
    const std::int64_t sign = random.below(2) == 0 ? 1 : -1;
    Rows next = out;
    for (std::size_t c = 0; c < 3; ++c) next[i][c] += sign * next[j][c];
    const auto is_large = [](const std::array<std::int64_t, 3>& row) {
      return std::abs(row[0]) > kMost || std::abs(row[1]) > kMost || std::abs(row[2]) > kMost;
    };
    if (!is_large(next[i])) out = next;
  }
  return out;
}
Point3d random_point(Random& random) {
  Point3d out;
  for (double& v : out)
    v = std::ldexp(random.unit() - 0.5, static_cast<int>(random.below(20)) - 10);
  return out;
}

TEST(BoxFrame, RefusesEntriesOf2To31AndNoSmallerOnes) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      for (const std::int64_t sign : {-1, 1}) {
        Rows rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        rows[r][c] = sign * kMost;
        const auto frame = BoxFrame::make(rows);
        ASSERT_TRUE(frame) << text(rows);
        EXPECT_EQ(frame->rows(), rows);
        EXPECT_FALSE(frame->is_plain());
        rows[r][c] = sign * (kMost + 1);
        EXPECT_FALSE(BoxFrame::make(rows)) << text(rows);
        rows[r][c] = sign < 0 ? std::numeric_limits<std::int64_t>::min()
                              : std::numeric_limits<std::int64_t>::max();
        EXPECT_FALSE(BoxFrame::make(rows)) << text(rows);
      }
  EXPECT_TRUE(BoxFrame::make(BoxFrame().rows())->is_plain());
}

TEST(BoxFrame, RefusesExactlyTheSingularMatrices) {
  constexpr std::uint64_t kSeed = 41;
  Random random(kSeed);
  int num_nearly = 0;
  for (int trial = 0; trial < 500; ++trial) {
    // A row is a combination of the others; then one entry is one off.
    Rows rows = random_rows(random, 22);
    const std::size_t r = random.below(3), k = random.below(3);
    const std::int64_t s = random.between(-200, 200), t = random.between(-200, 200);
    for (std::size_t c = 0; c < 3; ++c)
      rows[r][c] = s * rows[(r + 1) % 3][c] + t * rows[(r + 2) % 3][c];
    EXPECT_EQ(determinant(rows), Rational(0));
    EXPECT_FALSE(BoxFrame::make(rows)) << "seed " << kSeed << ": " << text(rows);
    rows[r][k] += random.below(2) == 0 ? 1 : -1;
    EXPECT_EQ(BoxFrame::make(rows).has_value(), determinant(rows) != Rational(0))
        << "seed " << kSeed << ": " << text(rows);
    rows = nearly_singular(random);
    ASSERT_EQ(abs(determinant(rows)), Rational(1));
    EXPECT_TRUE(BoxFrame::make(rows)) << "seed " << kSeed << ": " << text(rows);
    for (const auto& row : rows)
      for (const std::int64_t v : row) num_nearly += std::abs(v) > kMost / 4 ? 1 : 0;
  }
  EXPECT_GT(num_nearly, 500);
  // The greatest determinant: Hadamard's bound is taken by rows of this kind, two thirds of it.
  for (const std::int64_t sign : {-1, 1}) {
    const std::int64_t m = sign * kMost;
    EXPECT_TRUE(BoxFrame::make({{{m, m, 0}, {0, m, m}, {m, 0, m}}}));
    EXPECT_TRUE(BoxFrame::make({{{m, m, m}, {m, -m, m}, {m, m, -m}}}));
    EXPECT_FALSE(BoxFrame::make({{{m, m, m}, {m, m, m}, {m, m, -m}}}));
  }
}

// One frame in four is one that doubles take for singular.
Rows some_rows(Random& random, int trial) {
  if (trial % 4 == 3) return nearly_singular(random);
  Rows rows = random_rows(random, trial % 4 == 0 ? 3 : 31);
  while (determinant(rows) == Rational(0)) rows = random_rows(random, 3);
  return rows;
}

void expect_within(double low, double high, const Rational& least, const Rational& greatest,
                   const Rational& room, const std::string& what) {
  EXPECT_TRUE(from(low) <= least && greatest <= from(high)) << what << ": not contained";
  EXPECT_TRUE(least - room <= from(low) && from(high) <= greatest + room) << what << ": wide";
}

TEST(BoxFrame, ContainsTheImagesOfPointsNarrowly) {
  constexpr std::uint64_t kSeed = 43;
  Random random(kSeed);
  for (int trial = 0; trial < 400; ++trial) {
    const Rows rows = some_rows(random, trial);
    const BoxFrame frame = BoxFrame::make(rows).value();
    const Point3d x = random_point(random);
    const Box3d box = frame.in_frame(x);
    const ExactPoint y = product(rows, exact(x)), size = magnitude(rows, exact(x));
    for (std::size_t r = 0; r < 3; ++r)
      expect_within(box.lo[r], box.hi[r], y[r], y[r], size[r] * Rational::power_of_two(-50),
                    "seed " + std::to_string(kSeed) + ", " + text(rows));
  }
}

TEST(BoxFrame, ContainsTheBoxAroundABoxNarrowly) {
  constexpr std::uint64_t kSeed = 47;
  Random random(kSeed);
  for (int trial = 0; trial < 400; ++trial) {
    const Rows rows = some_rows(random, trial);
    const BoxFrame frame = BoxFrame::make(rows).value();
    const Point3d a = random_point(random), b = random_point(random);
    Box3d box;
    for (std::size_t k = 0; k < 3; ++k)
      box.lo[k] = std::min(a[k], b[k]), box.hi[k] = std::max(a[k], b[k]);
    const Box3d around = frame.around(box);
    const Rational det = determinant(rows);
    for (std::size_t c = 0; c < 3; ++c) {
      Rational least, greatest, size;
      for (std::size_t r = 0; r < 3; ++r) {
        const Rational f = cofactor(rows, r, c) / det;
        const Rational p = f * from(box.lo[r]), q = f * from(box.hi[r]);
        least += std::min(p, q), greatest += std::max(p, q), size += std::max(abs(p), abs(q));
      }
      // Boxes of doubles that are nearly singular are narrow, too: the determinant is exact.
      expect_within(around.lo[c], around.hi[c], least, greatest, size * Rational::power_of_two(-48),
                    "seed " + std::to_string(kSeed) + ", " + text(rows));
    }
  }
}

TEST(BoxFrame, GoesApproximatelyBack) {
  const BoxFrame frame = BoxFrame::make({{{2, 2, -1}, {-1, 2, 2}, {2, -1, 2}}}).value();
  const Point3d x{0.25, -1.5, 3}, y{2 * 0.25 - 3 - 3, -0.25 - 3 + 6, 0.5 + 1.5 + 6};
  const Point3d back = frame.approx_back(y);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(back[k], x[k], 1e-14);
}

struct Subject {
  FormShape shape;
  bool is_rational;
};
std::vector<Subject> subjects() {
  std::vector<Subject> out;
  for (const FormShape& s : {FormShape{false, 1, 1}, FormShape{false, 2, 1}, FormShape{false, 2, 3},
                             FormShape{true, 1, 0}, FormShape{true, 3, 0}})
    for (const bool is_rational : {false, true}) out.push_back({s, is_rational});
  return out;
}

TEST(BoxFrame, ContainsTheHullsOfNodesNarrowly) {
  constexpr std::uint64_t kSeed = 53;
  Random random(kSeed);
  for (const Subject& subject : subjects()) {
    const PatchComplex complex =
        both_sides(bent_sheet(subject.shape, subject.is_rational, 0, 1, random));
    PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kWhole).value();
    for_some_nodes(forest, random, 4, [&](PieceForest::Id id, const ExactPoints& points) {
      for (int trial = 0; trial < 4; ++trial) {
        const Rows rows = some_rows(random, trial);
        const Box3d hull = hull_in_frame(forest, id, BoxFrame::make(rows).value());
        for (std::size_t r = 0; r < 3; ++r) {
          Rational least, greatest, size;
          for (std::size_t i = 0; i < points.size(); ++i) {
            const auto& p = points[i];
            const ExactPoint x{p[0] / p[3], p[1] / p[3], p[2] / p[3]};
            const Rational y = product(rows, x)[r];
            if (i == 0 || y < least) least = y;
            if (i == 0 || greatest < y) greatest = y;
            size = std::max(size, magnitude(rows, x)[r]);
          }
          expect_within(
              hull.lo[r], hull.hi[r], least, greatest, size * Rational::power_of_two(-43),
              "seed " + std::to_string(kSeed) + ", node " + std::to_string(id) + ", " + text(rows));
        }
      }
      const Box3d plain = hull_in_frame(forest, id, BoxFrame());
      EXPECT_EQ(plain.lo, forest.node(id).hull.lo);
      EXPECT_EQ(plain.hi, forest.node(id).hull.hi);
    });
  }
}

// More nodes than it has places for, in frames that follow each other and come back.
TEST(BoxFrame, RemembersTheHullsOfTheFrameInUse) {
  constexpr std::uint64_t kSeed = 59;
  Random random(kSeed);
  const PatchComplex complex = both_sides(bent_sheet(FormShape{false, 2, 1}, true, 0, 1, random));
  PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kWhole).value();
  for (PieceForest::Id id = 0; forest.num_nodes() < 3000; ++id) forest.children(id);
  FrameHulls hulls(forest);
  std::vector<BoxFrame> frames{BoxFrame()};
  for (int trial = 0; trial < 3; ++trial)
    frames.push_back(BoxFrame::make(some_rows(random, trial)).value());
  int num_met = 0, num_missed = 0;
  for (int step = 0; step < 40; ++step) {
    const BoxFrame& frame = frames[random.below(frames.size())];
    hulls.use(frame);
    const PieceForest::Id other = random.below(forest.num_nodes());
    const Box3d box = hull_in_frame(forest, other, frame);
    for (int k = 0; k < 60; ++k) {
      // Often the same few, which share a place.
      const auto id = static_cast<PieceForest::Id>(k % 2 == 0 ? 7 + 1024 * random.below(3)
                                                              : random.below(forest.num_nodes()));
      const Box3d expected = hull_in_frame(forest, id, frame), hull = hulls.of(id);
      EXPECT_EQ(hull.lo, expected.lo) << "seed " << kSeed << ", node " << id;
      EXPECT_EQ(hull.hi, expected.hi) << "seed " << kSeed << ", node " << id;
      const auto met = hulls.that_meets(id, box);
      EXPECT_EQ(met.has_value(), hull_that_meets(forest, id, frame, box).has_value())
          << "seed " << kSeed << ", nodes " << id << ", " << other;
      ++(met ? num_met : num_missed);
    }
  }
  EXPECT_GT(num_met, 50);
  EXPECT_GT(num_missed, 50);
}

TEST(BoxFrame, RemembersNoHullOfADroppedNode) {
  Random random(60);
  const PatchComplex complex = both_sides(bent_sheet(FormShape{false, 2, 1}, true, 0, 1, random));
  PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kWhole).value();
  const BoxFrame frame = BoxFrame::make(some_rows(random, 1)).value();
  FrameHulls hulls(forest);
  hulls.use(frame);
  const PieceForest::Id quarter = forest.children(forest.root(0));
  const PieceForest::Id first = forest.children(quarter);
  const Box3d before = hulls.of(first);
  forest.drop_children(quarter);
  ASSERT_EQ(forest.children(quarter + 3), first);
  const Box3d expected = hull_in_frame(forest, first, frame);
  ASSERT_NE(expected.lo, before.lo);
  hulls.use(frame);
  EXPECT_EQ(hulls.of(first).lo, expected.lo);
  EXPECT_EQ(hulls.of(first).hi, expected.hi);
}

// Weights that doubles do not tell from 0 leave the hull unbounded.
TEST(BoxFrame, KeepsHullsUnboundedWhereWeightsAlmostVanish) {
  const Rational zero, one(1), tiny = Rational::power_of_two(-80);
  const std::vector<Rational> values{zero, tiny, zero, zero, zero, tiny,
                                     zero, zero, tiny, one,  tiny, tiny};
  const PatchComplex complex = both_sides(make_patch(Patch::Triangle(1, 4, true, values)).value());
  PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kWhole).value();
  const Rows rows{{{2, 2, -1}, {-1, 2, 2}, {2, -1, 2}}};
  Random random(1);
  for_some_nodes(forest, random, 6, [&](PieceForest::Id id, const ExactPoints& points) {
    const Box3d hull = hull_in_frame(forest, id, BoxFrame::make(rows).value());
    for (const auto& p : points) {
      const ExactPoint y = product(rows, {p[0] / p[3], p[1] / p[3], p[2] / p[3]});
      for (std::size_t r = 0; r < 3; ++r) {
        EXPECT_TRUE(!std::isfinite(hull.lo[r]) || from(hull.lo[r]) <= y[r]) << "node " << id;
        EXPECT_TRUE(!std::isfinite(hull.hi[r]) || y[r] <= from(hull.hi[r])) << "node " << id;
      }
    }
  });
}

}  // namespace
}  // namespace veritope
