// SPDX-License-Identifier: LGPL-3.0-or-later
// The nodes of a PieceForest in integers, where doubles do not decide: as many as the budget allows.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "solids/pieces/exact_piece.h"
#include "solids/pieces/piece_forest.h"
#include "solids/pieces/piece_net_internal.h"

namespace veritope {

struct PieceForest::Exact {
  ExactPiece piece;
  std::size_t owed = 0;  // given back to the budget when the piece first decides a sign
};

// Whether exact arithmetic would make the hull shorter by more than a part in 256, or bounded.
bool PieceForest::is_rough(const Form& form, const double* net, const Box3d& hull) const {
  const double size = extent(hull);
  if (!std::isfinite(size)) return true;
  const Layout at = layout(form, Part::kControl);
  double least = 1;
  if (at.components == 4) {
    const double* const w = net + at.begin(3);
    least = *std::min_element(w, w + at.count);
    if (net[at.error(3)] > 0x1p-10 * least) return true;
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const double error =
        net[at.error(c)] / least + 4 * internal::kNetUnit * std::abs(form.origin[c]);
    if (error > 0x1p-10 * size) return true;
  }
  return false;
}

Box3d PieceForest::tight_hull(Id id) {
  const double* const net = this->net(id, Part::kControl);
  const Form& form = forms_[nodes_[id].patch];
  const Box3d hull = hull_of(form, net);
  if (!is_rough(form, net, hull) || exact_hulls_left_ == 0) return hull;
  --exact_hulls_left_;
  return ExactPiece(*this, nodes_[id]).hull();
}

PieceForest::Exact* PieceForest::exact_node(Id id, bool with_determinants) {
  auto& slot = exact_[id];
  if (slot && (slot->piece.has_determinants() || !with_determinants)) return slot.get();
  const Form& form = forms_[nodes_[id].patch];
  const std::size_t cost =
      (slot ? 0 : 4 * form.shape.count()) + (with_determinants ? 4 * form.determinant.count() : 0);
  if (exact_left_ < cost || exact_stored_ + cost > kMostExactStored) return nullptr;
  exact_left_ -= cost, exact_stored_ += cost;
  if (!slot) slot = std::make_shared<Exact>(Exact{ExactPiece(*this, nodes_[id])});
  slot->owed += cost;
  if (with_determinants) slot->piece.make_determinants();
  return slot.get();
}

const ExactPiece* PieceForest::exact(Id id) {
  const Exact* const node = exact_node(id, false);
  return node == nullptr ? nullptr : &node->piece;
}
const ExactPiece* PieceForest::exact_determinants(Id id) {
  const Exact* const node = exact_node(id, true);
  return node == nullptr ? nullptr : &node->piece;
}

Sign3 PieceForest::exact_side_of(Id id, const Point3d& c) {
  Exact* const node = exact_node(id, true);
  if (node == nullptr) return Sign3::kUncertain;
  const ExactPiece::Side side(node->piece, c);
  std::optional<Sign> common;
  bool is_one = true;
  for_each_kept(nodes_[id], [&](std::size_t i) {
    if (!is_one) return;
    const Sign s = side.at(i);
    if (!common) common = s;
    is_one = s == *common && s != Sign::kZero;
  });
  if (!common || !is_one) {
    exact_left_ -= std::min(exact_left_, forms_[nodes_[id].patch].determinant.count());
    return Sign3::kUncertain;
  }
  exact_left_ += std::exchange(node->owed, 0);
  return *common == Sign::kPositive ? Sign3::kPositive : Sign3::kNegative;
}

std::optional<PieceForest::SideWithZeros> PieceForest::side_with_zeros(Id id, const Point3d& c) {
  const RoundedSide rounded = rounded_side_of(id, c);
  SideWithZeros out;
  if (is_certain(rounded.sign)) {
    out.sign = rounded.sign == Sign3::kPositive ? Sign::kPositive : Sign::kNegative;
    return out;
  }
  if (!rounded.may_be_weak) return std::nullopt;
  Exact* const node = exact_node(id, true);
  if (node == nullptr) return std::nullopt;
  const ExactPiece::Side side(node->piece, c);
  const std::size_t n = forms_[nodes_[id].patch].determinant.count();
  out.is_zero.resize(n);
  bool is_one = true;
  for (std::size_t i = 0; i < n && is_one; ++i) {
    const Sign s = side.at(i);
    out.is_zero[i] = s == Sign::kZero;
    if (s == Sign::kZero) continue;
    if (out.sign == Sign::kZero) out.sign = s;
    is_one = s == out.sign;
  }
  if (!is_one || out.sign == Sign::kZero) {
    exact_left_ -= std::min(exact_left_, n);
    return std::nullopt;
  }
  exact_left_ += std::exchange(node->owed, 0);
  bool is_strict = true;
  for_each_kept(nodes_[id], [&](std::size_t i) { is_strict = is_strict && !out.is_zero[i]; });
  if (is_strict) out.is_zero.clear();
  return out;
}

}  // namespace veritope
