// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_model.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "robust/base/entity_error.h"
#include "solids/vmodel/jacobian_sign.h"
#include "solids/vmodel/v_model_maker_internal.h"
#include "splines/bspline_components.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

std::string axis_text(std::size_t axis) { return "axis " + std::to_string(axis) + ": "; }

std::optional<Error> fault_of_axis(const KnotAxis<Rational>& axis, std::size_t number,
                                   std::uint64_t cell) {
  const std::string at = axis_text(number);
  if (axis.degree > kMaxVDegree)
    return error_at_entity(Code::kOverLimit, cell,
                           "the volume has the degree " + std::to_string(axis.degree) + " along " +
                               "uvw"[number] + ", and certificates are about volumes of a degree " +
                               "of at most " + std::to_string(kMaxVDegree));
  const auto p = static_cast<std::size_t>(axis.degree);
  if (axis.knots.front() != axis.domain_begin() || axis.knots.back() != axis.domain_end())
    return error_at_entity(Code::kBadArgument, cell, at + "the knots are not clamped");
  for (std::size_t i = p + 1; i + p < axis.num_control(); ++i)
    if (axis.knots[i] == axis.knots[i + p])
      return error_at_entity(Code::kBadArgument, cell,
                             at + "the inner knot " + internal::knot_text(axis.knots[i]) +
                                 " occurs more often than the degree " + std::to_string(p));
  return std::nullopt;
}

std::optional<Error> fault_of_cell(const VVolume& cell, std::uint64_t number) {
  for (std::size_t a = 0; a < 3; ++a)
    if (auto error = fault_of_axis(cell.axis(a), a, number)) return error;
  if (!cell.is_rational()) return std::nullopt;
  for (const Rational& w : cell.component(cell.num_components() - 1))
    if (w.sign() <= 0)
      return error_at_entity(Code::kBadArgument, number,
                             "the weight " + w.to_string() + " is not positive");
  return std::nullopt;
}

Sign hand_of(const VVolume& cell) {
  std::array<std::vector<Rational>, 3> breaks;
  Grid<3> grid;
  for (std::size_t a = 0; a < 3; ++a) {
    breaks[a] = internal::breaks_of(cell.axis(a));
    grid.size[a] = breaks[a].size() - 1;
  }
  for (std::size_t n = 0; n < grid.count(); ++n) {
    const auto piece = grid.index_of(n);
    std::array<Rational, 3> middle;
    for (std::size_t a = 0; a < 3; ++a)
      middle[a] = (breaks[a][piece[a]] + breaks[a][piece[a] + 1]) / Rational(2);
    if (const Sign sign = jacobian_sign(cell, middle); sign != 0) return sign;
  }
  return Sign::kZero;
}

}  // namespace

const std::vector<Rational>& VModel::added_breaks(std::size_t c, std::size_t axis) const {
  return added_[added_of_[c][axis]];
}

std::vector<Rational> VModel::breaks(std::size_t c, std::size_t axis) const {
  const auto knots = internal::breaks_of(cells_[c].axis(axis));
  const auto& added = added_breaks(c, axis);
  std::vector<Rational> out;
  std::merge(knots.begin(), knots.end(), added.begin(), added.end(), std::back_inserter(out));
  return out;
}

Result<VVolume> geometry_of(const VVolume& volume) {
  if (volume.dimension() < 3)
    return bad_argument("a volume with " + std::to_string(volume.dimension()) +
                        " coordinates, not in space");
  return first_coordinates(volume, 3);
}

std::optional<Error> VModelMaker::take(std::vector<VVolume> cells) {
  if (cells.empty()) return Error{Code::kEmpty, {}, "there is no cell"};
  if (cells.size() > kMaxVCells)
    return error_at_entity(Code::kOverLimit, kMaxVCells,
                           "there are over " + std::to_string(kMaxVCells) + " cells");
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].dimension() != 3) {
      Result<VVolume> geometry = geometry_of(cells[c]);
      if (!geometry) return error_at_entity(geometry.error().code, c, geometry.error().message);
      cells[c] = std::move(geometry).value();
    }
    if (auto error = fault_of_cell(cells[c], c)) return error;
  }
  m_.cells_ = std::move(cells);
  return std::nullopt;
}

void VModelMaker::find_hands(VOrientation orientation) {
  for (std::uint32_t c = 0; c < m_.num_cells(); ++c) {
    m_.hands_.push_back(hand_of(m_.cells_[c]));
    if (m_.hands_.back() < 0) m_.left_handed_.push_back(c);
  }
  m_.is_reversed_.assign(m_.num_cells(), false);
  if (orientation == VOrientation::kKeep) return;
  for (const std::uint32_t c : m_.left_handed_) m_.is_reversed_[c] = true;
}

void VModelMaker::find_collapses() {
  m_.faces_.resize(6 * m_.num_cells());
  m_.collapsed_edges_.resize(m_.num_cells());
  for (std::size_t c = 0; c < m_.num_cells(); ++c) {
    for (std::size_t k = 0; k < 6; ++k)
      m_.faces_[6 * c + k].collapse =
          internal::collapse_of(view(static_cast<VFaceNumber>(6 * c + k)));
    for (std::size_t e = 0; e < 12; ++e)
      if (internal::is_edge_collapsed(m_.cells_[c], e))
        m_.collapsed_edges_[c] = static_cast<std::uint16_t>(m_.collapsed_edges_[c] | 1u << e);
  }
}

VModel VModelMaker::finish() && {
  for (std::size_t c = 0; c < m_.num_cells(); ++c)
    if (m_.piece_grids_[c].count() > 1) internal::find_forbidden(m_, c, m_.forbidden_);
  return std::move(m_);
}

Result<VModel> make_v_model(std::vector<VVolume> cells, VOrientation orientation) {
  VModelMaker maker;
  if (auto error = maker.take(std::move(cells))) return std::move(*error);
  maker.find_hands(orientation);
  maker.find_collapses();
  maker.glue();
  if (auto error = maker.find_breaks()) return std::move(*error);
  maker.count();
  return std::move(maker).finish();
}

}  // namespace veritope
