// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/compose/bridge_piece_internal.h: the polynomial piece of a volume on which a bridge lies. Internal to
// solids/micro/compose.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "solids/micro/microstructure.h"
#include "splines/bezier.h"

namespace veritope::internal {

/// The map of a volume on one of its knot spans, as a map of [0, 1]^3; it may go on beyond the span.
struct SpanPiece {
  BezierVolume<Rational> map{{1, 1, 1}, 3, false};
  TilePoint begin, width;  ///< of the span

  /// A parameter of the volume as one of the piece.
  Rational brought(std::size_t axis, const Rational& x) const {
    return (x - begin[axis]) / width[axis];
  }
};

/// The pieces of a volume, each as far as its polynomials go: a knot that the map does not need parts nothing.
class VolumePieces {
 public:
  /// REQUIRES that the volume outlives it.
  explicit VolumePieces(const VVolume& volume);

  using Spans = std::array<std::size_t, 3>;  // numbers of knot spans
  /// A span whose piece is the map on this box; nothing if the box crosses a knot that the map needs, or leaves the
  /// domain. Knots are examined when a box first crosses one.
  /// @cost  a knot is compared span by span; it is enough that one pair of spans differs
  std::optional<Spans> span_around(const TilePoint& lo, const TilePoint& hi);
  /// REQUIRES numbers of spans.
  SpanPiece at(const Spans& spans) const;

 private:
  struct Axis {
    std::vector<Rational> breaks;
    std::vector<std::optional<bool>> is_needed;  // of the break with this number
  };
  BezierVolume<Rational> piece(const Spans& spans) const;
  bool needs(std::size_t axis, std::size_t number);

  const VVolume* volume_;
  std::array<Axis, 3> axes_;
};

}  // namespace veritope::internal
