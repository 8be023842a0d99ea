// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/piece_forest.h: all patches of a complex as trees of ever smaller pieces, in doubles with proved
// bounds: closed hulls, and the signs of n·(S - c). Theory: docs/THEORY.md §4. Bound: docs/bounds/piece_net.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "robust/base/memory_budget.h"
#include "robust/base/result.h"
#include "robust/base/sign.h"
#include "solids/patches/patch_complex.h"
#include "solids/base/box_hierarchy.h"
#include "solids/pieces/surface_form.h"

namespace veritope {

class ExactPiece;

/// The pieces of the star-box certificate (docs/certificates/star-box.md, section 4). Coordinates here are those of the
/// model in a frame, so that the largest is approximately 1. Nodes are made on demand and stay; their nets may be
/// dropped and are then made again.
class PieceForest {
 public:
  using Id = std::uint32_t;
  static constexpr Id kNone = ~Id{0};
  static constexpr int kMaxLevel = 24;

  /// A tensor piece is [i, i + 1] x [j, j + 1] in units of 2^-(roots + level). A triangle has barycentric coordinates
  /// in units of 2^-level: upright, corner e is (a, b, c) plus the unit vector e, with a + b + c = 2^level - 1, b = i,
  /// c = j; upside down, minus it, with a + b + c = 2^level + 1.
  struct Node {
    Box3d hull;  ///< contains the closed hull of the exact control points
    std::uint32_t patch;
    Id first_child = kNone;
    Id parent = kNone;
    std::uint64_t i, j;
    std::array<double*, 2> nets{};            // by Part
    std::array<std::uint32_t, 2> net_ages{};  // the net exists iff this is the age of the store
    std::uint8_t level = 0;
    bool is_upside_down = false;
  };
  /// The data that all nodes of a patch share.
  struct Form {
    FormShape shape, determinant;
    bool is_rational = false;
    std::uint8_t root_bits[2] = {0, 0};  ///< 2^a x 2^b roots
    std::uint8_t collapsed = 0;          ///< bit s: side s of the patch
    Point3d origin{};                    ///< of the nets
    Id first_root = 0;
    std::uint32_t num_roots = 1;
    std::vector<double> root_control, root_determinants;  ///< nets of the whole patch
  };

  /// Coordinate k of the model minus shift[k], times 2^scale[k]. Star boxes stay star boxes. A frame is plain (one
  /// scale, no shift) unless the model lies far from the origin, by 16 times its size, or an axis is 16 times as long
  /// as another, since doubles, or cubes, would then have to be too fine; or unless a patch is 2^32 times smaller than
  /// the model: then the origin lies in it.
  struct Frame {
    std::array<int, 3> scale{};
    std::array<Rational, 3>
        /// a dyadic number; without a tiny patch a multiple of 2^-scale[k], so that multiples of a power of two up to 1
        /// stay such multiples
        shift;
    bool is_plain() const;
  };
  enum class FrameChoice {
    kFitted,
    kPlain,  ///< for collars, which need cubes and the model's own origin
    kWhole,  ///< plain, and long patches are cut only where they bend: for boxes in frames, which are as long as they
  };
  /// @param budget  of the nodes, with what searches keep for each, and of the nets; it must outlive the forest. Null:
  ///                no limit
  /// REQUIRES a complex without defects. @error kOverLimit with the patch, if it is beyond the range of doubles.
  static Result<PieceForest> make(const PatchComplex& complex,
                                  FrameChoice choice = FrameChoice::kFitted,
                                  MemoryBudget* budget = nullptr);

