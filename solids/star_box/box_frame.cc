// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/box_frame.h"

#include <algorithm>
#include <limits>

#include "interval/interval.h"
#include "interval/upward.h"
#include "robust/base/int128.h"
#include "solids/star_box/node_points_internal.h"

namespace veritope {
namespace {

using Entry = int128;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The cofactor of row r, column c; its magnitude is below 2^63.
Entry cofactor(const BoxFrame::Rows& a, std::size_t r, std::size_t c) {
  const std::size_t i = (r + 1) % 3, j = (r + 2) % 3, k = (c + 1) % 3, l = (c + 2) % 3;
  return Entry{a[i][k]} * a[j][l] - Entry{a[i][l]} * a[j][k];
}
Entry determinant(const BoxFrame::Rows& a) {
  Entry out = 0;
  for (std::size_t c = 0; c < 3; ++c) out += a[0][c] * cofactor(a, 0, c);
  return out;
}

// Contains the integer, within a few units of its last place. REQUIRES upward rounding.
Interval enclosure(Entry v) {
  if (v < 0) return -enclosure(-v);  // parts of different signs would cancel
  Interval out;
  for (int shift = 96; shift >= 0; shift -= 32)
    out = out * Interval(0x1p32) +
          Interval(static_cast<double>(static_cast<std::uint64_t>(v >> shift) & 0xffffffffu));
  return out;
}

// The rows as doubles, exactly: entries are below 2^31; and their negatives. The compiler must not know what is the
// negative of what: it would take the negative of a product, which rounds the wrong way.
class RowsInDoubles {
 public:
  explicit RowsInDoubles(const BoxFrame::Rows& rows) {
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) {
        plus_[r][c] = static_cast<double>(rows[r][c]);
        minus_[r][c] = fenced(-plus_[r][c]);
      }
  }
  // Contains the product of row r and x. REQUIRES upward rounding.
  Interval product(std::size_t r, const std::array<Interval, 3>& x) const {
    double hi = 0, minus_lo = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_minus = plus_[r][k] < 0;
      const double lo_of_x = fenced(x[k].lo()), hi_of_x = fenced(x[k].hi());
      hi += plus_[r][k] * (is_minus ? lo_of_x : hi_of_x);
      minus_lo += minus_[r][k] * (is_minus ? hi_of_x : lo_of_x);
    }
    // Nothing is computed after the rounding mode has changed back.
    hi = fenced(hi), minus_lo = fenced(minus_lo);
    // Not a number where x has no bound.
    if (!(hi < kInfinity && minus_lo < kInfinity))
      return Interval::from_bounds(-kInfinity, kInfinity);
    return Interval::from_bounds(-minus_lo, hi);
  }

 private:
  std::array<std::array<double, 3>, 3> plus_, minus_;
};

}  // namespace

BoxFrame::BoxFrame()
    : rows_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, back_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}} {}

std::optional<BoxFrame> BoxFrame::make(const Rows& rows) {
  for (const auto& row : rows)
    for (const std::int64_t v : row)
      if (v <= -kEntryLimit || v >= kEntryLimit) return std::nullopt;
  const Entry det = determinant(rows);
  if (det == 0) return std::nullopt;
  BoxFrame out;
  out.rows_ = rows;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      out.back_[c][r] = static_cast<double>(cofactor(rows, r, c)) / static_cast<double>(det);
  return out;
}

bool BoxFrame::is_plain() const { return *this == BoxFrame(); }

Box3d BoxFrame::in_frame(const Point3d& x) const { return in_frame(Box3d{x, x}); }

Box3d BoxFrame::in_frame(const Box3d& x) const {
  const RowsInDoubles rows(rows_);
  const ScopedUpward upward;
  std::array<Interval, 3> at;
  for (std::size_t k = 0; k < 3; ++k) at[k] = Interval::from_bounds(x.lo[k], x.hi[k]);
  Box3d out;
  for (std::size_t r = 0; r < 3; ++r) {
    const Interval v = rows.product(r, at);
    out.lo[r] = v.lo(), out.hi[r] = v.hi();
  }
  return out;
}

Box3d BoxFrame::around(const Box3d& in_frame) const {
  if (is_plain()) return in_frame;
  const ScopedUpward upward;
  const Interval det = enclosure(determinant(rows_));
  Box3d out;
  for (std::size_t c = 0; c < 3; ++c) {
    Interval sum;
    for (std::size_t r = 0; r < 3; ++r)
      sum +=
          enclosure(cofactor(rows_, r, c)) * Interval::from_bounds(in_frame.lo[r], in_frame.hi[r]);
    sum = sum / det;
    out.lo[c] = sum.lo(), out.hi[c] = sum.hi();
  }
  return out;
}

Point3d BoxFrame::approx_back(const Point3d& in_frame) const {
  Point3d out{};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t r = 0; r < 3; ++r) out[c] += back_[c][r] * in_frame[r];
  return out;
}

Box3d hull_in_frame(PieceForest& forest, PieceForest::Id id, const BoxFrame& frame) {
  if (frame.is_plain()) return forest.node(id).hull;
  const internal::NodePoints points(forest, id);
  const RowsInDoubles rows(frame.rows());
  const ScopedUpward upward;
  Box3d out{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (std::size_t i = 0; i < points.count(); ++i) {
    const auto at = points.point(i);
    if (!at) return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};
    for (std::size_t r = 0; r < 3; ++r) {
      const Interval v = rows.product(r, *at);
      out.lo[r] = std::min(out.lo[r], v.lo()), out.hi[r] = std::max(out.hi[r], v.hi());
    }
  }
  return out;
}

std::optional<Box3d> hull_that_meets(PieceForest& forest, PieceForest::Id id, const BoxFrame& frame,
                                     const Box3d& box) {
  if (!meets(frame.in_frame(forest.node(id).hull), box)) return std::nullopt;
  const Box3d hull = hull_in_frame(forest, id, frame);
  if (!meets(hull, box)) return std::nullopt;
  return hull;
}

}  // namespace veritope
