// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/crossing_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solids/star_box/star_box.h"
#include "verify/certify/piece_neighbours.h"

namespace veritope {
namespace {

constexpr std::size_t kFewRoots = 64, kManyRoots = 1024;
constexpr std::size_t kMostSolvedNear = 32, kMostContacts = 256;
constexpr std::size_t kMostPiecesNear = 400;
constexpr double kGrowth = 1.75,
                 kPart = 0.3;  // the box, and its longest piece, relative to the piece's hull
constexpr double kReach = 4;   // relative to the size of a piece

}  // namespace

template <typename SolveAll>
std::invoke_result_t<SolveAll, std::vector<CrossingSearch::Pair>> CrossingSearch::by_level(
    const Effort& effort, SolveAll solve_all) {
  std::vector<Pair> pairs = root_pairs(effort);
  thin_out(&pairs, kMostSplit);
  for (int level = 0; level < effort.levels && !pairs.empty(); ++level) {
    pairs = split(pairs, std::min(effort.most_pairs, kMostSplit));
    std::vector<Pair> apart;
    for (const Pair& p : pairs)
      if (!are_neighbours(forest_, p.a, p.b)) apart.push_back(p);
    if (auto witness = solve_all(std::move(apart))) return witness;
  }
  return std::nullopt;
}

std::optional<CrossingWitness> CrossingSearch::among_patches() {
  const std::size_t n = forest_.num_roots();
  const auto solve_all = [&](const std::vector<Pair>& pairs) { return crossing_of(pairs, 256); };
  if (n <= kFewRoots) return by_level({true, 3, 16384}, solve_all);
  if (n <= kManyRoots) return by_level({true, 2, 128 * n}, solve_all);
  return by_level({false, 3, 64 * n}, solve_all);
}

std::optional<CrossingWitness> CrossingSearch::everywhere() {
  return by_level({true, 7, 16384 + 32 * forest_.num_roots()},
                  [&](const std::vector<Pair>& pairs) { return crossing_of(pairs, 1024); });
}

std::optional<MeetingWitness> CrossingSearch::touching_everywhere() {
  return by_level({true, 5, 16384 + 32 * forest_.num_roots()}, [&](std::vector<Pair> pairs) {
    return contact_of(std::move(pairs), kMostContacts);
  });
}

std::vector<CrossingSearch::Pair> CrossingSearch::root_pairs(const Effort& effort) {
  std::vector<Pair> out;
  for (std::uint32_t r = 0; r < forest_.num_roots() && out.size() < effort.most_pairs; ++r) {
    const Id a = forest_.root(r);
    const Box3d hull = forest_.node(a).hull;
    forest_.roots().visit(
        [&](const Box3d& box) { return out.size() < effort.most_pairs && meets(box, hull); },
        [&](std::uint32_t number) {
          const Id b = forest_.root(number);
          ++num_pairs;
          if (number >= r && (effort.with_neighbours || !are_neighbours(forest_, a, b)))
            out.push_back({a, b});
        });
  }
  return out;
}

// Keeps at most this many of the pairs, evenly spread.
void CrossingSearch::thin_out(std::vector<Pair>* pairs, std::size_t most) {
  if (pairs->size() <= most) return;
  for (std::size_t i = 0; i < most; ++i) (*pairs)[i] = (*pairs)[i * pairs->size() / most];
  pairs->resize(most);
}

// Splits the longer piece of each pair, or both, and thins out what results.
std::vector<CrossingSearch::Pair> CrossingSearch::split(const std::vector<Pair>& pairs,
                                                        std::size_t most) {
  std::vector<Pair> out;
  // Returns 0 if there is no room for the parts.
  const auto parts = [&](Id id, bool is_split, Id* first) -> Id {
    if (is_split && !forest_.may_split(id)) return 0;
    *first = is_split ? forest_.children(id) : id;
    return is_split ? 4 : 1;
  };
  for (const Pair& pair : pairs) {
    forest_.limit_memory(PieceForest::kNetMemory);
    const PieceForest::Node &x = forest_.node(pair.a), &y = forest_.node(pair.b);
    if (x.level >= PieceForest::kMaxLevel || y.level >= PieceForest::kMaxLevel) continue;
    const double size_a = extent(x.hull), size_b = extent(y.hull);
    Id a = 0, b = 0;
    const Id num_a = parts(pair.a, !(2 * size_a < size_b), &a),
             num_b = parts(pair.b, !(2 * size_b < size_a), &b);
    for (Id i = 0; i < num_a; ++i)
      for (Id k = pair.a == pair.b ? i : 0; k < num_b; ++k) {
        ++num_pairs;
        if (meets(forest_.node(a + i).hull, forest_.node(b + k).hull))
          out.push_back({a + i, b + k});
      }
  }
  thin_out(&out, most);
  return out;
}

std::vector<CrossingSearch::Pair> CrossingSearch::pairs_near(Id piece) {
  const Box3d hull = forest_.node(piece).hull;
  const double half = 0.5 * kGrowth * extent(hull);
  if (!(half > 0) || !std::isfinite(half)) return {};
  const Point3d middle = approx_centre(hull);
  Box3d box;
  for (std::size_t k = 0; k < 3; ++k) box.lo[k] = middle[k] - half, box.hi[k] = middle[k] + half;
  std::vector<Id> pieces, held;
  find_pieces(forest_, box, kPart * extent(hull), kMostPiecesNear, &pieces, &held);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = i + 1; k < pieces.size(); ++k) {
      ++num_pairs;
      if (meets(forest_.node(pieces[i]).hull, forest_.node(pieces[k]).hull) &&
          !are_neighbours(forest_, pieces[i], pieces[k]))
        pairs.push_back({pieces[i], pieces[k]});
    }
  return pairs;
}

