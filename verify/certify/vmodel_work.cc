// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/vmodel_work.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "robust/integer.h"
#include "solids/vmodel/piece_cutter.h"
#include "verify/certify/vmodel_cut_internal.h"

namespace veritope {
namespace {

using internal::CommonBits, internal::KnotPiece, internal::interval_of, internal::kFreeVModelUnits,
    internal::kMostBitsOfKnots, internal::kMostBitsOfPiece, internal::kMostBitsOfPoints,
    internal::kVModelUnitsOfByte;


Finding beyond_limits(std::size_t cell, const std::string& what) {
  Finding out;
  out.code = "not-covered";
  out.message = "cell " + std::to_string(cell) + ": " + what;
  out.place.parts.push_back({cell, {}, {}});
  return out;
}

// The page's numbers of a cell's pieces.
struct Shape {
  std::array<std::uint64_t, 3> sizes{};  // control points along the axes
  std::uint64_t m = 1, m2 = 1, c = 1, d = 0, degrees = 0;
  bool is_rational = false;

  explicit Shape(const VVolume& cell) : is_rational(cell.is_rational()) {
    for (std::size_t a = 0; a < 3; ++a) {
      const auto p = static_cast<std::uint64_t>(cell.axis(a).degree);
      const std::uint64_t of_n = (is_rational ? 4 : 3) * p;
      sizes[a] = p + 1;
      m *= p + 1, m2 *= 2 * p + 1, c *= of_n, d += of_n - 1, degrees += p;
    }
  }
  std::uint64_t of_coefficients(std::uint64_t bits) const { return 2 + m * degrees * bits / 4096; }
  std::uint64_t of_determinant(std::uint64_t bits) const {
    const std::uint64_t limbs = 2 + bits / 32;
    return 2 + (is_rational ? m2 : m) * m2 * limbs * limbs / 256;
  }
  std::uint64_t of_node(std::uint64_t bits, std::uint64_t level) const {
    return 1 + c * d * (4 * bits + level * d) / 16384;
  }
};

std::uint64_t longest(const BezierVolume<Integer>& piece) {
  std::uint64_t out = 1;
  for (const Integer& x : piece.coefficients()) out = std::max(out, x.bit_length());
  return out;
}

// The control points of a piece.
std::uint64_t bits_of_window(const VVolume& cell, const Shape& shape,
                             const std::array<const KnotPiece*, 3>& at) {
  const Grid<3> net = cell.grid();
  CommonBits out;
  for (std::size_t i = 0; i < shape.sizes[0]; ++i)
    for (std::size_t j = 0; j < shape.sizes[1]; ++j)
      for (std::size_t k = 0; k < shape.sizes[2]; ++k) {
        const std::size_t point =
            ((at[0]->first + i) * net.size[1] + at[1]->first + j) * net.size[2] + at[2]->first + k;
        for (int x = 0; x < cell.num_components(); ++x) out.add(cell.component(x)[point]);
      }
  return out.bits();
}

}  // namespace

std::optional<Finding> VModelWork::add(std::uint64_t units, std::size_t cell) {
  units_ += units;
  if (units_ <= kFreeVModelUnits + kVModelUnitsOfByte * bytes_) return std::nullopt;
  return beyond_limits(cell,
                       "checkers would have to do more work than they may for a file of this size");
}

std::optional<Finding> VModelWork::of_pieces() {
  for (std::size_t c = 0; c < model_.num_cells(); ++c)
    if (auto finding = add_cell(c)) return finding;
  return std::nullopt;
}

std::optional<Finding> VModelWork::add_cell(std::size_t number) {
  const VVolume& cell = model_.cell(number);
  const Shape shape(cell);
  std::array<std::vector<KnotPiece>, 3> axes;
  std::array<std::vector<Rational>, 3> breaks;
  for (std::size_t a = 0; a < 3; ++a) {
    breaks[a] = model_.breaks(number, a);
    const std::uint64_t cube = (shape.sizes[a] - 1) * (shape.sizes[a] - 1) * (shape.sizes[a] - 1);
    for (std::size_t i = 0; i + 1 < breaks[a].size(); ++i) {
      axes[a].push_back(interval_of(cell.axis(a), breaks[a][i], breaks[a][i + 1]));
      const std::uint64_t t = axes[a].back().bits;
      if (t > kMostBitsOfKnots)
        return beyond_limits(number, "its knots are longer than certificates may be about");
      if (auto f = add(1 + cube * (64 + cube * t * t / 8192) / 32, number)) return f;
    }
  }
  const PieceCutter cutter(cell, breaks);
  std::array<std::size_t, 3> at{};
  for (at[0] = 0; at[0] < axes[0].size(); ++at[0])
    for (at[1] = 0; at[1] < axes[1].size(); ++at[1])
      for (at[2] = 0; at[2] < axes[2].size(); ++at[2]) {
        const std::array<const KnotPiece*, 3> window = {&axes[0][at[0]], &axes[1][at[1]],
                                                        &axes[2][at[2]]};
        std::uint64_t bits = bits_of_window(cell, shape, window), units = 0;
        if (bits > kMostBitsOfPoints)
          return beyond_limits(number,
                               "its control points are longer than certificates may be about");
        for (std::size_t a = 0; a < 3; ++a) {
          const std::uint64_t longer = shape.sizes[a] * (shape.sizes[a] - 1) * window[a]->bits;
          units += shape.m * shape.sizes[a] * (32 + (1 + longer / 128) * (1 + bits / 64)) / 32;
          if (!window[a]->is_whole) bits += longer / 2;
        }
        if (shape.c * bits > kMostBitsOfPiece) bits = longest(cutter.exact(at));
        if (shape.c * bits > kMostBitsOfPiece)
          return beyond_limits(
              number, "its numbers are longer than certificates of such degrees may be about");
        bits_.push_back(static_cast<std::uint32_t>(bits));
        units += shape.of_coefficients(bits) + shape.of_determinant(bits) + shape.of_node(bits, 0);
        if (auto finding = add(units, number)) return finding;
      }
  return std::nullopt;
}

std::optional<Finding> VModelWork::of_trees(const VDeterminants& determinants) {
  std::size_t cell = 0;
  for (const PieceProof& proof : determinants.proofs) {
    while (proof.piece >= model_.first_piece(cell + 1)) ++cell;
    const Shape shape(model_.cell(cell));
    std::vector<std::uint64_t> levels = {0};  // of the nodes to come; the root is counted
    for (const std::uint8_t symbol : proof.tree) {
      const std::uint64_t level = levels.back();
      levels.pop_back();
      if (level > 0)
        if (auto f = add(shape.of_node(bits_[proof.piece], level), cell)) return f;
      if (symbol != 0) levels.insert(levels.end(), 2, level + 1);
    }
  }
  return std::nullopt;
}

}  // namespace veritope
