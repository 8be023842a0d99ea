// SPDX-License-Identifier: LGPL-3.0-or-later
// render/sample_layer_internal.h: what some rows of samples show of a solid or of balls: one opaque layer.
#pragma once
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "render/image.h"
#include "render/sample_rows_internal.h"
#include "robust/base/box3d.h"

namespace veritope::internal {

/// Lengths are in sides of samples.
struct LayerSample {
  static constexpr double kNothing = -std::numeric_limits<double>::infinity();
  double height = kNothing;              ///< toward the camera
  std::array<float, 3> normal{0, 0, 1};  ///< of length 1: to the right, upward, toward the camera
  Colour colour;                         ///< before it is shaded
  bool is_seen() const { return height != kNothing; }
};

/// How far back colours fade to white: by `most` at the lowest height, not at all at the highest one.
struct Haze {
  double lowest = 0, highest = 0, most = 0;
};

class SampleLayer {
 public:
  /// Outlines and normals look at samples up to this distance.
  static constexpr std::size_t kReach = 2;

  explicit SampleLayer(const SampleRows& rows) : rows_(rows), samples_(rows.size()) {}

  const SampleRows& rows() const { return rows_; }
  LayerSample& at(std::size_t column, std::size_t row) {
    return samples_[rows_.index(column, row)];
  }
  const LayerSample& at(std::size_t column, std::size_t row) const {
    return samples_[rows_.index(column, row)];
  }

  /// The normals of all samples by differences of heights. Beside an edge or a step the side is taken that is most
  /// nearly flat.
  void find_normals();
  /// Draws rows [first, last) of pixels; what shows nothing keeps the image's colour. Outlines are thin dark lines at
  /// sharp edges and where the layer ends or goes on farther back than `step`.
  struct Look {
    Haze haze;
    bool has_outlines = false;
    double step = 0;
  };
  void draw(std::size_t first, std::size_t last, const Look& look, Image* image) const;

 private:
  double slope(std::size_t column, std::size_t row, bool is_down) const;
  bool is_outline(std::size_t column, std::size_t row, double step) const;
  static bool is_step(const LayerSample& a, const LayerSample& b, double step);
  Colour shaded(std::size_t column, std::size_t row, const Look& look) const;

  SampleRows rows_;
  std::vector<LayerSample> samples_;
};

}  // namespace veritope::internal
