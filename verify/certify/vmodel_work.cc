// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/vmodel_work.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "robust/integer.h"
#include "solids/vmodel/piece_cutter.h"
#include "verify/certify/vmodel_cut_internal.h"

namespace veritope {
namespace {

using internal::KnotPiece, internal::kFreeVModelUnits, internal::kMostBitsOfPiece,
    internal::kVModelUnitsOfByte;

Finding beyond_limits(std::size_t cell, const std::string& what) {
  Finding out;
  out.code = "not-covered";
  out.message = "cell " + std::to_string(cell) + ": " + what;
  out.place.parts.push_back({cell, {}, {}});
  return out;
}

std::uint64_t longest_without_factor(const BezierVolume<Integer>& piece) {
  std::uint64_t out = 0;
  Integer factor;
  for (const Integer& x : piece.coefficients()) {
    out = std::max(out, x.bit_length());
    if (factor != Integer(1)) factor = gcd(factor, x);
  }
  if (factor == Integer(1) || factor.sign() == Sign::kZero) return std::max<std::uint64_t>(1, out);
  out = 1;
  for (const Integer& x : piece.coefficients())
    out = std::max(out, divide_exactly(x, factor).bit_length());
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

// The control points of a piece.
std::vector<Rational> window_of(const VVolume& cell, const Shape& shape,
                                const std::array<KnotPiece, 3>& at) {
  const Grid<3> net = cell.grid();
  std::vector<Rational> out;
  for (std::size_t i = 0; i < shape.sizes[0]; ++i)
    for (std::size_t j = 0; j < shape.sizes[1]; ++j)
      for (std::size_t k = 0; k < shape.sizes[2]; ++k) {
        const std::size_t point =
            ((at[0].first + i) * net.size[1] + at[1].first + j) * net.size[2] + at[2].first + k;
        for (int x = 0; x < cell.num_components(); ++x) out.push_back(cell.component(x)[point]);
      }
  return out;
}

// The cell with weights.
VVolume with_weights(const VVolume& cell) {
  if (cell.is_rational()) return cell;
  std::vector<Rational> numbers;
  for (int x = 0; x < 3; ++x)
    numbers.insert(numbers.end(), cell.component(x).begin(), cell.component(x).end());
  numbers.resize(numbers.size() / 3 * 4, Rational(1));
  return VVolume(cell.axes(), 4, true, std::move(numbers));
}

const char* const kLongKnots = "its knots are longer than certificates may be about";
const char* const kLongPoints = "its control points are longer than certificates may be about";
const char* const kLongPiece =
    "its numbers are longer than certificates of such degrees may be about";

}  // namespace

std::optional<Finding> VModelWork::add(std::uint64_t units, std::size_t cell) {
  units_ += units;
  if (units_ <= kFreeVModelUnits + kVModelUnitsOfByte * bytes_) return std::nullopt;
  return beyond_limits(cell,
                       "checkers would have to do more work than they may for a file of this size");
}

std::optional<Finding> VModelWork::of_pieces() {
  for (const bool is_bound : {true, false}) {
    std::optional<Finding> finding;
    units_ = 0, bits_.clear();
    for (std::size_t c = 0; c < model_.num_cells() && !finding; ++c)
      finding = add_cell(c, is_bound);
    if (!finding || !is_bound) return finding;
  }
  return std::nullopt;
}

std::optional<Finding> VModelWork::add_cell(std::size_t number, bool is_bound) {
  const VVolume cell = with_weights(model_.cell(number));
  const Shape shape(model_.cell(number));
  std::array<std::vector<KnotPiece>, 3> axes;
  std::array<std::vector<Rational>, 3> breaks;
  for (std::size_t a = 0; a < 3; ++a) {
    breaks[a] = model_.breaks(number, a);
    for (std::size_t i = 0; i + 1 < breaks[a].size(); ++i) {
      const auto made =
          internal::interval_of(cell.axis(a), breaks[a][i], breaks[a][i + 1], is_bound);
      if (!made) return beyond_limits(number, kLongKnots);
      axes[a].push_back(*made);
      if (auto f = add(made->units(cell.axis(a).degree), number)) return f;
    }
  }
  const PieceCutter cutter(cell, breaks);
  std::array<std::size_t, 3> at{};
  for (at[0] = 0; at[0] < axes[0].size(); ++at[0])
    for (at[1] = 0; at[1] < axes[1].size(); ++at[1])
      for (at[2] = 0; at[2] < axes[2].size(); ++at[2]) {
        const std::array<KnotPiece, 3> window = {axes[0][at[0]], axes[1][at[1]], axes[2][at[2]]};
        const auto points = internal::bits_of_points(window_of(cell, shape, window), is_bound);
        if (!points) return beyond_limits(number, kLongPoints);
        const internal::CutProducts products = internal::products_of(shape.sizes, window, *points);
        if (auto finding = add(products.units, number)) return finding;
        const std::uint64_t bits =
            is_bound ? products.bits : longest_without_factor(cutter.exact(at));
        if (shape.c * bits > kMostBitsOfPiece) return beyond_limits(number, kLongPiece);
        bits_.push_back(static_cast<std::uint32_t>(bits));
        if (auto finding = add(
                shape.of_coefficients(bits) + shape.of_determinant(bits) + shape.of_node(bits, 0),
                number))
          return finding;
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
