// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>

#include "interval/box_geometry.h"
#include "solids/micro/filter/separation_internal.h"
#include "solids/micro/filter/tile_walk_internal.h"
#include "solids/micro/filter/tile_winding_internal.h"

namespace veritope::internal {

namespace {

// Parts of patches up to this depth are visited breadth first, because a tile that crosses the surface deeply shows it
// early; after that depth first, because a shallow crossing shows itself only to small parts.
constexpr int kBreadthFirstDepth = 6;
constexpr int kMaxShellVertices = 64;
constexpr int kPiecesWithoutHope = 500;
constexpr std::size_t kMaxTouchingParts = 64;

}  // namespace

// Where the image of a corner lies, as far as its box shows that.
Value3 TileWalk::note(const TilePiece& piece, std::size_t corner) {
  const Value3 value = model_.value(outer_box(piece.corners[corner]));
  auto& witness = value == Value3::kOne ? inside_ : off_;
  if (is_constant(value) && !witness)
    witness = TilePatchPoint{piece.patch, piece.parameter(0, corner), piece.parameter(1, corner)};
  return value;
}

// Notes where a point lies, in rationals. REQUIRES a point off the surface of M.
void TileWalk::note_exactly(const TilePatchPoint& at) {
  const PointAnswer answer = model_.classify(cell_.image(tile(), at));
  if (!answer.is_decided) {
    has_unsettled_ = true;
    return;
  }
  VT_CHECK(!answer.is_on(), "a point of a part that misses the surface lies on it");
  auto& witness = answer.winding != 0 ? inside_ : off_;
  if (!witness) witness = at;
}

// Notes where the middles of the parts that touch lie, if not on the surface of M: one may touch it from inside, and
// another one from outside.
void TileWalk::note_touching() {
  for (std::size_t i = 0; i < touching_.size() && !is_crossing(); ++i) {
    const TilePiece& piece = touching_[i];
    const Rational half = Rational::power_of_two(-1);
    const TilePatchPoint middle{piece.patch, half * (piece.parameter(0, 0) + piece.parameter(0, 3)),
                                half * (piece.parameter(1, 0) + piece.parameter(1, 3))};
    const PointAnswer answer = model_.classify(cell_.image(tile(), middle));
    if (!answer.is_decided || answer.is_on()) continue;
    auto& witness = answer.winding != 0 ? inside_ : off_;
    if (!witness) witness = middle;
  }
}

void TileWalk::note_corners() {
  corner_values_.assign(pieces_.corners().size(), Value3::kMixed);
  std::vector<char> is_noted(pieces_.corners().size());
  for (std::uint32_t i = 0; i < tile().patches().size(); ++i) {
    const auto& corners = tile().patches()[i].corners;
    for (std::size_t k = 0; k < 4; ++k) {
      if (is_noted[corners[k]] != 0) continue;
      is_noted[corners[k]] = 1;
      const Value3 value = model_.value(outer_box(pieces_.corners()[corners[k]]));
      corner_values_[corners[k]] = value;
      auto& witness = value == Value3::kOne ? inside_ : off_;
      if (is_constant(value) && !witness)
        witness = TilePatchPoint{i, Rational(k & 1), Rational(k >> 1)};
      if (is_crossing()) return;
    }
  }
}

void TileWalk::open_patches() {
  const auto n = static_cast<std::uint32_t>(tile().patches().size());
  is_patch_apart_.assign(n, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    OpenPiece open{pieces_.root(i), {}};
    open.near = obstacles_->near(open.piece);
    ++num_pieces_;
    if (open.near.empty()) {
      is_patch_apart_[i] = 1;
    } else {
      open_.push_back(std::move(open));
    }
  }
}

// Whether nothing is left to be asked about the piece.
bool TileWalk::settle(OpenPiece* open) {
  if (open->near.empty()) {
    apart_.push_back(open->piece);
    return true;
  }
  const PieceSide side = obstacles_->examine(open->piece, open->near, &contact_);
  if (side.is_hopeless) {
    // What remains to be found is a crossing somewhere else.
    has_unsettled_ = true;
    most_pieces_ = std::min(most_pieces_, num_pieces_ + kPiecesWithoutHope);
    return true;
  }
  if (!side.is_decided) return false;
  if (side.is_apart) {
    apart_.push_back(open->piece);
    return true;
  }
  is_touching_ = true;
  if (touching_.size() < kMaxTouchingParts) touching_.push_back(open->piece);
  is_near_inside_ = is_near_inside_ && side.is_near_inside;
  is_near_outside_ = is_near_outside_ && side.is_near_outside;
  return true;
}

void TileWalk::halve(const OpenPiece& open, std::vector<OpenPiece>* out) {
  std::size_t axis = 0;
  auto parts = pieces_.halves(open.piece, &axis);
  const std::size_t bit = std::size_t{1} << axis, other = 3 - bit;
  for (const std::size_t corner : {bit, bit | other}) note(parts.first, corner);
  for (TilePiece* part : {&parts.first, &parts.second}) {
    out->push_back({std::move(*part), open.near});
    obstacles_->keep_close(out->back().piece, &out->back().near);
    ++num_pieces_;
  }
}

void TileWalk::visit_breadth_first() {
  for (int depth = 0; depth < kBreadthFirstDepth; ++depth) {
    std::vector<OpenPiece> next;
    for (OpenPiece& open : open_) {
      if (settle(&open)) continue;
      if (num_pieces_ >= most_pieces_) {
        has_unsettled_ = true;
        continue;
      }
      halve(open, &next);
      if (is_crossing()) return;
    }
    open_ = std::move(next);
  }
}

// Each piece that is still open gets an equal share of the pieces that are left.
void TileWalk::visit_depth_first() {
  std::vector<OpenPiece> roots = std::move(open_);
  open_.clear();
  for (std::size_t i = 0; i < roots.size() && !is_crossing(); ++i) {
    const int left = std::max(most_pieces_ - num_pieces_, 0);
    const int last = num_pieces_ + left / static_cast<int>(roots.size() - i);
    std::vector<OpenPiece> stack;
    stack.push_back(std::move(roots[i]));
    while (!stack.empty() && !is_crossing()) {
      OpenPiece open = std::move(stack.back());
      stack.pop_back();
      if (settle(&open)) continue;
      if (!open.piece.can_halve() || open.piece.depth() >= limits_.max_depth ||
          num_pieces_ >= std::min(last, most_pieces_)) {
        has_unsettled_ = true;
        if (num_pieces_ >= std::min(last, most_pieces_)) break;
        continue;
      }
      halve(open, &stack);
    }
  }
}

CellFinding TileWalk::found(CellStatus status) const {
  CellFinding out;
  out.status = status;
  out.inside = inside_;
  out.off = off_;
  if (status == CellStatus::kTouching) out.contact = contact_;
  return out;
}

// Vertices of shells in the tile. Nothing if every shell has a vertex off the tile.
std::optional<CellFinding> TileWalk::find_shells_inside() {
  Box3d box = empty_box();
  for (std::uint32_t i = 0; i < tile().patches().size(); ++i)
    box = hull(box, box_of(pieces_.root(i)));
  std::optional<CellFinding> out;
  model_.shells().visit(box, [&](std::uint32_t shell) {
    if (out && out->status == CellStatus::kCrossing) return;
    const auto vertices = model_.shells().of(shell);
    // A shell that does not meet the tile's surface lies on one side of it: any vertex tells.
    const std::size_t step =
        is_touching_ ? std::max<std::size_t>(1, vertices.size() / kMaxShellVertices) : 1;
    int num_tried = 0;
    for (std::size_t i = 0; i < vertices.size() && num_tried < kMaxShellVertices; i += step) {
      ++num_tried;
      const Box3 p = model_.vertex(vertices[i]);
      const std::optional<bool> is_in = meets(outer_box(p), box) ? is_in_tile(pieces_, p) : false;
      if (!is_in) continue;
      if (!*is_in) return;
      out = found(CellStatus::kCrossing);
      out->vertex = vertices[i];
      return;
    }
    out = found(CellStatus::kUndecided);
  });
  return out;
}

CellFinding TileWalk::finish() {
  if (is_crossing()) return found(CellStatus::kCrossing);
  if (has_unsettled_) return found(CellStatus::kUndecided);
  // One point of every part that misses the surface of M.
  for (std::uint32_t i = 0; i < is_patch_apart_.size() && !is_crossing(); ++i) {
    if (is_patch_apart_[i] == 0) continue;
    const auto& corners = tile().patches()[i].corners;
    if (std::none_of(corners.begin(), corners.end(),
                     [&](std::uint32_t c) { return is_constant(corner_values_[c]); }))
      note_exactly({i, Rational(0), Rational(0)});
  }
  for (std::size_t i = 0; i < apart_.size() && !is_crossing(); ++i) {
    const TilePiece& piece = apart_[i];
    bool is_known = false;
    for (std::size_t k = 0; k < 4 && !is_known; ++k) is_known = is_constant(note(piece, k));
    if (!is_known) note_exactly({piece.patch, piece.parameter(0, 0), piece.parameter(1, 0)});
  }
  if (is_crossing()) return found(CellStatus::kCrossing);
  if (has_unsettled_) return found(CellStatus::kUndecided);
  // Either every point of the tile's surface is in M, or none is in its interior.
  const bool is_inside = is_near_inside_ && !off_;
  if (!is_inside && !(is_near_outside_ && !inside_)) {
    note_touching();
    return found(is_crossing() ? CellStatus::kCrossing : CellStatus::kUndecided);
  }
  // Curves and sheets hold nothing inside.
  if (!tile().is_open())
    if (std::optional<CellFinding> shell = find_shells_inside()) return *shell;
  if (!is_touching_) return found(is_inside ? CellStatus::kKept : CellStatus::kOutside);
  return found(contact_ ? CellStatus::kTouching : CellStatus::kUndecided);
}

CellFinding TileWalk::run() {
  if (!is_finite(pieces_.net().hull())) return found(CellStatus::kUndecided);
  note_corners();
  if (is_crossing()) return found(CellStatus::kCrossing);
  if (!pieces_.bound()) return found(CellStatus::kUndecided);
  open_patches();
  visit_breadth_first();
  visit_depth_first();
  return finish();
}

}  // namespace veritope::internal
