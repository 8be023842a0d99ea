// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_half_spaces.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "robust/base/check.h"

namespace veritope {
namespace {

using Column = std::array<Rational, 4>;
using Square = std::array<Column, 4>;  // rows

constexpr std::size_t kMaxGreedySteps = 64;  // then Bland's rule, which cannot cycle

// REQUIRES a regular matrix.
Square inverse_of(Square m) {
  Square out;
  for (std::size_t i = 0; i < 4; ++i) out[i][i] = Rational(1);
  for (std::size_t i = 0; i < 4; ++i) {
    std::size_t pivot = i;
    while (pivot < 4 && m[pivot][i].sign() == Sign::kZero) ++pivot;
    VT_CHECK(pivot < 4, "a basis of half-spaces is regular");
    std::swap(m[pivot], m[i]);
    std::swap(out[pivot], out[i]);
    const Rational by = m[i][i];
    for (std::size_t j = 0; j < 4; ++j) m[i][j] /= by, out[i][j] /= by;
    for (std::size_t k = 0; k < 4; ++k) {
      if (k == i || m[k][i].sign() == Sign::kZero) continue;
      const Rational factor = m[k][i];
      for (std::size_t j = 0; j < 4; ++j) {
        m[k][j] -= factor * m[i][j];
        out[k][j] -= factor * out[i][j];
      }
    }
  }
  return out;
}

// Columns (vector, 1) of the dual program: minimise the sum of y number over y >= 0 whose columns add up to (0, 1). A
// basis of four columns has weights y, and a point u with a height t: h(u) = t for the four.
class DualSimplex {
 public:
  DualSimplex(std::span<const DmsHalfSpace> all, DmsHalfSpaceKind kind)
      : all_(all), is_open_(kind == DmsHalfSpaceKind::kOpen) {}

  std::variant<DmsPoint, std::vector<DmsWeightedHalfSpace>> run() {
    for (std::size_t step = 0;; ++step) {
      invert();
      if (top_.sign() == Sign::kNegative || (is_open_ && top_.sign() == Sign::kZero))
        return weights();
      const auto entering = step < kMaxGreedySteps ? most_violated() : first_below();
      if (!entering) return point_;
      if (step >= kMaxGreedySteps && !most_violated()) return point_;
      exchange(*entering);
    }
  }

 private:
  static Column column_of(const DmsHalfSpace& h) {
    return {h.vector[0], h.vector[1], h.vector[2], Rational(1)};
  }

  void invert() {
    Square m;
    for (std::size_t i = 0; i < 4; ++i) {
      const Column c = column_of(all_[basis_[i]]);
      for (std::size_t k = 0; k < 4; ++k) m[k][i] = c[k];
    }
    inverse_ = inverse_of(std::move(m));
    Column price;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = 0; i < 4; ++i) price[k] += all_[basis_[i]].number * inverse_[i][k];
    for (std::size_t c = 0; c < 3; ++c) point_[c] = -price[c];
    top_ = price[3];
  }
  std::vector<DmsWeightedHalfSpace> weights() const {
    std::vector<DmsWeightedHalfSpace> out;
    for (std::size_t i = 0; i < 4; ++i)
      if (inverse_[i][3].sign() == Sign::kPositive) out.push_back({basis_[i], inverse_[i][3]});
    return out;
  }

  // The half-space that is missed by most; nothing if none is.
  std::optional<std::size_t> most_violated() const {
    std::optional<std::size_t> found;
    Rational least;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      Rational h = height_in(all_[i], point_);
      const bool is_missed = h.sign() == Sign::kNegative || (is_open_ && h.sign() == Sign::kZero);
      if (is_missed && (!found || h < least)) found = i, least = std::move(h);
    }
    return found;
  }
  // The first one that lowers the top.
  std::optional<std::size_t> first_below() const {
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (height_in(all_[i], point_) < top_) return i;
    return std::nullopt;
  }

  void exchange(std::size_t entering) {
    const Column c = column_of(all_[entering]);
    std::optional<std::size_t> leaving;
    Rational least;
    for (std::size_t i = 0; i < 4; ++i) {
      Rational share;
      for (std::size_t k = 0; k < 4; ++k) share += inverse_[i][k] * c[k];
      if (share.sign() != Sign::kPositive) continue;
      Rational ratio = inverse_[i][3] / share;
      if (!leaving || ratio < least || (ratio == least && basis_[i] < basis_[*leaving]))
        leaving = i, least = std::move(ratio);
    }
    VT_CHECK(leaving.has_value(), "the weights of a basis are bounded");
    basis_[*leaving] = entering;
  }

  const std::span<const DmsHalfSpace> all_;
  const bool is_open_;
  std::array<std::size_t, 4> basis_{0, 1, 2, 3};
  Square inverse_;
  DmsPoint point_;
  Rational top_;
};

}  // namespace

Rational height_in(const DmsHalfSpace& half_space, const DmsPoint& point) {
  return dot_product(half_space.vector, point) + half_space.number;
}

std::variant<DmsPoint, std::vector<DmsWeightedHalfSpace>> meet_half_spaces(
    std::span<const DmsHalfSpace> all, DmsHalfSpaceKind kind) {
  VT_CHECK(all.size() >= 4, "the first four half-spaces are a basis");
  return DualSimplex(all, kind).run();
}

}  // namespace veritope
