// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/vmodel_invalid_work.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "solids/vmodel/v_parts.h"
#include "splines/knot_insertion.h"
#include "verify/certify/vmodel_cut_internal.h"

namespace veritope {
namespace {

using Ends = std::array<Rational, 2>;
constexpr std::array<std::size_t, 3> kAllAxes = {0, 1, 2};

std::array<Rational, 3> corner_of_face(const VModel& model, VFaceNumber f, unsigned i, unsigned j) {
  const std::size_t axis = f % 6 / 2;
  const auto [p, q] = v_face_axes(axis);
  return v_corner_point(model.cell(f / 6),
                        (f % 2) << axis | std::size_t{i} << p | std::size_t{j} << q);
}

VInvalidWork::FaceCorners corners_of(const VModel& model, VFaceNumber f) {
  VInvalidWork::FaceCorners out;
  for (unsigned i = 0; i < 4; ++i) out[i] = corner_of_face(model, f, i & 1, i >> 1);
  return out;
}

}  // namespace

bool VInvalidWork::fits() const {
  return !is_beyond_ &&
         units_ <= internal::kFreeVModelUnits + internal::kVModelUnitsOfByte * bytes_;
}

void VInvalidWork::add_interval(const VVolume& cell, std::size_t axis, const Ends& at,
                                bool is_compared) {
  const auto piece = internal::interval_of(cell.axis(axis), at[0], at[1], true);
  is_beyond_ = is_beyond_ || !piece;
  if (!piece) return;
  const int degree = cell.axis(axis).degree;
  units_ += piece->units(degree);
  if (is_compared) units_ += static_cast<std::uint64_t>(degree) * piece->bits * piece->bits / 1024;
}

void VInvalidWork::add_cut(const VVolume& cell, std::span<const std::size_t> axes,
                           const std::array<Ends, 3>& at, bool has_intervals,
                           bool has_determinant) {
  std::vector<std::uint64_t> sizes;
  std::vector<internal::KnotPiece> cuts;
  std::array<std::size_t, 3> first{};  // of the axes that are not cut: a face or an edge
  Grid<3> local;
  for (std::size_t a = 0; a < 3; ++a) {
    local.size[a] = 1;
    if (std::find(axes.begin(), axes.end(), a) == axes.end()) {
      first[a] = at[a][0].sign() == Sign::kZero ? 0 : cell.grid().size[a] - 1;
      continue;
    }
    if (has_intervals) add_interval(cell, a, at[a], false);
    const auto piece = internal::interval_of(cell.axis(a), at[a][0], at[a][1], true);
    is_beyond_ = is_beyond_ || !piece;
    if (!piece) return;
    first[a] = piece->first;
    local.size[a] = static_cast<std::size_t>(cell.axis(a).degree) + 1;
    sizes.push_back(local.size[a]);
    cuts.push_back(*piece);
  }
  std::vector<Rational> numbers;
  for (std::size_t i = 0; i < local.count(); ++i) {
    auto index = local.index_of(i);
    for (std::size_t a = 0; a < 3; ++a) index[a] += first[a];
    for (int c = 0; c < cell.num_components(); ++c)
      numbers.push_back(cell.component(c)[cell.grid().at(index)]);
    if (!cell.is_rational()) numbers.emplace_back(1);
  }
  const auto bits = internal::bits_of_points(numbers, true);
  is_beyond_ = is_beyond_ || !bits;
  if (!bits) return;
  const internal::CutProducts part = internal::products_of(sizes, cuts, *bits);
  std::uint64_t m = 1, m2 = 1, c = 1, degrees = 0;
  for (const std::uint64_t n : sizes)
    c *= (cell.is_rational() ? 4 : 3) * (n - 1), m *= n, m2 *= 2 * n - 1, degrees += n - 1;
  units_ += part.units + 2 + m * degrees * part.bits / 4096;
  if (axes.size() < 3) return;
  if (c * part.bits > internal::kMostBitsOfPiece) is_beyond_ = true;
  const std::uint64_t limbs = 2 + part.bits / 32;
  if (has_determinant) units_ += 2 + (cell.is_rational() ? m2 : m) * m2 * limbs * limbs / 256;
}

void VInvalidWork::add_box(const VBox& box) {
  add_cut(model_.cell(box.cell), kAllAxes, parameters_of(model_, box), true, false);
}
void VInvalidWork::add_flat(std::uint32_t cell, const std::array<std::size_t, 3>& span) {
  const std::array<Ends, 3> whole = {
      Ends{Rational(0), Rational(1)}, {Rational(0), Rational(1)}, {Rational(0), Rational(1)}};
  add_cut(model_.cell(cell), kAllAxes, parameters_of(model_, VBox{cell, span, whole}), true, true);
}

void VInvalidWork::add_arc(const VArc& arc) {
  const VVolume& cell = model_.cell(arc.cell);
  const std::size_t along = arc.side / 2, across = arc.face / 2;
  const auto axes = v_face_axes(across);
  const std::size_t axis = axes[along];
  const std::vector<Rational> knots = internal::breaks_of(cell.axis(axis));
  const Rational &lo = knots[arc.span], &hi = knots[arc.span + 1];
  std::array<Ends, 3> at;
  at[across] = {Rational(static_cast<int>(arc.face % 2)), Rational()};
  at[axes[1 - along]] = {Rational(static_cast<int>(arc.side % 2)), Rational()};
  at[axis] = {lo + (hi - lo) * arc.at[0], lo + (hi - lo) * arc.at[1]};
  add_cut(cell, std::array{axis}, at, true, false);
}

void VInvalidWork::add_cells_near(const std::array<Rational, 3>& point) {
  for (const VVolume& cell : model_.cells()) {
    if (!is_near(cell, point)) continue;
    std::array<std::vector<Rational>, 3> knots;
    Grid<3> grid;
    for (std::size_t a = 0; a < 3; ++a) {
      knots[a] = internal::breaks_of(cell.axis(a));
      grid.size[a] = knots[a].size() - 1;
      for (std::size_t i = 0; i < grid.size[a]; ++i)
        add_interval(cell, a, {knots[a][i], knots[a][i + 1]}, false);
    }
    for (std::size_t i = 0; i < grid.count() && fits(); ++i) {
      const auto span = grid.index_of(i);
      std::array<Ends, 3> at;
      for (std::size_t a = 0; a < 3; ++a) at[a] = {knots[a][span[a]], knots[a][span[a] + 1]};
      add_cut(cell, kAllAxes, at, false, false);
    }
  }
}

void VInvalidWork::add_comparisons(std::span<const VFaceNumber> faces,
                                   const std::array<Rational, 3>* with) {
  std::vector<VFaceNumber> others;
  const auto has_corner = [&](VFaceNumber f) {
    const FaceCorners all = corners_of(model_, f);
    return std::find(all.begin(), all.end(), *with) != all.end();
  };
  for (VFaceNumber f = 0; f < model_.num_faces(); ++f)
    if (!model_.face(f).is_collapsed() && (with == nullptr || has_corner(f))) others.push_back(f);
  units_ += faces.size() * (with == nullptr ? model_.num_faces() : others.size());
  for (const VFaceNumber f : faces) {
    const FaceCorners of_f = corners_of(model_, f);
    for (const VFaceNumber g : others) {
      if (!fits()) return;
      if (f != g) add_comparison(f, of_f, g);
    }
  }
}

void VInvalidWork::add_comparison(VFaceNumber f, const FaceCorners& of_f, VFaceNumber g) {
  if (std::find(of_f.begin(), of_f.end(), corner_of_face(model_, g, 0, 0)) == of_f.end()) return;
  const FaceCorners of_g = corners_of(model_, g);
  for (unsigned s = 0; s < 8; ++s) {
    bool fits_corners = true;
    for (unsigned i = 0; i < 4 && fits_corners; ++i) {
      const auto to = v_symmetry_image(s, {i & 1, i >> 1});
      fits_corners = of_f[i] == of_g[to[0] + 2 * to[1]];
    }
    if (!fits_corners) continue;
    // The breaks of both, brought to [0, 1] on the parameters of g.
    std::array<std::vector<Rational>, 2> common;
    const auto add = [&](VFaceNumber h, std::size_t k, std::size_t to, bool is_reversed) {
      const std::vector<Rational> t =
          internal::breaks_of(model_.cell(h / 6).axis(v_face_axes(h % 6 / 2)[k]));
      for (const Rational& x : t) {
        const Rational at = (x - t.front()) / (t.back() - t.front());
        common[to].push_back(is_reversed ? Rational(1) - at : at);
      }
    };
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t to = k ^ (s & 1);
      add(f, k, to, (s >> (to == 0 ? 1 : 2) & 1) != 0);
      add(g, k, k, false);
    }
    for (auto& list : common) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    add_face_parts(g, common);
    std::array<std::vector<Rational>, 2> of_f;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t to = k ^ (s & 1);
      of_f[k] = common[to];
      if ((s >> (to == 0 ? 1 : 2) & 1) == 0) continue;
      for (Rational& x : of_f[k]) x = Rational(1) - x;
      std::reverse(of_f[k].begin(), of_f[k].end());
    }
    add_face_parts(f, of_f);
  }
}

