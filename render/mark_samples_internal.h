// SPDX-License-Identifier: LGPL-3.0-or-later
// render/mark_samples_internal.h: which mark, or rim of a mark, each sample shows.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "render/flat_scene_internal.h"
#include "render/sample_rows_internal.h"

namespace veritope::internal {

/// The nearest mark of each sample and the nearest rim. A rim hides marks only from well in front of them, so that the
/// pieces of a polyline do not cut each other. At equal depths the mark with the higher number is in front.
class MarkSamples {
 public:
  MarkSamples(const SampleRows& rows, const FlatScene& scene);

  /// Adds a mark with its rim to the samples whose centres lie in them.
  void add(std::uint32_t mark);
  /// Covers the colours of all samples of the rows with what was added.
  void draw_over(std::span<Colour> colours) const;

 private:
  SampleRows rows_;
  const FlatScene* scene_;
  std::vector<std::uint64_t> marks_, rims_;
};

/// The rows of samples that a mark with its rim may cover, of `num_rows` that there are, as [first, last).
std::array<std::uint32_t, 2> rows_of_mark(const FlatMark& mark, std::size_t num_rows);

/// White around dark colours, dark around bright ones.
Colour rim_colour(Colour colour);

}  // namespace veritope::internal
