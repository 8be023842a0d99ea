// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/v_singularities.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <tuple>
#include <utility>

namespace veritope {
namespace {

// A box of pieces, in numbers of breaks.
using BreakBox = std::array<std::array<std::size_t, 2>, 3>;

BreakBox box_of(const std::array<std::size_t, 3>& piece, std::uint32_t zero) {
  const std::array<std::uint32_t, 3> ends = {zero / 9, zero / 3 % 3, zero % 3};
  BreakBox out;
  for (std::size_t a = 0; a < 3; ++a) {
    out[a][0] = piece[a] + (ends[a] == 1 ? 1 : 0);
    out[a][1] = piece[a] + (ends[a] == 0 ? 0 : 1);
  }
  return out;
}

// Joins boxes that differ along this axis only, and touch.
void join_along(std::size_t axis, std::vector<BreakBox>& boxes) {
  const std::size_t p = axis == 0 ? 1 : 0, q = axis == 2 ? 1 : 2;
  std::sort(boxes.begin(), boxes.end(), [&](const BreakBox& a, const BreakBox& b) {
    return std::tie(a[p], a[q], a[axis]) < std::tie(b[p], b[q], b[axis]);
  });
  std::vector<BreakBox> out;
  for (const BreakBox& box : boxes) {
    const bool is_next = !out.empty() && out.back()[p] == box[p] && out.back()[q] == box[q] &&
                         out.back()[axis][0] < out.back()[axis][1] && box[axis][0] < box[axis][1] &&
                         out.back()[axis][1] >= box[axis][0];
    if (is_next)
      out.back()[axis][1] = std::max(out.back()[axis][1], box[axis][1]);
    else
      out.push_back(box);
  }
  boxes = std::move(out);
}

bool is_part(const BreakBox& a, const BreakBox& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a[k][0] < b[k][0] || a[k][1] > b[k][1]) return false;
  return true;
}

constexpr std::size_t kMostCompared =
    2000;  // boxes of a cell among which parts of others are sought

std::vector<BreakBox> maximal(std::vector<BreakBox> boxes) {
  for (std::size_t axis = 0; axis < 3; ++axis) join_along(axis, boxes);
  std::sort(boxes.begin(), boxes.end());
  boxes.erase(std::unique(boxes.begin(), boxes.end()), boxes.end());
  if (boxes.size() > kMostCompared) return boxes;
  std::vector<BreakBox> out;
  for (const BreakBox& box : boxes)
    if (std::none_of(boxes.begin(), boxes.end(),
                     [&](const BreakBox& other) { return other != box && is_part(box, other); }))
      out.push_back(box);
  return out;
}

VSingularity::Kind kind_of_zero(const VModel& model, std::size_t cell, const BreakBox& box) {
  using Kind = VSingularity::Kind;
  std::size_t lengths = 0, across = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const bool has_length = box[a][0] < box[a][1];
    lengths += has_length ? 1 : 0;
    if (!has_length) across = a;
  }
  if (lengths < 2) return lengths == 0 ? Kind::kCorner : Kind::kEdge;
  const VFaceRole& face = model.face(cell, 2 * across + (box[across][0] == 0 ? 0 : 1));
  if (face.collapse == VCollapse::kToPoint) return Kind::kPoint;
  return face.is_collapsed() ? Kind::kCurve : Kind::kFace;
}

}  // namespace

std::vector<VSingularity> singularities_of(const VModel& model, const VDeterminants& determinants) {
  std::vector<VSingularity> out;
  auto proof = determinants.proofs.begin();
  for (std::size_t c = 0; c < model.num_cells(); ++c) {
    std::vector<BreakBox> boxes;
    const Grid<3> grid = model.piece_grid(c);
    for (; proof != determinants.proofs.end() && proof->piece < model.first_piece(c + 1); ++proof) {
      const auto n = static_cast<std::size_t>(proof->piece - model.first_piece(c));
      const std::array<std::size_t, 3> piece = {n / (grid.size[1] * grid.size[2]),
                                                n / grid.size[2] % grid.size[1], n % grid.size[2]};
      for (std::uint32_t zero = 0; zero < 26; ++zero)
        if ((proof->zeros >> zero & 1u) != 0) boxes.push_back(box_of(piece, zero));
    }
    if (boxes.empty()) continue;
    std::array<std::vector<Rational>, 3> breaks;
    for (std::size_t a = 0; a < 3; ++a) breaks[a] = model.breaks(c, a);
    for (const BreakBox& box : maximal(std::move(boxes))) {
      VSingularity& s = out.emplace_back();
      s.cell = c;
      for (std::size_t a = 0; a < 3; ++a) s.box[a] = {breaks[a][box[a][0]], breaks[a][box[a][1]]};
      s.kind = kind_of_zero(model, c, box);
    }
  }
  return out;
}

}  // namespace veritope
