// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/patch_octree_internal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "solids/classify/sheet_net_internal.h"

namespace veritope::internal {
namespace {

// A node is one of these, with a number in the other 30 bits.
enum PatchNodeKind : std::uint32_t {
  kDivided = 0,
  kClear = 1u << 30,  // no patch meets the cell
  kSlab = 2u << 30,
  kAsk = 3u << 30
};
constexpr std::uint32_t kKindBits = 3u << 30, kNumberBits = ~kKindBits;

constexpr double kThin =
    0x1p-18;                    // of a slab, in units of the root's size: no better one is sought
constexpr double kFlat = 0.25;  // a slab that is thinner than this part of its cell is not thick
constexpr std::size_t kMostNodes = std::size_t{1} << 23;
// Pieces of all cells together, those of inner cells included.
constexpr std::size_t kMostPieces = std::size_t{1} << 21, kMostPiecesOfPatch = 64;

Point3d box_corner(const Box3d& box, unsigned i) {
  return {(i & 1u) != 0 ? box.hi[0] : box.lo[0], (i & 2u) != 0 ? box.hi[1] : box.lo[1],
          (i & 4u) != 0 ? box.hi[2] : box.lo[2]};
}

double dot(const Point3d& a, const Point3d& b) { return plane_value(a, b[0], b[1], b[2]); }

// Which corner is farthest along n.
unsigned farthest_corner(const Point3d& n) {
  return (n[0] > 0 ? 1u : 0u) | (n[1] > 0 ? 2u : 0u) | (n[2] > 0 ? 4u : 0u);
}

}  // namespace

class PatchOctree::Builder {
 public:
  Builder(PatchOctree& tree, const PatchRays& rays, const LabelOf& label_of, int levels)
      : tree_(tree), rays_(rays), label_of_(label_of), levels_(levels) {}

  void build() {
    std::vector<Piece> pieces;
    for (std::uint32_t p = 0; p < rays_.num_patches(); ++p)
      pieces.push_back(make_piece(SheetNet(rays_.form(p))));
    tree_.nodes_.push_back(0);
    build(0, OctreeCell{tree_.frame_->origin, tree_.frame_->size}, 0, pieces, SlabCell{},
          kMostPieces + kMostPiecesOfPatch * pieces.size());
  }

 private:
  struct Piece {
    SheetNet net;
    Box3d hull;
    Point3d normal;
    std::array<double, 2> range;  // along the normal
  };
  static Piece make_piece(SheetNet net) {
    Piece out{std::move(net), {}, {}, {}};
    out.hull = out.net.hull();
    out.normal = out.net.normal();
    out.range = out.net.range_along(out.normal);
    return out;
  }

