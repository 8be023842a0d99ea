// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

#include "solids/polyhedron/box_order.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

// What happens in a walk: (k, A.lo, A.hi, B.lo, B.hi) at step 3, and (i, j) at step 4 with the first number -1.
using Event = std::tuple<std::int64_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

// Section 5 of docs/certificates/mesh.md, word for word: every node computes its box and its common vertices anew.
class PageWalk {
 public:
  PageWalk(const TriangleMesh& mesh, const std::vector<std::uint32_t>& order, const std::vector<std::uint8_t>& stars,
           std::set<std::int64_t> separated)
      : mesh_(mesh), order_(order), stars_(stars), separated_(std::move(separated)) {
    self(0, static_cast<std::uint32_t>(order.size()));
  }
  std::vector<Event> events;

 private:
  void self(std::uint32_t lo, std::uint32_t hi) {
    if (hi - lo == 1) return;
    const std::uint32_t m = lo + (hi - lo) / 2;
    self(lo, m);
    self(m, hi);
    cross(lo, m, m, hi);
  }
  void cross(std::uint32_t al, std::uint32_t ah, std::uint32_t bl, std::uint32_t bh) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto [amin, amax] = extent(al, ah, axis);
      const auto [bmin, bmax] = extent(bl, bh, axis);
      if (amax < bmin || bmax < amin) return;
    }
    const auto a = common(al, ah), b = common(bl, bh);
    for (std::uint32_t v : a)
      if (b.count(v) != 0) return;
    events.emplace_back(k_, al, ah, bl, bh);
    if (separated_.count(k_++) != 0) return;
    if (ah - al == 1 && bh - bl == 1) {
      events.emplace_back(-1, al, 0, bl, 0);
      return;
    }
    if (ah - al >= bh - bl) {
      const std::uint32_t m = al + (ah - al) / 2;
      cross(al, m, bl, bh);
      cross(m, ah, bl, bh);
    } else {
      const std::uint32_t m = bl + (bh - bl) / 2;
      cross(al, ah, bl, m);
      cross(al, ah, m, bh);
    }
  }
  std::pair<double, double> extent(std::uint32_t lo, std::uint32_t hi, int axis) const {
    double least = mesh_.positions[mesh_.faces[order_[lo]][0]][axis], most = least;
    for (std::uint32_t i = lo; i < hi; ++i)
      for (std::uint32_t v : mesh_.faces[order_[i]]) {
        least = std::min(least, mesh_.positions[v][axis]);
        most = std::max(most, mesh_.positions[v][axis]);
      }
    return {least, most};
  }
  std::set<std::uint32_t> common(std::uint32_t lo, std::uint32_t hi) const {
    std::set<std::uint32_t> out;
    for (std::uint32_t v : mesh_.faces[order_[lo]]) {
      bool in_all = stars_[v] != 0;
      for (std::uint32_t i = lo; i < hi; ++i) {
        const auto& f = mesh_.faces[order_[i]];
        in_all = in_all && std::find(f.begin(), f.end(), v) != f.end();
      }
      if (in_all) out.insert(v);
    }
    return out;
  }

  const TriangleMesh& mesh_;
  const std::vector<std::uint32_t>& order_;
  const std::vector<std::uint8_t>& stars_;
  const std::set<std::int64_t> separated_;
  std::int64_t k_ = 0;
};

struct Recorder {
  std::set<std::int64_t> separated;
  std::int64_t first = 0;  // number of the part's first pair
  std::vector<Event> events;
  std::optional<std::size_t> stop_after;

  bool stop() const { return stop_after && events.size() >= *stop_after; }
  bool node_pair(const TreeRange& a, const TreeRange& b, std::uint64_t k) {
    const std::int64_t index = first + static_cast<std::int64_t>(k);
    events.emplace_back(index, a.lo, a.hi, b.lo, b.hi);
    return separated.count(index) != 0;
  }
  void leaf_pair(std::uint32_t i, std::uint32_t j) { events.emplace_back(-1, i, 0, j, 0); }
};

