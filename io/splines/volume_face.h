// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/volume_face.h: where a surface lies on the boundary of a volume.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "robust/rational.h"

namespace veritope {

/// Where a face, or a piece of one, lies on its volume.
struct VolumeFace {
  std::uint64_t volume = 0;           ///< an entity of the model
  std::size_t axis = 0, end = 0;      ///< the axis across; 0: where it begins, 1: where it ends
  std::array<std::size_t, 2> axes{};  ///< the volume's axes that are the surface's u and v
  Rational at;                        ///< the volume's parameter across
  /// For a piece, whose u and v run from 0 to 1: the volume's parameters there, along both axes. Without it u and v are
  /// the volume's parameters.
  std::optional<std::array<std::array<Rational, 2>, 2>> piece = std::nullopt;
};

}  // namespace veritope