  const Frame& frame() const { return frame_; }
  /// REQUIRES frame().is_plain().
  int scale() const;
  Rational in_frame(std::size_t axis, const Rational& model) const;
  Rational in_model(std::size_t axis, double framed) const;
  /// Contains the box in model units; infinite where binary64 ends.
  Box3d in_model(const Box3d& box) const;
  const PatchComplex& complex() const { return *complex_; }
  std::size_t num_patches() const { return forms_.size(); }
  const Form& form(std::uint32_t patch) const { return forms_[patch]; }
  const Node& node(Id id) const { return nodes_[id]; }
  /// Numbers of nodes are less, those of dropped ones included.
  std::size_t num_nodes() const { return nodes_.size(); }
  std::size_t num_dropped() const { return 4 * free_.size(); }
  /// Whether the node has children or may have some: it is not of the greatest level, and the budget has room for them.
  bool may_split(Id id) {
    if (nodes_[id].first_child != kNone) return true;
    return nodes_[id].level < kMaxLevel &&
           (!free_.empty() || make_room(nodes_, 4, node_share_, kBytesOfNode));
  }
  /// The first of the node's four children, whose numbers follow each other. REQUIRES level < kMaxLevel, and
  /// may_split(id) where there is a budget.
  Id children(Id id);
  /// Forgets all nodes below this one; their numbers will be given to other nodes. What others keep for a number is
  /// void once num_drops has changed.
  void drop_children(Id id);
  std::uint64_t num_drops() const { return num_drops_; }
  MemoryBudget* budget() const { return node_share_.budget(); }
  /// Whether the budget refused something.
  bool is_out_of_memory() const { return budget() != nullptr && budget()->is_spent(); }
  /// The tree over all roots; its number i is root(i).
  const BoxHierarchy& roots() const { return roots_; }
  Id root(std::uint32_t number) const { return number; }
  std::size_t num_roots() const { return num_roots_; }

  /// Whether side s of the node (numbered as in the patch: in a triangle, from corner s to corner s + 1) lies in side s
  /// of the patch.
  bool side_of_patch(const Node& node, std::uint32_t side) const;
  /// Whether a corner of the node (where its side of that number starts) lies on side s of the patch.
  bool is_on_side(const Node& node, std::uint32_t corner, std::uint32_t side) const;
  /// Calls visit(i) for the places of the determinants' coefficients outside the rows of collapsed sides.
  template <typename Visit>
  void for_each_kept(const Node& node, Visit visit) const;

  /// The sign that all coefficients of g_c = det(F, F_u, F_v, (c, 1)) have, rows of collapsed sides left out; uncertain
  /// if they differ or one is 0. It is also uncertain if two sides of the piece lie in collapsed sides and share a
  /// corner: there g_c is 0 and the corner is never certified. Where the bound of doubles does not decide, integers do
  /// while the budget for them lasts; after that the sign is uncertain, too.
  Sign3 side_of(Id id, const Point3d& c);
  /// The sign of the coefficients of g_c that are not zero, if all of these have one sign.
  struct SideWithZeros {
    Sign sign = Sign::kZero;
    /// For each coefficient, rows of collapsed sides included, whether it is zero; empty if only such rows are.
    std::vector<bool> is_zero;
  };
  /// Zeros are found by integers. Nothing if all coefficients are zero or two differ in sign, if two sides of the piece
  /// lie in collapsed sides and share a corner, or if the budget for integers is spent.
  std::optional<SideWithZeros> side_with_zeros(Id id, const Point3d& c);
  /// Approximate coefficients of G0 .. G3 relative to origin(), for searches.
  const double* approx_determinants(Id id);
  /// The sum of the control net of the piece's normals: approximate and not of unit length, for searches.
  Point3d approx_normal(Id id);
  /// The bound of the errors of G_k's coefficients.
  double determinant_error(Id id, std::size_t k);
  /// Homogeneous control points relative to origin(), component by component, and the bound of their errors.
  const double* control(Id id);
  double control_error(Id id, std::size_t component);
  /// The node in integers, with or without determinants; nothing if the budget is spent. The node's integers stay until
  /// limit_memory. Pieces that decide a sign cost no budget; the others of a model share kMostExact coefficients,
  /// approximately half a second.
  const ExactPiece* exact(Id id);
  const ExactPiece* exact_determinants(Id id);
  /// What descents that do not come back to a node allow the nets of pieces.
  static constexpr std::size_t kNetMemory = std::size_t{1} << 26;
  /// Drops all nets if they take more than this many bytes, or more than a quarter of the budget; nodes stay.
  void limit_memory(std::size_t bytes);

