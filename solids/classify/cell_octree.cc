// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <numeric>

#include "robust/filter.h"
#include "solids/classify/cell_octree_internal.h"
#include "solids/classify/segment_count_internal.h"

namespace veritope::internal {
namespace {

constexpr std::uint64_t kMostCopies =
    10;  // facets of all cells together, for each facet of the mesh

struct Reference {
  Vec3d point;
  RegionLabel label;
};

}  // namespace

// The size is 2^k > 2 extent. The origin is a multiple of 2^(k - 8), at least 2^(k - 4) below the box in every
// coordinate. With points of cells, 7 bits below a cell of the last level, every number needs at most 53 bits.
std::optional<OctreeFrame> OctreeFrame::around(const Box3d& box) {
  const double length = extent(box);
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k)
    most = std::max({most, std::abs(box.lo[k]), std::abs(box.hi[k])});
  if (!(length > 0) || !(most < 0x1p1000) || !(length > 0x1p-900)) return std::nullopt;
  OctreeFrame out;
  const int exponent = std::ilogb(length) + 2;  // 2^exponent >= 2 length
  out.size = std::ldexp(1.0, exponent);
  const double step = std::ldexp(1.0, exponent - 8);
  const int above = std::max(0, std::ilogb(most) - exponent + 1);
  out.max_level = std::min(OctreeFrame::kIndexBits, 53 - 10 - above);
  if (out.max_level < 1) return std::nullopt;  // the box is tiny beside its distance from 0
  const auto start = [&](double lo) { return (std::floor(lo / step) - 16) * step; };
  out.origin = {start(box.lo[0]), start(box.lo[1]), start(box.lo[2])};
  out.margin = std::max(out.size * 0x1p-40, most * 0x1p-51);
  return out;
}

class CellOctree::Builder {
 public:
  Builder(CellOctree& tree, const FacetTests& tests, std::uint32_t num_facets,
          std::size_t few_facets, ShellChains& chains)
      : tree_(tree),
        tests_(tests),
        chains_(chains),
        num_facets_(num_facets),
        few_facets_(few_facets) {
    boxes_.reserve(num_facets);
    for (std::uint32_t f = 0; f < num_facets; ++f) {
      Box3d b = empty_box();
      for (const Vec3d& p : tests.corners(f)) add(to_point(p), &b);
      boxes_.push_back(b);
    }
  }

  void build() {
    const OctreeCell root{tree_.frame_.origin, tree_.frame_.size};
    std::vector<std::uint32_t> all(num_facets_);
    std::iota(all.begin(), all.end(), 0u);
    tree_.nodes_.push_back(0);
    // The origin lies below the box of all facets in every coordinate.
    build(0, root, 0, all, Reference{root.lo, {}}, kMostCopies * num_facets_);
  }

 private:
  bool is_off_planes(const std::vector<std::uint32_t>& facets, const Vec3d& p) const {
    return std::all_of(facets.begin(), facets.end(), [&](std::uint32_t f) {
      return tests_.side(f, p) != Sign::kZero || tests_.is_degenerate(f);
    });
  }

  // The children of a cell, as bits, with which the box of a facet of the cell has common points, margin included.
  unsigned children_at(std::uint32_t f, const Vec3d& middle) const {
    constexpr unsigned kLow[3] = {0x55, 0x33, 0x0f};
    const double m = tree_.frame_.margin;
    const Box3d& b = boxes_[f];
    unsigned out = 0xff;
    for (std::size_t k = 0; k < 3; ++k) {
      const double c = middle[static_cast<int>(k)];
      out &= (b.lo[k] <= c + m ? kLow[k] : 0u) | (b.hi[k] >= c - m ? ~kLow[k] : 0u);
    }
    return out;
  }

  // The plane function L of a facet has one sign on every cell of this size at whose centre its value is beyond this,
  // margin included: |L - value| <= e at the centre, where e is the session's bound; the radius r below differs from
  // that of the exact normal by less than e, because the bound holds for all points of the session's box, and from its
  // own rounding by less than 2^-40 r. So |value| > r (1 + 2^-40) + 4 e leaves no zero of L in the cell.
  double reach_of(const SessionPlane& plane, double size) const {
    const double half = 0.5 * size + 2 * tree_.frame_.margin;
    const double r =
        (std::abs(double(plane.x)) + std::abs(double(plane.y)) + std::abs(double(plane.z))) * half;
    return r * (1 + 0x1p-40) + 4 * tests_.session().orient3d_error();
  }

