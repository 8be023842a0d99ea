// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/star_box/node_points_internal.h: the control points of a node as intervals.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "interval/interval.h"
#include "solids/pieces/piece_forest.h"

namespace veritope::internal {

/// Valid until the forest makes or drops a net.
class NodePoints {
 public:
  NodePoints(PieceForest& forest, PieceForest::Id id)
      : form_(forest.form(forest.node(id).patch)), net_(forest.control(id)) {
    for (std::size_t c = 0; c < (form_.is_rational ? 4u : 3u); ++c)
      error_[c] = forest.control_error(id, c);
  }

  const PieceForest::Form& form() const { return form_; }
  std::size_t count() const { return form_.shape.count(); }

  /// The weight, and (X, Y, Z) relative to the form's origin, times the weight. REQUIRES upward rounding.
  Interval weight(std::size_t i) const { return form_.is_rational ? value(3, i) : Interval(1.0); }
  Interval value(std::size_t c, std::size_t i) const {
    return Interval(net_[c * count() + i]) + Interval::from_bounds(-error_[c], error_[c]);
  }
  /// The point itself; nothing if its weight is not surely positive. REQUIRES upward rounding.
  std::optional<std::array<Interval, 3>> point(std::size_t i) const {
    const Interval w = weight(i);
    if (!(w.lo() > 0)) return std::nullopt;
    std::array<Interval, 3> out;
    for (std::size_t c = 0; c < 3; ++c) {
      out[c] = Interval(form_.origin[c]);
      out[c] += form_.is_rational ? value(c, i) / w : value(c, i);
    }
    return out;
  }

 private:
  const PieceForest::Form& form_;
  const double* net_;
  std::array<double, 4> error_{};
};

}  // namespace veritope::internal