std::optional<CrossingWitness> CrossingSearch::near(Id piece) {
  return crossing_of(pairs_near(piece), kMostSolvedNear);
}

std::optional<MeetingWitness> CrossingSearch::touching_near(Id piece) {
  contacts_.start_again();
  return contact_of(pairs_near(piece), kMostSolvedNear);
}

// Calls the solver for at most this many of the pairs, evenly spread.
std::optional<CrossingWitness> CrossingSearch::crossing_of(const std::vector<Pair>& pairs,
                                                           std::size_t most) {
  const std::size_t n = std::min(most, pairs.size());
  for (std::size_t i = 0; i < n; ++i)
    if (auto witness = solve(pairs[i * pairs.size() / n])) return witness;
  return std::nullopt;
}

// Calls the solver for at most this many of the pairs, first those whose middles are nearest to each other for their
// size.
std::optional<MeetingWitness> CrossingSearch::contact_of(std::vector<Pair> pairs,
                                                         std::size_t most) {
  const auto distance = [&](const Pair& pair) {
    const Box3d &a = forest_.node(pair.a).hull, &b = forest_.node(pair.b).hull;
    const Point3d x = approx_centre(a), y = approx_centre(b);
    return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]) / (extent(a) + extent(b));
  };
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < pairs.size(); ++i) order.push_back({distance(pairs[i]), i});
  const std::size_t n = std::min(most, pairs.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n), order.end());
  for (std::size_t i = 0; i < n; ++i) {
    const Pair& pair = pairs[order[i].second];
    if (auto witness =
            contacts_.solve(range_of_piece(forest_, pair.a), range_of_piece(forest_, pair.b)))
      return witness;
  }
  return std::nullopt;
}

std::optional<CrossingWitness> CrossingSearch::solve(const Pair& pair) {
  const PieceForest::Node &a = forest_.node(pair.a), &b = forest_.node(pair.b);
  const std::array<SheetPlace, 2> guess{middle(a), middle(b)};
  const double far = std::max(reach(a), reach(b));
  if (const auto solution = solver_.solve(guess, far)) return solver_.prove(*solution);
  return solver_.prove_close(guess, far);
}

SheetPlace CrossingSearch::middle(const PieceForest::Node& node) const {
  const PieceForest::Form& form = forest_.form(node.patch);
  const auto part = [](double k, int bits) { return std::ldexp(k, -bits); };
  const auto i = static_cast<double>(node.i), j = static_cast<double>(node.j);
  if (!form.shape.is_triangle)
    return {node.patch,
            {part(i + 0.5, form.root_bits[0] + node.level),
             part(j + 0.5, form.root_bits[1] + node.level)}};
  const double third = node.is_upside_down ? -1.0 / 3 : 1.0 / 3;
  const double b = part(i + third, node.level), c = part(j + third, node.level);
  return {node.patch, {b + c, c / (b + c)}};
}

double CrossingSearch::reach(const PieceForest::Node& node) const {
  const PieceForest::Form& form = forest_.form(node.patch);
  const int bits = node.level + std::min(form.root_bits[0], form.root_bits[1]);
  const double size = std::ldexp(kReach, -bits);
  if (!form.shape.is_triangle) return size;
  return size / std::max(middle(node).at[0], 0x1p-10);  // near corner 0 all of t is near
}

}  // namespace veritope
