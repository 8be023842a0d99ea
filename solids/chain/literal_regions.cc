// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solids/chain/integer_net_internal.h"
#include "solids/chain/literal_regions_internal.h"

namespace veritope::internal {
namespace {

using RegionCorner = std::array<std::uint32_t, 2>;  // two barycentric coordinates, times 2^level

// A piece that is not known to have f <= 0.
struct RegionPiece {
  IntegerNet f;
  std::array<RegionCorner, 3> corners;
  bool is_positive = false;     // f >= 0, and not 0 everywhere
  bool is_in_one_part = false;  // the points with f > 0 are connected
};

bool has_sign(std::span<const Integer> values, Sign sign) {
  return std::any_of(values.begin(), values.end(),
                     [&](const Integer& v) { return v.sign() == sign; });
}

std::size_t corner_index(int degree, std::size_t corner) {
  return corner == 0   ? triangle_index(0, 0)
         : corner == 1 ? triangle_index(degree, 0)
                       : triangle_index(0, degree);
}
const Integer& at_corner(const RegionPiece& p, std::size_t corner) {
  return p.f.component(0)[corner_index(p.f.degree(), corner)];
}

RegionCorner twice(const RegionCorner& a) { return {2 * a[0], 2 * a[1]}; }
RegionCorner between(const RegionCorner& a, const RegionCorner& b) {
  return {a[0] + b[0], a[1] + b[1]};
}

// Pieces with many coefficients are dear.
int num_levels(const BezierTriangle<Rational>& f) {
  return f.count() <= 21 ? kRegionLevels : f.count() <= 36 ? kRegionLevels - 1 : kRegionLevels - 2;
}

std::vector<RegionPiece> leaves_of(const BezierTriangle<Rational>& f, int levels) {
  std::vector<RegionPiece> pieces;
  pieces.push_back({integer_net(f), {{{1, 0}, {0, 1}, {0, 0}}}});
  for (int level = 0; level <= levels; ++level) {
    std::erase_if(pieces, [](RegionPiece& p) {
      const auto c = p.f.component(0);
      if (!has_sign(c, Sign::kPositive)) return true;
      p.is_positive = !has_sign(c, Sign::kNegative);
      return false;
    });
    if (level == levels) break;
    std::vector<RegionPiece> next;
    for (const RegionPiece& p : pieces) {
      auto parts = quarters_of(p.f);
      const auto& [a, b, c] = p.corners;
      const RegionCorner m0 = between(b, c), m1 = between(a, c), m2 = between(a, b);
      next.push_back({std::move(parts[0]), {twice(a), m2, m1}});
      next.push_back({std::move(parts[1]), {m2, twice(b), m0}});
      next.push_back({std::move(parts[2]), {m1, m0, twice(c)}});
      next.push_back({std::move(parts[3]), {m0, m1, m2}});
    }
    pieces = std::move(next);
  }
  return pieces;
}

// The coefficients along the side from corner s to corner s + 1.
std::vector<Integer> side_of_piece(const RegionPiece& p, std::size_t s) {
  const auto c = boundary_curve(p.f, static_cast<int>((s + 2) % 3));
  return {c.component(0).begin(), c.component(0).end()};
}

// Along these coefficients f is positive on one interval at most, which contains an end: their signs change once.
bool changes_at_most_once(const std::vector<Integer>& f) {
  int changes = 0;
  Sign last = Sign::kZero;
  for (const Integer& c : f) {
    if (c.sign() == 0) continue;
    if (last != 0 && c.sign() != last) ++changes;
    last = c.sign();
  }
  return changes <= 1;
}

// Looks for a direction along a side, forward or backward, in which f does not fall. Every point with f > 0 is joined
// to one on the side at which the direction leaves the piece: the side s + 1 from corner s to s + 1, the side s + 2
// from corner s + 1 to s. If f > 0 on one interval of that side, f > 0 in one part of the piece; if nowhere there,
// nowhere. False: nowhere.
bool examine(RegionPiece& p) {
  p.is_in_one_part = p.is_positive;
  for (std::size_t s = 0; s < 3 && !p.is_in_one_part; ++s)
    for (const int sign : {1, -1}) {
      Barycentric<Integer> direction;
      direction[s] = Integer(-sign);
      direction[(s + 1) % 3] = Integer(sign);
      const auto slope = directional_derivative<Integer>(p.f, direction);
      if (has_sign(slope.component(0), Sign::kNegative)) continue;
      const std::vector<Integer> end = side_of_piece(p, (s + (sign > 0 ? 1 : 2)) % 3);
      if (!has_sign(end, Sign::kPositive)) return false;
      p.is_in_one_part = p.is_in_one_part || changes_at_most_once(end);
    }
  return true;
}

// f / (u^a v^b w^c) for the greatest such powers: u times the Bernstein polynomial of (i - 1, j, k) of degree n - 1 is
// i / n times that of (i, j, k) of degree n. In the interior of the triangle it has the sign of f.
BezierTriangle<Rational> without_factors(BezierTriangle<Rational> f) {
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (;;) {
      const int n = f.degree();
      bool is_divisible = n > 0;
      for_each_triangle_index(n, [&](int i, int j, int k) {
        const std::array<int, 3> at{i, j, k};
        is_divisible =
            is_divisible && (at[corner] > 0 || f.component(0)[triangle_index(j, k)].sign() == 0);
      });
      if (!is_divisible) break;
      BezierTriangle<Rational> out(n - 1, 1, false);
      for_each_triangle_index(n - 1, [&](int i, int j, int k) {
        std::array<int, 3> from{i, j, k};
        ++from[corner];
        out.component(0)[triangle_index(j, k)] =
            f.component(0)[triangle_index(from[1], from[2])] * Rational(n) / Rational(from[corner]);
      });
      f = std::move(out);
    }
  return f;
}

class RegionSets {
 public:
  explicit RegionSets(std::size_t count) : root_(count) {
    std::iota(root_.begin(), root_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { root_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> root_;
};

// Joins pieces that share a corner, if `counts(piece, corner)` for both.
template <typename Counts>
void join_at_corners(const std::vector<RegionPiece>& pieces, RegionSets& sets, Counts counts) {
  std::map<RegionCorner, std::size_t> first;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      if (!counts(pieces[i], k)) continue;
      const auto [known, is_new] = first.emplace(pieces[i].corners[k], i);
      if (!is_new) sets.join(i, known->second);
    }
}

// f > 0 at all inner points of the side.
bool is_positive_along(const RegionPiece& p, std::size_t s) {
  const std::vector<Integer> f = side_of_piece(p, s);
  return has_sign(f, Sign::kPositive) && !has_sign(f, Sign::kNegative);
}

void join_at_sides(const std::vector<RegionPiece>& pieces, RegionSets& sets) {
  std::map<std::pair<RegionCorner, RegionCorner>, std::size_t> first;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t s = 0; s < 3; ++s) {
      if (!is_positive_along(pieces[i], s)) continue;
      const auto ends = std::minmax(pieces[i].corners[s], pieces[i].corners[(s + 1) % 3]);
      const auto [known, is_new] = first.emplace(ends, i);
      if (!is_new) sets.join(i, known->second);
    }
}

// Parameters in the piece with f > 0: in the middle, at a corner, or in the middle of a side.
std::optional<Barycentric<Rational>> positive_place(const RegionPiece& p, int levels) {
  const auto parameters = [&](const std::array<int, 3>& weights) {
    const Rational all(weights[0] + weights[1] + weights[2]);
    Barycentric<Rational> out;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t c = 0; c < 2; ++c)
        out[c] += Rational(weights[k]) / all * Rational(p.corners[k][c]) *
                  Rational::power_of_two(-levels);
    out[2] = Rational(1) - out[0] - out[1];
    return out;
  };
  constexpr std::array<std::array<int, 3>, 7> kPlaces = {
      {{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}}};
  for (const auto& w : kPlaces)
    if (evaluate<Integer>(p.f, {w[0], w[1], w[2]})[0].sign() > 0) return parameters(w);
  return std::nullopt;
}

}  // namespace

PositiveRegion positive_region(const BezierTriangle<Rational>& given) {
  const BezierTriangle<Rational> f = without_factors(given);
  const int levels = num_levels(f);
  std::vector<RegionPiece> pieces = leaves_of(f, levels);
  std::erase_if(pieces, [](RegionPiece& p) { return !examine(p); });
  PositiveRegion out;
  // The closure of { f > 0 } is in the pieces: if these fall apart, it does.
  RegionSets touching(pieces.size());
  join_at_corners(pieces, touching, [](const RegionPiece&, std::size_t) { return true; });
  std::map<std::size_t, Barycentric<Rational>> places;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto place = positive_place(pieces[i], levels);
    if (place) places.emplace(touching.find(i), *place);
  }
  if (places.size() >= 2) {
    out.decision = Decision::kViolated;
    out.where = {places.begin()->second, std::next(places.begin())->second};
    return out;
  }
  // It is connected if each piece has one part of it, and these have points in common.
  if (!std::all_of(pieces.begin(), pieces.end(),
                   [](const RegionPiece& p) { return p.is_in_one_part; }))
    return out;
  RegionSets joined(pieces.size());
  join_at_corners(pieces, joined, [](const RegionPiece& p, std::size_t k) {
    return p.is_positive || at_corner(p, k).sign() > 0;
  });
  join_at_sides(pieces, joined);
  std::optional<std::size_t> all;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!positive_place(pieces[i], levels)) return out;  // a part may hide there
    if (all && joined.find(i) != *all) return out;
    all = joined.find(i);
  }
  out.decision = Decision::kHolds;
  return out;
}

}  // namespace veritope::internal
