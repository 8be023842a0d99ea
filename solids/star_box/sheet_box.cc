// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/sheet_box.h"

#include <optional>

#include "robust/base/check.h"
#include "solids/pieces/crossing_number.h"
#include "solids/pieces/piece_descent.h"
#include "solids/star_box/star_zeros.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;

// The signs of the separators on one node, each computed when first asked for.
class NodeSigns {
 public:
  NodeSigns(PieceForest& forest, Id id, const std::vector<SheetSeparator>& separators)
      : forest_(forest), id_(id), separators_(separators), known_(separators.size()) {}

  bool suit(const Sheet& sheet) {
    for (std::size_t l = 0; l < separators_.size(); ++l) {
      if (sheet.signs[l] == Sign::kZero) continue;
      if (!known_[l]) known_[l] = separator_sign(forest_, id_, separators_[l]);
      if (*known_[l] != to_sign3(sheet.signs[l])) return false;
    }
    return true;
  }

 private:
  PieceForest& forest_;
  Id id_;
  const std::vector<SheetSeparator>& separators_;
  std::vector<std::optional<Sign3>> known_;
};

std::optional<std::size_t> sheet_of(PieceForest& forest, Id id, const SheetBox& box) {
  NodeSigns signs(forest, id, box.separators);
  for (std::size_t i = 0; i < box.sheets.size(); ++i)
    if (signs.suit(box.sheets[i]) &&
        has_star_signs_or_zeros(forest, id, {box.sheets[i].inside, box.sheets[i].outside}))
      return i;
  return std::nullopt;
}

bool is_strictly_inside(const Box3d& a, const Box3d& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(b.lo[k] < a.lo[k] && a.hi[k] < b.hi[k])) return false;
  return true;
}

bool are_all_apart(const std::vector<Sheet>& sheets) {
  for (std::size_t i = 0; i < sheets.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!are_apart(sheets[i], sheets[j])) return false;
  return true;
}

}  // namespace

bool are_apart(const Sheet& a, const Sheet& b) {
  for (std::size_t l = 0; l < a.signs.size(); ++l)
    if (a.signs[l] * b.signs[l] == Sign::kNegative) return true;
  return false;
}

bool find_sheet_pieces(PieceForest& forest, const SheetBox& box, std::size_t most,
                       SheetPieces* pieces) {
  pieces->tested.assign(box.sheets.size(), {});
  pieces->held.clear();
  pieces->num_visited = 0;
  std::size_t num_tested = 0;
  // Only what the frame shows may be dropped: a plane across an axis may part a piece from the box that no plane of the
  // frame does, and the checker would have to split it.
  const auto meets_box = [&](const Box3d& b) { return meets(box.frame.in_frame(b), box.box); };
  return descend_where(forest, meets_box, 16 * most, [&](Id id) {
    ++pieces->num_visited;
    const auto hull = hull_that_meets(forest, id, box.frame, box.box);
    if (!hull) return PieceStep::kTaken;  // dropped
    if (is_inside(*hull, box.box)) pieces->held.push_back(id);
    const auto sheet = sheet_of(forest, id, box);
    if (!sheet) return PieceStep::kSplit;
    pieces->tested[*sheet].push_back(id);
    return ++num_tested <= most ? PieceStep::kTaken : PieceStep::kStop;
  });
}

bool is_sheet_box(PieceForest& forest, const SheetBox& box, std::size_t most, SheetPieces* pieces) {
  VT_CHECK(!box.sheets.empty(), "a star box without a sheet");
  if (!are_all_apart(box.sheets)) return false;
  for (const Sheet& s : box.sheets)
    for (const Point3d* const c : {&s.inside, &s.outside})
      if (!is_strictly_inside(box.frame.in_frame(*c), box.box)) return false;
  if (!find_sheet_pieces(forest, box, most, pieces)) return false;
  for (std::size_t i = 0; i < box.sheets.size(); ++i)
    if (crossing_number(forest, pieces->tested[i],
                        CentreLine{box.sheets[i].inside, box.sheets[i].outside}) != 1)
      return false;
  return true;
}

}  // namespace veritope
