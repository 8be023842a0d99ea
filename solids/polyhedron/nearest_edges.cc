// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/nearest_edges.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "robust/base/fp_guard.h"
#include "robust/base/parallel.h"
#include "solids/base/range_tree.h"
#include "solids/polyhedron/chunk_internal.h"

namespace veritope {

namespace {

using internal::GapBounds;
using internal::kEdgeGapFloor;
using internal::kEdgeGapRel;
using internal::ScaledEdge;

constexpr std::uint32_t kNoEdge = NearestEdge::kNone;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kUp = 1 + 0x1p-40;  // pays for some roundings of positive terms

// Edges that coincide are one strand: everything but their numbers is the same.
struct Strand {
  ScaledEdge scaled;           // its lexicographically lesser end is first
  std::uint32_t first, count;  // its edges in Strands::numbers, which ascend
  std::uint32_t least;         // the first of them
};

struct Strands {
  int exponent;  // of the scale
  std::vector<std::uint32_t> numbers;
  std::vector<Strand> all;
};

using SortedEnds = std::array<std::array<double, 3>, 2>;
SortedEnds sorted_ends(const EdgeEnds& e) {
  // + 0.0: -0 becomes 0.
  const std::array a{e.a.x + 0.0, e.a.y + 0.0, e.a.z + 0.0},
      b{e.b.x + 0.0, e.b.y + 0.0, e.b.z + 0.0};
  return b < a ? SortedEnds{b, a} : SortedEnds{a, b};
}

std::uint64_t hash_of(const SortedEnds& ends) {
  std::uint64_t h = 0;
  for (const auto& p : ends)
    for (const double c : p) {
      h = (h ^ std::bit_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
  return h;
}

// The exponent that brings the greatest coordinate to 2^500.
int scale_exponent(std::span<const EdgeEnds> edges) {
  double most = 0;
  for (const EdgeEnds& e : edges)
    for (const Vec3d& p : {e.a, e.b})
      most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return most == 0 ? 0 : 500 - std::ilogb(most);
}

struct HashedEdge {
  std::uint64_t hash;
  std::uint32_t number;
  auto operator<=>(const HashedEdge&) const = default;
};

class StrandMaker {
 public:
  StrandMaker(std::span<const EdgeEnds> edges, unsigned jobs) : edges_(edges), jobs_(jobs) {}

  Strands make() {
    std::vector<HashedEdge> hashed(edges_.size());
    parallel_for(hashed.size(), internal::kChunk, jobs_,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   const ScopedDefaultFp to_nearest;
                   for (std::size_t i = begin; i < end; ++i)
                     hashed[i] = {hash_of(sorted_ends(edges_[i])), static_cast<std::uint32_t>(i)};
                 });
    std::sort(hashed.begin(), hashed.end());
    out_.exponent = scale_exponent(edges_);
    out_.numbers.reserve(hashed.size());
    out_.all.reserve(hashed.size());
    for (std::size_t i = 0, j = 0; i < hashed.size(); i = j) {
      for (j = i + 1; j < hashed.size() && hashed[j].hash == hashed[i].hash;) ++j;
      add_of_one_hash(std::span(hashed).subspan(i, j - i));
    }
    return std::move(out_);
  }

 private:
  SortedEnds ends(const HashedEdge& e) const { return sorted_ends(edges_[e.number]); }

  // Nearly always one strand, whose numbers ascend.
  void add_of_one_hash(std::span<HashedEdge> edges) {
    const bool is_one = std::all_of(edges.begin() + 1, edges.end(),
                                    [&](const HashedEdge& e) { return ends(e) == ends(edges[0]); });
    if (!is_one)
      std::sort(edges.begin(), edges.end(), [&](const HashedEdge& x, const HashedEdge& y) {
        return std::pair(ends(x), x.number) < std::pair(ends(y), y.number);
      });
    for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
      for (j = i + 1; j < edges.size() && (is_one || ends(edges[j]) == ends(edges[i]));) ++j;
      add(ends(edges[i]), edges.subspan(i, j - i));
    }
  }

  // Edges of length 0 are left out.
  void add(SortedEnds ends, std::span<const HashedEdge> edges) {
    if (ends[0] == ends[1]) return;
    for (auto& p : ends)
      for (double& c : p) c = std::ldexp(c, out_.exponent);
    out_.all.push_back({internal::scaled_edge(ends[0], ends[1]),
                        static_cast<std::uint32_t>(out_.numbers.size()),
                        static_cast<std::uint32_t>(edges.size()), edges[0].number});
    for (const HashedEdge& e : edges) out_.numbers.push_back(e.number);
  }

  std::span<const EdgeEnds> edges_;
  unsigned jobs_;
  Strands out_;
};

// What a limit of distances must exceed so that no distance is taken for greater because of its rounding. The error of
// a distance is at most kEdgeGapRel * (it + the length of the edge) + kEdgeGapFloor; kUp pays for the first part.
double slack_of(const ScaledEdge& e) { return 4 * kEdgeGapRel * e.length + kEdgeGapFloor; }

// Bounds of the six coordinates of the ends of some strands, and the least number of one of their edges.
struct StrandBounds {
  std::array<double, 6> lo, hi;
  std::uint32_t least;

