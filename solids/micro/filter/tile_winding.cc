// SPDX-License-Identifier: LGPL-3.0-or-later
#include <array>
#include <cstdlib>
#include <vector>

#include "interval/box_geometry.h"
#include "solids/micro/filter/tile_winding_internal.h"

namespace veritope::internal {

namespace {

// A ray from the origin along the axis, sheared so that no pattern of a model is parallel to it; seen along it, a point
// has two coordinates.
struct SlantedRay {
  std::size_t axis = 0;
  double slope_b = 0, slope_c = 0;
};
constexpr std::array<SlantedRay, 6> kSlantedRays{{{0, 0x1.3p-4, 0x1.9p-5},
                                                  {1, -0x1.7p-4, 0x1.5p-4},
                                                  {2, 0x1.1p-3, -0x1.dp-5},
                                                  {0, -0x1.9p-3, 0x1.bp-3},
                                                  {1, 0x1.fp-3, 0x1.3p-2},
                                                  {2, -0x1.5p-2, -0x1.7p-3}}};

struct SeenPoint {
  Interval ahead, b, c;
};

class RayCount {
 public:
  RayCount(const TilePieces& pieces, const Box3& point, const SlantedRay& ray)
      : pieces_(pieces), origin_(point), ray_(ray) {}

  // The winding number of the surface around the point, up to its sign.
  std::optional<int> count() {
    const auto num_patches = static_cast<std::uint32_t>(pieces_.tile().patches().size());
    int sum = 0;
    std::vector<TilePiece> stack;
    for (std::uint32_t i = 0; i < num_patches; ++i) stack.push_back(pieces_.root(i));
    for (int visited = 0; !stack.empty(); ++visited) {
      const TilePiece piece = stack.back();
      stack.pop_back();
      if (const std::optional<int> turns = crossings(piece)) {
        sum += *turns;
        continue;
      }
      if (!piece.can_halve() || visited > kMaxVisited) return std::nullopt;
      std::size_t axis = 0;
      auto halves = pieces_.halves(piece, &axis);
      stack.push_back(std::move(halves.first));
      stack.push_back(std::move(halves.second));
    }
    return sum;
  }

 private:
  static constexpr int kMaxVisited = 4000;

  SeenPoint seen(const Box3& p) const {
    const std::size_t b = (ray_.axis + 1) % 3, c = (ray_.axis + 2) % 3;
    const Box3 d = p - origin_;
    return {d[ray_.axis], d[b] - Interval(ray_.slope_b) * d[ray_.axis],
            d[c] - Interval(ray_.slope_c) * d[ray_.axis]};
  }
  // What a bound of coordinates in space becomes.
  SeenPoint seen_bend(const Point3d& bend) const {
    const std::size_t b = (ray_.axis + 1) % 3, c = (ray_.axis + 2) % 3;
    const Interval ahead(bend[ray_.axis]);
    return {ahead, Interval(bend[b]) + Interval(std::abs(ray_.slope_b)) * ahead,
            Interval(bend[c]) + Interval(std::abs(ray_.slope_c)) * ahead};
  }
  static Interval grown(const Interval& a, const Interval& by) {
    return Interval::from_bounds((a - by).lo(), (a + by).hi());
  }

  // The crossings of the ray with the piece, counted by sign; nothing if the piece must be halved.
  std::optional<int> crossings(const TilePiece& piece) const {
    std::array<SeenPoint, 4> at;
    for (std::size_t i = 0; i < 4; ++i) at[i] = seen(piece.corners[i]);
    const std::array<SeenPoint, 2> bend{seen_bend(piece.bend[0]), seen_bend(piece.bend[1])};
    SeenPoint all = at[0];
    for (std::size_t i = 1; i < 4; ++i)
      all = {hull(all.ahead, at[i].ahead), hull(all.b, at[i].b), hull(all.c, at[i].c)};
    all = {grown(all.ahead, bend[0].ahead + bend[1].ahead), grown(all.b, bend[0].b + bend[1].b),
           grown(all.c, bend[0].c + bend[1].c)};
    if (all.b.sign() == Sign3::kPositive || all.b.sign() == Sign3::kNegative ||
        all.c.sign() == Sign3::kPositive || all.c.sign() == Sign3::kNegative ||
        all.ahead.sign() == Sign3::kNegative)
      return 0;
    if (all.ahead.sign() != Sign3::kPositive) return std::nullopt;
    // The piece is ahead of the origin: it meets the ray as often as its border winds around the origin.
    constexpr std::array<std::size_t, 5> kAround{0, 1, 3, 2, 0};
    int turns = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const SeenPoint &from = at[kAround[i]], &to = at[kAround[i + 1]];
      const SeenPoint& by = bend[i % 2];
      const Interval b = grown(hull(from.b, to.b), by.b), c = grown(hull(from.c, to.c), by.c);
      // Sides that miss the half-line b > 0, c = 0 and the origin do not count.
      if (b.sign() == Sign3::kNegative || c.sign() == Sign3::kPositive ||
          c.sign() == Sign3::kNegative)
        continue;
      if (b.sign() != Sign3::kPositive) return std::nullopt;
      const Sign3 begin = from.c.sign(), end = to.c.sign();
      if ((begin != Sign3::kPositive && begin != Sign3::kNegative) ||
          (end != Sign3::kPositive && end != Sign3::kNegative))
        return std::nullopt;
      if (begin == Sign3::kNegative && end == Sign3::kPositive) ++turns;
      if (begin == Sign3::kPositive && end == Sign3::kNegative) --turns;
    }
    return turns;
  }

  const TilePieces& pieces_;
  const Box3 origin_;
  const SlantedRay ray_;
};

}  // namespace

std::optional<bool> is_in_tile(const TilePieces& pieces, const Box3& point) {
  for (const SlantedRay& ray : kSlantedRays)
    if (const std::optional<int> w = RayCount(pieces, point, ray).count()) return *w != 0;
  return std::nullopt;
}

}  // namespace veritope::internal
