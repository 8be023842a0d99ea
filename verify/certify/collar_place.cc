// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/collar_place.h"

#include <algorithm>

#include "robust/base/check.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;
constexpr std::uint32_t kNoBody = ~std::uint32_t{0}, kSeveralBodies = kNoBody - 1;

// inside(root) for one hull, and the bodies of the cells of K that it meets.
class HullDescent {
 public:
  HullDescent(const OctreeRoot& root, const OctreeKeySet& cells,
              const std::vector<std::uint32_t>& body_of_cell)
      : root_(root), cells_(cells), body_of_cell_(body_of_cell) {}

  bool is_inside_cells(const Box3d& hull) {
    body_ = kNoBody;
    const Box3d all = root_.box();
    for (std::size_t k = 0; k < 3; ++k)
      if (!(all.lo[k] < hull.lo[k] && hull.hi[k] < all.hi[k])) return false;
    return visit(OctreeKey(), hull);
  }
  /// The body of the last hull that was inside; kSeveralBodies if its cells lie in more than one.
  std::uint32_t body() const { return body_; }
  std::uint64_t visits() const { return visits_; }

 private:
  bool visit(OctreeKey key, const Box3d& hull) {
    ++visits_;
    if (!meets(root_.box(key), hull)) return true;
    const std::size_t at = cells_.lower_bound(key.first_code());
    if (at == cells_.size() || !key.contains(cells_[at])) return false;
    if (cells_[at] == key) {
      const std::uint32_t body = body_of_cell_[at];
      if (body_ != body) body_ = body_ == kNoBody ? body : kSeveralBodies;
      return true;
    }
    for (unsigned octant = 0; octant < 8; ++octant)
      if (!visit(key.child(octant), hull)) return false;
    return true;
  }

  const OctreeRoot& root_;
  const OctreeKeySet& cells_;
  const std::vector<std::uint32_t>& body_of_cell_;
  std::uint32_t body_ = kNoBody;
  std::uint64_t visits_ = 0;
};

class Placement {
 public:
  Placement(PieceForest& forest, const StarCover& cover, const OctreeRoot& root,
            const CommonSubdivision& complex, const ComplexBoundary& boundary)
      : forest_(forest),
        cover_(cover),
        boundary_(boundary),
        num_cells_(complex.num_cells()),
        descent_(root, complex.cells(), boundary.body_of_cell) {}

  std::optional<CollarPlace> run(Misplaced* why) {
    out_.body_of_shell.assign(forest_.complex().shells().size(), kNoBody);
    for (std::uint32_t r = 0; r < forest_.num_roots(); ++r)
      if (!visit_cover(forest_.root(r), why)) return std::nullopt;
    out_.is_leaf.resize(forest_.num_nodes());
    if (!is_bijection(why)) return std::nullopt;
    return std::move(out_);
  }

 private:
  bool visit_cover(Id id, Misplaced* why) {
    if (cover_.box_of_node[id] != StarCover::kNone) return visit_piece(id, why);
    const Id first = forest_.node(id).first_child;
    for (Id k = 0; k < 4; ++k)
      if (!visit_cover(first + k, why)) return false;
    return true;
  }

  bool visit_piece(Id id, Misplaced* why) {
    ++nodes_;
    if (descent_.is_inside_cells(forest_.node(id).hull)) return accept(id, why);
    // The checkers count in the same way: docs/certificates/collar.md, section 4.
    if (nodes_ + descent_.visits() > 2000 * (out_.num_leaves + num_cells_ + 100))
      return fail(why, id,
                  "too many pieces are needed to show that the surface lies inside the cells");
    forest_.limit_memory(PieceForest::kNetMemory);
    if (!forest_.may_split(id))
      return fail(why, id, "a piece of the least size does not lie inside the cells");
    const Id first = forest_.children(id);
    for (Id k = 0; k < 4; ++k)
      if (!visit_piece(first + k, why)) return false;
    return true;
  }

  bool accept(Id id, Misplaced* why) {
    if (out_.is_leaf.size() <= id)
      out_.is_leaf.resize(std::max<std::size_t>(id + 1, forest_.num_nodes()));
    out_.is_leaf[id] = true;
    ++out_.num_leaves;
    std::uint32_t& body = out_.body_of_shell[forest_.complex().shell(forest_.node(id).patch)];
    if (descent_.body() == kSeveralBodies || (body != kNoBody && body != descent_.body()))
      return fail(why, id, "a shell lies in several components of the cells");
    body = descent_.body();
    return true;
  }

  bool is_bijection(Misplaced* why) const {
    std::vector<bool> taken(boundary_.bodies.size());
    for (const std::uint32_t body : out_.body_of_shell) {
      if (taken[body])
        return fail(why, PieceForest::kNone, "two shells lie in one component of the cells");
      taken[body] = true;
    }
    if (std::find(taken.begin(), taken.end(), false) == taken.end()) return true;
    return fail(why, PieceForest::kNone, "a component of the cells holds no shell");
  }

  static bool fail(Misplaced* why, Id piece, const char* message) {
    *why = {piece, message};
    return false;
  }

  PieceForest& forest_;
  const StarCover& cover_;
  const ComplexBoundary& boundary_;
  std::uint64_t num_cells_, nodes_ = 0;
  HullDescent descent_;
  CollarPlace out_;
};

}  // namespace

std::optional<CollarPlace> place_surface(PieceForest& forest, const StarCover& cover,
                                         const OctreeRoot& root, const CommonSubdivision& complex,
                                         const ComplexBoundary& boundary, Misplaced* why) {
  VT_CHECK(cover.is_complete(), "trees start at leaves of a whole cover");
  return Placement(forest, cover, root, complex, boundary).run(why);
}

}  // namespace veritope