  // With the margin that rounded places of points need.
  Box3d box_of(const OctreeCell& cell) const {
    const double m = tree_.frame_->margin, lo = -m, hi = cell.size + m;
    return {{cell.lo.x + lo, cell.lo.y + lo, cell.lo.z + lo},
            {cell.lo.x + hi, cell.lo.y + hi, cell.lo.z + hi}};
  }
  // More than normal·p of points of the root and of their rounded coordinates can be wrong by; |normal| is 1.
  double slack() const {
    const Vec3d& o = tree_.frame_->origin;
    const double most =
        std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)}) + tree_.frame_->size;
    return 0x1p-48 * most;
  }

  bool may_meet(const Piece& piece, const Box3d& box) const {
    if (!meets(piece.hull, box)) return false;
    const unsigned far = farthest_corner(piece.normal);
    return dot(piece.normal, box_corner(box, far)) + slack() >= piece.range[0] &&
           dot(piece.normal, box_corner(box, 7 - far)) - slack() <= piece.range[1];
  }

  // The pieces of `from` that may meet the box, cut until none is longer than the cell.
  std::vector<Piece> pieces_in(const std::vector<Piece>& from, const Box3d& box,
                               double size) const {
    std::vector<Piece> out;
    for (const Piece& p : from)
      if (may_meet(p, box)) add_small(p, box, size, out);
    return out;
  }
  void add_small(const Piece& piece, const Box3d& box, double size, std::vector<Piece>& out) const {
    const double u = piece.net.length(0), v = piece.net.length(1);
    if (!(std::max(u, v) > 2 * size)) {
      out.push_back(piece);
      return;
    }
    SheetNet left = piece.net;
    SheetNet right = left.halve(u >= v ? 0 : 1);
    for (SheetNet* net : {&left, &right}) {
      const Piece half = make_piece(std::move(*net));
      if (may_meet(half, box)) add_small(half, box, size, out);
    }
  }

  std::uint32_t number_of(const std::optional<RegionLabel>& label) {
    if (!label) return SlabCell::kNoLabel;
    const auto [at, is_new] =
        numbers_.emplace(*label, static_cast<std::uint32_t>(tree_.labels_.size()));
    if (is_new) tree_.labels_.push_back(*label);
    return at->second;
  }

  // The label at a point of the cell to which the slab belongs.
  std::uint32_t label_at(const Point3d& p, const SlabCell& around) {
    const double v = dot(around.normal, p);
    if (v < around.lo && around.below != SlabCell::kNoLabel) return around.below;
    if (v > around.hi && around.above != SlabCell::kNoLabel) return around.above;
    return number_of(label_of_(
        RayPoint(ExactPoint{in_model(p[0]), in_model(p[1]), in_model(p[2])}, rays_.scale())));
  }
  Rational in_model(double c) const {
    return Rational::from_double(c) * Rational::power_of_two(rays_.scale());
  }

  SlabCell slab_of(const std::vector<Piece>& pieces, const Box3d& box, const SlabCell& around) {
    SlabCell out;
    for (const Piece& p : pieces) {  // those of both sides of a thin wall count as one direction
      const double sign = dot(p.normal, pieces.front().normal) < 0 ? -1 : 1;
      for (std::size_t k = 0; k < 3; ++k) out.normal[k] += sign * p.normal[k];
    }
    const double sum = std::abs(out.normal[0]) + std::abs(out.normal[1]) + std::abs(out.normal[2]);
    if (!(sum > 0)) out.normal = {1, 0, 0};
    for (double& x : out.normal) x = sum > 0 ? x / sum * (1 - 0x1p-40) : x;
    out.lo = std::numeric_limits<double>::infinity();
    out.hi = -out.lo;
    for (const Piece& p : pieces) {
      const auto range = p.net.range_along(out.normal);
      out.lo = std::min(out.lo, range[0] - slack());
      out.hi = std::max(out.hi, range[1] + slack());
    }
    const unsigned far = farthest_corner(out.normal);
    const Point3d high = box_corner(box, far), low = box_corner(box, 7 - far);
    if (dot(out.normal, high) > out.hi) out.above = label_at(high, around);
    if (dot(out.normal, low) < out.lo) out.below = label_at(low, around);
    return out;
  }

  void build(std::size_t node, const OctreeCell& cell, int level, const std::vector<Piece>& from,
             const SlabCell& around, std::size_t budget) {
    const Box3d box = box_of(cell);
    const std::vector<Piece> pieces = pieces_in(from, box, cell.size);
    if (pieces.empty()) return set_empty(node, cell, around);
    const SlabCell slab = slab_of(pieces, box, around);
    const double thickness = slab.hi - slab.lo;
    const bool is_thick = !(thickness < kFlat * cell.size);
    if (level >= (is_thick ? levels_ + 1 : levels_) || level >= tree_.frame_->max_level ||
        thickness < kThin * tree_.frame_->size || tree_.nodes_.size() + 8 > kMostNodes ||
        8 * pieces.size() > budget)
      return set_slab(node, slab);
    const auto first = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_[node] = kDivided | first;
    tree_.nodes_.resize(first + 8);
    // The budget is shared out by the pieces that the children may have.
    std::array<std::size_t, 8> counts{};
    std::size_t all = 0;
    for (unsigned i = 0; i < 8; ++i) {
      const Box3d part = box_of(cell.child(i));
      counts[i] = static_cast<std::size_t>(std::count_if(
          pieces.begin(), pieces.end(), [&](const Piece& p) { return may_meet(p, part); }));
      all += counts[i];
    }
    budget -= pieces.size();
    for (unsigned i = 0; i < 8; ++i)
      build(first + i, cell.child(i), level + 1, pieces, slab,
            budget / std::max<std::size_t>(all, 1) * counts[i]);
  }

  void set_empty(std::size_t node, const OctreeCell& cell, const SlabCell& around) {
    std::uint32_t label = label_at(to_point(cell.centre()), around);
    for (int i = 0; i < OctreeCell::kNumPoints && label == SlabCell::kNoLabel; ++i)
      label = label_at(to_point(cell.point(i)), around);
    tree_.nodes_[node] = label == SlabCell::kNoLabel ? kAsk : kClear | label;
  }

  void set_slab(std::size_t node, const SlabCell& slab) {
    if (slab.below == SlabCell::kNoLabel && slab.above == SlabCell::kNoLabel) {
      tree_.nodes_[node] = kAsk;
      return;
    }
    tree_.nodes_[node] = kSlab | static_cast<std::uint32_t>(tree_.slabs_.size());
    tree_.slabs_.push_back(slab);
  }

  PatchOctree& tree_;
  const PatchRays& rays_;
  const LabelOf& label_of_;
  const int levels_;
  std::map<RegionLabel, std::uint32_t> numbers_;
};

PatchOctree::PatchOctree(const PatchRays& rays, const LabelOf& label_of, int levels)
    : frame_(OctreeFrame::around(rays.hull())) {
  if (frame_) Builder(*this, rays, label_of, levels).build();
}

