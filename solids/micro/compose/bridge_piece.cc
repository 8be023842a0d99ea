// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/compose/bridge_piece_internal.h"
#include "splines/bezier_domain.h"
#include "splines/blossom_weights.h"
#include "splines/composition_span.h"

namespace veritope::internal {

VolumePieces::VolumePieces(const VVolume& volume) : volume_(&volume) {
  for (std::size_t a = 0; a < 3; ++a) {
    axes_[a].breaks = breaks_of(volume.axis(a));
    axes_[a].is_needed.resize(axes_[a].breaks.size());
  }
}

BezierVolume<Rational> VolumePieces::piece(const Spans& spans) const {
  std::array<std::size_t, 3> knots;
  for (std::size_t a = 0; a < 3; ++a)
    knots[a] = find_span(volume_->axis(a), axes_[a].breaks[spans[a]]);
  return bezier_piece(*volume_, knots);
}

// Whether the pieces before and after an inner break differ somewhere.
bool VolumePieces::needs(std::size_t axis, std::size_t number) {
  Axis& along = axes_[axis];
  if (along.is_needed[number]) return *along.is_needed[number];
  const Rational width = along.breaks[number] - along.breaks[number - 1],
                 next = (along.breaks[number + 1] - along.breaks[number]) / width;
  Grid<3> others;
  for (std::size_t a = 0; a < 3; ++a) others.size[a] = a == axis ? 1 : axes_[a].breaks.size() - 1;
  bool differs = false;
  for (std::size_t n = 0; n < others.count() && !differs; ++n) {
    std::array<std::size_t, 3> spans = others.index_of(n);
    spans[axis] = number - 1;
    const BezierVolume<Rational> before = piece(spans);
    spans[axis] = number;
    differs = restricted(before, axis, Rational(1), Rational(1) + next) != piece(spans);
  }
  along.is_needed[number] = differs;
  return differs;
}

std::optional<VolumePieces::Spans> VolumePieces::span_around(const TilePoint& lo,
                                                             const TilePoint& hi) {
  Spans out;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::vector<Rational>& breaks = axes_[a].breaks;
    if (lo[a] < breaks.front() || breaks.back() < hi[a]) return std::nullopt;
    std::size_t span = 0;
    while (span + 2 < breaks.size() && breaks[span + 1] <= lo[a]) ++span;
    for (std::size_t k = span + 1; k + 1 < breaks.size() && breaks[k] < hi[a]; ++k)
      if (needs(a, k)) return std::nullopt;
    out[a] = span;
  }
  return out;
}

SpanPiece VolumePieces::at(const Spans& spans) const {
  SpanPiece out;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::vector<Rational>& breaks = axes_[a].breaks;
    out.begin[a] = breaks[spans[a]];
    out.width[a] = breaks[spans[a] + 1] - breaks[spans[a]];
  }
  out.map = piece(spans);
  return out;
}

}  // namespace veritope::internal