 private:
  friend class ForestBuilder;
  // A node's control points and its determinants are two nets, each made on demand: hulls need no determinants, which
  // are many times as long.
  enum class Part : std::uint8_t { kControl, kDeterminants };
  // A net: its components one after the other, then their errors, then the greatest absolute value of each. A net of
  // determinants ends with approx_normal, whose first coordinate is not a number before the first call.
  struct Layout {
    FormShape shape;
    std::size_t components, count;
    bool has_normal;
    std::size_t size() const { return normal() + (has_normal ? 3 : 0); }
    std::size_t begin(std::size_t c) const { return c * count; }
    std::size_t error(std::size_t c) const { return components * count + c; }
    std::size_t magnitude(std::size_t c) const { return components * (count + 1) + c; }
    std::size_t normal() const { return components * (count + 2); }
    void forget_normal(double* net) const {
      if (has_normal) net[normal()] = std::numeric_limits<double>::quiet_NaN();
    }
  };
  static Layout layout(const Form& form, Part part);
  double* net(Id id, Part part);
  void make_net(Id id, Part part);
  void make_root_net(Id id, Part part);
  void keep_net(Id id, Part part, double* net) {
    nodes_[id].nets[static_cast<std::size_t>(part)] = net;
    nodes_[id].net_ages[static_cast<std::size_t>(part)] = store_.age();
  }
  void quarter(Id id, Part part);
  Box3d tight_hull(Id id);
  bool is_rough(const Form& form, const double* net, const Box3d& hull) const;
  /// What doubles know of side_of.
  struct RoundedSide {
    Sign3 sign = Sign3::kUncertain;
    bool may_be_weak =
        true;  ///< false: coefficients surely differ in sign, or the rule on collapsed sides fails
  };
  RoundedSide rounded_side_of(Id id, const Point3d& c);
  Sign3 exact_side_of(Id id, const Point3d& c);
  struct Exact;
  Exact* exact_node(Id id, bool with_determinants);
  Box3d hull_of(const Form& form, const double* net) const;
  /// How many sides of the node lie in collapsed sides of the patch.
  enum class Collapsed { kNone, kApart, kAdjacent };
  Collapsed collapsed_sides(const Node& node, const Form& form) const;

  // Room for nets. Memory that was handed out stays where it is until all of it is returned; then the same memory is
  // handed out again, warm.
  class NetStore {
   public:
    double* take(std::size_t n) {
      if (used_ + n > kBlock) next_block(n);
      double* const out = blocks_[block_ - 1].get() + used_;
      used_ += n;
      return out;
    }
    void take_back() { block_ = 0, used_ = kBlock, ++age_; }
    void charge(MemoryBudget* budget) { share_ = MemoryShare(budget); }
    std::uint32_t age() const { return age_; }
    std::size_t bytes() const { return block_ * kBlock * sizeof(double); }

   private:
    // Four nets of the greatest degrees, rational, take 38,000 doubles.
    static constexpr std::size_t kBlock = std::size_t{1} << 16;
    void next_block(std::size_t n);
    std::vector<std::unique_ptr<double[]>> blocks_;
    MemoryShare share_;
    std::size_t block_ = 0, used_ = kBlock;
    std::uint32_t age_ = 1;
  };

  const PatchComplex* complex_ = nullptr;
  Frame frame_;
  std::vector<Form> forms_;
  std::vector<Node> nodes_;
  std::vector<Id> free_;  // first children that were dropped, each with the three after it
  std::uint64_t num_drops_ = 0;
  // It includes the entries that searches keep for each node: its box, its place in a queue, its facing.
  static constexpr std::size_t kBytesOfNode = sizeof(Node) + 48;
  MemoryShare node_share_, form_share_;
  std::size_t num_roots_ = 0;
  NetStore store_;
  BoxHierarchy roots_;

  static constexpr std::size_t kMostExact = std::size_t{1} << 17;
  static constexpr std::size_t kMostExactStored = std::size_t{1} << 21;
  static constexpr std::size_t kMostExactHulls = std::size_t{1} << 14;
  std::unordered_map<Id, std::shared_ptr<Exact>> exact_;
  std::size_t exact_left_ = kMostExact, exact_stored_ = 0, exact_hulls_left_ = kMostExactHulls;
};

template <typename Visit>
void PieceForest::for_each_kept(const Node& node, Visit visit) const {
  const Form& form = forms_[node.patch];
  bool left_out[4];
  for (std::uint32_t s = 0; s < 4; ++s)
    left_out[s] = (form.collapsed >> s & 1) != 0 && side_of_patch(node, s);
  const FormShape& d = form.determinant;
  if (d.is_triangle) {
    for_each_triangle_index(d.p, [&](int i, int j, int k) {
      if (!(left_out[0] && k == 0) && !(left_out[1] && i == 0) && !(left_out[2] && j == 0))
        visit(triangle_index(j, k));
    });
    return;
  }
  for (int i = 0; i <= d.p; ++i)
    for (int j = 0; j <= d.q; ++j)
      if (!(left_out[0] && j == 0) && !(left_out[1] && i == d.p) && !(left_out[2] && j == d.q) &&
          !(left_out[3] && i == 0))
        visit(static_cast<std::size_t>(i * (d.q + 1) + j));
}

}  // namespace veritope