  static StrandBounds of(const Strand& s) {
    const Point3d &a = s.scaled.a, &b = s.scaled.b;
    const std::array<double, 6> c{a[0], a[1], a[2], b[0], b[1], b[2]};
    return {c, c, s.least};
  }
  static StrandBounds of(std::span<const Strand> strands) {
    StrandBounds out = of(strands[0]);
    for (const Strand& s : strands) out.add(of(s));
    return out;
  }
  void add(const StrandBounds& other) {
    for (std::size_t k = 0; k < 6; ++k) {
      lo[k] = std::min(lo[k], other.lo[k]);
      hi[k] = std::max(hi[k], other.hi[k]);
    }
    least = std::min(least, other.least);
  }
  std::size_t longest_axis() const {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 6; ++k)
      if (hi[axis] - lo[axis] < hi[k] - lo[k]) axis = k;
    return axis;
  }
};

// Puts strands in the order of a tree whose leaves are bundles of some strands, and whose nodes are halved along the
// longest axis of the space of six dimensions in which an edge is a point: strands of a node have near ends.
class StrandOrder {
 public:
  static constexpr std::size_t kBundle = 8;  // 4 and 16 are slower

  StrandOrder(std::vector<Strand>& strands, unsigned jobs) : strands_(strands), jobs_(jobs) {}

  /// The first levels one by one, all nodes of a level at once; then each node on its own.
  void arrange() const {
    std::vector<TreeRange> level{
        {0, 0, static_cast<std::uint32_t>(num_chunks(strands_.size(), kBundle))}};
    for (int depth = 0; depth < 6 && level.front().size() > 64; ++depth) {
      parallel_for(level.size(), 1, jobs_,
                   [&](std::size_t i, std::size_t, std::size_t) { halve(level[i]); });
      std::vector<TreeRange> below;
      for (const TreeRange& r : level) below.insert(below.end(), {r.left(), r.right()});
      level = std::move(below);
    }
    parallel_for(level.size(), 1, jobs_,
                 [&](std::size_t i, std::size_t, std::size_t) { arrange_below(level[i]); });
  }

 private:
  void arrange_below(const TreeRange& r) const {
    if (r.is_leaf()) return;
    halve(r);
    arrange_below(r.left());
    arrange_below(r.right());
  }

  void halve(const TreeRange& r) const {
    const auto at = [&](std::uint32_t bundle) {
      return strands_.begin() +
             static_cast<std::ptrdiff_t>(std::min(bundle * kBundle, strands_.size()));
    };
    const std::size_t axis =
        StrandBounds::of(std::span<const Strand>(at(r.lo), at(r.hi))).longest_axis();
    const auto coordinate = [axis](const Strand& s) {
      return (axis < 3 ? s.scaled.a : s.scaled.b)[axis % 3];
    };
    std::nth_element(at(r.lo), at(r.right().lo), at(r.hi), [&](const Strand& x, const Strand& y) {
      const double p = coordinate(x), q = coordinate(y);
      return p != q ? p < q : x.least < y.least;
    });
  }