void expect_as_on_the_page(const TriangleMesh& mesh, const VertexStars& stars, Random& random, bool some_separated) {
  std::vector<std::uint32_t> order(mesh.faces.size());
  std::iota(order.begin(), order.end(), 0u);
  order = random.below(2) == 0 ? median_order(mesh, order, 1) : morton_order(mesh, order, UnitScale(bounding_box(mesh.positions, 1)), 1);
  std::set<std::int64_t> separated;
  for (std::int64_t k = 0; some_separated && k < 2000; ++k)
    if (random.below(10) == 0) separated.insert(k);
  const PageWalk page(mesh, order, stars.code, separated);

  const BoxTree tree(mesh, order, stars, 2);
  Recorder whole{separated, 0, {}, {}};
  const std::uint64_t pairs = tree.walk({tree.root(), tree.root()}, whole);
  EXPECT_EQ(whole.events == page.events, true) << shapes::to_text(mesh);

  Recorder joined{separated, 0, {}, {}};
  for (const WalkPart& part : tree.parts()) joined.first += static_cast<std::int64_t>(tree.walk(part, joined));
  EXPECT_EQ(joined.events == page.events, true) << "the parts are not the whole walk";
  EXPECT_EQ(static_cast<std::uint64_t>(joined.first), pairs);
}

// PROVES MESH-5
TEST(BoxTree, WalksAsThePageSaysWholeAndInParts) {
  for (int n = 1; n <= 40; ++n) {
    Random random(static_cast<std::uint64_t>(n));
    const TriangleMesh mesh = shapes::grid_soup(random, n, 5);
    VertexStars stars;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) stars.code.push_back(random.below(3) == 0 ? 1 : 0);
    expect_as_on_the_page(mesh, stars, random, false);
    expect_as_on_the_page(mesh, stars, random, true);
  }
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(5)); ++seed) {
    Random random(seed);
    for (const TriangleMesh& mesh : {shapes::needle_soup(random, 120), shapes::torus(12, 7, 3, 1), shapes::cone(50),
                                     shapes::grid_soup(random, 260, 30)}) {
      VertexStars stars;
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) stars.code.push_back(random.below(2) == 0 ? 14 : 0);
      expect_as_on_the_page(mesh, stars, random, random.below(2) == 0);
    }
  }
}

// Five facets, by hand: 0, 1 and 2 have a star vertex in common; 3 and 4 have disjoint boxes, and meet that of 2.
// PROVES MESH-5
TEST(BoxTree, MeetsExactlyThePairsThatNoStepOfThePageSettles) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0},  {-2, 0, 0}, {-2, 2, 0}, {-2, -2, 0}, {0, -2, 0}, {4, -1, 0}, {4, 1, 0},
                    {-1, 1, 0}, {1, 1, 0},  {0, 3, 0},  {3, 0, 0},   {5, 0, 0},  {4, 2, 0}};
  mesh.faces = {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {7, 8, 9}, {10, 11, 12}};
  const auto walk = [&](bool has_star, const std::set<std::int64_t>& separated) {
    VertexStars stars{std::vector<std::uint8_t>(mesh.positions.size()), {}};
    stars.code[0] = has_star ? 1 : 0;
    const BoxTree tree(mesh, {0, 1, 2, 3, 4}, stars, 1);
    Recorder recorder{separated, 0, {}, {}};
    tree.walk({tree.root(), tree.root()}, recorder);
    return recorder.events;
  };
  using Events = std::vector<Event>;
  // 0-1, 0-2 and 1-2: step 2. 3-4, 0-4, 1-3, 1-4: step 1. 2-4: step 3, and step 4 without a separator there.
  const Events separated{{0, 2, 3, 3, 5},  {1, 2, 3, 3, 4}, {-1, 2, 0, 3, 0}, {2, 2, 3, 4, 5},  {3, 0, 2, 2, 5},
                         {4, 0, 2, 3, 5},  {5, 0, 1, 3, 5}, {6, 0, 1, 3, 4},  {-1, 0, 0, 3, 0}, {7, 1, 2, 3, 5}};
  EXPECT_EQ(walk(true, {2}) == separated, true);
  Events plain = separated;
  plain.insert(plain.begin() + 4, Event{-1, 2, 0, 4, 0});
  EXPECT_EQ(walk(true, {}) == plain, true);
  // A separator of two nodes settles all pairs below them.
  EXPECT_EQ(walk(true, {3}) == Events(plain.begin(), plain.begin() + 6), true);
  // Without a star all pairs whose boxes meet end at step 4.
  const Events bare{{0, 0, 1, 1, 2},  {-1, 0, 0, 1, 0}, {1, 2, 3, 3, 5},  {2, 2, 3, 3, 4},  {-1, 2, 0, 3, 0},
                    {3, 2, 3, 4, 5},  {-1, 2, 0, 4, 0}, {4, 0, 2, 2, 5},  {5, 0, 2, 2, 3},  {6, 0, 1, 2, 3},
                    {-1, 0, 0, 2, 0}, {7, 1, 2, 2, 3},  {-1, 1, 0, 2, 0}, {8, 0, 2, 3, 5},  {9, 0, 1, 3, 5},
                    {10, 0, 1, 3, 4}, {-1, 0, 0, 3, 0}, {11, 1, 2, 3, 5}};
  EXPECT_EQ(walk(false, {}) == bare, true);
}

