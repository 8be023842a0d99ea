// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/tensor_form.h: a patch as a tensor-product map of [0,1]^2, in integers and in doubles, so
// that rays treat triangles and tensor patches alike.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "robust/integer.h"
#include "solids/patches/patch_complex.h"

namespace veritope {

/// How a side of the square is glued: sides of one edge are the same curve, travelled forward by some of them and
/// backward by the others, and cancel.
struct GluedSide {
  bool is_collapsed = false;  ///< one point, which no edge is about
  std::uint32_t edge = 0;
  bool is_forward = true;
};

/// The points (x, y, z) with normal . (x, y, z) = offset; in coordinates of the model.
struct FormPlane {
  std::array<Integer, 3> normal;
  Integer offset;
};

/// Sides of the square, counterclockwise: v = 0, u = 1, v = 1, u = 0. A triangle becomes S(u, v) = map(1 - u,
/// u (1 - v), u v): its sides 0, 1, 2 are those of the square, and side 3 is collapsed to corner 0.
struct TensorForm {
  std::array<int, 2> degrees{};
  /// Homogeneous control points (x, y, z, w), times one positive integer, component by component, v fastest.
  std::array<std::vector<Integer>, 4> exact;
  /// The control points divided by powers of two, one for x, y, z and w of the patch and one for coordinates of the
  /// model, and rounded to nearest.
  std::array<std::vector<double>, 4> rounded;
  std::array<GluedSide, 4> sides{};
  /// The plane that holds the patch, if there is one and only one.
  std::optional<FormPlane> plane;
  int coefficient = 1;      ///< of the patch in its chain
  std::uint32_t shell = 0;  ///< windings are counted for each

  /// @param scale  the power of two by which coordinates are divided
  /// REQUIRES weights > 0, degrees up to kMaxPatchDegree.
  TensorForm(const Patch::Tensor& map, int scale);
  /// A patch of a closed oriented surface, glued as there.
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

}  // namespace veritope