  std::vector<Strand>& strands_;
  unsigned jobs_;
};

// Each strand below comes from `core` by moving its points by at most `radius`; so its gap to any edge differs from
// that of `core` by at most this.
struct StrandNode {
  ScaledEdge core;
  double radius;  // rounded upward, and the slack of the core is added
  StrandBounds bounds;
};

StrandNode node_over(const StrandBounds& bounds) {
  const ScopedDefaultFp to_nearest;
  std::array<double, 6> mid;
  std::array<double, 2> squared{};
  for (std::size_t k = 0; k < 6; ++k) {
    mid[k] = 0.5 * (bounds.lo[k] + bounds.hi[k]);
    const double half = std::max(bounds.hi[k] - mid[k], mid[k] - bounds.lo[k]);
    squared[k / 3] += half * half;
  }
  const ScaledEdge core = internal::scaled_edge({mid[0], mid[1], mid[2]}, {mid[3], mid[4], mid[5]});
  const double radius = kUp * std::sqrt(std::max(squared[0], squared[1])) + kEdgeGapFloor;
  return {core, radius + slack_of(core), bounds};
}

StrandNode joined_nodes(const StrandNode& a, const StrandNode& b) {
  StrandBounds bounds = a.bounds;
  bounds.add(b.bounds);
  return node_over(bounds);
}

class StrandTree {
 public:
  /// REQUIRES strands arranged by StrandOrder, at least one.
  StrandTree(std::span<const Strand> strands, unsigned jobs)
      : strands_(strands),
        tree_(
            num_chunks(strands.size(), kBundle), jobs,
            [this](std::uint32_t i) { return node_over(StrandBounds::of(bundle(i))); },
            joined_nodes) {}

  TreeRange root() const { return tree_.root(); }
  const StrandNode& operator[](const TreeRange& r) const { return tree_[r]; }
  std::span<const Strand> bundle(std::uint32_t i) const {
    return strands_.subspan(i * kBundle, std::min(kBundle, strands_.size() - i * kBundle));
  }
  bool is_in(const Strand& s, const TreeRange& r) const {
    const auto bundle = static_cast<std::size_t>(&s - strands_.data()) / kBundle;
    return r.lo <= bundle && bundle < r.hi;
  }

 private:
  static constexpr std::size_t kBundle = StrandOrder::kBundle;

  std::span<const Strand> strands_;
  RangeTree<StrandNode> tree_;
};

// An edge of another strand, its gap, and what is known about it.
struct Neighbour {
  std::uint32_t edge = kNoEdge;
  GapBounds gap{0, 0};  // in scaled coordinates
  bool is_touching = false;
  std::optional<Rational> squared;  // in those of the mesh; computed when it is needed
};

// Exact questions about an edge and its neighbours, with bounds as the first tier.
class GapComparison {
 public:
  GapComparison(std::span<const EdgeEnds> edges, const Strand& of)
      : edges_(edges),
        ends_(edges[of.least]),
        length_(of.scaled.length),
        slack_(slack_of(of.scaled)) {}

  double length() const { return length_; }
  double slack() const { return slack_; }

  bool touches(std::uint32_t edge) const { return has_no_gap(ends_, edges_[edge]); }
  bool runs_along(std::uint32_t edge) const { return run_along(ends_, edges_[edge]); }

  const Rational& squared(Neighbour& n) const {
    if (!n.squared) n.squared = squared_gap(ends_, edges_[n.edge]);
    return *n.squared;
  }

  /// Whether the gap is at most the length / part.
  bool is_within(Neighbour& n, int part) const {
    if (n.is_touching || kUp * part * n.gap.hi < length_ - slack_) return true;
    if (part * n.gap.lo > kUp * (length_ + slack_)) return false;
    return Rational(part) * Rational(part) * squared(n) <= squared_length(ends_);
  }

  /// Whether x is nearer than y.
  bool precedes(Neighbour& x, Neighbour& y) const {
    if (x.is_touching && y.is_touching) return x.edge < y.edge;
    if (x.is_touching || x.gap.hi < y.gap.lo) return true;
    if (y.is_touching || x.gap.lo > y.gap.hi) return false;
    const auto order = squared(x) <=> squared(y);
    return order != 0 ? order < 0 : x.edge < y.edge;
  }