  // The label at `to`, at the end of a segment from a reference of a cell that contains both; nothing if the segment
  // touches the rim of a facet, or ends on the plane of one that may count.
  std::optional<RegionLabel> label_at(const Vec3d& to, const Reference& from,
                                      const std::vector<std::uint32_t>& facets) const {
    Box3d segment = empty_box();
    add(to_point(from.point), &segment);
    add(to_point(to), &segment);
    WindingChange change;
    for (const std::uint32_t f : facets) {
      if (!meets(boxes_[f], segment)) continue;
      const Sign start = tests_.side(f, from.point), end = tests_.side(f, to);
      if (start == end && start != Sign::kZero) continue;
      if (start == Sign::kZero || end == Sign::kZero) {
        if (tests_.is_degenerate(f)) continue;
        return std::nullopt;
      }
      switch (tests_.passage(f, from.point, to)) {
        case Passage::kTouchesRim: return std::nullopt;
        case Passage::kCrosses: change.cross(f, start, chains_.shells()); break;
        case Passage::kMisses: break;
      }
    }
    return RegionLabel{from.label.winding + change.winding,
                       chains_.after(from.label.chain, change.shells)};
  }

  // A point of the cell with its label, found from a reference of a cell that contains it and meets `facets` only. If
  // it `must_serve`, it lies on no plane of them.
  std::optional<Reference> reference_in(const OctreeCell& cell, const Reference& from,
                                        const std::vector<std::uint32_t>& facets, bool must_serve) {
    if (cell.contains(from.point) && (!must_serve || is_off_planes(facets, from.point)))
      return from;
    for (int i = 0; i < OctreeCell::kNumPoints; ++i) {
      const Vec3d p = cell.point(i);
      if (must_serve && !is_off_planes(facets, p)) continue;
      if (const auto label = label_at(p, from, facets)) return Reference{p, *label};
    }
    return std::nullopt;
  }

  void build(std::size_t node, const OctreeCell& cell, int level,
             const std::vector<std::uint32_t>& facets, const std::optional<Reference>& reference,
             std::uint64_t budget) {
    if (!reference) return set_occupied(node, facets, std::nullopt);
    if (facets.empty()) return set_empty(node, reference->label);
    std::array<std::vector<std::uint32_t>, 8> parts;
    if (facets.size() <= few_facets_ || level == tree_.frame_.max_level ||
        !divide(cell, facets, budget, parts))
      return set_occupied(node, facets, reference_in(cell, *reference, facets, true));
    const auto first = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_[node] = kInner | first;
    tree_.nodes_.resize(first + 8);
    const auto references = references_of_children(cell, *reference, facets, parts);
    std::uint64_t all = 0;
    for (const auto& part : parts) all += part.size();
    for (unsigned i = 0; i < 8; ++i) {
      const std::uint64_t share = all == 0 ? 0 : budget * parts[i].size() / all;
      build(first + i, cell.child(i), level + 1, parts[i], references[i], share);
      parts[i] = {};
    }
  }

  // A point of each child with its label. They follow from child to child, over common faces: a segment between points
  // of both lies in the two, so that only their facets count. REQUIRES that the cell contains the reference.
  std::array<std::optional<Reference>, 8> references_of_children(
      const OctreeCell& cell, const Reference& from, const std::vector<std::uint32_t>& facets,
      const std::array<std::vector<std::uint32_t>, 8>& parts) {
    std::array<std::optional<Reference>, 8> out;
    const Vec3d middle = cell.centre();
    const unsigned start = (from.point.x > middle.x ? 1u : 0u) |
                           (from.point.y > middle.y ? 2u : 0u) |
                           (from.point.z > middle.z ? 4u : 0u);
    out[start] = from;
    for (unsigned step = 1; step < 8; ++step) {
      const unsigned i = start ^ step, before = start ^ (step & (step - 1));
      if (out[before]) {
        both_.clear();
        std::set_union(parts[before].begin(), parts[before].end(), parts[i].begin(), parts[i].end(),
                       std::back_inserter(both_));
        out[i] = reference_in(cell.child(i), *out[before], both_, false);
      }
      if (!out[i]) out[i] = reference_in(cell.child(i), from, facets, false);
    }
    return out;
  }

  // False if the parts have too many facets in all.
  bool divide(const OctreeCell& cell, const std::vector<std::uint32_t>& facets,
              std::uint64_t budget, std::array<std::vector<std::uint32_t>, 8>& parts) const {
    const Vec3d middle = cell.centre();
    const double size = 0.5 * cell.size;
    std::array<Vec3d, 8> centres;
    for (unsigned i = 0; i < 8; ++i) centres[i] = cell.child(i).centre();
    std::uint64_t copies = 0;
    for (const std::uint32_t f : facets) {
      const SessionPlane plane = tests_.plane(f);
      const double reach = reach_of(plane, size);
      for (unsigned rest = children_at(f, middle); rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        if (is_certain(sign_beyond(Session3d::plane_value(plane, centres[i]), reach))) continue;
        parts[i].push_back(f);
        ++copies;
      }
      if (copies > budget) return false;
    }
    return true;
  }