// The rounded place of q differs from its own by less than the margin by which cells were taken greater.
const RegionLabel* PatchOctree::find(const RayPoint& q) const {
  if (!frame_) return nullptr;
  const Point3d& p = q.rounded();
  const auto [x, y, z] = frame_->place_of({p[0], p[1], p[2]});
  Node node = nodes_[0];
  for (int bit = OctreeFrame::kIndexBits - 1; (node & kKindBits) == kDivided; --bit)
    node = nodes_[node + ((x >> bit & 1) | (y >> bit & 1) << 1 | (z >> bit & 1) << 2)];
  const std::uint32_t number = node & kNumberBits;
  if ((node & kKindBits) == kClear) return &labels_[number];
  if ((node & kKindBits) == kAsk) return nullptr;
  const SlabCell& slab = slabs_[number];
  const double v = dot(slab.normal, p);
  if (v < slab.lo && slab.below != SlabCell::kNoLabel) return &labels_[slab.below];
  if (v > slab.hi && slab.above != SlabCell::kNoLabel) return &labels_[slab.above];
  return nullptr;
}

// The cells that a box meets, until two of them differ or one does not tell.
class PatchOctree::BoxQuestion {
 public:
  BoxQuestion(const PatchOctree& tree, const Box3d& box)
      : tree_(tree),
        box_(box),
        first_(tree.frame_->place_of({box.lo[0], box.lo[1], box.lo[2]})),
        last_(tree.frame_->place_of({box.hi[0], box.hi[1], box.hi[2]})) {}

  // Places of points are monotone: those of the box lie between those of its corners.
  std::optional<Value3> answer() {
    const OctreeFrame& frame = *tree_.frame_;
    const Vec3d& o = frame.origin;
    const Box3d root{{o.x, o.y, o.z}, {o.x + frame.size, o.y + frame.size, o.z + frame.size}};
    if (!is_inside(box_, root) || !visit(0, {}, OctreeFrame::kIndexBits)) return std::nullopt;
    if (has_[0] && has_[1]) return Value3::kMixed;
    return to_value(has_[1]);
  }

 private:
  using Place = std::array<std::uint32_t, 3>;

  bool is_met(const Place& at, std::uint32_t side) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (last_[k] < at[k] || at[k] + side - 1 < first_[k]) return false;
    return true;
  }

  // False: the cells do not tell. The cell's side is 2^bits.
  bool visit(std::uint32_t number, const Place& at, int bits) {
    if (++num_visited_ > kMostVisited) return false;
    const Node node = tree_.nodes_[number];
    switch (node & kKindBits) {
      case kClear: return add(tree_.labels_[node & kNumberBits]);
      case kSlab: return add_slab(tree_.slabs_[node & kNumberBits], part_in(at, bits));
      case kDivided: break;
      default: return false;
    }
    const std::uint32_t half = std::uint32_t{1} << (bits - 1);
    for (std::uint32_t i = 0; i < 8; ++i) {
      const Place child{at[0] + (i & 1) * half, at[1] + (i >> 1 & 1) * half,
                        at[2] + (i >> 2 & 1) * half};
      if (is_met(child, half) && !visit(node + i, child, bits - 1)) return false;
      if (has_[0] && has_[1]) return true;
    }
    return true;
  }

  bool add(const RegionLabel& label) {
    has_[label.winding != 0 ? 1 : 0] = true;
    return true;
  }
  bool add(std::uint32_t label) { return label != SlabCell::kNoLabel && add(tree_.labels_[label]); }

  // Contains the points of the box whose place is in the cell.
  Box3d part_in(const Place& at, int bits) const {
    const OctreeFrame& frame = *tree_.frame_;
    const double unit = frame.size / (1 << OctreeFrame::kIndexBits), side = std::ldexp(unit, bits);
    const Point3d lo{frame.origin.x + at[0] * unit, frame.origin.y + at[1] * unit,
                     frame.origin.z + at[2] * unit};
    Box3d cell;
    for (std::size_t k = 0; k < 3; ++k) {
      cell.lo[k] = lo[k] - 2 * frame.margin;
      cell.hi[k] = lo[k] + side + 2 * frame.margin;
    }
    return common(box_, cell);
  }

  // normal·p is greatest and least in corners. A part on both sides of the slab has both labels.
  bool add_slab(const SlabCell& slab, const Box3d& part) {
    const unsigned far = farthest_corner(slab.normal);
    const double most = dot(slab.normal, box_corner(part, far)),
                 least = dot(slab.normal, box_corner(part, 7 - far));
    if (most < slab.lo) return add(slab.below);
    if (least > slab.hi) return add(slab.above);
    return least < slab.lo && most > slab.hi && add(slab.below) && add(slab.above) && has_[0] &&
           has_[1];
  }

  static constexpr int kMostVisited = 512;
  const PatchOctree& tree_;
  const Box3d& box_;
  Place first_, last_;
  int num_visited_ = 0;
  std::array<bool, 2> has_{};  // points off the solid, points in it
};

std::optional<Value3> PatchOctree::value(const Box3d& box) const {
  if (!frame_) return std::nullopt;
  return BoxQuestion(*this, box).answer();
}

LookupSize PatchOctree::size() const {
  return {nodes_.size(), nodes_.size() * sizeof(Node) + labels_.size() * sizeof(RegionLabel) +
                             slabs_.size() * sizeof(SlabCell)};
}

}  // namespace veritope::internal