 private:
  std::span<const EdgeEnds> edges_;
  const EdgeEnds& ends_;
  double length_, slack_;  // of the scaled edge
};

// Finds the nearest one among the other strands: branch and bound.
class StrandSearch {
 public:
  StrandSearch(const StrandTree& tree, const Strand& of, const GapComparison& compare,
               std::uint32_t max_steps)
      : tree_(tree),
        of_(of),
        compare_(compare),
        max_steps_(max_steps),
        limit_(kUp * compare.length() + kEdgeGapFloor) {}

  /// From now on searches only for strands without a gap whose least edge precedes this one.
  void touch_before(std::uint32_t edge) {
    best_.edge = edge;
    best_.is_touching = true;
    limit_ = 0;
  }

  /// Returns whether the search came to its end.
  bool run() {
    visit_around(tree_.root());
    return !is_given_up();
  }
  Neighbour take() { return std::move(best_); }

 private:
  // An exact answer takes the time of this number of steps.
  static constexpr std::uint32_t kExactSteps = 100;

  bool is_given_up() const { return steps_ >= max_steps_; }
  // Whether nothing with this least edge can precede a best one without a gap.
  bool is_too_late(std::uint32_t least) const { return best_.is_touching && best_.edge <= least; }

  // A computed distance that exceeds this belongs to a distance greater than limit_ + radius.
  double limit_beyond(double radius) const { return kUp * (limit_ + radius + compare_.slack()); }

  bool is_hopeless(double lower, std::uint32_t least) const {
    return lower > kUp * (limit_ + compare_.slack()) || is_too_late(least) || is_given_up();
  }

  // A lower bound of the gaps to the strands of a node; infinity if none can precede the best one.
  double lower_bound(const TreeRange& r) {
    const StrandNode& node = tree_[r];
    ++steps_;
    if (is_too_late(node.bounds.least)) return kInfinite;
    const double squared =
        internal::approx_squared_gap(of_.scaled, node.core, limit_beyond(node.radius));
    return std::sqrt(squared) - node.radius;
  }

  // The part with the strand itself comes first: the nearest one is often there, and then limits the search elsewhere.
  void visit_around(const TreeRange& r) {
    if (r.is_leaf()) return consider_all(r);
    const bool is_left = tree_.is_in(of_, r.left());
    visit_around(is_left ? r.left() : r.right());
    const TreeRange other = is_left ? r.right() : r.left();
    visit(other, lower_bound(other));
  }

  void visit(const TreeRange& r, double lower) {
    if (is_hopeless(lower, tree_[r].bounds.least)) return;
    if (r.is_leaf()) return consider_all(r);
    TreeRange near = r.left(), far = r.right();
    double to_near = lower_bound(near), to_far = lower_bound(far);
    if (to_far < to_near) std::swap(near, far), std::swap(to_near, to_far);
    visit(near, to_near);
    visit(far, to_far);
  }

  void consider_all(const TreeRange& leaf) {
    for (const Strand& s : tree_.bundle(leaf.lo)) consider(s);
  }

  void consider(const Strand& s) {
    ++steps_;
    if (&s == &of_ || is_too_late(s.least)) return;
    const double squared =
        internal::approx_squared_gap(of_.scaled, s.scaled, limit_beyond(slack_of(s.scaled)));
    if (squared == kInfinite) return;
    Neighbour other{s.least, internal::gap_bounds(of_.scaled, s.scaled), false, {}};
    if (other.gap.lo > limit_ || !runs_along(s)) return;
    other.is_touching = other.gap.lo == 0 && compare_.touches(s.least);
    if (other.is_touching) other.gap = {0, 0};
    const bool is_better =
        best_.edge == kNoEdge ? compare_.is_within(other, 1) : compare_.precedes(other, best_);
    if (other.squared) steps_ += kExactSteps;
    if (!is_better) return;
    best_ = std::move(other);
    limit_ = std::min(limit_, best_.gap.hi);
  }

