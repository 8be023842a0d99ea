// SPDX-License-Identifier: LGPL-3.0-or-later
// render/surface_samples_internal.h: which triangles each sample shows.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/flat_scene_internal.h"
#include "render/sample_rows_internal.h"

namespace veritope::internal {

/// The nearest kMostLayers triangles of each sample, up to the first opaque one. They do not depend on the order in
/// which triangles are added: at equal depths the lower number is in front.
class SurfaceSamples {
 public:
  static constexpr std::size_t kMostLayers = 4;
  /// draw_over looks at samples up to this distance.
  static constexpr std::size_t kReach = 2;

  SurfaceSamples(const SampleRows& rows, const FlatScene& scene);

  /// What lies outside of the rows is left out.
  void add(std::uint32_t triangle);
  /// Covers the colours of some of the rows with the layers, and if asked for with outlines: thin dark lines where the
  /// front layer has a sharp edge or ends in front of another one.
  void draw_over(const SampleRows& rows, bool with_outlines, std::span<Colour> colours) const;

 private:
  using Layers = std::array<std::uint64_t, kMostLayers>;
  Colour blended(std::size_t column, std::size_t row, Colour background) const;
  std::uint64_t front(std::size_t column, std::size_t row) const {
    return layers_[rows_.index(column, row)].front();
  }
  bool is_outline(std::size_t column, std::size_t row) const;
  bool is_step(std::uint64_t a, std::uint64_t b) const;

  SampleRows rows_;
  const FlatScene* scene_;
  std::vector<Layers> layers_;
};

}  // namespace veritope::internal
