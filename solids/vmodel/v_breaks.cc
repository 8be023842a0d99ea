// SPDX-License-Identifier: LGPL-3.0-or-later
// Where the cells are cut so that glued faces conform.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/entity_error.h"
#include "solids/vmodel/v_model_maker_internal.h"
#include "splines/knot_insertion.h"

namespace veritope {

// Pieces are counted before anything is as large as their number: a few cells with many knots each can ask for more
// than any memory holds.
std::optional<Error> VModelMaker::find_breaks() {
  internal::TiedAxes axes(3 * m_.num_cells());
  for (VFaceNumber f = 0; f < m_.num_faces(); ++f) tie_axes(axes, f);
  const std::vector<std::vector<Rational>> all = breaks_of_classes(axes);
  m_.first_piece_.push_back(0);
  for (std::uint32_t c = 0; c < m_.num_cells(); ++c) {
    Grid<3> grid;
    for (std::uint32_t a = 0; a < 3; ++a) grid.size[a] = all[axes.find(3 * c + a).axis].size() + 1;
    const auto count = grid.count_up_to(kMaxVPieces);
    if (!count || m_.first_piece_.back() + *count > kMaxVPieces)
      return error_at_entity(
          Code::kOverLimit, c,
          "the cells up to this one have over " + std::to_string(kMaxVPieces) + " pieces");
    m_.piece_grids_.push_back(grid);
    m_.first_piece_.push_back(m_.first_piece_.back() + *count);
  }
  m_.added_.emplace_back();
  m_.added_of_.assign(m_.num_cells(), {0, 0, 0});
  for (std::uint32_t a = 0; a < 3 * m_.num_cells(); ++a) {
    const auto root = axes.find(a);
    if (!all[root.axis].empty()) add_missing(a, all[root.axis], root.flips);
  }
  return std::nullopt;
}

void VModelMaker::tie_axes(internal::TiedAxes& axes, VFaceNumber f) const {
  const VFaceRole& role = m_.faces_[f];
  if (!role.is_glued() || role.mate < f) return;
  const auto own = v_face_axes(f % 6 / 2), others = v_face_axes(role.mate % 6 / 2);
  const std::size_t first = role.symmetry & 1;
  const auto number = [](VFaceNumber face, std::size_t axis) {
    return static_cast<std::uint32_t>(3 * (face / 6) + axis);
  };
  axes.tie(number(f, own[first]), number(role.mate, others[0]), (role.symmetry & 2) != 0);
  axes.tie(number(f, own[1 - first]), number(role.mate, others[1]), (role.symmetry & 4) != 0);
}

// The inner knots of an axis on [0,1], reversed if asked for.
std::vector<Rational> VModelMaker::inner_breaks(std::uint32_t axis, bool is_reversed) const {
  const auto& knots = m_.cells_[axis / 3].axis(axis % 3);
  std::vector<Rational> out = internal::breaks_of(knots);
  out.pop_back();
  out.erase(out.begin());
  const Rational begin = knots.domain_begin(), length = knots.domain_end() - begin;
  for (Rational& t : out)
    t = is_reversed ? Rational(1) - (t - begin) / length : (t - begin) / length;
  if (is_reversed) std::reverse(out.begin(), out.end());
  return out;
}

// The inner breaks on [0,1] of all axes of a class, in the place of its root.
std::vector<std::vector<Rational>> VModelMaker::breaks_of_classes(internal::TiedAxes& axes) const {
  const auto count = static_cast<std::uint32_t>(3 * m_.num_cells());
  std::vector<std::vector<Rational>> all(count);
  const auto add = [](std::vector<Rational>& to, const std::vector<Rational>& from) {
    // Most axes of a class have the breaks of the first one.
    if (to.size() < from.size() || !std::equal(from.begin(), from.end(), to.begin()))
      to.insert(to.end(), from.begin(), from.end());
  };
  for (std::uint32_t a = 0; a < count; ++a) {
    if (!has_inner(a)) continue;
    const auto root = axes.find(a);
    add(all[root.axis], inner_breaks(a, root.flips));
    if (axes.is_symmetric(root.axis)) add(all[root.axis], inner_breaks(a, !root.flips));
  }
  for (auto& breaks : all) {
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  }
  return all;
}

bool VModelMaker::has_inner(std::uint32_t axis) const {
  const auto& knots = m_.cells_[axis / 3].axis(axis % 3);
  return knots.num_control() > static_cast<std::size_t>(knots.degree) + 1;
}

void VModelMaker::add_missing(std::uint32_t axis, const std::vector<Rational>& all,
                              bool is_reversed) {
  std::vector<Rational> wanted = all, missing;
  if (is_reversed) {
    for (Rational& t : wanted) t = Rational(1) - t;
    std::reverse(wanted.begin(), wanted.end());
  }
  const auto own = inner_breaks(axis, false);
  std::set_difference(wanted.begin(), wanted.end(), own.begin(), own.end(),
                      std::back_inserter(missing));
  if (missing.empty()) return;
  const auto& knots = m_.cells_[axis / 3].axis(axis % 3);
  for (Rational& t : missing)
    t = knots.domain_begin() + t * (knots.domain_end() - knots.domain_begin());
  m_.added_of_[axis / 3][axis % 3] = static_cast<std::uint32_t>(m_.added_.size());
  m_.added_.push_back(std::move(missing));
}

}  // namespace veritope
