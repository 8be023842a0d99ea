// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/chain_point.h: points of the line, the plane and space, for which chains are one template; with binary64
// coordinates beside the exact ones where binary64 has them.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "robust/base/box3d.h"
#include "robust/rational.h"

namespace veritope {

/// Exact coordinates; of space the same type as ExactPoint.
template <std::size_t Dim>
using PointIn = std::array<Rational, Dim>;

/// The box of doubles around a point; coordinates beyond Dim are 0.
template <std::size_t Dim>
Box3d box_around(const PointIn<Dim>& p) {
  Box3d out{};
  for (std::size_t k = 0; k < Dim; ++k) {
    out.lo[k] = round_down(p[k]);
    out.hi[k] = round_up(p[k]);
  }
  return out;
}

/// A point with everything that tests of cells need of it.
template <std::size_t Dim>
class ChainPoint {
 public:
  explicit ChainPoint(const PointIn<Dim>& exact) : exact_(exact), box_(box_around<Dim>(exact)) {
    if (box_.lo != box_.hi) return;
    doubles_.emplace();
    for (std::size_t k = 0; k < Dim; ++k) (*doubles_)[k] = box_.lo[k];
  }

  const PointIn<Dim>& exact() const { return exact_; }
  /// Its coordinates as binary64 numbers, if binary64 has them all.
  const std::optional<std::array<double, Dim>>& doubles() const { return doubles_; }
  /// Contains the point.
  const Box3d& box() const { return box_; }

 private:
  PointIn<Dim> exact_;
  Box3d box_;
  std::optional<std::array<double, Dim>> doubles_;
};

}  // namespace veritope
