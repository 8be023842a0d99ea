// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/tensor_form_internal.h: a patch as a tensor-product map of [0,1]^2, in integers and in doubles, so
// that rays treat triangles and tensor patches alike. Internal to solids/classify.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robust/integer.h"
#include "solids/patches/patch_complex.h"

namespace veritope::internal {

/// Sides of the square, counterclockwise: v = 0, u = 1, v = 1, u = 0. A triangle becomes S(u, v) = map(1 - u,
/// u (1 - v), u v): its sides 0, 1, 2 are those of the square, and side 3 is collapsed to corner 0.
struct TensorForm {
  static constexpr std::uint32_t kNoSide = 4;

  std::array<int, 2> degrees{};
  bool is_triangle = false;
  /// Homogeneous control points (x, y, z, w), times one positive integer, component by component, v fastest.
  std::array<std::vector<Integer>, 4> exact;
  /// The control points divided by powers of two, one for x, y, z and w of the patch and one for coordinates of the
  /// model, and rounded to nearest.
  std::array<std::vector<double>, 4> rounded;
  std::array<bool, 4> is_collapsed{};  ///< by side of the square

  /// @param scale  the power of two by which coordinates are divided
  /// REQUIRES weights > 0, degrees up to kMaxPatchDegree.
  TensorForm(const PatchComplex& complex, std::uint32_t patch, int scale);

  std::size_t count() const {
    return static_cast<std::size_t>(degrees[0] + 1) * static_cast<std::size_t>(degrees[1] + 1);
  }
  /// From one coefficient to the next along an axis.
  std::size_t stride(std::size_t axis) const {
    return axis == 0 ? static_cast<std::size_t>(degrees[1] + 1) : 1;
  }
  /// The first coefficient of a side of the square, in the direction in which its parameter grows.
  std::size_t first_of_side(std::uint32_t side) const {
    if (side == 1) return static_cast<std::size_t>(degrees[0]) * stride(0);
    return side == 2 ? static_cast<std::size_t>(degrees[1]) : 0;
  }
};

/// The axis along which the parameter of a side of the square grows.
inline std::size_t axis_of_side(std::uint32_t side) { return side % 2; }
/// Sides 0 and 1 are travelled upwards, counterclockwise.
inline bool runs_upward(std::uint32_t side) { return side < 2; }

/// The power of two that makes the greatest coordinate of the control points less than 1, and at least 1/4 unless all
/// are zero.
int scale_of(const PatchComplex& complex);

}  // namespace veritope::internal
