// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/box_frame.h"

#include <bit>
#include <cstdlib>
#include <limits>

#include "interval/bound_pair.h"
#include "interval/interval.h"
#include "interval/upward.h"
#include "robust/base/int128.h"

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

// (-lo, hi) of an interval: rounding upward widens both, and no compiler looks into operations on such pairs.
using internal::Pair;
Pair pair_of(double lo, double hi) {
  return internal::make_pair(internal::negated(internal::bits_of(lo)), internal::bits_of(hi));
}
double lo_of(Pair p) { return std::bit_cast<double>(internal::negated(internal::first(p))); }
double hi_of(Pair p) { return std::bit_cast<double>(internal::second(p)); }
bool is_finite(Pair p) {
  const auto is_number = [](internal::Bits v) {
    return !internal::is_nan(v) && !internal::is_infinite(v);
  };
  return is_number(internal::first(p)) && is_number(internal::second(p));
}

// The coordinates of a point or of a box, each with its negative.
struct PairsOfPoint {
  Pair at[3][2];
  void set(std::size_t k, Pair value) { at[k][0] = value, at[k][1] = internal::swapped(value); }
};

// The rows as doubles, exactly: entries are below 2^31. Magnitudes and signs, because a product with a positive number
// rounds both bounds the right way.
class RowsInDoubles {
 public:
  explicit RowsInDoubles(const BoxFrame::Rows& rows) {
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) {
        const internal::Bits size = internal::bits_of(static_cast<double>(std::abs(rows[r][c])));
        size_[r][c] = internal::make_pair(size, size);
        is_minus_[r][c] = rows[r][c] < 0 ? 1 : 0;
      }
  }
  // Contains the product of row r and x; not a number, or infinite, where x has no bound. REQUIRES upward rounding.
  Pair product(std::size_t r, const PairsOfPoint& x) const {
    Pair sum = internal::multiplied(size_[r][0], x.at[0][is_minus_[r][0]]);
    for (std::size_t k = 1; k < 3; ++k)
      sum = internal::added(sum, internal::multiplied(size_[r][k], x.at[k][is_minus_[r][k]]));
    return sum;
  }

 private:
  Pair size_[3][3];
  std::uint8_t is_minus_[3][3];
};

// The control points of a node: NodePoints::point as pairs.
class PointsInPairs {
 public:
  PointsInPairs(PieceForest& forest, PieceForest::Id id)
      : form_(forest.form(forest.node(id).patch)), net_(forest.control(id)) {
    for (std::size_t c = 0; c < (form_.is_rational ? 4u : 3u); ++c) {
      const double error = forest.control_error(id, c);
      error_[c] = pair_of(-error, error);
    }
    for (std::size_t c = 0; c < 3; ++c) origin_[c] = pair_of(form_.origin[c], form_.origin[c]);
  }
  std::size_t count() const { return form_.shape.count(); }
  // Returns false if the weight is not surely positive. REQUIRES upward rounding.
  bool get(std::size_t i, PairsOfPoint* out) const {
    if (!form_.is_rational) {
      for (std::size_t c = 0; c < 3; ++c) out->set(c, internal::added(origin_[c], value(c, i)));
      return true;
    }
    const Pair w = value(3, i);
    if (!(internal::key_of(internal::first(w)) < 0)) return false;
    const Pair least = internal::negated(internal::both_first(w)), most = internal::both_second(w);
    for (std::size_t c = 0; c < 3; ++c) {
      // A positive end goes farthest over the least weight, a negative one over the greatest.
      const Pair x = value(c, i);
      const Pair over = internal::divided(x, internal::chosen_by_sign(x, least, most));
      out->set(c, internal::added(origin_[c], over));
    }
    return true;
  }

 private:
  Pair value(std::size_t c, std::size_t i) const {
    const double x = net_[c * count() + i];
    return internal::added(pair_of(x, x), error_[c]);
  }

  const PieceForest::Form& form_;
  const double* net_;
  Pair error_[4], origin_[3];
};

constexpr Box3d kEverywhere{{-kInfinity, -kInfinity, -kInfinity},
                            {kInfinity, kInfinity, kInfinity}};

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
  PairsOfPoint at;
  for (std::size_t k = 0; k < 3; ++k) at.set(k, pair_of(x.lo[k], x.hi[k]));
  Box3d out = kEverywhere;
  for (std::size_t r = 0; r < 3; ++r) {
    const Pair v = rows.product(r, at);
    if (is_finite(v)) out.lo[r] = lo_of(v), out.hi[r] = hi_of(v);
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
  const PointsInPairs points(forest, id);
  const RowsInDoubles rows(frame.rows());
  const ScopedUpward upward;
  const Pair none = pair_of(kInfinity, -kInfinity);
  Pair hull[3] = {none, none, none}, sums[3] = {};
  PairsOfPoint at;
  for (std::size_t i = 0; i < points.count(); ++i) {
    if (!points.get(i, &at)) return kEverywhere;
    for (std::size_t r = 0; r < 3; ++r) {
      const Pair v = rows.product(r, at);
      hull[r] = internal::larger(hull[r], v);
      sums[r] = internal::added(sums[r], v);
    }
  }
  // A maximum may forget what is not a number, a sum does not.
  Box3d out;
  for (std::size_t r = 0; r < 3; ++r) {
    if (!is_finite(sums[r])) return kEverywhere;
    out.lo[r] = lo_of(hull[r]), out.hi[r] = hi_of(hull[r]);
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

void FrameHulls::use(const BoxFrame& frame) {
  if (frame == frame_ && drops_ == forest_.num_drops()) return;
  frame_ = frame;
  drops_ = forest_.num_drops();
  for (Known& k : known_) k.id = PieceForest::kNone;
}

FrameHulls::Known& FrameHulls::slot_of(PieceForest::Id id) {
  Known& out = known_[id % kSlots];
  if (out.id != id) {
    out.id = id, out.has_hull = false;
    out.around = frame_.in_frame(forest_.node(id).hull);
  }
  return out;
}

Box3d FrameHulls::of(PieceForest::Id id) {
  Known& known = slot_of(id);
  if (!known.has_hull) known.hull = hull_in_frame(forest_, id, frame_), known.has_hull = true;
  return known.hull;
}

std::optional<Box3d> FrameHulls::that_meets(PieceForest::Id id, const Box3d& box) {
  if (!meets(slot_of(id).around, box)) return std::nullopt;
  const Box3d hull = of(id);
  if (!meets(hull, box)) return std::nullopt;
  return hull;
}

}  // namespace veritope