  void set_empty(std::size_t node, const RegionLabel& label) {
    const auto [at, is_new] =
        labels_.emplace(label, static_cast<std::uint32_t>(tree_.labels_.size()));
    if (is_new) tree_.labels_.push_back(label);
    tree_.nodes_[node] = kEmpty | at->second;
  }

  void set_occupied(std::size_t node, const std::vector<std::uint32_t>& facets,
                    const std::optional<Reference>& reference) {
    OccupiedCell out;
    out.first = static_cast<std::uint32_t>(tree_.facets_.size());
    out.count = static_cast<std::uint32_t>(facets.size());
    out.has_reference = reference.has_value();
    if (reference) {
      out.reference = reference->point;
      out.label = reference->label;
    }
    for (const std::uint32_t f : facets)
      tree_.facets_.push_back(
          {f, reference && tests_.side(f, reference->point) == Sign::kPositive ? 1u : 0u});
    tree_.nodes_[node] = kOccupied | static_cast<std::uint32_t>(tree_.occupied_.size());
    tree_.occupied_.push_back(out);
  }

  CellOctree& tree_;
  const FacetTests& tests_;
  ShellChains& chains_;
  const std::uint32_t num_facets_;
  const std::size_t few_facets_;
  std::vector<Box3d> boxes_;
  std::vector<std::uint32_t> both_;  // the facets of two children
  std::map<RegionLabel, std::uint32_t> labels_;
};

CellOctree::CellOctree(const FacetTests& tests, const OctreeFrame& frame, std::uint32_t num_facets,
                       std::size_t few_facets, ShellChains& chains)
    : frame_(frame) {
  Builder(*this, tests, num_facets, few_facets, chains).build();
  make_grid(num_facets);
}

// The deepest level with at most as many cells as the mesh has facets.
void CellOctree::make_grid(std::uint32_t num_facets) {
  while (grid_level_ < 7 && (std::uint64_t{8} << (3 * grid_level_)) <= num_facets) ++grid_level_;
  const std::uint32_t n = 1u << grid_level_;
  grid_.resize(std::size_t{n} * n * n);
  for (std::uint32_t z = 0; z < n; ++z)
    for (std::uint32_t y = 0; y < n; ++y)
      for (std::uint32_t x = 0; x < n; ++x) {
        Node node = nodes_[0];
        for (int bit = grid_level_ - 1; bit >= 0 && node < kEmpty; --bit)
          node = nodes_[node + ((x >> bit & 1) | (y >> bit & 1) << 1 | (z >> bit & 1) << 2)];
        grid_[(std::size_t{z} * n + y) * n + x] = node;
      }
}

std::vector<std::uint32_t> CellOctree::renumber_facets(std::uint32_t num_facets) {
  std::vector<std::uint32_t> order, rank(num_facets, kNowhere);
  order.reserve(num_facets);
  const auto rank_of = [&](std::uint32_t f) {
    if (rank[f] == kNowhere) {
      rank[f] = static_cast<std::uint32_t>(order.size());
      order.push_back(f);
    }
    return rank[f];
  };
  for (CellFacet& f : facets_) f.facet = rank_of(f.facet) & 0x7fffffffu;
  for (std::uint32_t f = 0; f < num_facets; ++f) rank_of(f);
  return order;
}

OctreeCell CellOctree::cell_at(const std::array<std::uint32_t, 3>& place, int level) const {
  const double size = std::ldexp(frame_.size, -level);
  return {{frame_.origin.x + place[0] * size, frame_.origin.y + place[1] * size,
           frame_.origin.z + place[2] * size},
          size};
}

// The rounded place of q differs from its own by less than the margin by which cells were taken greater.
CellOctree::Found CellOctree::find(const Vec3d& q) const {
  constexpr int kIndexBits = OctreeFrame::kIndexBits;
  const auto [x, y, z] = frame_.place_of(q);
  int bit = kIndexBits - grid_level_;
  Node node =
      grid_[(((std::size_t{z >> bit} << grid_level_) + (y >> bit)) << grid_level_) + (x >> bit)];
  while (node < kEmpty) {
    --bit;
    node = nodes_[node + ((x >> bit & 1) | (y >> bit & 1) << 1 | (z >> bit & 1) << 2)];
  }
  const std::uint32_t number = node & kNumber;
  if ((node & kOccupied) == 0) return {&labels_[number], nullptr, {}};
  return {nullptr, &occupied_[number], cell_at({x >> bit, y >> bit, z >> bit}, kIndexBits - bit)};
}

LookupSize CellOctree::size() const {
  return {nodes_.size(), grid_.size() * sizeof(Node) + nodes_.size() * sizeof(Node) +
                             labels_.size() * sizeof(RegionLabel) +
                             occupied_.size() * sizeof(OccupiedCell) +
                             facets_.size() * sizeof(CellFacet)};
}

}  // namespace veritope::internal