  bool runs_along(const Strand& s) {
    const Sign3 sign = internal::run_along_filter(of_.scaled, s.scaled);
    if (is_certain(sign)) return sign == Sign3::kPositive;
    steps_ += kExactSteps;
    return compare_.runs_along(s.least);
  }

  const StrandTree& tree_;
  const Strand& of_;
  const GapComparison& compare_;
  std::uint32_t max_steps_;
  double limit_;  // no gap above it is of interest
  Neighbour best_;
  std::uint32_t steps_ = 0;
};

// v * 2^-exponent with its bounds rounded outward. REQUIRES 0 <= v.lo <= v.hi, finite.
Interval unscaled(const GapBounds& v, int exponent) {
  const auto rounded = [exponent](double bound, double toward) {
    const double out = std::ldexp(bound, -exponent);
    return std::ldexp(out, exponent) == bound ? out : std::nextafter(out, toward);
  };
  return Interval::from_bounds(rounded(v.lo, 0), rounded(v.hi, kInfinite));
}

Interval gap_enclosure(Neighbour& n, const GapComparison& compare, int exponent) {
  if (n.is_touching) return Interval();
  if (n.gap.hi - n.gap.lo <= 0x1p-42 * n.gap.lo) return unscaled(n.gap, exponent);
  const double root = nearest_root(compare.squared(n));
  return Interval::from_bounds(std::nextafter(root, 0.0), std::nextafter(root, kInfinite));
}

// Edges that coincide have no gap to each other; but another strand without a gap may have the least number.
void set_coinciding(std::span<const std::uint32_t> numbers, std::uint32_t least_of_others,
                    std::vector<NearestEdge>& out) {
  for (const std::uint32_t e : numbers) {
    const std::uint32_t partner = e == numbers[0] ? numbers[1] : numbers[0];
    out[e].edge = std::min(partner, least_of_others);
    out[e].is_near = out[e].is_touching = true;
  }
}

// Finds the nearest edge of all edges of a strand.
class NearestFinder {
 public:
  NearestFinder(std::span<const EdgeEnds> edges, const Strands& strands, const StrandTree& tree,
                std::uint32_t max_steps)
      : edges_(edges), strands_(strands), tree_(tree), max_steps_(max_steps) {}

  void find(const Strand& strand, std::vector<NearestEdge>& out) const {
    const auto numbers = std::span(strands_.numbers).subspan(strand.first, strand.count);
    const GapComparison compare(edges_, strand);
    StrandSearch search(tree_, strand, compare, max_steps_);
    if (numbers.size() > 1) search.touch_before(numbers[1]);
    const bool is_ended = search.run();
    Neighbour best = search.take();
    for (const std::uint32_t e : numbers) out[e].is_searched = is_ended;
    if (numbers.size() > 1) return set_coinciding(numbers, best.edge, out);
    if (best.edge == kNoEdge) return;
    NearestEdge& nearest = out[numbers[0]];
    nearest.edge = best.edge;
    nearest.is_touching = best.is_touching;
    nearest.is_near = compare.is_within(best, kNearPart);
    nearest.gap = gap_enclosure(best, compare, strands_.exponent);
  }

 private:
  std::span<const EdgeEnds> edges_;
  const Strands& strands_;
  const StrandTree& tree_;
  std::uint32_t max_steps_;
};

}  // namespace

std::vector<NearestEdge> find_nearest_edges(std::span<const EdgeEnds> edges, unsigned jobs,
                                            std::uint32_t max_steps) {
  const ScopedDefaultFp to_nearest;
  std::vector<NearestEdge> out(edges.size());
  Strands strands = StrandMaker(edges, jobs).make();
  if (strands.all.empty()) return out;
  StrandOrder(strands.all, jobs).arrange();
  const StrandTree tree(strands.all, jobs);
  const NearestFinder finder(edges, strands, tree, max_steps);
  parallel_for(strands.all.size(), internal::kChunk / 16, jobs,
               [&](std::size_t, std::size_t begin, std::size_t end) {
                 const ScopedDefaultFp worker_to_nearest;
                 for (std::size_t i = begin; i < end; ++i) finder.find(strands.all[i], out);
               });
  return out;
}

}  // namespace veritope