// breaks: from 0 to 1.
void VInvalidWork::add_face_parts(VFaceNumber f,
                                  const std::array<std::vector<Rational>, 2>& breaks) {
  const VVolume& cell = model_.cell(f / 6);
  const std::size_t across = f % 6 / 2;
  const auto axes = v_face_axes(across);
  std::array<std::vector<Rational>, 2> at;
  for (std::size_t k = 0; k < 2; ++k) {
    const KnotAxis<Rational>& axis = cell.axis(axes[k]);
    const Rational length = axis.domain_end() - axis.domain_begin();
    for (const Rational& t : breaks[k]) at[k].push_back(axis.domain_begin() + length * t);
    for (std::size_t i = 0; i + 1 < at[k].size(); ++i)
      add_interval(cell, axes[k], {at[k][i], at[k][i + 1]}, true);
  }
  std::array<Ends, 3> part;
  part[across] = {Rational(static_cast<int>(f % 2)), Rational()};
  for (std::size_t i = 0; i + 1 < at[0].size(); ++i)
    for (std::size_t j = 0; j + 1 < at[1].size() && fits(); ++j) {
      part[axes[0]] = {at[0][i], at[0][i + 1]};
      part[axes[1]] = {at[1][j], at[1][j + 1]};
      add_cut(cell, axes, part, false, false);
    }
}

}  // namespace veritope