TEST(BoxTree, AWholeFanUnderItsStarIsOnePair) {
  const TriangleMesh mesh = shapes::cone(64);
  VertexStars stars{std::vector<std::uint8_t>(mesh.positions.size()), {}};
  stars.code[0] = 3;
  std::vector<std::uint32_t> order(64);  // the facets at the apex
  std::iota(order.begin(), order.end(), 0u);
  const BoxTree tree(mesh, order, stars, 2);
  Recorder recorder;
  EXPECT_EQ(tree.walk({tree.root(), tree.root()}, recorder), 0u);
}

TEST(BoxTree, PartsDependOnTheNumberOfFacetsOnly) {
  Random random(9);
  for (int n : {1, 2, 3, 255, 256, 257, 1000}) {
    const auto parts = [&](const TriangleMesh& mesh) {
      std::vector<std::uint32_t> order(mesh.faces.size());
      std::iota(order.begin(), order.end(), 0u);
      std::vector<std::array<std::uint32_t, 6>> out;
      for (const WalkPart& p : BoxTree(mesh, order, {std::vector<std::uint8_t>(mesh.positions.size()), {}}, 1).parts())
        out.push_back({p.a.node, p.a.lo, p.a.hi, p.b.node, p.b.lo, p.b.hi});
      return out;
    };
    EXPECT_EQ(parts(shapes::grid_soup(random, n, 3)), parts(shapes::needle_soup(random, n))) << n;
  }
}

TEST(BoxTree, NodesAreNumberedInPreorder) {
  const TreeRange root{0, 0, 7};
  EXPECT_EQ(root.left().node, 1u);
  EXPECT_EQ(root.left().size(), 3u);
  EXPECT_EQ(root.right().node, 6u);  // root, and the five nodes of three leaves
  EXPECT_EQ(root.right().lo, 3u);
  EXPECT_TRUE((TreeRange{4, 2, 3}).is_leaf());
}

TEST(BoxTree, StopsWhenTheVisitorHasSeenEnough) {
  Random random(2);
  const TriangleMesh mesh = shapes::needle_soup(random, 200);
  std::vector<std::uint32_t> order(mesh.faces.size());
  std::iota(order.begin(), order.end(), 0u);
  const BoxTree tree(mesh, order, {std::vector<std::uint8_t>(mesh.positions.size()), {}}, 1);
  Recorder recorder;
  recorder.stop_after = 10;
  tree.walk({tree.root(), tree.root()}, recorder);
  EXPECT_LE(recorder.events.size(), 11u);
}

}  // namespace
}  // namespace veritope
